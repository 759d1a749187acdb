// SPDX-License-Identifier: Apache-2.0
// Tables of shaped beams: their levels, and what plain ones (of many lights) look like.
#include "render/haze/fan.h"
#include "shared/optics.h"
#include "support/test_view.h"

#include <cstdio>

namespace ghost::render {
namespace {

using glm::vec3;

shared::Light shaped_light(const vec3& from, const vec3& to, float field_deg) {
    shared::Light light = aimed_light(from, to, field_deg, 8000);
    light.shaped = 2;
    light.iris_depth = 0.05f;
    put_gobo(light, 2, 20);
    for (int k = 0; k < 4; ++k) {
        const float turn = 0.2f - 1.5708f * static_cast<float>(k);
        light.blade[k] = {{-std::sin(turn), std::cos(turn)}, 0.5f, 0.07f + 0.005f * static_cast<float>(k)};
    }
    return light;
}

struct Rect {
    std::uint32_t x, y, side;
};

std::uint32_t texels(const shared::Fan& fan) {
    std::uint32_t sum = 0;
    for (std::uint32_t k = 0; k < fan.levels; ++k) {
        const std::uint32_t side = shared::fan_node_side(fan.place[k]);
        sum += side * (side >> fan.plain);
    }
    return sum;
}

TEST(FanNodes, LevelsFallAndLieBesideEachOther) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> fraction(0, 1);
    const auto place = [&] {
        return vec3(fraction(random), fraction(random), fraction(random)) * 16.0f - 8.0f;
    };
    for (int k = 0; k < 2000; ++k) {
        shared::Light light = shaped_light(place(), place(), 1 + 60 * fraction(random) * fraction(random));
        light.focus_per_m = 0.5f * fraction(random);
        light.lens_radius_m = k % 10 == 0 ? 0 : 0.01f + 0.2f * fraction(random);
        const float reach_m = k % 3 == 0 ? kEndless_m : 0.1f + 20 * fraction(random);
        const FanDetail detail = k % 2 == 0 ? FanDetail::fine : FanDetail::plain;
        const shared::Fan fan = make_fan(light, place(), 50 + 2000 * fraction(random), reach_m, detail, 0);
        ASSERT_GE(fan.levels, 1u);
        ASSERT_LE(fan.levels, shared::kFanNodes);
        std::vector<Rect> rects;
        for (std::uint32_t level = 0; level < fan.levels; ++level) {
            const glm::uvec2 corner = shared::fan_node_corner(fan.place[level]);
            rects.push_back({corner.x, corner.y, shared::fan_node_side(fan.place[level])});
            const Rect& rect = rects.back();
            EXPECT_EQ(rect.side % shared::kNodeStep, 0u);
            EXPECT_GE(rect.side, shared::kLeastFan);
            EXPECT_LE(rect.side, shared::kFinestNode);
            EXPECT_LE(rect.x + rect.side, shared::kFanWidth);
            EXPECT_LE(rect.y + rect.side, shared::kFinestFan);
            for (std::uint32_t other = 0; other < level; ++other)
                EXPECT_TRUE(
                    rect.x >= rects[other].x + rects[other].side || rects[other].x >= rect.x + rect.side ||
                    rect.y >= rects[other].y + rects[other].side || rects[other].y >= rect.y + rect.side);
            if (level == 0) continue;
            EXPECT_LT(fan.node[level].x, fan.node[level - 1].x);
            // At the next node the level has risen by one.
            EXPECT_NEAR((fan.node[level - 1].x - fan.node[level].x) * fan.node[level - 1].y, 1, 1e-3);
        }
        if (!(light.lens_radius_m > 0)) continue;
        EXPECT_EQ(fan.node[0].x, 1);
        // The last one is where the beam ends.
        const float end = 1 - shared::beam_focus(light, reach_m).away; // t there
        EXPECT_NEAR(fan.node[fan.levels - 1].x, std::min(end, 0.9f), 2e-3f);
    }
}

TEST(FanNodes, ABeamThatEndsNeedsFewer) {
    const shared::Light light = shaped_light({0, 7, 6}, {0, 4, 0}, 20);
    const vec3 eye(0, -15, 4);
    const auto made = [&](float reach_m, FanDetail detail) {
        return make_fan(light, eye, 600, reach_m, detail, 0);
    };
    const std::uint32_t endless = texels(made(kEndless_m, FanDetail::fine));
    const std::uint32_t ends = texels(made(8, FanDetail::fine));
    const std::uint32_t plain = texels(made(8, FanDetail::plain));
    std::printf("texels: %u endless, %u ends at 8 m, %u plain\n", endless, ends, plain);
    EXPECT_LT(ends, 0.9 * endless);
    EXPECT_LT(plain, 0.4 * ends);
}

using PlainTables = RelightTest;

// Of a hundred lights all but one are dark.
image::ImageF drawn(const scene::Passes& passes, const shared::Light& light, int light_count) {
    Settings settings;
    settings.haze = {0.022f, 0.022f, 0.77f, -0.6f, 0.035f};
    settings.surfaces = false;
    std::vector<shared::Light> lights(static_cast<std::size_t>(light_count), light);
    for (std::size_t k = 1; k < lights.size(); ++k) lights[k].intensity_cd = vec3(0);
    Relighter relighter(device(), passes, test_gobos(), light_count, settings);
    relighter.draw(lights);
    return relighter.frame();
}

TEST_F(PlainTables, ShowTheSameBeam) {
    const scene::Passes passes = wall_passes(camera_at({0, -12, 3}, {0, 4, 3}, 26, 160, 90), 6.0f);
    const shared::Light light = shaped_light({-4, 2, 6}, {4, 2, 0.5f}, 30);
    const image::ImageF fine = drawn(passes, light, 1);
    const image::ImageF plain = drawn(passes, light, 100);
    double sum = 0, bias = 0, squares = 0;
    for (std::size_t k = 0; k < fine.samples.size(); ++k) {
        const double difference = double{plain.samples[k]} - double{fine.samples[k]};
        sum += double{fine.samples[k]};
        bias += difference;
        squares += difference * difference;
    }
    const double mean = sum / static_cast<double>(fine.samples.size());
    const double rms = std::sqrt(squares / static_cast<double>(fine.samples.size())) / mean;
    std::printf("plain: %.2f %% of the light too much, rms %.1f %% of the mean\n", 100 * bias / sum,
                100 * rms);
    EXPECT_GT(squares, 0); // they are not the same tables
    EXPECT_LT(std::abs(bias / sum), 0.005);
    EXPECT_LT(rms, 0.15);
}

} // namespace
} // namespace ghost::render
