// SPDX-License-Identifier: Apache-2.0
#include "show/show.h"
#include "support/test_window.h"
#include "ui/model/camera_flight.h"
#include "ui/model/look_fader.h"

#include <QCoreApplication>

namespace ghost::ui {
namespace {

constexpr int kLong_ms = 60'000;

Look with_intensity(float intensity) {
    Look look;
    look.fixtures[0].intensity = intensity;
    return look;
}

TEST(LookFader, without_seconds_a_look_is_there_at_once) {
    LookFader fader([] {});
    fader.change({}, with_intensity(1));
    EXPECT_FALSE(fader.is_going());
    EXPECT_EQ(fader.on_the_way(with_intensity(1), nullptr, {}), with_intensity(1));
}

TEST(LookFader, seconds_are_those_of_the_next_change_alone) {
    scene::Show show;
    show.fixtures.resize(1);
    RigNow now;
    now.fixtures.resize(1);
    LookFader fader([] {});
    (void)fader.on_the_way(with_intensity(0), &show, now);
    fader.set_next(kLong_ms / 1000);
    fader.change(with_intensity(0), with_intensity(1));
    EXPECT_TRUE(fader.is_going());
    const float begins = *fader.on_the_way(with_intensity(1), &show, now).fixtures.at(0).intensity;
    EXPECT_LT(begins, 0.5f);
    // A hand that sets something meanwhile has it at once, and the fade goes on.
    Look by_hand = with_intensity(1);
    by_hand.fixtures[0].zoom_deg = 20.0f;
    fader.change(with_intensity(1), by_hand);
    EXPECT_TRUE(fader.is_going());
    EXPECT_EQ(fader.on_the_way(by_hand, &show, now).fixtures.at(0).zoom_deg, 20.0f);
    fader.forget();
    EXPECT_FALSE(fader.is_going());
    EXPECT_EQ(fader.on_the_way(by_hand, &show, now), by_hand);
}

TEST(LookFader, what_is_on_its_way_may_be_told_to_be_there_sooner) {
    scene::Show show;
    show.fixtures.resize(1);
    RigNow now;
    now.fixtures.resize(1);
    LookFader fader([] {});
    (void)fader.on_the_way(with_intensity(0), &show, now);
    fader.set_next(kLong_ms / 1000);
    fader.change(with_intensity(0), with_intensity(1));
    fader.hurry(2.0 * kLong_ms / 1000);
    EXPECT_LT(fader.on_the_way(with_intensity(1), &show, now).fixtures.at(0).intensity, 0.5f);
    EXPECT_TRUE(fader.is_going()) << "later than it is on its way: it goes on";
    fader.hurry(0);
    EXPECT_FALSE(fader.is_going());
    EXPECT_EQ(fader.on_the_way(with_intensity(1), &show, now), with_intensity(1));
}

TEST(CameraFlight, it_ends_at_its_end_with_the_frame_of_that) {
    FramedCamera here;
    int steps = 0;
    CameraFlight flight([&](const FramedCamera& now) {
        here = now;
        ++steps;
    });
    FramedCamera from, to;
    to.camera.position_m = {4, 0, 0};
    to.camera.fov_y_deg = 20;
    to.frame = {1920, 1080};
    flight.begin(from, to, 100);
    flight.set_exposure(7, false);
    while (flight.is_going()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_GE(steps, 1);
    EXPECT_EQ(here.camera.position_m, to.camera.position_m);
    EXPECT_EQ(here.camera.fov_y_deg, 20.0f);
    EXPECT_EQ(here.camera.ev100, 7.0f);
    EXPECT_EQ(here.frame, to.frame);
    flight.begin(from, to, kLong_ms);
    flight.stop();
    EXPECT_FALSE(flight.is_going());
}

} // namespace
} // namespace ghost::ui
