#pragma once
// SPDX-License-Identifier: Apache-2.0
// glare_develop.comp, develop.comp and meter.comp: from the frame with the finest level of its glare to the
// display (shared/develop.h). Planes are rgba16f, but for the picture; any thread, has_vectors().

#include "render/pixels/plane.h"

#include <cstdint>

namespace ghost::render {

// The frame as a camera sees it: frame * frame_weight + finest * glare_weight.
struct SeenFrame {
    Plane frame;
    Plane finest; // level of the glare; or none
    float frame_weight = 1;
    float glare_weight = 0;
};

// exposure: display value per cd/m^2; tone: shared::kToneAgx ..; picture: rgba8.
void develop(const SeenFrame& seen, float exposure, std::uint32_t tone, const Plane& picture);
// EV100 for the log-average luminance of the lit pixels.
float metered_ev100(const SeenFrame& seen);

} // namespace ghost::render
