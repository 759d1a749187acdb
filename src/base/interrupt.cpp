// SPDX-License-Identifier: Apache-2.0
#include "base/interrupt.h"

#include <csignal>

namespace ghost {

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

InterruptScope::InterruptScope()
    : interrupt_(std::signal(SIGINT, handle)), terminate_(std::signal(SIGTERM, handle)) {}

InterruptScope::~InterruptScope() {
    // After a first signal the second one ends the program, as handle() has arranged.
    if (interrupted()) return;
    std::signal(SIGINT, interrupt_);
    std::signal(SIGTERM, terminate_);
}

bool interrupted() {
    return caught != 0;
}

} // namespace ghost
