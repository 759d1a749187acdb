// SPDX-License-Identifier: Apache-2.0
#include "base/give_way.h"

#include <sys/resource.h>

namespace ghost {

void give_way() {
    (void)setpriority(PRIO_PROCESS, 0, 19); // 0: of Linux the calling thread
}

} // namespace ghost
