#pragma once
// SPDX-License-Identifier: Apache-2.0
// Light that bounces, and how finely (docs/design/bounce.md), by the names that show.toml, the command line
// and the window have for it. Pure.

#include <iterator>
#include <optional>
#include <string>
#include <string_view>

namespace ghost::scene {

enum class BounceDetail { off, room, normal, fine };
inline constexpr const char* kBounceDetails[] = {"off", "room", "normal", "fine"};
static_assert(std::size(kBounceDetails) == static_cast<std::size_t>(BounceDetail::fine) + 1);

inline const char* name_of(BounceDetail detail) {
    return kBounceDetails[static_cast<std::size_t>(detail)];
}
std::optional<BounceDetail> find_bounce_detail(std::string_view name);

// "is 'normel', expected one of "off", ..., did you mean 'normal'?"
std::string no_such_bounce_detail(std::string_view name);

} // namespace ghost::scene
