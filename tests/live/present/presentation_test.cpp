// SPDX-License-Identifier: Apache-2.0
#include "live/present/presentation.h"

#include "link/picture_place.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

TEST(Presentation, a_device_that_is_the_processor_has_to_be_clearly_faster) {
    EXPECT_TRUE(is_device_faster(9, 10, false));
    EXPECT_FALSE(is_device_faster(11, 10, false));
    EXPECT_FALSE(is_device_faster(9, 10, true));
    EXPECT_TRUE(is_device_faster(7, 10, true));
}

TEST(Presentation, windows_hear_of_nothing_where_they_show_the_pictures) {
    ui::Link link;
    link.on_news = [] {};
    Presentation presentation(link, {});
    const auto device = must(gpu::Device::create({"", true}));
    presentation.begin(*device);
    presentation.offer(true);
    presentation.show();
    EXPECT_FALSE(link.surface_offer.take());
    EXPECT_FALSE(link.shower.take());
    EXPECT_FALSE(presentation.is_by_device());
    EXPECT_EQ(presentation.words(), "");
}

TEST(Presentation, a_device_without_displays_leaves_it_to_the_window_and_says_so) {
    ui::Link link;
    link.on_news = [] {};
    Presentation presentation(link, {ui::Shower::device, false});
    const auto device = must(gpu::Device::create({"", true})); // for pictures that nobody shows
    presentation.begin(*device);
    presentation.offer(true);
    EXPECT_FALSE(link.surface_offer.take());
    const auto now = link.shower.take();
    ASSERT_TRUE(now);
    EXPECT_TRUE(now->is_decided);
    EXPECT_FALSE(now->is_device);
    EXPECT_NE(presentation.words().find("the window"), std::string::npos);
}

TEST(Presentation, it_is_offered_once_a_device_and_measured_when_nothing_takes_long) {
    gpu::DeviceOptions options;
    options.validation = true;
    options.presents = true;
    const auto device = must(gpu::Device::create(options));
    if (!device->instance_of_surfaces()) GTEST_SKIP() << "this driver knows no displays";
    ui::Link link;
    link.on_news = [] {};
    Presentation presentation(link, {ui::Shower::measured, false});
    presentation.begin(*device);
    presentation.offer(false);
    EXPECT_FALSE(link.surface_offer.take());
    presentation.offer(true);
    const auto offer = link.surface_offer.take();
    ASSERT_TRUE(offer);
    EXPECT_TRUE(offer->is_measured);
    EXPECT_NE(offer->instance, nullptr);
    presentation.offer(true);
    EXPECT_FALSE(link.surface_offer.take());
    offer->let_go(7); // one that it never saw
    presentation.end();
    presentation.begin(*device);
    presentation.offer(true);
    EXPECT_TRUE(link.surface_offer.take());
}

// Two devices, one after the other, of one instance: a surface outlives them.
TEST(Presentation, devices_that_show_share_their_instance) {
    gpu::DeviceOptions options;
    options.presents = true;
    auto first = must(gpu::Device::create(options));
    const auto second = must(gpu::Device::create(options));
    if (!first->instance_of_surfaces()) GTEST_SKIP() << "this driver knows no displays";
    EXPECT_EQ(first->instance_of_surfaces(), second->instance_of_surfaces());
    first.reset();
    EXPECT_NE(second->instance_of_surfaces(), nullptr);
}

TEST(PicturePlace, the_frame_lies_in_the_middle_whole) {
    const ui::Rect wide = ui::place_of_picture(800, 600, {160, 90}, {});
    EXPECT_DOUBLE_EQ(wide.y, 75);
    EXPECT_DOUBLE_EQ(wide.height, 450);
    // A picture that shows more above and below than its frame.
    const ui::Rect framed = ui::place_of_picture(800, 600, {800, 600}, {{160, 90}, 0.75f});
    EXPECT_DOUBLE_EQ(framed.x, 0);
    EXPECT_DOUBLE_EQ(framed.height, 600);
}

} // namespace
} // namespace ghost::app
