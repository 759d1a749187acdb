#pragma once
// SPDX-License-Identifier: Apache-2.0
// A clock that only goes on, from any start. Any thread.

#include <chrono>

namespace ghost {

inline std::chrono::nanoseconds steady_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

inline double steady_now_s() {
    return std::chrono::duration<double>(steady_now()).count();
}

} // namespace ghost
