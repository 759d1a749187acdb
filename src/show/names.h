#pragma once
// SPDX-License-Identifier: Apache-2.0
// Names of what a show has: they become names of folders and files. Pure.

#include <cstddef>
#include <string>
#include <string_view>

namespace ghost::scene {

inline constexpr std::size_t kMostNameBytes = 100;

// 1 to kMostNameBytes bytes, no leading dot, none of /\:*?"<>|.
bool is_good_name(std::string_view name);
// The nearest such name: '-' for each letter that it may not have, whole letters up to kMostNameBytes. Empty:
// there is none.
std::string good_name(std::string_view name);

} // namespace ghost::scene
