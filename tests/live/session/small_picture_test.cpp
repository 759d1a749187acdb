// SPDX-License-Identifier: Apache-2.0
// A small picture from another camera is what the live picture would be there, and changes nothing of it.
#include "live/session/small_picture.h"

#include "show/camera_moves.h"
#include "support/demo_copy.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ghost::app {
namespace {

constexpr int kSmallWidth = 160, kSmallHeight = 90;

double difference(const image::Image8& a, const image::Image8& b) {
    EXPECT_EQ(a.samples.size(), b.samples.size());
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.samples.size(), b.samples.size()); ++i)
        sum += std::abs(static_cast<int>(a.samples[i]) - static_cast<int>(b.samples[i]));
    return sum / static_cast<double>(a.samples.size());
}

TEST(SmallPicture, is_that_of_its_camera_and_leaves_the_live_one_as_it_was) {
    SessionOptions options;
    options.show = DemoCopy::show().string();
    options.live = true;
    options.quiet = true;
    options.width = kSmallWidth;
    options.height = kSmallHeight;
    const auto session = must(open_session(options));
    session->show->motion = fixture::Motion::as_commanded;
    std::map<std::size_t, fixture::Programmer> hands;
    for (std::size_t i = 0; i < session->show->fixtures.size(); ++i)
        hands[i] = {.intensity = 1.0f, .zoom_deg = 30.0f, .pan_deg = 0.0f, .tilt_deg = -40.0f};
    session->rig->step({}, 0, hands);
    const scene::Camera house = session->show->cameras.front();
    const scene::Camera close = session->show->cameras[1];
    const auto live_from = [&](const scene::Camera& camera) {
        scene::Camera from = camera;
        from.width = kSmallWidth;
        from.height = kSmallHeight;
        session->look_from(scene::with_frame(from, {camera.width, camera.height}));
        session->draw();
        return session->relighter->picture();
    };
    const image::Image8 wanted = live_from(close), before = live_from(house);
    ASSERT_GT(difference(wanted, before), 5) << "the two cameras see other things";

    ASSERT_TRUE(SmallPicture::fits(*session));
    SmallPicture small(*session, kSmallWidth, kSmallHeight);
    EXPECT_FALSE(small.draw(close, session->lit(), 0, [] { return true; })) << "it gave way";
    const auto picture = small.draw(close, session->lit(), 0, [] { return false; });
    ASSERT_TRUE(picture);
    EXPECT_LT(difference(*picture, wanted), 2);
    session->draw();
    EXPECT_EQ(session->relighter->picture().samples, before.samples);
    const auto other = small.draw(house, session->lit(), 0, [] { return false; });
    ASSERT_TRUE(other);
    EXPECT_LT(difference(*other, before), 2) << "one after the other";
}

} // namespace
} // namespace ghost::app
