#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a show has at most, whatever it comes from: its file, a plot, a book of it. docs/reference/limits.md.

#include <cstddef>

namespace ghost::scene {

inline constexpr std::size_t kMaxFixtures = 10'000;
inline constexpr std::size_t kMaxBreaks = 64; // addresses of a fixture; real ones have one to four

} // namespace ghost::scene
