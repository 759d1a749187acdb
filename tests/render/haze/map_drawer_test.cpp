// SPDX-License-Identifier: Apache-2.0
// Distance maps that the device draws: in a box to the digit, with the cells and farthest distances that the
// processor makes of the same texels; and what bad input gets. Against Embree: live/session/drawn_maps_test.
#include "render/haze/map_drawer.h"

#include "render/haze/distance_images.h"
#include "render/haze/private/blockers.h"
#include "shared/blockers.h"
#include "shared/octahedral.h"
#include "support/one_device.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <numeric>

namespace ghost::render {
namespace {

scene::Mesh box_of(const glm::vec3& half_m) {
    scene::Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0), along(0);
            normal[axis] = side;
            along[(axis + 1) % 3] = 1;
            const glm::vec3 across = glm::cross(normal, along);
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const auto& [s, t] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
                mesh.positions.push_back((normal + s * along + t * across) * half_m);
                mesh.normals.push_back(normal);
            }
            for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
        }
    return mesh;
}

void add(scene::Stage& stage, scene::Mesh mesh, const glm::vec3& at_m, int fixture = scene::kNone) {
    if (stage.materials.empty()) stage.materials.emplace_back();
    stage.meshes.push_back(std::move(mesh));
    stage.instances.push_back(
        {"", static_cast<int>(stage.meshes.size()) - 1, glm::translate(glm::mat4(1.0f), at_m), fixture});
}

std::vector<int> all_blocks(std::uint32_t side) {
    std::vector<int> blocks(std::size_t{side / shared::kMapBlock} * (side / shared::kMapBlock));
    std::iota(blocks.begin(), blocks.end(), 0);
    return blocks;
}

scene::DistanceMaps empty_maps(std::uint32_t side, std::size_t count) {
    scene::DistanceMaps maps;
    maps.size = static_cast<int>(side);
    maps.maps.resize(count);
    for (scene::DistanceMap& map : maps.maps)
        map.distance.assign(std::size_t{side} * side, scene::kNoSurface);
    return maps;
}

// A level of a layer.
template <class Texel>
std::vector<Texel> texels_of(const gpu::Texture& texture, std::uint32_t layer, std::uint32_t level = 0) {
    const std::uint32_t side = std::max(texture.shape().width >> level, 1u);
    const std::uint64_t bytes = std::uint64_t{side} * side * sizeof(Texel);
    const gpu::Buffer buffer(device(), bytes, gpu::Access::readback);
    gpu::Commands commands(device());
    commands.begin();
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, layer, 1};
    region.imageExtent = {side, side, 1};
    vkCmdCopyImageToBuffer(commands.handle(), texture.image(), VK_IMAGE_LAYOUT_GENERAL, buffer.handle(), 1,
                           &region);
    commands.submit_and_wait();
    std::vector<Texel> texels(std::size_t{side} * side);
    std::memcpy(texels.data(), buffer.mapped(), bytes);
    return texels;
}

class MapDrawerTest : public testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(device().validation_errors(), 0u); }

    // Of all directions.
    static std::unique_ptr<DistanceImages> drawn(const scene::Stage& stage, std::uint32_t side,
                                                 const std::vector<glm::vec3>& places_m) {
        Report report;
        const StageModel model(device(), stage, report);
        auto images = std::make_unique<DistanceImages>(device(), empty_maps(side, places_m.size()),
                                                       DistanceImages::Made::by_the_device);
        EXPECT_EQ(images->lack(), "");
        const std::vector<int> blocks = all_blocks(side);
        std::vector<MapDrawer::Job> jobs;
        for (std::uint32_t k = 0; k < places_m.size(); ++k) jobs.push_back({k, places_m[k], blocks});
        images->draw(model, jobs);
        return images;
    }
};

// A room 8 x 6 x 4 m round (0, 0, 2), with things in it.
constexpr glm::vec3 kHalf_m{4, 3, 2};

