#pragma once
// SPDX-License-Identifier: Apache-2.0
// Ctrl-C and a polite kill (SIGINT, SIGTERM) as a question that long commands ask, so that they can finish
// their files. A second signal ends the program at once. Main thread sets it up; any thread may ask.

namespace ghost {

void catch_interrupts();
bool interrupted();

// Catches them for as long as it lives, where the rest of a command leaves them to the system.
class InterruptScope {
public:
    InterruptScope();
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

private:
    using Handler = void (*)(int);
    Handler interrupt_;
    Handler terminate_;
};

} // namespace ghost
