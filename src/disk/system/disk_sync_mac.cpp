// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "disk/disk_sync.h"

#include "disk/private/system_files.h"

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

bool rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to) {
    return ::renamex_np(from.c_str(), to.c_str(), RENAME_EXCL) == 0;
}

} // namespace ghost
