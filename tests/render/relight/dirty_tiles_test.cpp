// SPDX-License-Identifier: Apache-2.0
// Kept images of resting lights while things move before the camera: mended where that is, they give the
// picture that drawing every light anew gives.
#include "render/relight/dirty_tiles.h"

#include "render/relight/relighter.h"
#include "support/g_buffer_picture.h"
#include "support/worker_device.h"

#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace ghost::render {
namespace {

using MenderTest = RelightTest;

constexpr int kLights = 6;
constexpr std::size_t kFirstCross = 2; // instances of room()

scene::Mesh cross_of_quads() {
    scene::Mesh mesh;
    for (const scene::Mesh& one : {quad({-0.5f, 0, -0.5f}, {1, 0.2f, 0}, {0, 0, 1}),
                                   quad({0, -0.5f, -0.5f}, {0.1f, 1, 0}, {0, 0, 1})}) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const std::uint32_t index : one.indices) mesh.indices.push_back(first + index);
        mesh.positions.insert(mesh.positions.end(), one.positions.begin(), one.positions.end());
        mesh.normals.insert(mesh.normals.end(), one.normals.begin(), one.normals.end());
    }
    return mesh;
}

scene::Stage stage_with(int count) {
    scene::Stage stage = room();
    stage.meshes.push_back(cross_of_quads());
    for (int k = 0; k < count; ++k)
        stage.instances.push_back({"cross", static_cast<int>(stage.meshes.size()) - 1,
                                   glm::translate(glm::mat4(1.0f), {2.0f * static_cast<float>(k) - 3, 1, 3}),
                                   scene::kNone});
    return stage;
}

// Narrow and wide ones, side by side from above.
std::vector<shared::Light> lights_at(float turn) {
    std::vector<shared::Light> lights;
    for (int k = 0; k < kLights; ++k) {
        const float x = 2.0f * static_cast<float>(k) - 5;
        lights.push_back(
            aimed_light({x, 4, 9}, {x + 2 * turn, 1, 0}, 8.0f + 6.0f * static_cast<float>(k), 20000));
    }
    return lights;
}

Settings settings() {
    Settings all;
    all.haze = {0.03f, 0.03f, 0.77f, -0.6f, 0.035f};
    all.ambient = glm::vec3(5.0f);
    return all;
}

struct Deviation {
    double most = 0;
    double mean = 0;
};

Deviation deviation_of(const image::ImageF& a, const image::ImageF& b) {
    Deviation all;
    for (std::size_t k = 0; k < a.samples.size(); ++k) {
        const double one = std::abs(static_cast<double>(a.samples[k]) - static_cast<double>(b.samples[k])) /
                           (0.5 + std::abs(static_cast<double>(b.samples[k])));
        all.most = std::max(all.most, one);
        all.mean += one / static_cast<double>(a.samples.size());
    }
    return all;
}

class Scene {
public:
    explicit Scene(int moving, const Settings& how = settings(), const gpu::Device& on = device())
        : on_(on), how_(how), model_(on, stage_with(moving), report_), buffer_(on, 192, 96) {
        for (int k = 0; k < moving; ++k) model_.mark_moving(kFirstCross + static_cast<std::size_t>(k));
        buffer_.draw(model_, pose_of(camera_at({0, -10, 3}, {0, 10, 2.5f}, 40, 192, 96)),
                     {how_.ambient, how_.haze});
        relighter_ = fresh(how_);
    }
    std::unique_ptr<Relighter> fresh(const Settings& how) const {
        return std::make_unique<Relighter>(on_, buffer_, nullptr, test_gobos(), kLights, how);
    }
    bool move(int index, const glm::vec3& place_m, float turn_rad) {
        model_.move(kFirstCross + static_cast<std::size_t>(index),
                    glm::rotate(glm::translate(glm::mat4(1.0f), place_m), turn_rad, glm::vec3(0, 0, 1)));
        if (!buffer_.update(model_)) return false;
        relighter_->touch();
        return true;
    }
    FrameStatistics draw(const std::vector<shared::Light>& lights) { return relighter_->draw(lights); }
    // Sums of half floats in another order: 0.05 % each.
    void expect_as_drawn_anew(const std::vector<shared::Light>& lights) const {
        Settings alone = how_;
        alone.workers = false;
        const auto anew = fresh(alone);
        anew->draw(lights);
        const Deviation found = deviation_of(relighter_->frame(), anew->frame());
        EXPECT_LT(found.most, 0.004);
        EXPECT_LT(found.mean, 0.0005);
    }

private:
    const gpu::Device& on_;
    Settings how_;
    Report report_;
    StageModel model_;
    GBuffer buffer_;
    std::unique_ptr<Relighter> relighter_;
};

TEST_F(MenderTest, RestingLightsAreMendedWhereSomethingMoved) {
    Scene scene(3);
    std::vector<shared::Light> lights = lights_at(0);
    EXPECT_EQ(scene.draw(lights).drawn, kLights);
    for (int step = 0; step < 6; ++step) {
        SCOPED_TRACE(step);
        const auto turn = static_cast<float>(step + 1);
        ASSERT_TRUE(scene.move(1, {-1 + 0.2f * turn, 1, 3}, 0.5f * turn));
        lights[2] = lights_at(0.1f * static_cast<float>(step + 1))[2]; // the light of the head that turns
        const FrameStatistics frame = scene.draw(lights);
        if (step > 1) {
            EXPECT_EQ(frame.drawn, 1);
        }
        if (step > 0) { // the first frame draws all lights and keeps none
            EXPECT_GT(frame.mended, 0);
        }
        EXPECT_LT(frame.mended, kLights);
        scene.expect_as_drawn_anew(lights);
    }
    // Nothing moves: nothing is mended.
    EXPECT_EQ(scene.draw(lights).mended, 0);
}

