// SPDX-License-Identifier: Apache-2.0
#include "passes/distance_maps.h"
#include "render/geometry/beam_reach.h"
#include "shared/beam.h"
#include "shared/octahedral.h"
#include "support/test_view.h"

#include <glm/gtc/packing.hpp>

namespace ghost::render {
namespace {

using glm::vec3;

constexpr SeenBox kHall{{-6, -12, 0}, {6, 6, 8}, true};

TEST(BeamReach, AClosedBoxEndsABeam) {
    const shared::Light down = aimed_light({0, 0, 5}, {0, 0, 0}, 20, 8000);
    EXPECT_GE(reach_in(kHall, down), 5.0f - down.position_m.z + 5.0f);
    EXPECT_LE(reach_in(kHall, down), 7.0f);
    // From above the box, through it.
    EXPECT_NEAR(reach_in(kHall, aimed_light({0, 0, 12}, {0, 0, 0}, 2, 8000)), 12.0f, 2.0f);
    // It never gets there: as little as there is.
    EXPECT_LT(reach_in(kHall, aimed_light({0, 0, 12}, {0, 0, 20}, 2, 8000)), 1.0f);
    SeenBox open = kHall;
    open.closed = false;
    EXPECT_EQ(reach_in(open, down), kEndless_m);
}

TEST(BeamReach, EverythingOfABeamInTheBoxIsWithinItsReach) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> fraction(0, 1);
    const auto inside = [&] {
        return kHall.low_m +
               (kHall.high_m - kHall.low_m) * vec3(fraction(random), fraction(random), fraction(random));
    };
    for (int k = 0; k < 2000; ++k) {
        const shared::Light light = aimed_light(inside(), inside(), 2 + 40 * fraction(random), 8000);
        const float reach = reach_in(kHall, light);
        const float rim = light.tan_field * light.cut_radius;
        for (int sample = 0; sample < 300; ++sample) {
            const vec3 q = shared::to_gate(light, inside() - light.position_m);
            const bool lit = q.z > 0 && glm::length(glm::vec2(q)) <= rim * q.z;
            EXPECT_LE(lit ? q.z : 0, reach);
        }
    }
}

// A lamp this high above a floor, under the open sky.
constexpr float kHigh_m = 5;

std::vector<std::uint16_t> floor_map(std::size_t side) {
    std::vector<std::uint16_t> texels;
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            const vec3 way = shared::direction_from_octahedral(
                (glm::vec2(static_cast<float>(x), static_cast<float>(y)) + 0.5f) / static_cast<float>(side));
            texels.push_back(way.z < -1e-3f ? glm::packHalf1x16(kHigh_m / -way.z) : scene::kNoSurface);
        }
    return texels;
}

TEST(BeamReach, WhatALampSeesEndsItsBeam) {
    for (const std::size_t side : {8u, 64u, 100u, 512u}) {
        SCOPED_TRACE(side);
        const FarParts parts = far_parts(floor_map(side), side);
        const shared::Light down = aimed_light({0, 0, kHigh_m}, {0, 0, 0}, 10, 8000);
        EXPECT_GE(reach_in(parts, down), kHigh_m);
        EXPECT_LE(reach_in(parts, down), 1.3f * kHigh_m);
        const shared::Light aslant = aimed_light({0, 0, kHigh_m}, {kHigh_m, 0, 0}, 10, 8000);
        EXPECT_GE(reach_in(parts, aslant), kHigh_m / std::cos(glm::radians(50.0f)));
        EXPECT_LE(reach_in(parts, aslant), 3.0f * kHigh_m);
        EXPECT_EQ(reach_in(parts, aimed_light({0, 0, kHigh_m}, {9, 0, kHigh_m}, 10, 8000)), kEndless_m);
        EXPECT_EQ(reach_in(parts, aimed_light({0, 0, kHigh_m}, {0, 0, 20}, 10, 8000)), kEndless_m);
    }
}

} // namespace
} // namespace ghost::render
