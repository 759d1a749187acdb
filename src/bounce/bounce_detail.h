#pragma once
// SPDX-License-Identifier: Apache-2.0
// Light that bounces, and how finely (docs/design/bounce.md).

namespace ghost::scene {

enum class BounceDetail { off, room, normal, fine };
inline constexpr const char* kBounceDetails[] = {"off", "room", "normal", "fine"};

} // namespace ghost::scene
