// SPDX-License-Identifier: Apache-2.0
// Bounced light of a session: the key of the show, the command line over it, links that are kept and given
// up, and what a light meter reads with it.
#include "live/session/bounce_light.h"

#include "disk/files.h"
#include "live/lux/light_meter.h"
#include "live/session/applied_look.h"
#include "shared/develop.h"
#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using scene::BounceDetail;

SessionOptions small() {
    SessionOptions options;
    options.show = DemoCopy::show().string();
    options.live = true;
    options.quiet = true;
    options.width = 96;
    options.height = 72;
    return options;
}

fs::path links() {
    return DemoCopy::show() / ".ghost" / "bounce" / "room.bin";
}

std::string with_key(const std::string& value) {
    return must(read_text_file(DemoCopy::show() / "show.toml", scene::kMaxShowBytes)) +
           "\n[light]\nbounce = \"" + value + "\"\n";
}

// All heads on, into the stage.
void light_all(Session& session) {
    session.show->motion = fixture::Motion::as_commanded;
    std::map<std::size_t, fixture::Programmer> programmer;
    for (std::size_t i = 0; i < session.show->fixtures.size(); ++i)
        programmer[i] = {.intensity = 1.0f, .zoom_deg = 30.0f, .tilt_deg = 20.0f, .gobo = 0};
    session.rig->step({}, 0, programmer);
}

std::vector<float> drawn(Session& session) {
    session.draw();
    return session.relighter->frame().samples;
}

TEST(BounceLight, the_show_says_it_the_command_line_overrides_it_and_off_is_as_before) {
    SessionOptions options = small();
    const auto plain = must(open_session(options));
    light_all(*plain);
    const std::vector<float> without = drawn(*plain);
    EXPECT_EQ(plain->bounce_detail(), BounceDetail::off);

    options.text = std::make_shared<const std::string>(with_key("room"));
    options.live = false; // the key alone draws it live
    const auto of_key = must(open_session(options));
    ASSERT_TRUE(of_key->live);
    EXPECT_EQ(of_key->bounce_detail(), BounceDetail::room);
    light_all(*of_key);
    const std::vector<float> with = drawn(*of_key);
    ASSERT_EQ(with.size(), without.size());
    double sum = 0, sum_without = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        sum += static_cast<double>(with[i]);
        sum_without += static_cast<double>(without[i]);
    }
    EXPECT_GT(sum, 1.03 * sum_without) << "the very first picture waited for its links";
    EXPECT_TRUE(of_key->is_bounce_settled());
    of_key->set_bounce(BounceDetail::off);
    EXPECT_EQ(drawn(*of_key), without) << "byte for byte";

    options.live = true;
    options.bounce = BounceDetail::off;
    const auto overridden = must(open_session(options));
    EXPECT_EQ(overridden->bounce_detail(), BounceDetail::off);
    light_all(*overridden);
    EXPECT_EQ(drawn(*overridden), without);
}

// As of a room of hundreds of metres, for this device has next to no layers.
TEST(BounceLight, a_room_beyond_the_device_is_said_and_the_picture_goes_on_without) {
    SessionOptions options = small();
    options.lowered_limits = {{"maxImageArrayLayers", 4}};
    const auto plain = must(open_session(options));
    light_all(*plain);
    const std::vector<float> without = drawn(*plain);
    options.bounce = BounceDetail::room;
    const auto session = must(open_session(options));
    light_all(*session);
    EXPECT_EQ(drawn(*session), without) << "byte for byte";
    EXPECT_FALSE(session->bounced);
    EXPECT_TRUE(session->is_bounce_settled());
    const auto is_said = [](const Message& message) {
        return message.where == "bounced light" &&
               message.what.find(" a side and 4 layers; no light bounces") != std::string::npos;
    };
    EXPECT_EQ(std::count_if(session->report.messages.begin(), session->report.messages.end(), is_said), 1);

    scene::BounceVolumes volumes; // nor where nobody asked before
    for (scene::BounceVolume* volume : {&volumes.surfaces, &volumes.air, &volumes.glow}) {
        volume->size = {2, 2, 5};
        volume->texels.resize(20);
    }
    session->relighter->set_room_light(std::make_shared<const scene::BounceVolumes>(volumes));
    EXPECT_EQ(drawn(*session), without);
    const std::uint64_t bytes = session->relighter->picture_bytes();
    for (scene::BounceVolume* volume : {&volumes.surfaces, &volumes.air, &volumes.glow})
        volume->texels.resize(16);
    session->relighter->set_room_light(std::make_shared<const scene::BounceVolumes>(volumes));
    EXPECT_GT(session->relighter->picture_bytes(), bytes) << "four layers are those that it has";
}

TEST(BounceLight, an_edit_of_the_show_is_taken_unless_the_command_line_says_otherwise) {
    SessionOptions options = small();
    options.maps_in_background = true;
    const auto session = must(open_session(options));
    scene::Show edited = *session->show;
    edited.bounce = BounceDetail::room;
    take_air(edited, *session);
    EXPECT_EQ(session->bounce_detail(), BounceDetail::room);
    EXPECT_EQ(session->show->bounce, BounceDetail::room);
    options.bounce = BounceDetail::off;
    const auto told = must(open_session(options));
    take_air(edited, *told);
    EXPECT_EQ(told->bounce_detail(), BounceDetail::off);
    EXPECT_EQ(told->show->bounce, BounceDetail::room) << "the show has it all the same";
}

