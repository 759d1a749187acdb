// SPDX-License-Identifier: Apache-2.0
#include "base/give_way.h"

#include <windows.h>

namespace ghost {

// Of Windows the priorities of a thread are steps: one below others is all that there is for "a bit".
void give_way(int nice) {
    (void)::SetThreadPriority(::GetCurrentThread(), nice >= kGiveWay ? THREAD_PRIORITY_IDLE
                                                    : nice > 0       ? THREAD_PRIORITY_BELOW_NORMAL
                                                                     : THREAD_PRIORITY_NORMAL);
}

void go_first() {
    (void)::SetThreadPriority(::GetCurrentThread(), THREAD_PRIORITY_TIME_CRITICAL);
}

} // namespace ghost
