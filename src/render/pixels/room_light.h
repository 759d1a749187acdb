#pragma once
// SPDX-License-Identifier: Apache-2.0
// glow.comp and room_light.comp: what bounces of light in a room, as the picture shows it. The volumes are
// taken as the solver left them. Metres. Any thread, has_vectors().

#include "bounce/bounce_volumes.h"
#include "render/pixels/plane.h"
#include "shared/room_light.h"
#include "shared/types.h"

#include <cstdint>
#include <vector>

namespace ghost::render {

// What it falls on, laid out as Fragments (render/geometry/fragments.h).
struct RoomPlanes {
    shared::View view{};
    shared::RoomLightPush room{}; // edges: as many pixels have extra fragments
    const scene::BounceVolumes* volumes = nullptr;
    Plane places;                     // rgba32f
    Plane normals, diffuse, specular; // rgba16f
    Plane edges;                      // rg32ui
};

// rgba16f: the slices of the first ray, of the second one ...
using GlowSlices = std::vector<std::uint64_t>;

void sum_glow(const RoomPlanes& where, GlowSlices& slices);
// frame += light, rgba16f. slices: of these planes; not looked at where room.as_lux is 1.
void add_room_light(const RoomPlanes& where, const GlowSlices& slices, const Plane& frame);

} // namespace ghost::render
