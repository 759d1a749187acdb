#pragma once
// SPDX-License-Identifier: Apache-2.0
// surface.comp and surface_live.comp for many lights at once: what surfaces show of beams. The beam is that
// of shaders/shared, compiled for eight fragments. A fragment's place, and what it is of, is looked at once
// for all lights, and what no beam reaches not at all. Metres, candela. Any thread, has_vectors().

#include "render/pixels/plane.h"
#include "shared/gobos.h"
#include "shared/types.h"

#include <cstdint>
#include <vector>

namespace ghost::render {

struct MarkedLight {
    shared::Light light{};
    const std::uint32_t* marks = nullptr; // a bit for each tile, then block of extra fragments: reached
    // Of its kept visibility, two for each of these (shared/visibility.h); null: nothing is in its way.
    const std::uint32_t* entries = nullptr;
};

// What lights fall on, laid out as Fragments (render/geometry/fragments.h).
struct SurfacePlanes {
    shared::View view{};
    shared::Attenuation attenuation{};
    int tiles_x = 0;
    int tiles = 0;  // of the picture
    int blocks = 0; // of extra fragments
    Plane places;   // rgba32f
    const shared::Gobos* gobos = nullptr;
};

// Of a baked camera (Screen Space Re-Rendering, section 2.1).
struct PassSurfaces : SurfacePlanes {
    std::vector<Plane> passes; // rgba16f, by Light::pass
};

// Of a free one.
struct LiveSurfaces : SurfacePlanes {
    Plane normals, diffuse, specular; // rgba16f
    std::vector<Plane> pages;         // rg16: kept visibility
};

// drawn += lights, rgba16f. The sum of a fragment is the same on any number of cores.
void light_passes(const PassSurfaces& where, const std::vector<MarkedLight>& lights, const Plane& drawn);
void light_stage(const LiveSurfaces& where, const std::vector<MarkedLight>& lights, const Plane& drawn);

} // namespace ghost::render
