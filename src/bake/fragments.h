#pragma once
// SPDX-License-Identifier: Apache-2.0
// How the samples of one pixel are split into fragments. A beam is evaluated once per fragment, so a fragment
// must be small: samples sorted by distance are cut at the widest gaps until each part is shorter than a few
// pixels' width. That parts the two sides of a silhouette, and also slices a floor seen at a grazing angle.
// Pure.

#include "rays/tracer.h"

#include <span>

namespace ghost::bake {

inline constexpr int kMaxFragments = 4;
// A part may be this many pixel widths deep; see docs/guide/baking.md for what other values cost and gain.
inline constexpr float kFragmentDepthPixels = 3.0f;

// part[k]: fragment of sample k, or -1 where nothing was hit; fragment 0 has most samples. pixel_m: width of
// a pixel per metre of distance. Returns the number of fragments (0: nothing was hit).
int split_into_fragments(std::span<const Surface> samples, float pixel_per_m, std::span<int> part);

} // namespace ghost::bake
