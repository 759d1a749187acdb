// SPDX-License-Identifier: Apache-2.0
// Objects that go with a tracker: the picture, shadows included, is that of a show in which they stand there.
#include "live/engine/followers.h"

#include "disk/files.h"
#include "live/session/live_view.h"
#include "show_folder/load_show.h"
#include "support/demo_copy.h"
#include "support/live_picture.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kWho = {"performer_singer", "mic_in_hand"};

scene::Show demo_show() {
    Report report;
    scene::Show show = must(scene::load_show(DemoCopy::show(), true, report));
    show.distance_map_size = 256;
    return show;
}

scene::Camera camera_of(const scene::Show& show) {
    scene::Camera camera = show.cameras[1]; // close
    camera.width = 256;
    camera.height = 144;
    return camera;
}

// All lamps lit, heads in the middle.
dmx::Universes levels(const scene::Show& show) {
    dmx::Levels values{};
    for (const scene::PatchedFixture& fixture : show.fixtures) {
        const auto first = static_cast<std::size_t>(fixture.address - 1);
        values[first] = 255;
        values[first + 1] = values[first + 3] = 128;
        values[first + 11] = values[first + 16] = 255;
    }
    dmx::Universes universes;
    universes.at(static_cast<std::uint16_t>(show.fixtures[0].universe)).levels =
        std::make_shared<const dmx::Levels>(values);
    return universes;
}

// A show, lit, and its view; the addresses must stay.
struct Stage {
    explicit Stage(scene::Show opened) : show(std::move(opened)), rig(show) {
        view = must(LiveView::open(device(), show, camera_of(show), {true, false, true, false}, report));
        gobos = scene::build_gobos(show, report);
        show.motion = fixture::Motion::as_commanded;
        const glm::vec3 aim_m{-0.75f, 2.0f, 1.2f};
        for (std::size_t i = 0; i < show.fixtures.size(); ++i) rig.aim_at(i, aim_m);
        rig.step(levels(show), 0.1);
        view->follow(rig);
    }
    image::ImageF picture() {
        const std::vector<shared::Light> lights = rig.lights(gobos, view->maps());
        render::Relighter relighter(device(), view->g_buffer(), view->distances(), gobos.images,
                                    static_cast<int>(lights.size()), {});
        relighter.draw(lights);
        return relighter.frame();
    }
    // Until all maps are those of now.
    bool settle() {
        view->follow(rig);
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
        do {
            (void)view->take_maps(report);
            if (!view->is_making_maps()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        } while (std::chrono::steady_clock::now() < end);
        return false;
    }
    Report report;
    scene::Show show;
    scene::Rig rig;
    scene::GoboStack gobos;
    std::unique_ptr<LiveView> view;
};

// Share of the samples that differ by more than a fiftieth of the brightest tenth.
double differing(const image::ImageF& a, const image::ImageF& b) {
    EXPECT_EQ(a.samples.size(), b.samples.size());
    std::vector<float> sorted = a.samples;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10),
                     sorted.end());
    const float step = sorted[sorted.size() * 9 / 10] / 50;
    std::size_t count = 0;
    for (std::size_t k = 0; k < a.samples.size(); ++k)
        count += std::abs(a.samples[k] - b.samples.at(k)) > step ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(a.samples.size());
}

