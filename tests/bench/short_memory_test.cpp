// SPDX-License-Identifier: Apache-2.0
// 400 lights on devices with less and less memory: the picture gets coarser, one line says what was lowered,
// nothing fails.
#include "bench/bench_views.h"
#include "gpu/device_memory.h"
#include "render/haze/memory_order.h"
#include "support/live_picture.h"
#include "support/must.h"

#include <algorithm>
#include <optional>

namespace ghost::app {
namespace {

constexpr int kLights = 400;
constexpr int kMapSide = 128;
constexpr std::uint64_t kMB = 1u << 20;

struct Scene {
    scene::Stage stage = empty_stage();
    scene::Camera camera;
    std::vector<shared::Light> lights;
    scene::DistanceMaps maps;
};

const Scene& scene_of_400() {
    static const Scene one = [] {
        Scene made;
        add_box(made.stage, {-12, -12, -0.2f}, {12, 8, 0});
        add_box(made.stage, {-12, 8, 0}, {12, 8.2f, 10});
        for (int k = 0; k < 6; ++k) {
            const float x = 3.0f * static_cast<float>(k) - 8;
            add_box(made.stage, {x, 1, 0}, {x + 0.8f, 1.8f, 2.5f});
        }
        made.camera.position_m = {0, -11, 3};
        made.camera.target_m = {0, 3, 2.5f};
        made.camera.fov_y_deg = 50;
        made.camera.width = 96;
        made.camera.height = 54;
        for (int k = 0; k < kLights; ++k) {
            const float x = static_cast<float>(k % 40) * 0.5f - 10;
            const float y = static_cast<float>(k / 40) * 0.8f - 2;
            shared::Light light = aimed_light({x, y, 7}, {x * 0.6f, y + 1.5f, 0}, 12, k % 2 == 0);
            light.intensity_cd *= 0.05f;
            made.lights.push_back(light);
        }
        const bake::Tracer tracer(made.stage);
        made.maps = trace_maps(tracer, made.lights, kMapSide);
        return made;
    }();
    return one;
}

struct Outcome {
    image::ImageF picture;
    std::uint64_t before_bytes = 0; // stage and camera, which cannot be lowered
    std::uint64_t used_bytes = 0;
    std::uint32_t side = 0;
    std::string messages;
};

Outcome drawn_with(std::uint64_t limit_bytes, const scene::DistanceMaps& maps = scene_of_400().maps,
                   std::uint32_t lights_per_dispatch = 0) {
    const auto device = must(gpu::Device::create({.validation = true, .memory_limit_bytes = limit_bytes}));
    const gpu::Device& gpu = *device;
    const Scene& scene = scene_of_400();
    Outcome outcome;
    testing::internal::CaptureStderr();
    {
        Report report;
        const render::StageModel model(gpu, scene.stage, report);
        render::GBuffer g_buffer(gpu, scene.camera.width, scene.camera.height);
        render::Settings settings = bench_settings();
        settings.image_memory_bytes = 64 * kMB;
        settings.lights_per_dispatch = lights_per_dispatch;
        g_buffer.draw(model,
                      {scene::camera_to_world(scene.camera), scene.camera.fov_y_deg, scene.camera.width,
                       scene.camera.height},
                      {glm::vec3(0), settings.haze});
        outcome.before_bytes = gpu.memory().used_bytes();
        const render::DistanceImages distances(gpu, maps);
        outcome.side = distances.side();
        shared::Gobos gobos = bench_gobos();
        render::Relighter relighter(gpu, g_buffer, &distances, gobos, kLights, settings);
        outcome.used_bytes = gpu.memory().used_bytes();
        // Two frames, so that kept images are used.
        std::vector<shared::Light> lights = scene.lights;
        relighter.draw(lights);
        lights[7].intensity_cd *= 2.0f;
        EXPECT_GT(relighter.draw(lights).drawn, 0);
        outcome.picture = relighter.frame();
    }
    outcome.messages = testing::internal::GetCapturedStderr();
    EXPECT_EQ(gpu.validation_errors(), 0u);
    EXPECT_EQ(gpu.memory().used_bytes(), 0u);
    return outcome;
}

std::size_t warnings_in(const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("warning:"); at != std::string::npos; at = text.find("warning:", at + 1))
        ++count;
    return count;
}

// The same maps with so many texels a side, the middle ones of what one stands for.
scene::DistanceMaps thinned(const scene::DistanceMaps& maps, std::uint32_t side) {
    scene::DistanceMaps thin;
    thin.size = static_cast<int>(side);
    const auto size = static_cast<std::size_t>(maps.size);
    const std::size_t step = size / side;
    for (const scene::DistanceMap& map : maps.maps) {
        scene::DistanceMap made;
        made.fixture = map.fixture;
        made.position_m = map.position_m;
        for (std::size_t y = step / 2; y < size; y += step)
            for (std::size_t x = step / 2; x < size; x += step)
                made.distance.push_back(map.distance[y * size + x]);
        scene::measure(made);
        thin.maps.push_back(std::move(made));
    }
    return thin;
}

// Mean difference as a share of the mean.
double apart(const image::ImageF& a, const image::ImageF& b) {
    double sum = 0, difference = 0;
    for (std::size_t k = 0; k < a.samples.size(); ++k) {
        sum += b.samples[k];
        difference += std::abs(a.samples[k] - b.samples[k]);
    }
    return difference / sum;
}

TEST(ShortMemory, four_hundred_lights_are_drawn_with_less) {
    const Outcome all = drawn_with(0);
    EXPECT_EQ(all.side, static_cast<std::uint32_t>(kMapSide));
    EXPECT_EQ(all.messages, "");
    const std::uint64_t lights_bytes = all.used_bytes - all.before_bytes;
    std::uint32_t side = all.side;
    std::optional<Outcome> coarser;               // with all memory
    for (const double share : {0.2, 0.1, 0.08}) { // without tables, which go first, twice as much and more
        const std::uint64_t limit =
            all.before_bytes + static_cast<std::uint64_t>(share * static_cast<double>(lights_bytes));
        const Outcome less = drawn_with(limit);
        EXPECT_LE(less.used_bytes, limit);
        EXPECT_LE(less.side, side);
        side = less.side;
        EXPECT_EQ(warnings_in(less.messages), 1u) << less.messages;
        EXPECT_EQ(std::count(less.messages.begin(), less.messages.end(), '\n'), 1) << less.messages;
        EXPECT_NE(less.messages.find("short for 400 lights"), std::string::npos) << less.messages;
        EXPECT_NE(less.messages.find("kept images instead of"), std::string::npos) << less.messages;
        EXPECT_EQ(less.messages.find("shadow maps of") != std::string::npos, less.side < all.side)
            << less.messages;
        // One light more or less is 0.0025 of the picture.
        if (less.side != all.side && (!coarser || coarser->side != less.side))
            coarser = drawn_with(0, thinned(scene_of_400().maps, less.side));
        const double off = apart(less.picture, coarser ? coarser->picture : all.picture);
        std::printf("%.5f apart, %.5f from the picture with all maps\n", off,
                    apart(less.picture, all.picture));
        EXPECT_LT(off, 0.001) << share;
        std::printf("[ %4.1f MB ] %s", static_cast<double>(limit) / kMB, less.messages.c_str());
    }
    EXPECT_LT(side, all.side);
}

// Less and less memory: tables go first, maps when all else has less already, and what was short stays short.
TEST(ShortMemory, what_goes_first_stands_first_in_the_table) {
    const std::uint64_t before = drawn_with(0).before_bytes;
    std::size_t named = 0;
    for (const std::uint64_t mb : {2000, 62, 40, 24}) {
        const Outcome less = drawn_with(before + mb * kMB);
        std::printf("[ %4d MB ] %s", static_cast<int>(mb), less.messages.c_str());
        std::vector<render::Kept> short_of;
        std::size_t last = 0;
        for (const render::MemoryShare& share : render::kMemoryOrder) {
            const std::size_t at = less.messages.find(std::string(share.after) + " instead of");
            if (at == std::string::npos) continue;
            EXPECT_GT(at, last) << less.messages;
            last = at;
            short_of.push_back(share.kept);
        }
        ASSERT_FALSE(short_of.empty()) << mb;
        EXPECT_EQ(short_of.front(), render::Kept::tables);
        EXPECT_EQ(short_of.back() == render::Kept::maps, short_of.size() == 4u) << less.messages;
        EXPECT_GE(short_of.size(), named);
        named = short_of.size();
        EXPECT_EQ(warnings_in(less.messages), 1u);
    }
    EXPECT_EQ(named, 4u) << "all that lights one by one have";
}

// Where many share a dispatch each of them has a table: fewer share one.
TEST(ShortMemory, fewer_lights_are_drawn_at_once) {
    const Outcome all = drawn_with(0, scene_of_400().maps, shared::kLightsPerChunk);
    EXPECT_EQ(all.messages, "");
    const Outcome less =
        drawn_with(all.before_bytes + 100 * kMB, scene_of_400().maps, shared::kLightsPerChunk);
    EXPECT_EQ(less.side, all.side);
    EXPECT_NE(less.messages.find(" lights at once instead of 128"), std::string::npos) << less.messages;
    EXPECT_EQ(warnings_in(less.messages), 1u) << less.messages;
    EXPECT_LT(less.used_bytes, all.before_bytes + 100 * kMB);
    const double off = apart(less.picture, all.picture);
    std::printf("%.5f apart with %s", off, less.messages.c_str());
    EXPECT_LT(off, 0.001);
}

} // namespace
} // namespace ghost::app
