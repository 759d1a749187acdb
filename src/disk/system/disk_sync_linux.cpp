// SPDX-License-Identifier: Apache-2.0
#include "disk/disk_sync.h"

#include "disk/private/system_files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace ghost {

bool sync_to_disk(std::FILE* file) {
    return ::fdatasync(::fileno(file)) == 0;
}

bool lock_file(std::FILE* file) {
    return ::flock(::fileno(file), LOCK_EX | LOCK_NB) == 0;
}

bool flush_file(int fd) {
    return ::fsync(fd) == 0;
}

std::optional<bool> rename_to_new(const std::filesystem::path& from, const std::filesystem::path& to,
                                  std::string& error) {
    // A file system without this call may have links.
    int done = ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE);
    if (done != 0 && errno == EINVAL) {
        done = ::link(from.c_str(), to.c_str());
        if (done == 0) ::unlink(from.c_str());
    }
    if (done == 0) return true;
    if (errno == EEXIST) return false;
    error = std::strerror(errno);
    return std::nullopt;
}

} // namespace ghost