scene::Stage furnished() {
    scene::Stage stage;
    add(stage, box_of(kHalf_m), {0, 0, 2});
    for (int k = 0; k < 24; ++k) {
        const auto turn = static_cast<float>(k);
        add(stage, box_of({0.02f + 0.01f * turn, 0.3f, 0.05f}),
            {3 * std::cos(turn), 2.4f * std::sin(turn), 0.3f + 0.14f * turn});
    }
    return stage;
}

TEST_F(MapDrawerTest, ABoxIsThereToHalfFloats) {
    scene::Stage stage;
    add(stage, box_of(kHalf_m), {0, 0, 2});
    // In the middle; in a corner; a centimetre from a wall; as high as an edge would be seen on a diagonal.
    const std::vector<glm::vec3> places_m{{0, 0, 2}, {3.7f, -2.8f, 3.9f}, {-3.99f, 0.3f, 1}, {1, 1, 2.5f}};
    for (const std::uint32_t side : {64u, 256u, 1024u}) {
        const auto images = drawn(stage, side, places_m);
        for (std::uint32_t map = 0; map < places_m.size(); ++map) {
            const std::vector<std::uint16_t> texels = texels_of<std::uint16_t>(images->texture(), map);
            float worst = 0;
            for (std::uint32_t y = 0; y < side; ++y)
                for (std::uint32_t x = 0; x < side; ++x) {
                    const glm::vec3 way = shared::direction_from_octahedral((glm::vec2(x, y) + 0.5f) /
                                                                            static_cast<float>(side));
                    float wanted_m = scene::kNoSurface_m;
                    for (int axis = 0; axis < 3; ++axis) {
                        if (std::abs(way[axis]) < 1e-9f) continue;
                        const float wall_m =
                            (axis == 2 ? 2.0f : 0.0f) + std::copysign(kHalf_m[axis], way[axis]);
                        wanted_m = std::min(wanted_m, (wall_m - places_m[map][axis]) / way[axis]);
                    }
                    const float is_m = glm::unpackHalf1x16(texels[y * side + x]);
                    worst = std::max(worst, std::abs(is_m / wanted_m - 1));
                }
            EXPECT_LT(worst, 6e-4f) << "of half floats 0.05 %: " << side << " texels, map " << map;
        }
    }
}

TEST_F(MapDrawerTest, CellsAndFarthestDistancesAreThoseOfTheProcessor) {
    const scene::Stage stage = furnished();
    const std::vector<glm::vec3> places_m{{0, 0, 3}, {-2, 1.3f, 1}};
    for (const std::uint32_t side : {64u, 128u, 256u, 512u, 2048u}) {
        const auto images = drawn(stage, side, places_m);
        for (std::uint32_t map = 0; map < places_m.size(); ++map) {
            const std::vector<std::uint16_t> texels = texels_of<std::uint16_t>(images->texture(), map);
            const std::vector<std::vector<Blockers>> wanted = blockers_of(texels, side);
            ASSERT_EQ(images->blockers().shape().levels, wanted.size());
            std::size_t rounded = 0, count = 0;
            for (std::uint32_t level = 0; level < wanted.size(); ++level) {
                const std::vector<Blockers> is = texels_of<Blockers>(images->blockers(), map, level);
                ASSERT_EQ(is.size(), wanted[level].size());
                for (std::size_t k = 0; k < is.size(); ++k) {
                    const Blockers &a = is[k], &b = wanted[level][k];
                    ++count;
                    ASSERT_EQ(a.near_from, b.near_from) << side << " level " << level << " cell " << k;
                    ASSERT_EQ(a.near_to, b.near_to) << side << " level " << level << " cell " << k;
                    ASSERT_EQ(a.far_to, b.far_to) << side << " level " << level << " cell " << k;
                    // Where the other group begins is a quotient, rounded down to a step.
                    const float off = std::abs(glm::unpackHalf1x16(a.parts) - glm::unpackHalf1x16(b.parts));
                    ASSERT_LE(off, 1.0f) << side << " level " << level << " cell " << k;
                    rounded += off > 0 ? 1 : 0;
                }
            }
            EXPECT_LE(rounded, count / 1000);
            shared::Light light{};
            light.map = map + 1;
            light.cut_radius = 1;
            const FarParts parts = far_parts(texels, side);
            for (const float tan_field : {0.05f, 0.4f, 2.0f})
                for (const glm::vec3& axis :
                     {glm::vec3(0, 0, -1), glm::vec3(0.6f, 0, -0.8f), glm::vec3(0, 0.8f, 0.6f)}) {
                    light.axis_w = axis;
                    light.tan_field = tan_field;
                    EXPECT_EQ(images->reach_m(light), reach_in(parts, light)) << side;
                }
        }
    }
}

