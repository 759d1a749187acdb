// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "disk/disk_sync.h"

#include "disk/private/system_files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <stdio.h>
#include <sys/file.h>
#include <unistd.h>

namespace ghost {

// fsync() of macOS leaves it in the disk's own memory. Not every file system knows the other.
bool flush_file(int fd) {
    return ::fcntl(fd, F_FULLFSYNC) == 0 || ::fsync(fd) == 0;
}

bool sync_to_disk(std::FILE* file) {
    return flush_file(::fileno(file));
}

bool lock_file(std::FILE* file) {
    return ::flock(::fileno(file), LOCK_EX | LOCK_NB) == 0;
}

std::optional<bool> rename_to_new(const std::filesystem::path& from, const std::filesystem::path& to,
                                  std::string& error) {
    // A file system without this call may have links.
    int done = ::renamex_np(from.c_str(), to.c_str(), RENAME_EXCL);
    if (done != 0 && errno == ENOTSUP) {
        done = ::link(from.c_str(), to.c_str());
        if (done == 0) ::unlink(from.c_str());
    }
    if (done == 0) return true;
    if (errno == EEXIST) return false;
    error = std::strerror(errno);
    return std::nullopt;
}

} // namespace ghost
