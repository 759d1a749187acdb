// SPDX-License-Identifier: Apache-2.0
// The live view of the demo: heads follow the desk and cost nothing while they rest; distance maps that come
// later give the picture that waiting for them gives.
#include "live/session/live_view.h"

#include "light/bodies.h"
#include "live/session/session.h"
#include "show_folder/load_show.h"
#include "support/demo_copy.h"
#include "support/live_picture.h"
#include "support/must.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

namespace ghost::app {
namespace {

scene::Show demo_show() {
    Report report;
    scene::Show show = must(scene::load_show(DemoCopy::show(), true, report));
    show.distance_map_size = 64;
    return show;
}

scene::Camera camera_of(const scene::Show& show) {
    scene::Camera camera = show.cameras[0];
    camera.width = 256;
    camera.height = 75;
    return camera;
}

// All fixtures lit, half of the range of every axis; the first one turned by so much.
dmx::Universes levels(const scene::Show& show, int turn) {
    dmx::Levels values{};
    for (const scene::PatchedFixture& fixture : show.fixtures) {
        const auto first = static_cast<std::size_t>(fixture.address - 1);
        values[first] = 255;
        values[first + 1] = values[first + 3] = 128;
        values[first + 11] = values[first + 16] = 255;
        if (fixture.type->name.find("Wash") != std::string::npos) values[first + 9] = 255;
    }
    values[static_cast<std::size_t>(show.fixtures[0].address) + 2] = static_cast<std::uint8_t>(128 + turn);
    dmx::Universes universes;
    universes.at(static_cast<std::uint16_t>(show.fixtures[0].universe)).levels =
        std::make_shared<const dmx::Levels>(values);
    return universes;
}

image::ImageF picture_of(const LiveView& view, scene::Rig& rig, const scene::GoboStack& gobos) {
    const std::vector<shared::Light> lights = rig.lights(gobos, view.maps());
    render::Relighter relighter(device(), view.g_buffer(), view.distances(), gobos.images,
                                static_cast<int>(lights.size()), {});
    relighter.draw(lights);
    return relighter.frame();
}

float most_difference(const image::ImageF& a, const image::ImageF& b) {
    EXPECT_EQ(a.samples.size(), b.samples.size());
    float most = 0;
    for (std::size_t k = 0; k < a.samples.size(); ++k)
        most = std::max(most, std::abs(a.samples[k] - b.samples.at(k)) / (1.0f + std::abs(b.samples.at(k))));
    return most;
}

int pixels_in(const std::vector<render::PixelRect>& rects) {
    int sum = 0;
    for (const render::PixelRect& rect : rects) sum += (rect.x1 - rect.x0) * (rect.y1 - rect.y0);
    return sum;
}

TEST(live_heads, FollowTheDeskAndCostNothingAtRest) {
    scene::Show show = demo_show();
    const scene::Camera camera = camera_of(show);
    Report report;
    const auto view = LiveView::open(device(), show, camera, {.shadows = false}, report);
    ASSERT_TRUE(view.ok()) << view.error().text();
    scene::Rig rig(show);
    rig.step(levels(show, 0), 3600);
    rig.step(levels(show, 0), 3600);
    EXPECT_TRUE((*view)->follow(rig)) << "away from home";
    EXPECT_FALSE((*view)->follow(rig));
    rig.step(levels(show, 0), 1.0);
    EXPECT_FALSE((*view)->follow(rig));
    rig.step(levels(show, 60), 3600);
    EXPECT_TRUE((*view)->follow(rig));
    const int changed = pixels_in((*view)->g_buffer().changed());
    EXPECT_GT(changed, 0);
    EXPECT_LT(changed, camera.width * camera.height / 20) << "one head of ten";
    EXPECT_FALSE((*view)->follow(rig));

    // The same as a stage that was made with its heads turned.
    scene::Stage turned = scene::stage_with_bodies(show, report);
    scene::pose_bodies(show, rig, turned);
    render::StageModel model(device(), turned, report);
    for (const std::size_t instance : scene::moving_instances(show, turned)) model.mark_moving(instance);
    render::GBuffer whole(device(), camera.width, camera.height);
    whole.draw(model, {scene::camera_to_world(camera), camera.fov_y_deg, camera.width, camera.height},
               {atmosphere_of(show).ambient, atmosphere_of(show).medium()});
    Report unheard;
    const scene::GoboStack gobos = scene::build_gobos(show, unheard);
    const std::vector<shared::Light> lights = rig.lights(gobos, scene::DistanceMaps{});
    render::Relighter relighter(device(), whole, nullptr, gobos.images, static_cast<int>(lights.size()), {});
    relighter.draw(lights);
    // Positions are rounded differently; on a head's own rim, right before its lens, the beam's edge is
    // steep.
    EXPECT_LT(most_difference(picture_of(**view, rig, gobos), relighter.frame()), 2e-3f);
    EXPECT_EQ(device().validation_errors(), 0u);
}

// A picture that goes on while heads turn, with what it kept, is one that is drawn for the first time; with
// next to no memory, too.
TEST(live_heads, WhatIsKeptGoesWithThem) {
    scene::Show show = demo_show();
    const scene::Camera camera = camera_of(show);
    Report report;
    const auto view = LiveView::open(device(), show, camera, {.quiet = true}, report);
    ASSERT_TRUE(view.ok()) << view.error().text();
    const scene::GoboStack gobos = scene::build_gobos(show, report);
    scene::Rig rig(show);
    rig.step(levels(show, 0), 3600);
    (*view)->follow(rig);
    const int count = static_cast<int>(rig.lights(gobos, (*view)->maps()).size());
    render::Settings much, little; // shaders, which round alike whether anything is kept or not
    much.pixels_on_processor = little.pixels_on_processor = false;
    little.visibility_bytes = 1;
    render::Relighter kept(device(), (*view)->g_buffer(), (*view)->distances(), gobos.images, count, much),
        by_loops(device(), (*view)->g_buffer(), (*view)->distances(), gobos.images, count, {}),
        poor(device(), (*view)->g_buffer(), (*view)->distances(), gobos.images, count, little);
    double made = 0, all = 0;
    for (int frame = 0; frame < 12; ++frame) {
        rig.step(levels(show, 5 * frame), 3600);
        if ((*view)->follow(rig)) {
            kept.touch();
            by_loops.touch();
            poor.touch();
        }
        const std::vector<shared::Light> lights = rig.lights(gobos, (*view)->maps());
        const render::FrameStatistics statistics = kept.draw(lights);
        (void)by_loops.draw(lights);
        (void)poor.draw(lights);
        if (frame > 2) {
            made += statistics.made_units;
            all += statistics.surface_tiles;
        }
        const image::ImageF fresh = picture_of(**view, rig, gobos);
        EXPECT_LT(most_difference(kept.frame(), fresh), 4e-3f) << "frame " << frame;
        EXPECT_EQ(most_difference(poor.frame(), kept.frame()), 0.0f) << "frame " << frame;
        EXPECT_LT(most_difference(by_loops.frame(), kept.frame()), 2e-3f) << "frame " << frame;
    }
    EXPECT_GT(all, 0);
    EXPECT_LT(made, 0.5 * all) << "one head of ten turns";
    // Nothing moves but light: what is asked for again is kept, a part in each frame, and nothing is made any
    // more.
    constexpr int kFramesUntilKept = 8;
    std::vector<shared::Light> lights = rig.lights(gobos, (*view)->maps());
    const auto narrower = [&] {
        for (shared::Light& light : lights) light.tan_field *= 0.98f;
        const render::FrameStatistics statistics = kept.draw(lights);
        EXPECT_GT(statistics.surface_tiles, 0);
        return statistics.made_units + statistics.direct_units;
    };
    int frames = 1;
    while (narrower() > 0 && frames < kFramesUntilKept) ++frames;
    EXPECT_LT(frames, kFramesUntilKept);
    for (int frame = 0; frame < 2; ++frame) EXPECT_EQ(narrower(), 0);
    EXPECT_LT(poor.memory_bytes(), kept.memory_bytes());
    EXPECT_EQ(device().validation_errors(), 0u);
}

TEST(live_heads, MapsThatComeLaterGiveTheSamePicture) {
    scene::Show show = demo_show();
    const scene::Camera camera = camera_of(show);
    std::filesystem::remove_all(show.cache_folder() / "distances");
    Report report;
    scene::Rig rig(show);
    rig.step(levels(show, 20), 3600);
    const scene::GoboStack gobos = scene::build_gobos(show, report);

    const auto later = LiveView::open(device(), show, camera, {.maps_in_background = true}, report);
    ASSERT_TRUE(later.ok()) << later.error().text();
    EXPECT_EQ((*later)->missing_maps(), show.fixtures.size()) << "none is waited for";
    for (const shared::Light& light : rig.lights(gobos, (*later)->maps())) EXPECT_EQ(light.map, 0u);
    const image::ImageF bare = picture_of(**later, rig, gobos);
    while ((*later)->is_making_maps()) {
        EXPECT_FALSE((*later)->take_maps(report)) << "nothing is replaced";
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ((*later)->missing_maps(), 0u);

    const auto waited = LiveView::open(device(), show, camera, {.quiet = true}, report);
    const auto open = LiveView::open(device(), show, camera, {.shadows = false}, report);
    ASSERT_TRUE(waited.ok() && open.ok());
    const image::ImageF shadows = picture_of(**waited, rig, gobos);
    EXPECT_EQ(most_difference(picture_of(**later, rig, gobos), shadows), 0.0f);
    EXPECT_LT(most_difference(bare, picture_of(**open, rig, gobos)), 0.01f) << "no map, no shadow";
    EXPECT_GT(most_difference(bare, shadows), 0.1f) << "there are no shadows here: the test tests nothing";

    // Another start finds them all.
    const auto again = LiveView::open(device(), show, camera, {.maps_in_background = true}, report);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ((*again)->missing_maps(), 0u);
    EXPECT_EQ(most_difference(picture_of(**again, rig, gobos), shadows), 0.0f);
    EXPECT_EQ(device().validation_errors(), 0u);
}

} // namespace
} // namespace ghost::app
