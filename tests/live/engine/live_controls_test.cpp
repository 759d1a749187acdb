// SPDX-License-Identifier: Apache-2.0
// What a remote control and trackers put into a session, and what is said of it; tests/cli/render has what a
// film makes of it.
#include "live/engine/live_controls.h"

#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace ghost::app {
namespace {

std::unique_ptr<Session> open_demo() {
    SessionOptions options;
    options.show = DemoCopy::show();
    options.width = 64;
    options.height = 36;
    options.live = true;
    options.shadows = false;
    options.quiet = true;
    options.motion = fixture::Motion::as_commanded;
    return must(open_session(options));
}

bool is_news(const RemoteNews& news) {
    return news.camera || news.jump || news.haze;
}

TEST(LiveControls, each_thing_that_is_asked_for_is_news_once) {
    const auto session = open_demo();
    LiveControls controls;
    RemoteRequest request;
    EXPECT_FALSE(is_news(controls.take(request, *session)));

    request.camera = RemoteCamera{1, 2};
    request.calls = 1;
    RemoteNews news = controls.take(request, *session);
    EXPECT_TRUE(news.camera && !news.jump && !news.haze);
    EXPECT_FALSE(is_news(controls.take(request, *session)));
    request.calls = 2; // of the same one
    EXPECT_TRUE(controls.take(request, *session).camera);

    request.at_s = 12;
    request.jumps = 1;
    news = controls.take(request, *session);
    EXPECT_TRUE(!news.camera && news.jump && !news.haze);

    request.haze = 3;
    news = controls.take(request, *session);
    EXPECT_TRUE(!news.camera && !news.jump && news.haze);
    EXPECT_EQ(session->haze_density, 3.0f);

    request.master = 0.5f;
    request.ev100 = 7.0f;
    EXPECT_FALSE(is_news(controls.take(request, *session))) << "these are asked for in each frame";
    EXPECT_EQ(controls.remote().light(), 0.5f);
    EXPECT_EQ(controls.remote().ev100, 7.0f);
    EXPECT_EQ(controls.remote().at_s, 12);
}

TEST(LiveControls, without_a_remote_control_or_trackers_nothing_is_heard) {
    const auto session = open_demo();
    session->haze_density = 2;
    LiveControls controls;
    controls.begin(*session, LiveControls::Of::another_show);
    EXPECT_FALSE(is_news(controls.hear_remote(*session, 0)));
    EXPECT_EQ(controls.hear_trackers(*session), nullptr);
    EXPECT_EQ(session->haze_density, 2.0f) << "that of whoever set it";
    EXPECT_FALSE(controls.has_remote() || controls.has_trackers());
    EXPECT_FALSE(controls.open_remote("a word", *session->show).ok());
    EXPECT_FALSE(controls.has_remote());
}

TEST(LiveControls, a_browser_says_what_a_remote_control_says) {
    const auto session = open_demo();
    LiveControls controls;
    controls.begin(*session, LiveControls::Of::another_show);
    EXPECT_FALSE(controls.command({1, "nothing", {}}).ok());
    EXPECT_FALSE(controls.command({2, "/ghostlight/haze", {2.0}}).ok()) << "it is said without that";
    EXPECT_TRUE(controls.command({3, "haze", {2.0}}).ok());
    EXPECT_TRUE(controls.command({4, "look", {std::string("Verse"), 1.0}}).ok());
    EXPECT_TRUE(controls.command({5, "camera", {session->show->cameras.front().name}}).ok());
    const RemoteNews news = controls.hear_remote(*session, 0);
    EXPECT_TRUE(news.haze && news.look && news.camera);
    EXPECT_EQ(session->haze_density, 2.0f);
    EXPECT_EQ(controls.remote().look.name, "Verse");
    EXPECT_FALSE(is_news(controls.hear_remote(*session, 1)));
}

// A stage that stays black in the next show, too, and nobody sees why.
TEST(LiveControls, another_show_begins_without_what_a_remote_control_turned_down) {
    const auto session = open_demo();
    LiveControls controls;
    controls.begin(*session, LiveControls::Of::another_show);
    EXPECT_TRUE(controls.command({1, "blackout", {}}).ok());
    EXPECT_TRUE(controls.command({2, "haze", {2.0}}).ok());
    EXPECT_TRUE(controls.command({3, "exposure", {12.0}}).ok());
    (void)controls.hear_remote(*session, 0);
    controls.begin(*session, LiveControls::Of::the_same_show);
    EXPECT_EQ(controls.remote().light(), 0) << "an edit, or another device";
    EXPECT_EQ(session->haze_density, 2.0f);
    controls.begin(*session, LiveControls::Of::another_show);
    EXPECT_EQ(controls.remote().light(), 1);
    EXPECT_FALSE(controls.remote().ev100);
    EXPECT_EQ(session->haze_density, 1.0f);
    EXPECT_FALSE(is_news(controls.hear_remote(*session, 1)));
}

TEST(LiveControls, heads_follow_a_tracker) {
    const auto session = open_demo();
    scene::TrackerUse use;
    use.id = 7;
    use.fixtures = {session->show->fixtures[0].name};
    session->show->tracking.uses = {use};
    dmx::Trackers trackers;
    dmx::PsnPacket packet;
    packet.positions.push_back({7, {2.0f, 1.5f, -3.0f}}); // y up, z towards the audience
    trackers.feed(packet, std::chrono::seconds(1));
    LiveControls controls;
    controls.take(trackers, *session);
    session->rig->step({}, 0.1);
    const shared::Light light = session->lit().lights[0];
    const glm::vec3 point_m{2.0f, 3.0f, 1.5f};
    EXPECT_GT(glm::dot(light.axis_w, glm::normalize(point_m - light.position_m)),
              std::cos(glm::radians(0.05f)));
}

} // namespace
} // namespace ghost::app