TEST_F(MapDrawerTest, OtherBlocksStay) {
    constexpr std::uint32_t kMapSide = 256, kAcross = kMapSide / shared::kMapBlock;
    scene::Stage stage = furnished();
    Report report;
    StageModel model(device(), stage, report);
    DistanceImages images(device(), empty_maps(kMapSide, 2), DistanceImages::Made::by_the_device);
    const std::vector<int> all = all_blocks(kMapSide), some{9, 10, 27, 36, 37, 63};
    images.draw(model, {{0, {0, 0, 3}, all}, {1, {1, 0, 3}, all}});
    const std::vector<std::uint16_t> before = texels_of<std::uint16_t>(images.texture(), 1);
    for (std::size_t k = 1; k < stage.instances.size(); ++k) model.show(k, false);
    images.draw(model, {{1, {-1, 0.5f, 2}, some}});
    const std::vector<std::uint16_t> after = texels_of<std::uint16_t>(images.texture(), 1);
    scene::Stage bare;
    add(bare, box_of(kHalf_m), {0, 0, 2});
    const auto anew = drawn(bare, kMapSide, {{-1, 0.5f, 2}});
    const std::vector<std::uint16_t> empty = texels_of<std::uint16_t>(anew->texture(), 0);
    for (std::uint32_t k = 0; k < kMapSide * kMapSide; ++k) {
        const auto block =
            static_cast<int>(k / kMapSide / shared::kMapBlock * kAcross + k % kMapSide / shared::kMapBlock);
        const bool is_drawn = std::find(some.begin(), some.end(), block) != some.end();
        ASSERT_EQ(after[k], is_drawn ? empty[k] : before[k]) << k;
    }
    const std::vector<std::vector<Blockers>> wanted = blockers_of(after, kMapSide);
    const std::vector<Blockers> coarsest =
        texels_of<Blockers>(images.blockers(), 1, static_cast<std::uint32_t>(wanted.size()) - 1);
    for (std::size_t k = 0; k < coarsest.size(); ++k)
        EXPECT_EQ(coarsest[k].far_to, wanted.back()[k].far_to) << "cells of blocks that changed in part";
    EXPECT_EQ(texels_of<std::uint16_t>(images.texture(), 0),
              texels_of<std::uint16_t>(drawn(stage, kMapSide, {{0, 0, 3}})->texture(), 0))
        << "the other map";
}

TEST_F(MapDrawerTest, WhatStopsNoLightAndWhatIsNoPlace) {
    constexpr std::uint32_t kMapSide = 64;
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                endless = std::numeric_limits<float>::infinity();
    scene::Stage stage;
    add(stage, box_of({1, 1, 1}), {0, 0, 0}, 3); // a body
    scene::Mesh flat = box_of({1, 1, 1});
    for (glm::vec3& position : flat.positions) position.z = 0, position.y = 0;
    add(stage, flat, {0, 0, -1}); // lines
    scene::Mesh bad = box_of({1, 1, 1});
    for (glm::vec3& position : bad.positions) position.x = nan;
    add(stage, bad, {0, 0, -1});
    add(stage, {}, {0, 0, -1}); // no triangle
    scene::Mesh wrong = box_of({1, 1, 1});
    wrong.indices[0] = 1000;
    add(stage, wrong, {0, 0, -1});
    add(stage, box_of({1, 1, 1}), {nan, 0, 0}); // nowhere
    const auto images = drawn(stage, kMapSide, {{0, 0, 0}, {nan, 0, 0}, {0, endless, 0}, {0, 0, 1e6f}});
    for (std::uint32_t map = 0; map < 4; ++map)
        for (const std::uint16_t texel : texels_of<std::uint16_t>(images->texture(), map))
            ASSERT_EQ(texel, scene::kNoSurface) << map;
    const auto nothing = drawn({}, kMapSide, {{0, 0, 0}});
    for (const std::uint16_t texel : texels_of<std::uint16_t>(nothing->texture(), 0))
        ASSERT_EQ(texel, scene::kNoSurface);
}

