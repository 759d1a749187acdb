#pragma once
// SPDX-License-Identifier: Apache-2.0
// surface.comp, for many lights at once: what surfaces show of beams, each fragment its pass times the beam
// (Screen Space Re-Rendering, section 2.1). The beam is that of shaders/shared, compiled for eight pixels.
// Metres, candela. Any thread, has_vectors().

#include "render/pixels/plane.h"
#include "shared/gobos.h"
#include "shared/types.h"

#include <glm/glm.hpp>
#include <vector>

namespace ghost::render {

// What the lights of a baked camera fall on, laid out as Fragments (render/geometry/fragments.h).
struct PassSurfaces {
    shared::View view{};
    shared::Attenuation attenuation{};
    int tiles_x = 0;
    int tiles = 0;                     // of the picture
    int blocks = 0;                    // of extra fragments, numbered after the tiles
    const glm::vec4* bounds = nullptr; // two of each of these: centre, radius (< 0: nothing to light)
    Plane places;                      // rgba32f
    std::vector<Plane> passes;         // rgba16f, by Light::pass
    const shared::Gobos* gobos = nullptr;
};

// drawn += lights, rgba16f. As many tiles and blocks as they reach, once for each light. The sum of a pixel
// is the same on any number of cores.
int light_surfaces(const PassSurfaces& where, const std::vector<shared::Light>& lights, const Plane& drawn);

} // namespace ghost::render
