// SPDX-License-Identifier: Apache-2.0
#include "app/interrupt.h"

#include <csignal>

namespace ghost::app {

namespace {

volatile std::sig_atomic_t caught = 0;

void handle(int signal) {
    caught = 1;
    std::signal(signal, SIG_DFL);
}

} // namespace

void catch_interrupts() {
    std::signal(SIGINT, handle);
    std::signal(SIGTERM, handle);
}

bool interrupted() {
    return caught != 0;
}

} // namespace ghost::app
