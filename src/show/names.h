#pragma once
// SPDX-License-Identifier: Apache-2.0
// Names of what a show has: they become names of folders and files. Pure.

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace ghost::scene {

inline constexpr std::size_t kMostNameBytes = 100;

inline constexpr std::string_view kOfPaths = "/\\:*?\"<>|";

// 1 to kMostNameBytes bytes, no leading dot, none of kOfPaths.
inline bool is_good_name(std::string_view name) {
    return !name.empty() && name.size() <= kMostNameBytes && name.front() != '.' &&
           name.find_first_of(kOfPaths) == std::string_view::npos;
}

// The nearest such name: '-' for each letter that it may not have, whole letters up to kMostNameBytes. Empty:
// there is none.
inline std::string good_name(std::string_view name) {
    std::size_t end = std::min(name.size(), kMostNameBytes);
    const auto goes_on = [&](std::size_t at) {
        return at < name.size() && (static_cast<unsigned char>(name[at]) & 0xC0) == 0x80; // UTF-8
    };
    while (end > 0 && goes_on(end)) --end;
    std::string good(name.substr(0, end));
    for (char& letter : good)
        if (kOfPaths.find(letter) != std::string_view::npos) letter = '-';
    if (good.starts_with('.')) good[0] = '-';
    return good;
}

} // namespace ghost::scene
