// SPDX-License-Identifier: Apache-2.0
#include "show/names.h"

#include <algorithm>

namespace ghost::scene {
namespace {

constexpr std::string_view kOfPaths = "/\\:*?\"<>|";

} // namespace

bool is_good_name(std::string_view name) {
    return !name.empty() && name.size() <= kMostNameBytes && name.front() != '.' &&
           name.find_first_of(kOfPaths) == std::string_view::npos;
}

std::string good_name(std::string_view name) {
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
