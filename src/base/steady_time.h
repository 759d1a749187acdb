#pragma once
// SPDX-License-Identifier: Apache-2.0
// Seconds of a clock that only goes on, from any start. Any thread.

#include <chrono>

namespace ghost {

inline double steady_now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace ghost
