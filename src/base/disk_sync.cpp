// SPDX-License-Identifier: Apache-2.0
#include "base/disk_sync.h"

#include <unistd.h>

namespace ghost {

bool sync_to_disk(std::FILE* file) {
    return ::fdatasync(::fileno(file)) == 0;
}

} // namespace ghost
