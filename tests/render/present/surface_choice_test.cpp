// SPDX-License-Identifier: Apache-2.0
#include "render/present/surface_choice.h"

#include <gtest/gtest.h>
#include <vector>

namespace ghost::render {
namespace {

constexpr VkColorSpaceKHR kSrgb = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
using Formats = std::vector<VkSurfaceFormatKHR>;

TEST(SurfaceChoice, usual_displays_have_blue_first) {
    const Formats offered{{VK_FORMAT_B8G8R8A8_SRGB, kSrgb}, {VK_FORMAT_B8G8R8A8_UNORM, kSrgb}};
    const auto chosen = choose_format(offered, true);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->surface.format, VK_FORMAT_B8G8R8A8_UNORM);
    EXPECT_EQ(chosen->drawn, VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_TRUE(chosen->swaps);
    EXPECT_EQ(chosen->encoding, Encoding::srgb);
}

TEST(SurfaceChoice, formats_that_convert_take_the_same_bytes) {
    const auto chosen = choose_format(Formats{{VK_FORMAT_R8G8B8A8_SRGB, kSrgb}}, false);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->surface.format, VK_FORMAT_R8G8B8A8_SRGB);
    EXPECT_EQ(chosen->drawn, VK_FORMAT_R8G8B8A8_UNORM);
    EXPECT_FALSE(chosen->swaps);
}

TEST(SurfaceChoice, hdr_is_taken_where_it_is_wanted_and_offered) {
    const VkSurfaceFormatKHR plain{VK_FORMAT_B8G8R8A8_UNORM, kSrgb},
        hdr10{VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_COLOR_SPACE_HDR10_ST2084_EXT},
        hdr10_red_last{VK_FORMAT_A2R10G10B10_UNORM_PACK32, VK_COLOR_SPACE_HDR10_ST2084_EXT},
        scrgb{VK_FORMAT_R16G16B16A16_SFLOAT, VK_COLOR_SPACE_EXTENDED_SRGB_LINEAR_EXT};
    const Formats all{plain, scrgb, hdr10};
    EXPECT_EQ(choose_format(all, true)->encoding, Encoding::pq);
    EXPECT_EQ(choose_format(all, false)->encoding, Encoding::srgb);
    EXPECT_EQ(choose_format(Formats{plain, scrgb}, true)->encoding, Encoding::scrgb);
    EXPECT_EQ(choose_format(Formats{scrgb}, true)->drawn, VK_FORMAT_R16G16B16A16_SFLOAT);
    const auto swapped = choose_format(Formats{plain, hdr10_red_last}, true);
    EXPECT_TRUE(swapped->swaps);
    EXPECT_EQ(swapped->drawn, VK_FORMAT_A2B10G10R10_UNORM_PACK32) << "of the same size, blue in red's place";
    // Sixteen bits alone are no sign of more than white.
    EXPECT_FALSE(choose_format(Formats{{VK_FORMAT_R16G16B16A16_SFLOAT, kSrgb}}, true));
}

TEST(SurfaceChoice, nothing_is_chosen_of_what_nobody_knows) {
    EXPECT_FALSE(choose_format(Formats{}, false));
    EXPECT_FALSE(choose_format(Formats{{VK_FORMAT_R5G6B5_UNORM_PACK16, kSrgb}}, true));
    EXPECT_FALSE(
        choose_format(Formats{{VK_FORMAT_B8G8R8A8_UNORM, VK_COLOR_SPACE_DISPLAY_P3_NONLINEAR_EXT}}, false));
}

TEST(SurfaceChoice, mailbox_before_fifo) {
    using Modes = std::vector<VkPresentModeKHR>;
    EXPECT_EQ(choose_mode(Modes{VK_PRESENT_MODE_FIFO_KHR, VK_PRESENT_MODE_MAILBOX_KHR}),
              VK_PRESENT_MODE_MAILBOX_KHR);
    EXPECT_EQ(choose_mode(Modes{VK_PRESENT_MODE_IMMEDIATE_KHR, VK_PRESENT_MODE_FIFO_KHR}),
              VK_PRESENT_MODE_FIFO_KHR);
    EXPECT_EQ(choose_mode(Modes{}), VK_PRESENT_MODE_FIFO_KHR);
}

VkSurfaceCapabilitiesKHR can_do(VkExtent2D current) {
    VkSurfaceCapabilitiesKHR can{};
    can.currentExtent = current;
    can.minImageExtent = {1, 1};
    can.maxImageExtent = {4096, 2160};
    can.minImageCount = 2;
    can.supportedCompositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR | VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    return can;
}

TEST(SurfaceChoice, the_surface_says_its_size_or_leaves_it_to_the_window) {
    const auto side = [](VkExtent2D current, VkExtent2D wanted) {
        const VkExtent2D chosen = choose_extent(can_do(current), wanted);
        return std::pair(chosen.width, chosen.height);
    };
    using Size = std::pair<std::uint32_t, std::uint32_t>;
    EXPECT_EQ(side({640, 360}, {800, 600}), (Size{640, 360}));
    EXPECT_EQ(side({0, 0}, {800, 600}), (Size{0, 0})) << "a window that is put away";
    EXPECT_EQ(side({~0u, ~0u}, {800, 600}), (Size{800, 600}));
    EXPECT_EQ(side({~0u, ~0u}, {10000, 0}), (Size{4096, 1}));
}

TEST(SurfaceChoice, as_many_images_as_keep_nobody_waiting) {
    VkSurfaceCapabilitiesKHR can = can_do({1, 1});
    EXPECT_EQ(choose_images(can, VK_PRESENT_MODE_FIFO_KHR), 3u);
    can.minImageCount = 4;
    EXPECT_EQ(choose_images(can, VK_PRESENT_MODE_FIFO_KHR), 4u);
    EXPECT_EQ(choose_images(can, VK_PRESENT_MODE_MAILBOX_KHR), 5u);
    can.maxImageCount = 4;
    EXPECT_EQ(choose_images(can, VK_PRESENT_MODE_MAILBOX_KHR), 4u);
}

TEST(SurfaceChoice, opaque_where_that_can_be) {
    VkSurfaceCapabilitiesKHR can = can_do({1, 1});
    EXPECT_EQ(choose_alpha(can), VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR);
    can.supportedCompositeAlpha = VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR;
    EXPECT_EQ(choose_alpha(can), VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR);
}

} // namespace
} // namespace ghost::render