TEST_F(MapDrawerTest, HolesAndWhatIsHalfThere) {
    constexpr std::uint32_t kMapSide = 256;
    struct Kind {
        scene::AlphaMode mode;
        float alpha;
        bool stops;
    };
    for (const auto& [mode, alpha, stops] : {Kind{scene::AlphaMode::opaque, 0.1f, true},
                                             {scene::AlphaMode::mask, 0.49f, false},
                                             {scene::AlphaMode::mask, 0.5f, true},
                                             {scene::AlphaMode::blend, 0.5f, false},
                                             {scene::AlphaMode::blend, 0.51f, true}}) {
        scene::Stage stage;
        stage.materials.emplace_back();
        stage.materials[0].alpha_mode = mode;
        stage.materials[0].alpha = alpha;
        stage.materials[0].alpha_cutoff = 0.5f;
        add(stage, box_of({1, 1, 1}), {0, 0, 0});
        const std::vector<std::uint16_t> texels =
            texels_of<std::uint16_t>(drawn(stage, kMapSide, {{0, 0, 0}})->texture(), 0);
        const auto is_met = [](std::uint16_t texel) { return texel != scene::kNoSurface; };
        EXPECT_EQ(std::all_of(texels.begin(), texels.end(), is_met), stops);
        EXPECT_EQ(std::none_of(texels.begin(), texels.end(), is_met), !stops);
    }
}

TEST_F(MapDrawerTest, MoreMapsThanLayersThatAreDrawnAtOnce) {
    constexpr std::uint32_t kMapSide = 64, kMaps = 37;
    std::vector<glm::vec3> places_m;
    for (std::uint32_t k = 0; k < kMaps; ++k)
        places_m.emplace_back(-1 + 0.05f * static_cast<float>(k), 0.3f, 2.2f);
    const scene::Stage stage = furnished();
    const auto images = drawn(stage, kMapSide, places_m);
    for (const std::uint32_t map : {0u, 15u, 16u, 36u})
        EXPECT_EQ(texels_of<std::uint16_t>(images->texture(), map),
                  texels_of<std::uint16_t>(drawn(stage, kMapSide, {places_m[map]})->texture(), 0))
            << map;
}

// The device that lacks something has maps all the same, which others make.
TEST(MapDrawer, WhatADeviceLacksIsSaid) {
    for (const auto& [limits, word] :
         {std::pair<gpu::LoweredLimits, std::string>{{{"maxClipDistances", 0}}, "maxClipDistances"},
          {{{"maxFramebufferLayers", 1}}, "shaderOutputLayer"}}) {
        const auto lowered = must(gpu::Device::create({.validation = true, .lowered_limits = limits}));
        DistanceImages images(*lowered, empty_maps(64, 1), DistanceImages::Made::by_the_device);
        EXPECT_FALSE(images.can_draw());
        EXPECT_NE(images.lack().find(word), std::string::npos) << images.lack();
        images.set(0, std::vector<std::uint16_t>(64 * 64, 0x3c00));
        images.finish();
        EXPECT_EQ(lowered->validation_errors(), 0u);
    }
    DistanceImages small(device(), empty_maps(32, 1), DistanceImages::Made::by_the_device);
    EXPECT_FALSE(small.can_draw());
}

} // namespace
} // namespace ghost::render
