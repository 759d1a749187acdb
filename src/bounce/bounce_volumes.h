#pragma once
// SPDX-License-Identifier: Apache-2.0
// Bounced light as pictures in three dimensions, ready for a device: what falls on surfaces, by the side they
// face; what falls on anything that hangs in the air, likewise; and how the air glows towards an eye. Half
// floats, RGBA, alpha 1 where there is something, all 0 elsewhere; x fastest, then y, z, side. Pure.

#include "bounce/bounce.h"
#include "bounce/bounce_solver.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::scene {

struct BounceVolume {
    glm::ivec3 size{0};                // voxels
    std::vector<std::uint64_t> texels; // a layer of size.x x size.y for each z of each side
};

struct BounceVolumes {
    glm::vec3 low_m{0};
    float surfel_m = 0;         // voxels of surfaces
    float cell_m = 0;           // voxels of air and glow
    BounceVolume surfaces, air; // lux, six sides
    BounceVolume glow;          // cd/m^2 for a metre, one side
    float extinction_per_m = 0; // by which all light is weakened while light bounces (bounce/bounce_air.h)
};

// All but the glow, which knows an eye.
void fill_lux(const Bounce& bounce, const BounceSolution& solution, BounceVolumes& volumes);
// Lux on a surface there, linear Rec.2020, as pictures have it (shaders/relight/room_light.comp).
glm::vec3 lux_on(const BounceVolumes& volumes, const glm::vec3& place_m, const glm::vec3& normal);
void fill_glow(const Bounce& bounce, const BounceAir& air, const BounceSolution& solution,
               const glm::vec3& eye_m, BounceVolumes& volumes);

} // namespace ghost::scene
