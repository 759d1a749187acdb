// SPDX-License-Identifier: Apache-2.0
// What a remote control and trackers do to a live film of the demo.
#include "cli/render/private/film_controls.h"

#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ghost::app {
namespace {

std::unique_ptr<Session> open_demo(const std::string& view) {
    SessionOptions options;
    options.show = DemoCopy::show();
    options.view = view;
    options.width = 128;
    options.height = 72;
    options.live = true;
    options.shadows = false;
    options.quiet = true;
    options.motion = fixture::Motion::as_commanded;
    options.ev100 = 5.0f;
    return must(open_session(options));
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

double mean(const image::ImageF& picture) {
    return std::accumulate(picture.samples.begin(), picture.samples.end(), 0.0) /
           static_cast<double>(picture.samples.size());
}

double mean(const image::Image8& picture) {
    return std::accumulate(picture.samples.begin(), picture.samples.end(), 0.0) /
           static_cast<double>(picture.samples.size());
}

double difference(const image::ImageF& a, const image::ImageF& b) {
    EXPECT_EQ(a.samples.size(), b.samples.size());
    double most = 0;
    for (std::size_t k = 0; k < a.samples.size(); ++k)
        most = std::max(most, static_cast<double>(std::abs(a.samples[k] - b.samples.at(k)) /
                                                  (1.0f + std::abs(b.samples.at(k)))));
    return most;
}

class FilmControlsTest : public testing::Test {
protected:
    void SetUp() override {
        session_ = open_demo("house");
        ASSERT_TRUE(session_);
        auto controls = FilmControls::open({}, *session_->show, "", 5.0f);
        ASSERT_TRUE(controls.ok());
        controls_ = std::move(*controls);
    }
    image::ImageF draw(const RemoteRequest& request, double now_s = 0) {
        controls_.apply(*session_, request, now_s);
        session_->rig->step(levels(*session_->show), 0.1);
        session_->draw();
        return session_->relighter->frame();
    }
    std::unique_ptr<Session> session_;
    FilmControls controls_;
};

TEST_F(FilmControlsTest, master_and_blackout) {
    RemoteRequest request;
    const double full = mean(draw(request));
    request.blackout = true;
    const double dark = mean(draw(request));
    request.blackout = false;
    request.master = 0.5f;
    const double half = mean(draw(request));
    request.master = 1;
    EXPECT_LT(dark, 0.5 * full);
    EXPECT_NEAR(half, 0.5 * (full + dark), 0.01 * full) << "light is linear";
    EXPECT_NEAR(mean(draw(request)), full, 1e-3 * full);
}

TEST_F(FilmControlsTest, haze) {
    RemoteRequest request;
    const image::ImageF before = draw(request);
    request.haze = 0;
    const image::ImageF clear = draw(request);
    request.haze = 2;
    const double thick = mean(draw(request));
    request.haze = 1;
    // Without haze there are no beams, but more light arrives.
    EXPECT_GT(difference(clear, before), 0.01);
    EXPECT_LT(thick, 0.95 * mean(clear));
    EXPECT_LT(difference(draw(request), before), 0.01);
}

TEST_F(FilmControlsTest, exposure_changes_the_picture_and_not_the_light) {
    RemoteRequest request;
    const image::ImageF light = draw(request);
    const double before = mean(session_->relighter->picture());
    request.ev100 = 3.0f;
    EXPECT_LT(difference(draw(request), light), 1e-3);
    EXPECT_GT(mean(session_->relighter->picture()), 1.05 * before);
    EXPECT_NEAR(static_cast<double>(session_->relighter->ev100_used()), 3.0, 1e-3);
    request.ev100.reset();
    (void)draw(request);
    EXPECT_NEAR(mean(session_->relighter->picture()), before, 0.5);
}

TEST_F(FilmControlsTest, a_camera_is_recalled_at_once_or_flown_to) {
    RemoteRequest request;
    const image::ImageF house = draw(request);
    const auto high = open_demo("high");
    high->rig->step(levels(*high->show), 0.1);
    high->draw();
    const image::ImageF there = high->relighter->frame();
    ASSERT_GT(difference(house, there), 0.1);

    const auto index = session_->show->find_camera("high");
    ASSERT_TRUE(index.ok());
    request.camera = RemoteCamera{*index, 0};
    request.calls = 1;
    EXPECT_LT(difference(draw(request), there), 0.01);
    EXPECT_LT(difference(draw(request), there), 0.01) << "and stays";

    request.camera = RemoteCamera{*session_->show->find_camera("house"), 10};
    request.calls = 2;
    EXPECT_LT(difference(draw(request, 100), there), 0.03) << "the flight begins here";
    const image::ImageF midway = draw(request, 105);
    EXPECT_GT(difference(midway, there), 0.05);
    EXPECT_GT(difference(midway, house), 0.05);
    EXPECT_LT(difference(draw(request, 111), house), 0.01);
}

TEST_F(FilmControlsTest, a_camera_rides_and_then_turns_to_its_tracker) {
    scene::Show& show = *session_->show;
    scene::Camera& home = show.cameras[session_->camera];
    home.mover = 0;
    show.movers.emplace_back().axes.emplace_back().high = 10; // upwards
    session_->rig = std::make_unique<scene::Rig>(show);
    session_->rig->movers().drive(0, {2});
    session_->rig->step({}, 0.1);
    controls_.aim(*session_);
    const glm::vec3 up_m{0, 0, 2};
    EXPECT_LT(glm::distance(session_->live->camera().position_m, home.position_m + up_m), 1e-4f);
    EXPECT_LT(glm::distance(session_->live->camera().target_m, home.target_m + up_m), 1e-4f);

    scene::TrackerUse use;
    use.id = 7;
    use.camera = home.name;
    show.tracking.uses = {use};
    dmx::PsnPacket packet;
    packet.positions.push_back({7, {2.0f, 1.5f, -3.0f}});
    dmx::Trackers trackers;
    trackers.feed(packet, std::chrono::seconds(1));
    controls_.apply(*session_, trackers);
    EXPECT_LT(glm::distance(session_->live->camera().position_m, home.position_m + up_m), 1e-4f);
    EXPECT_LT(glm::distance(session_->live->camera().target_m, glm::vec3(2.0f, 3.0f, 1.5f)), 1e-4f);
}

TEST_F(FilmControlsTest, heads_and_camera_follow_a_tracker) {
    scene::TrackerUse use;
    use.name = "Singer";
    use.offset_m = {0, 0, 0.25f};
    use.camera = session_->live->camera().name;
    use.fixtures = {session_->show->fixtures[0].name};
    session_->show->tracking.uses = {use};
    dmx::Trackers trackers;
    const image::ImageF before = draw({});
    controls_.apply(*session_, trackers);
    EXPECT_LT(difference(draw({}), before), 1e-3) << "nothing was heard yet";

    dmx::PsnPacket packet;
    packet.names[7] = "Singer";
    packet.positions.push_back({7, {2.0f, 1.5f, -3.0f}}); // y up, z towards the audience
    trackers.feed(packet, std::chrono::seconds(1));
    controls_.apply(*session_, trackers);
    session_->rig->step(levels(*session_->show), 0.1);
    const glm::vec3 point_m{2.0f, 3.0f, 1.75f};
    EXPECT_LT(glm::distance(session_->live->camera().target_m, point_m), 1e-4f);
    const std::vector<shared::Light> lights = session_->lit().lights;
    EXPECT_GT(glm::dot(lights[0].axis_w, glm::normalize(point_m - lights[0].position_m)),
              std::cos(glm::radians(0.05f)));
    EXPECT_LT(glm::dot(lights[1].axis_w, glm::normalize(point_m - lights[1].position_m)),
              std::cos(glm::radians(0.5f)));
}

} // namespace
} // namespace ghost::app