TEST(Followers, an_object_goes_with_its_tracker_and_so_does_its_shadow) {
    const glm::vec3 by_m{1.2f, -0.6f, 0.0f};
    scene::Show there = demo_show();
    for (const std::string& name : kWho) {
        scene::ObjectSettings moved;
        moved.name = name;
        moved.move_m = by_m;
        there.objects.push_back(moved);
    }
    Stage expected(std::move(there));
    ASSERT_FALSE(expected.report.lost_anything());

    const fs::path maps = DemoCopy::show() / ".ghost" / "distances" / "256";
    ASSERT_TRUE(fs::is_directory(maps)) << "those of the show that was opened first";
    ASSERT_TRUE(write_file_atomic(maps / "stranger", std::string_view("no map")).ok());
    Stage tracked(demo_show());
    const image::ImageF before = tracked.picture();
    const image::ImageF wanted = expected.picture();
    const double apart = differing(before, wanted);
    EXPECT_GT(apart, 0.01) << "it must be seen that somebody moved";

    std::uint64_t steps = kMostMatchSteps;
    const std::vector<std::size_t> who = tracked.view->objects_named(kWho, steps);
    ASSERT_GE(who.size(), kWho.size());
    const auto home_m = tracked.view->track(who);
    ASSERT_TRUE(home_m.has_value());
    tracked.view->move_tracked(who, by_m);
    ASSERT_TRUE(tracked.settle());
    EXPECT_LT(differing(tracked.picture(), wanted), 0.02 * apart);
    const fs::path moved = DemoCopy::show() / ".ghost" / "tracked" / "distances" / "256";
    EXPECT_TRUE(fs::exists(moved / "stage.json"));
    EXPECT_FALSE(fs::exists(moved / "stranger")) << "no map is copied for one";
    // And back again.
    tracked.view->move_tracked(who, glm::vec3(0));
    ASSERT_TRUE(tracked.settle());
    EXPECT_LT(differing(tracked.picture(), before), 0.02 * apart);
    EXPECT_TRUE(tracked.view->objects_named({"nobody*"}, steps).empty());
    EXPECT_FALSE(tracked.view->track({}).has_value());
    steps = 1;
    EXPECT_TRUE(tracked.view->objects_named({"*"}, steps).empty());
    EXPECT_EQ(steps, 0u);
}

TEST(Followers, a_camera_turns_to_its_tracker) {
    scene::Show show;
    scene::TrackerUse use;
    use.id = 3;
    use.camera = "close";
    use.offset_m = {0, 0, 0.5f};
    show.tracking.uses = {use};
    scene::Camera camera;
    camera.name = "close";
    dmx::Trackers trackers;
    EXPECT_EQ(follow(camera, show, trackers).target_m, camera.target_m);
    dmx::PsnPacket packet;
    packet.positions.push_back({3, {1.0f, 2.0f, -3.0f}});
    trackers.feed(packet, std::chrono::seconds(1));
    EXPECT_EQ(follow(camera, show, trackers).target_m, glm::vec3(1.0f, 3.0f, 2.5f));
    camera.name = "another";
    EXPECT_EQ(follow(camera, show, trackers).target_m, camera.target_m);
}

// Of one that looks there the picture would be of no numbers, which nothing draws.
TEST(Followers, a_place_that_is_no_place_of_a_stage_is_said_once_and_nothing_goes_there) {
    SessionOptions opening;
    opening.show = DemoCopy::show().string();
    opening.view = "close";
    opening.width = 64;
    opening.height = 36;
    opening.map_size = 256;
    opening.quiet = opening.live = true;
    const auto session = must(open_session(opening));
    scene::TrackerUse use;
    use.id = 3;
    use.camera = "close";
    use.fixtures = {session->show->fixtures[0].name};
    session->show->tracking.uses = {use};
    const scene::Camera camera = session->live->camera();
    for (const float far_m : {1e20f, -1e38f, 12'000.0f}) {
        Followers followers;
        const std::size_t said = session->report.messages.size();
        dmx::Trackers trackers;
        dmx::PsnPacket packet;
        packet.positions.push_back({3, {far_m, 0, 0}});
        trackers.feed(packet, std::chrono::seconds(1));
        EXPECT_EQ(follow(camera, *session->show, trackers).target_m, camera.target_m);
        for (int frame = 0; frame < 3; ++frame) followers.apply(*session, trackers);
        ASSERT_EQ(session->report.messages.size(), said + 1);
        EXPECT_NE(session->report.messages.back().what.find("10 km"), std::string::npos);
        session->rig->step({}, 0.1);
        (void)session->draw(0);
    }
}

} // namespace
} // namespace ghost::app
