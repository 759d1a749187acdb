// SPDX-License-Identifier: Apache-2.0
// Distance maps that the device draws against those that Embree traces, texel by texel: the same rays, so
// what differs lies where an edge passes within a rounding of a texel's middle.
#include "bake/moving_maps.h"
#include "live/session/session.h"
#include "passes/distance_maps.h"
#include "render/geometry/stage_model.h"
#include "render/haze/distance_images.h"
#include "support/likeness.h"
#include "support/one_device.h"
#include "support/random_stage.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numeric>

namespace ghost::app {
namespace {

constexpr std::uint32_t kDrawnSide = 256;
constexpr float kSameDistance = 0.0015f; // of it: three steps of half floats

std::vector<std::uint16_t> layer_of(const gpu::Texture& texture, std::uint32_t layer) {
    const std::uint32_t side = texture.shape().width;
    const std::uint64_t bytes = std::uint64_t{side} * side * sizeof(std::uint16_t);
    const gpu::Buffer buffer(device(), bytes, gpu::Access::readback);
    gpu::Commands commands(device());
    commands.begin();
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, layer, 1};
    region.imageExtent = {side, side, 1};
    vkCmdCopyImageToBuffer(commands.handle(), texture.image(), VK_IMAGE_LAYOUT_GENERAL, buffer.handle(), 1,
                           &region);
    commands.submit_and_wait();
    std::vector<std::uint16_t> texels(std::size_t{side} * side);
    std::memcpy(texels.data(), buffer.mapped(), bytes);
    return texels;
}

struct Counted {
    std::size_t texels = 0;
    std::size_t other = 0;   // another distance
    std::size_t no_edge = 0; // of these: beyond all that Embree met in the texels round it
};

void count(const std::vector<std::uint16_t>& drawn, const std::vector<std::uint16_t>& traced,
           Counted& counted) {
    constexpr int kSide = static_cast<int>(kDrawnSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto at = [&](int u, int v) {
                return static_cast<std::size_t>(std::clamp(v, 0, kSide - 1) * kSide +
                                                std::clamp(u, 0, kSide - 1));
            };
            const float is_m = glm::unpackHalf1x16(drawn[at(x, y)]);
            const float wanted_m = glm::unpackHalf1x16(traced[at(x, y)]);
            ++counted.texels;
            if (std::abs(is_m - wanted_m) <= kSameDistance * wanted_m) continue;
            ++counted.other;
            float least_m = wanted_m, most_m = wanted_m;
            for (int k = 0; k < 25; ++k) {
                const float near_m = glm::unpackHalf1x16(traced[at(x + k % 5 - 2, y + k / 5 - 2)]);
                least_m = std::min(least_m, near_m);
                most_m = std::max(most_m, near_m);
            }
            const bool is_edge = most_m > (1 + kSameDistance) * least_m &&
                                 is_m >= least_m * (1 - kSameDistance) &&
                                 is_m <= most_m * (1 + kSameDistance);
            counted.no_edge += is_edge ? 0 : 1;
        }
}

shared::Light all_round(std::size_t map) {
    shared::Light light{};
    light.axis_w = {0, 0, -1};
    light.tan_field = 1;
    light.cut_radius = 1;
    light.panel_m = 1;
    light.intensity_cd = glm::vec3(1);
    light.map = static_cast<std::uint32_t>(map + 1);
    return light;
}

// Both ways of a stage, before and after something moved.
Counted both_ways(const scene::Stage& stage, const std::vector<glm::vec3>& places_m) {
    Counted counted;
    Report report;
    render::StageModel model(device(), stage, report);
    bake::MovingMaps traced(stage, static_cast<int>(kDrawnSide), places_m);
    bake::MovingMaps asked(stage, static_cast<int>(kDrawnSide), places_m, bake::MovingMaps::Made::elsewhere);
    scene::DistanceMaps maps{static_cast<int>(kDrawnSide), std::vector<scene::DistanceMap>(places_m.size())};
    for (scene::DistanceMap& map : maps.maps)
        map.distance.assign(std::size_t{kDrawnSide} * kDrawnSide, scene::kNoSurface);
    render::DistanceImages images(device(), maps, render::DistanceImages::Made::by_the_device);
    EXPECT_EQ(images.lack(), "");
    std::vector<shared::Light> lights;
    for (std::size_t k = 0; k < places_m.size(); ++k) lights.push_back(all_round(k));
    for (int step = 0; step < 2; ++step) {
        if (step > 0) {
            for (std::size_t k = 0; k < stage.instances.size(); k += 3) {
                const glm::mat4 world = glm::translate(glm::mat4(1.0f), glm::vec3(0.37f, -0.21f, 0.13f)) *
                                        stage.instances[k].world;
                model.move(k, world);
                traced.move(k, world);
                asked.move(k, world);
            }
            if (stage.instances.size() > 1) {
                model.show(1, false);
                traced.show(1, false);
                asked.show(1, false);
            }
            for (bake::MovingMaps* const moving : {&traced, &asked}) moving->hang(0, places_m[0] + 0.11f);
        }
        const bake::MovingMaps::News told = traced.update(lights), news = asked.update(lights);
        EXPECT_EQ(told.rays, news.rays);
        EXPECT_EQ(told.is_seen_by_resting, news.is_seen_by_resting);
        EXPECT_EQ(told.maps.size(), news.maps.size());
        std::vector<render::MapDrawer::Job> jobs;
        for (const bake::MovingMaps::Changed& changed : news.maps)
            jobs.push_back(
                {static_cast<std::uint32_t>(changed.map), asked.position_m(changed.map), changed.blocks});
        images.draw(model, jobs);
        EXPECT_TRUE(asked.distance(0).empty());
        for (std::uint32_t map = 0; map < places_m.size(); ++map)
            count(layer_of(images.texture(), map), traced.distance(map), counted);
    }
    EXPECT_EQ(device().validation_errors(), 0u);
    return counted;
}

TEST(DrawnMaps, OfRandomStagesAreEmbrees) {
    Counted all;
    for (std::uint32_t seed = 0; seed < 48; ++seed) {
        const bake::RandomStage made = bake::random_stage(seed);
        std::vector<glm::vec3> places_m;
        for (const shared::Light& light : made.lights) places_m.push_back(light.position_m);
        const Counted counted = both_ways(made.stage, places_m);
        if (counted.no_edge > 0)
            std::printf("%u, %s: %zu of %zu texels differ, %zu of them at no edge\n", seed, made.kind.c_str(),
                        counted.other, counted.texels, counted.no_edge);
        all.texels += counted.texels;
        all.other += counted.other;
        all.no_edge += counted.no_edge;
    }
    std::printf("%.4f %% of %zu texels differ, %zu of them at no edge\n",
                100.0 * static_cast<double>(all.other) / static_cast<double>(all.texels), all.texels,
                all.no_edge);
    EXPECT_LT(static_cast<double>(all.other), 5e-5 * static_cast<double>(all.texels));
    EXPECT_LT(static_cast<double>(all.no_edge), 3e-6 * static_cast<double>(all.texels));
}

// Holes of a mask, leaves that are half there, a body that stops nothing, bars thinner than a texel. Devices
// mix texels of a picture by weights of 8 bits: a hole's edge lies elsewhere by as much.
TEST(DrawnMaps, OfHolesAndLeavesAreEmbrees) {
    scene::Stage stage = bake::edgy_stage();
    scene::Texture holes;
    holes.pixels = {16, 16, 4};
    for (int k = 0; k < 16 * 16; ++k) {
        std::uint8_t* const texel = holes.pixels.at(k % 16, k / 16);
        texel[0] = texel[1] = texel[2] = 200;
        texel[3] = static_cast<std::uint8_t>((k * 97 + k / 16 * 31) % 256);
    }
    stage.textures.push_back(holes);
    for (const scene::AlphaMode mode : {scene::AlphaMode::mask, scene::AlphaMode::blend}) {
        const int material = bake::add_material(stage, {0.5f, 0.5f, 0.5f});
        stage.materials.back().alpha_mode = mode;
        stage.materials.back().alpha_cutoff = 0.4f;
        stage.materials.back().base_texture = 0;
        const float x = mode == scene::AlphaMode::mask ? -3.0f : 0.5f;
        bake::place(stage,
                    bake::add_mesh(stage, bake::quad_mesh({x, 1, 1}, {2.5f, 0, 0}, {0, 1, 2}), material));
    }
    bake::place(stage, 0, glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 2)), 0);
    const Counted counted = both_ways(stage, {{0, -1, 3}, {-2, 3, 1.2f}, {1, 1.5f, 2}});
    std::printf("%.4f %% of %zu texels differ, %zu of them at no edge\n",
                100.0 * static_cast<double>(counted.other) / static_cast<double>(counted.texels),
                counted.texels, counted.no_edge);
    EXPECT_LT(static_cast<double>(counted.other), 1e-3 * static_cast<double>(counted.texels));
    EXPECT_LT(static_cast<double>(counted.no_edge), 2e-4 * static_cast<double>(counted.texels));
}

