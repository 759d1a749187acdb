// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
#include "base/give_way.h"

#include <pthread.h>
#include <pthread/qos.h>

namespace ghost {

// nice is of whole processes there; a thread says what its work is for.
void give_way(int nice) {
    (void)pthread_set_qos_class_self_np(nice >= kGiveWay ? QOS_CLASS_BACKGROUND : QOS_CLASS_UTILITY, 0);
}

void go_first() {
    (void)pthread_set_qos_class_self_np(QOS_CLASS_USER_INTERACTIVE, 0);
}

} // namespace ghost
