// SPDX-License-Identifier: Apache-2.0
#include "disk/disk_sync.h"

#include "disk/private/system_files.h"

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

bool rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to) {
    return ::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0;
}

} // namespace ghost