TEST(BounceLight, links_are_made_once_whatever_the_camera_and_the_lights_do) {
    SessionOptions options = small();
    options.bounce = BounceDetail::room;
    const auto first = must(open_session(options));
    light_all(*first);
    const std::vector<float> expected = drawn(*first);
    ASSERT_TRUE(fs::exists(links()));
    const auto made_at = fs::last_write_time(links());
    const auto again = must(open_session(options));
    light_all(*again);
    EXPECT_EQ(drawn(*again), expected);

    // From elsewhere, and turned on while heads stand somewhere.
    options.bounce.reset();
    options.eye = again->show->cameras.front();
    options.eye->position_m.x += 1.25f;
    const auto elsewhere = must(open_session(options));
    light_all(*elsewhere);
    elsewhere->set_bounce(BounceDetail::room);
    elsewhere->draw();
    EXPECT_FALSE(elsewhere->report.lost_anything());
    EXPECT_EQ(fs::last_write_time(links()), made_at);

    // Nor without a device.
    const auto bounced = must(bounced_now(*again->show, again->live->solid(), BounceDetail::room, *again->rig,
                                          again->gobos, again->atmosphere().medium(), true));
    ASSERT_TRUE(bounced);
    EXPECT_EQ(bounced->surfaces.texels, again->bounced->surfaces.texels);
    EXPECT_EQ(bounced->air.texels, again->bounced->air.texels);
    EXPECT_EQ(fs::last_write_time(links()), made_at);
    EXPECT_FALSE(must(bounced_now(*again->show, again->live->solid(), BounceDetail::off, *again->rig,
                                  again->gobos, again->atmosphere().medium(), true)));
}

TEST(BounceLight, making_links_is_given_up_and_begun_again) {
    SessionOptions options = small();
    options.maps_in_background = true;
    const auto session = must(open_session(options));
    light_all(*session);
    fs::remove(links());
    session->set_bounce(BounceDetail::room);
    session->stop_bounce(true);
    session->bounce->wait_for_links(true);
    session->draw();
    EXPECT_TRUE(session->bounce->is_stopped());
    EXPECT_FALSE(session->bounced);
    EXPECT_FALSE(session->report.lost_anything()) << "who cancels need not be told";
    EXPECT_TRUE(session->is_bounce_settled()) << "nothing is waited for";
    EXPECT_FALSE(fs::exists(links()));
    session->stop_bounce(false);
    EXPECT_EQ(session->bounce_detail(), BounceDetail::room);
    EXPECT_FALSE(session->is_bounce_settled());
    for (int i = 0; i < 1200 && !session->is_bounce_settled(); ++i) {
        session->draw();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_TRUE(session->bounced);
    EXPECT_TRUE(fs::exists(links()));
    // Too late to be given up.
    session->stop_bounce(true);
    EXPECT_FALSE(session->bounce->is_stopped());
}

TEST(BounceLight, the_meter_reads_it_by_rays_and_as_a_picture) {
    SessionOptions options = small();
    const auto session = must(open_session(options));
    session->show->ambient_lux = 0;
    light_all(*session);
    session->look_from(session->live->camera());
    session->draw();
    const scene::FrameLights lit = session->lit();
    const image::ImageF without = lux_picture(*session, lit);
    session->set_bounce(BounceDetail::room);
    session->draw();
    ASSERT_TRUE(session->bounced);
    const image::ImageF with = lux_picture(*session, lit);

    // Only what bounced: no light of a lamp, and none is weakened less.
    const bake::DenormalsOff mode;
    const bake::Tracer tracer(session->live->solid());
    std::vector<float> ratios;
    double bounced_sum = 0;
    for (int y = 2; y < 72; y += 3)
        for (int x = 2; x < 96; x += 3) {
            const glm::vec2 place((static_cast<float>(x) + 0.5f) / 96, (static_cast<float>(y) + 0.5f) / 72);
            const bake::Surface surface = surface_at(session->live->camera(), place, tracer);
            if (surface.instance < 0) continue;
            const Lux lux = lux_at(surface, lit, *session, tracer);
            EXPECT_GE(lux.bounced, 0);
            EXPECT_GE(lux.all, lux.bounced);
            bounced_sum += static_cast<double>(lux.bounced);
            EXPECT_GE(*with.at(x, y), 0.99f * *without.at(x, y)) << x << " " << y;
            const bool is_in_shadow = *without.at(x, y) < 0.01f * lux.bounced;
            if (is_in_shadow && lux.bounced > 0.5f) ratios.push_back(*with.at(x, y) / lux.bounced);
        }
    EXPECT_GT(bounced_sum, 0);
    ASSERT_GT(ratios.size(), 20u);
    std::sort(ratios.begin(), ratios.end());
    std::printf("picture / rays in %zu places in shadow: %.3f %.3f %.3f\n", ratios.size(),
                static_cast<double>(ratios[ratios.size() / 10]),
                static_cast<double>(ratios[ratios.size() / 2]),
                static_cast<double>(ratios[ratios.size() * 9 / 10]));
    EXPECT_NEAR(ratios[ratios.size() / 2], 1, 0.03);
}

} // namespace
} // namespace ghost::app
