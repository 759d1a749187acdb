// SPDX-License-Identifier: Apache-2.0
// Lights beside the place of their distance map, as the cells of a bar are: where nothing is in the way the
// picture is the one with a map of their own, and shadows are where the map's place throws them.
#include "beam_groups/beam_groups.h"
#include "support/thesis_scene.h"

namespace ghost::app {
namespace {

constexpr float kCellLamp_m = 8, kCellPlate_m = 5; // above the floor
constexpr int kSharedMapSize = 1024;

scene::Stage floor_and_wall() {
    scene::Stage stage = empty_stage();
    add_box(stage, {-30, -30, -0.2f}, {30, 30, 0});
    add_box(stage, {-30, 6, 0}, {30, 6.2f, 12});
    return stage;
}

shared::Light lamp(float aside_m, bool own_map) {
    shared::Light light = aimed_light({aside_m, 0, kCellLamp_m}, {aside_m, 2, 0}, 40, true);
    light.disc_radius_m = 0.02f;
    if (!own_map) light.off_map_m = {aside_m, 0, 0};
    return light;
}

double psnr_of(const scene::Stage& stage, float aside_m, bool air) {
    render::Settings settings = bench_settings();
    settings.air = air;
    settings.surfaces = !air;
    const LiveStage::Eye eye{{3, -9, 3}, {0, 2, 2}, 50};
    LiveStage own(stage, {lamp(aside_m, true)}, 192, 128, settings, kSharedMapSize);
    LiveStage shared(stage, {lamp(aside_m, false)}, 192, 128, settings, kSharedMapSize);
    own.look(eye);
    shared.look(eye);
    return likeness(shared.draw(), own.draw()).psnr_db;
}

TEST(SharedMap, NothingInTheWayNothingChanges) {
    const scene::Stage stage = floor_and_wall();
    for (const float aside_m : {0.1f, scene::kMapShare_m}) {
        const double surfaces = psnr_of(stage, aside_m, false), air = psnr_of(stage, aside_m, true);
        std::printf("%.2f m beside its map: surfaces %.1f dB, haze %.1f dB\n", double{aside_m}, surfaces,
                    air);
        EXPECT_GT(surfaces, 60);
        EXPECT_GT(air, 50);
    }
}

// Where the floor begins to be lit, along X; the plate ends at 0.
double edge_m(float aside_m, bool own_map) {
    scene::Stage stage = empty_stage();
    add_box(stage, {-30, -30, -0.2f}, {30, 30, 0});
    add_box(stage, {-10, -10, kCellPlate_m - 0.005f}, {0, 10, kCellPlate_m + 0.005f});
    shared::Light light = lamp(aside_m, own_map);
    render::Settings settings = bench_settings();
    settings.air = false;
    LiveStage live(stage, {light}, 256, 8, settings, kSharedMapSize);
    live.look({{0, -3, 3}, {0, 0, 0}, 1.0f});
    const image::ImageF picture = live.draw();
    const double half_m = std::tan(glm::radians(0.5)) * 32 * std::sqrt(18.0);
    const float most = picture.at(255, 4)[1];
    for (int x = 1; x < 256; ++x)
        if (picture.at(x, 4)[1] > 0.5f * most) return (x / 256.0 * 2 - 1) * half_m;
    ADD_FAILURE() << "no light at all";
    return 0;
}

TEST(SharedMap, AShadowIsBesideItsPlaceAsSimilarTrianglesSay) {
    for (const float aside_m : {0.1f, scene::kMapShare_m}) {
        const double own = edge_m(aside_m, true), shared = edge_m(aside_m, false);
        const double expected = double{aside_m * kCellPlate_m / (kCellLamp_m - kCellPlate_m)};
        std::printf(
            "%.2f m beside its map: a shadow of what is 3 m away, on a floor 8 m away, is off by %.3f m\n",
            double{aside_m}, shared - own);
        EXPECT_NEAR(own, -expected, 0.04);
        EXPECT_NEAR(shared, 0.0, 0.04);
    }
}

} // namespace
} // namespace ghost::app
