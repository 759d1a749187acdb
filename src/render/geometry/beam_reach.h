#pragma once
// SPDX-License-Identifier: Apache-2.0
// How far along its axis anything of a beam can be seen: the tables of the haze need to tell nothing beyond
// (render/haze/fan.h). Upper bounds, metres from the beam's apex. Pure.

#include "shared/types.h"

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::render {

inline constexpr float kEndless_m = 1e6f;

// Of a picture every pixel of which shows a surface: these and the eye. All haze that it shows lies between
// them.
struct SeenBox {
    glm::vec3 low_m{0}, high_m{0};
    bool closed = false; // false: some pixel shows no surface, and haze without end
};

float reach_in(const SeenBox& box, const shared::Light& light);

// The farthest distance in each part of a distance map.
inline constexpr std::size_t kFarSide = 16;
using FarParts = std::array<float, kFarSide * kFarSide>;

// texels: half floats, side x side (passes/distance_maps.h).
FarParts far_parts(const std::vector<std::uint16_t>& texels, std::size_t side);
// The same of a square of so many texels; parts: of the whole map.
void update_far_parts(const std::vector<std::uint16_t>& texels, std::size_t side, std::size_t x0,
                      std::size_t y0, std::size_t width, FarParts& parts);

float reach_in(const FarParts& parts, const shared::Light& light);

} // namespace ghost::render
