// SPDX-License-Identifier: Apache-2.0
// A window that asks for more pixels than memory holds gets fewer, says so once, and goes on.
#include "live/session/picture_room.h"

#include "live/engine/opened_engine.h"
#include "support/demo_copy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace ghost::app {
namespace {

constexpr std::uint64_t kMB = 1u << 20;

scene::Camera camera_of(int width, int height) {
    scene::Camera camera;
    camera.width = width;
    camera.height = height;
    return camera;
}

TEST(PictureRoom, what_fits_stays) {
    const scene::Camera camera = fitted(camera_of(1920, 1080), 1920 * 1080 * kPictureBytesPerPixel);
    EXPECT_EQ(camera.width, 1920);
    EXPECT_EQ(camera.height, 1080);
}

TEST(PictureRoom, what_does_not_keeps_its_shape) {
    const scene::Camera camera = fitted(camera_of(7680, 4320), 1920 * 1080 * kPictureBytesPerPixel);
    EXPECT_EQ(camera.width, 1920);
    EXPECT_EQ(camera.height, 1080);
}

TEST(PictureRoom, there_is_always_a_picture) {
    const scene::Camera none = fitted(camera_of(7680, 4320), 0);
    EXPECT_EQ(none.width, 16);
    EXPECT_EQ(none.height, 16);
    const scene::Camera least = fitted(camera_of(16, 1), 0);
    EXPECT_EQ(least.height, 1);
}

// The number in the header, measured: heads have moved, and no image is kept.
TEST(PictureRoom, a_pixel_takes_what_is_said) {
    SessionOptions options;
    options.show = DemoCopy::show().string();
    options.live = options.quiet = true;
    options.bake = options.shadows = false;
    options.width = 320;
    options.height = 180;
    options.image_memory_bytes = 0;
    auto opened = open_session(options);
    ASSERT_TRUE(opened.ok()) << opened.error().text();
    Session& session = **opened;
    for (const auto& [width, height] : {std::pair{320, 180}, {640, 360}, {417, 333}}) {
        session.look_from([&, width = width, height = height] {
            scene::Camera camera = session.show->cameras.front();
            camera.width = width;
            camera.height = height;
            return camera;
        }());
        session.draw();
        session.programmer[0].tilt_deg = static_cast<float>(width) * 0.1f;
        session.rig->step({}, 1.0, session.programmer);
        session.draw();
        const double bytes_per_pixel = static_cast<double>(session.relighter->picture_bytes()) /
                                       (static_cast<double>(width) * static_cast<double>(height));
        std::printf("[ %dx%d ] %.0f bytes a pixel\n", width, height, bytes_per_pixel);
        EXPECT_LT(bytes_per_pixel, static_cast<double>(kPictureBytesPerPixel));
        EXPECT_GT(bytes_per_pixel, 0.6 * static_cast<double>(kPictureBytesPerPixel));
    }
}

TEST(PictureRoom, a_window_of_8k_on_a_device_that_does_not_hold_it) {
    EngineOptions options = quiet_engine();
    options.session.memory_limit_bytes = 320 * kMB;
    OpenedEngine demo(options);
    ASSERT_TRUE(demo.opened);
    ui::Link& link = demo.link;
    ui::ViewRequest& request = demo.request;
    std::optional<ui::Opened>& opened = demo.opened;
    request.camera = opened->show->cameras.front();
    request.frozen = true;
    std::optional<ui::Picture> picture;
    const auto settle_at = [&](int width, int height) {
        request.camera.width = width;
        request.camera.height = height;
        ++request.number;
        link.request.put(request);
        return comes_within(60, [&] {
            const auto settled = link.settled.take(); // before its picture, which stands there by then
            if (auto newest = link.picture.take()) picture = std::move(newest);
            return settled && *settled == request.number;
        });
    };
    ASSERT_TRUE(settle_at(7680, 4320));
    ASSERT_TRUE(picture && picture->image);
    EXPECT_GE(picture->image->width, 320);
    EXPECT_LT(picture->image->width, 2000);
    EXPECT_NEAR(picture->image->width * 9.0 / 16.0, picture->image->height, 1.0);
    EXPECT_FALSE(picture->is_coarse) << "it rests";
    std::optional<std::vector<Message>> messages;
    ASSERT_TRUE(comes_within(60, [&] { return (messages = link.messages.take()).has_value(); }));
    const auto said = [&] {
        return std::count_if(messages->begin(), messages->end(), [](const Message& message) {
            return message.what.find("memory is short for a picture of 7680x4320") != std::string::npos;
        });
    };
    EXPECT_EQ(said(), 1);
    // Back to a size that fits.
    ASSERT_TRUE(settle_at(320, 180));
    EXPECT_EQ(picture->image->width, 320);
    EXPECT_EQ(picture->image->height, 180);
    EXPECT_FALSE(link.failed.take());
}

} // namespace
} // namespace ghost::app
