#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the address sanitizer keeps of what was freed, so that it sees who reads it: a limit of memory in a
// test allows for it.

namespace ghost {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr double kKeptFreed_mb = 600;
#else
inline constexpr double kKeptFreed_mb = 0;
#endif

} // namespace ghost
