// SPDX-License-Identifier: Apache-2.0
#include "base/give_way.h"

#include <sched.h>
#include <sys/resource.h>

namespace ghost {

void give_way(int nice) {
    (void)setpriority(PRIO_PROCESS, 0, nice); // 0: of Linux the calling thread
}

void go_first() {
    sched_param first{};
    first.sched_priority = sched_get_priority_min(SCHED_RR);
    (void)sched_setscheduler(0, SCHED_RR | SCHED_RESET_ON_FORK, &first);
}

} // namespace ghost
