// SPDX-License-Identifier: Apache-2.0
#include "disk/disk_sync.h"

#include <sys/file.h>
#include <unistd.h>

namespace ghost {

bool sync_to_disk(std::FILE* file) {
    return ::fdatasync(::fileno(file)) == 0;
}

bool lock_file(std::FILE* file) {
    return ::flock(::fileno(file), LOCK_EX | LOCK_NB) == 0;
}

} // namespace ghost