TEST_F(MenderTest, LightAtHalfTheSizeIsMendedLikewise) {
    Settings coarse = settings();
    coarse.coarse = true;
    Scene scene(3, coarse);
    std::vector<shared::Light> lights = lights_at(0);
    scene.draw(lights);
    for (int step = 0; step < 4; ++step) {
        SCOPED_TRACE(step);
        ASSERT_TRUE(scene.move(1, {-1 + 0.2f * static_cast<float>(step + 1), 1, 3}, 0.5f));
        lights[2] = lights_at(0.1f * static_cast<float>(step + 1))[2];
        const FrameStatistics frame = scene.draw(lights);
        if (step > 0) {
            EXPECT_GT(frame.mended, 0);
        }
        scene.expect_as_drawn_anew(lights);
    }
}

TEST_F(MenderTest, AMoveAloneMakesAnotherFrame) {
    Scene scene(1);
    std::vector<shared::Light> lights = lights_at(0);
    scene.draw(lights);
    lights[5] = lights_at(0.2f)[5]; // now the others are kept
    scene.draw(lights);
    ASSERT_TRUE(scene.move(0, {0, 2, 2}, 1));
    const FrameStatistics frame = scene.draw(lights);
    EXPECT_EQ(frame.changed, 0);
    EXPECT_EQ(frame.drawn, 1) << "only the one without an image";
    EXPECT_GT(frame.mended, 0);
    scene.expect_as_drawn_anew(lights);
}

// What changes, moves and goes dark is drawn at random, and is at the end as if drawn at once.
void expect_any_order_does(const Settings& how, const gpu::Device& on) {
    Scene scene(4, how, on);
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<float>(random() >> 8) / 16777216.0f; };
    std::vector<shared::Light> lights = lights_at(0);
    for (int step = 0; step < 14; ++step) {
        SCOPED_TRACE(step);
        for (int k = 0; k < kLights; ++k)
            if (unit() < 0.3f)
                lights[static_cast<std::size_t>(k)] = lights_at(unit())[static_cast<std::size_t>(k)];
        if (unit() < 0.3f) lights[0].intensity_cd = glm::vec3(0.0f);
        for (int k = 0; k < 4; ++k)
            if (unit() < 0.5f) scene.move(k, {8 * unit() - 4, 8 * unit() - 4, 5 * unit()}, 6 * unit());
        if (unit() < 0.7f) scene.draw(lights);
    }
    scene.draw(lights);
    scene.expect_as_drawn_anew(lights);
}

Settings with_few_images() {
    Settings few = settings();
    few.image_memory_bytes = std::uint64_t{192} * 96 * 8 * 4; // four images
    return few;
}

TEST_F(MenderTest, AnythingMayChangeInAnyOrder) {
    for (const Settings& how : {settings(), with_few_images()}) expect_any_order_does(how, device());
}

TEST_F(MenderTest, AnythingMayChangeWhereWorkersDraw) {
    const gpu::Device* on = kWorkerDevice->get();
    if (!on) GTEST_SKIP() << "a graphics card draws here, or LP_NUM_THREADS is set: there are no workers";
    Settings coarse = settings();
    coarse.coarse = true;
    for (Settings how : {settings(), with_few_images(), coarse}) {
        how.workers = true;
        expect_any_order_does(how, *on);
    }
    for (const auto& worker : on->workers()) EXPECT_GT(worker->work().dispatches, 50u) << "they drew";
    EXPECT_EQ(on->validation_errors(), 0u);
}

TEST_F(MenderTest, OnlyLightsThatMayBeSeenThereCount) {
    const shared::View view = [] {
        GBuffer buffer(device(), 192, 96);
        Report report;
        const StageModel model(device(), room(), report);
        buffer.draw(model, pose_of(camera_at({0, -10, 3}, {0, 10, 3}, 40, 192, 96)), {});
        return buffer.fragments().camera;
    }();
    const PixelRect left{40, 40, 56, 56}, right{176, 40, 192, 56}, all{0, 0, 192, 96};
    const shared::Light beam = aimed_light({-6, 6, 9}, {-6, 6, 0}, 6, 1000); // down, on the left
    EXPECT_TRUE(may_reach(beam, view, left));
    EXPECT_FALSE(may_reach(beam, view, right));
    EXPECT_TRUE(may_reach(beam, view, all));
    const shared::Light away = aimed_light({0, -12, 3}, {0, -30, 3}, 20, 1000); // behind the camera
    EXPECT_FALSE(may_reach(away, view, left));
    shared::Light dark = beam;
    dark.intensity_cd = glm::vec3(0.0f);
    EXPECT_FALSE(may_reach(dark, view, left));
    EXPECT_TRUE(may_reach(aimed_light({0, -12, 3}, {0, 10, 3}, 20, 1000), view, {88, 40, 104, 56}));
}

} // namespace
} // namespace ghost::render
