// SPDX-License-Identifier: Apache-2.0
// When the passes of a camera are fine enough to be shown in a window.
#include "live/session/baked_view.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace ghost::app
