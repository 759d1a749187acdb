// SPDX-License-Identifier: Apache-2.0
// When the passes of a camera are fine enough to be shown in a window.
#include "live/session/baked_view.h"

#include "live/session/session.h"
#include "render/geometry/pass_images.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <string>

namespace ghost::app {
namespace {

scene::Camera passes(int width, int height) {
    scene::Camera camera;
    camera.width = width;
    camera.height = height;
    return camera;
}

TEST(BakedView, passes_are_shown_where_the_window_has_no_more_pixels_for_them) {
    EXPECT_EQ(why_too_coarse(passes(1024, 300), {562, 673}), "");
    EXPECT_EQ(why_too_coarse(passes(1024, 300), {1024, 2000}), "") << "letterboxed: 1024x300";
    EXPECT_EQ(why_too_coarse(passes(1024, 300), {4000, 300}), "");
    EXPECT_EQ(why_too_coarse(passes(1024, 300), {1280, 760}),
              "its passes have 1024x300 pixels, and the window shows it with 1280x375");
    EXPECT_NE(why_too_coarse(passes(1024, 300), {2048, 301}), "");
}

// Vulkan promises 256 layers; this many lights need more.
TEST(BakedView, passes_beyond_the_device_are_refused_and_say_why) {
    Session session;
    session.device = must(gpu::Device::create({.lowered_limits = {{"maxImageArrayLayers", 256}}}));
    BakedPasses baked;
    baked.passes.width = baked.passes.height = 1;
    baked.passes.extra_first = {0, 0};
    baked.passes.fragments.resize(1);
    baked.passes.lights.resize(300);
    EXPECT_EQ(render::beyond_device(*session.device, baked.passes),
              "pictures of 1 x 1 in 301 layers, and this device has them up to " +
                  std::to_string(session.device->limits().image_side) + " a side and 256 layers");
    const auto view = BakedView::create(session, baked);
    ASSERT_FALSE(view.ok());
    EXPECT_NE(view.error().text().find("its passes need pictures of 1 x 1 in 301 layers"), std::string::npos)
        << view.error().text();
    baked.passes.lights.resize(255);
    EXPECT_EQ(render::beyond_device(*session.device, baked.passes), "");
}

// A narrow picture has many rows for the fragments of its edges.
TEST(BakedView, rows_of_edges_count_as_rows_of_the_picture) {
    const auto device = must(gpu::Device::create({.lowered_limits = {{"maxImageDimension2D", 4096}}}));
    scene::Passes passes;
    passes.width = 1;
    passes.height = 4000;
    passes.fragments.resize(4000);
    EXPECT_EQ(render::beyond_device(*device, passes), "");
    passes.fragments.resize(4000 + 3 * 4000);
    EXPECT_NE(render::beyond_device(*device, passes).find("and this device has them up to 4096 a side"),
              std::string::npos);
}

} // namespace
} // namespace ghost::app
