#pragma once
// SPDX-License-Identifier: Apache-2.0
// glare_down.comp, glare_tail.comp and glare_up.comp (docs/design/glare.md). Planes are rgba16f, as the
// shaders bind them; any thread, has_vectors().

#include "render/pixels/plane.h"

namespace ghost::render {

// The next coarser level. of_frame: fine is the frame, whose alpha says how many times brighter a pixel is.
void glare_down(const Plane& fine, const Plane& coarse, float scale, bool of_frame);
// texel_deg, weight: shared::GlareTailPush.
void glare_tail(const Plane& from, const Plane& to, float texel_deg, float weight);
// fine = fine * fine_weight + coarse * coarse_weight.
void glare_up(const Plane& coarse, const Plane& fine, float fine_weight, float coarse_weight);

} // namespace ghost::render