SessionOptions kinetic_stage(MovingMapsBy maps) {
    SessionOptions opening;
    opening.show = GHOST_SOURCE_DIR "/assets/kinetic";
    opening.width = 240;
    opening.height = 136;
    opening.map_size = 256;
    opening.motion = fixture::Motion::as_commanded;
    opening.live = opening.quiet = opening.repeatable = opening.validation = true;
    opening.moving_maps = maps;
    return opening;
}

// The kinetic stage on its way: truss, winch, revolve, lift and wagon.
image::ImageF picture_at(Session& session, int place) {
    const auto along = static_cast<float>(place);
    auto& movers = session.rig->movers();
    movers.drive(0, {-0.7f * along, -0.9f * along});
    movers.drive(1, {0.4f * along});
    movers.drive(2, {80 * along});
    movers.drive(3, {0.6f * along});
    movers.drive(4, {2.8f * along});
    std::map<std::size_t, fixture::Programmer> lit;
    for (std::size_t k = 0; k < session.show->fixtures.size(); ++k) {
        lit[k].intensity = 1;
        lit[k].tilt_deg = -20.0f + 3 * along;
    }
    session.rig->step({}, 1, lit);
    (void)session.draw(0);
    return session.relighter->frame();
}

TEST(DrawnMaps, WhatFliesLooksAsWithEmbrees) {
    const auto traced = must(open_session(kinetic_stage(MovingMapsBy::processor)));
    const auto drawn = must(open_session(kinetic_stage(MovingMapsBy::device)));
    EXPECT_FALSE(traced->live->draws_maps());
    EXPECT_TRUE(drawn->live->draws_maps());
    for (int place = 0; place < 5; ++place) {
        const image::ImageF wanted = picture_at(*traced, place), is = picture_at(*drawn, place);
        EXPECT_EQ(drawn->live->map_work().rays, traced->live->map_work().rays);
        EXPECT_GT(drawn->live->map_work().rays, 0u);
        const double db = display_psnr(is, wanted);
        traced->shadows = false;
        const double without_db = display_psnr(picture_at(*traced, place), wanted);
        traced->shadows = true;
        std::printf("place %d: %.1f dB, without shadows %.1f dB\n", place, db, without_db);
        EXPECT_GT(db, 60);
        EXPECT_LT(without_db, 50) << "the maps are seen";
    }
    EXPECT_EQ(drawn->device->validation_errors(), 0u);
}

TEST(DrawnMaps, ADeviceThatCannotIsSaidWhereItWasAskedFor) {
    const auto says_so = [](const Session& session) {
        return std::any_of(
            session.report.messages.begin(), session.report.messages.end(), [](const Message& one) {
                return one.where == "distance maps" && one.what.find("maxClipDistances") != std::string::npos;
            });
    };
    SessionOptions opening = kinetic_stage(MovingMapsBy::device);
    opening.lowered_limits = {{"maxClipDistances", 0}};
    const auto asked = must(open_session(opening));
    EXPECT_TRUE(says_so(*asked));
    EXPECT_FALSE(asked->live->draws_maps());
    opening.moving_maps = MovingMapsBy::choice;
    const auto chosen = must(open_session(opening));
    EXPECT_FALSE(says_so(*chosen));
    EXPECT_GT(display_psnr(picture_at(*asked, 2), picture_at(*chosen, 2)), 90);
}

} // namespace
} // namespace ghost::app
