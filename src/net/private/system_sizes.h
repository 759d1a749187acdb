#pragma once
// SPDX-License-Identifier: Apache-2.0
// How much is asked of each system at once.

#include <cstddef>

namespace ghost::dmx {

inline constexpr std::size_t kBatch = 64;
inline constexpr std::size_t kDatagramBytes =
    1536;                                     // more than any level packet; the rest of a longer one is cut
inline constexpr std::size_t kMostPorts = 64; // serial ones
inline constexpr std::size_t kReadBytes = 64u << 10;
// Connections that nobody has accepted yet: twenty browsers open 120 at once, and who finds no place tries
// again a second later, behind others.
inline constexpr int kWaiting = 256;

} // namespace ghost::dmx
