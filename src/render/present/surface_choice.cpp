// SPDX-License-Identifier: Apache-2.0
#include "render/present/surface_choice.h"

#include <algorithm>
#include <array>

namespace ghost::render {
namespace {

constexpr std::uint32_t kLeftToUs = 0xFFFFFFFF; // currentExtent of Wayland

constexpr VkColorSpaceKHR kSrgb = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
constexpr VkColorSpaceKHR kPq = VK_COLOR_SPACE_HDR10_ST2084_EXT;
constexpr VkColorSpaceKHR kScrgb = VK_COLOR_SPACE_EXTENDED_SRGB_LINEAR_EXT;

constexpr VkFormat kRgba8 = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkFormat kRgb10 = VK_FORMAT_A2B10G10R10_UNORM_PACK32;
constexpr VkFormat kHalves = VK_FORMAT_R16G16B16A16_SFLOAT;

// Best first. What is copied there is sRGB already, so formats that would convert take it as well.
constexpr std::array<SurfaceFormat, 4> kHdr{
    {{{VK_FORMAT_A2B10G10R10_UNORM_PACK32, kPq}, kRgb10, false, Encoding::pq},
     {{VK_FORMAT_A2R10G10B10_UNORM_PACK32, kPq}, kRgb10, true, Encoding::pq},
     {{VK_FORMAT_R16G16B16A16_SFLOAT, kPq}, kHalves, false, Encoding::pq},
     {{VK_FORMAT_R16G16B16A16_SFLOAT, kScrgb}, kHalves, false, Encoding::scrgb}}};
constexpr std::array<SurfaceFormat, 4> kPlain{
    {{{VK_FORMAT_B8G8R8A8_UNORM, kSrgb}, kRgba8, true, Encoding::srgb},
     {{VK_FORMAT_R8G8B8A8_UNORM, kSrgb}, kRgba8, false, Encoding::srgb},
     {{VK_FORMAT_B8G8R8A8_SRGB, kSrgb}, kRgba8, true, Encoding::srgb},
     {{VK_FORMAT_R8G8B8A8_SRGB, kSrgb}, kRgba8, false, Encoding::srgb}}};

std::optional<SurfaceFormat> first_of(std::span<const SurfaceFormat> known,
                                      std::span<const VkSurfaceFormatKHR> offered) {
    for (const SurfaceFormat& one : known)
        if (one.drawn != VK_FORMAT_UNDEFINED &&
            std::any_of(offered.begin(), offered.end(), [&](const VkSurfaceFormatKHR& other) {
                return other.format == one.surface.format && other.colorSpace == one.surface.colorSpace;
            }))
            return one;
    return std::nullopt;
}

} // namespace

std::optional<SurfaceFormat> choose_format(std::span<const VkSurfaceFormatKHR> offered, bool hdr) {
    if (hdr)
        if (const auto found = first_of(kHdr, offered)) return found;
    return first_of(kPlain, offered);
}

VkPresentModeKHR choose_mode(std::span<const VkPresentModeKHR> offered) {
    const bool has_mailbox =
        std::find(offered.begin(), offered.end(), VK_PRESENT_MODE_MAILBOX_KHR) != offered.end();
    return has_mailbox ? VK_PRESENT_MODE_MAILBOX_KHR : VK_PRESENT_MODE_FIFO_KHR;
}

VkExtent2D choose_extent(const VkSurfaceCapabilitiesKHR& can, VkExtent2D wanted) {
    if (can.currentExtent.width != kLeftToUs) return can.currentExtent;
    return {std::clamp(wanted.width, can.minImageExtent.width, can.maxImageExtent.width),
            std::clamp(wanted.height, can.minImageExtent.height, can.maxImageExtent.height)};
}

std::uint32_t choose_images(const VkSurfaceCapabilitiesKHR& can, VkPresentModeKHR mode) {
    // One that is seen, one that waits, one that is drawn.
    const std::uint32_t wanted =
        std::max(can.minImageCount + (mode == VK_PRESENT_MODE_MAILBOX_KHR ? 1u : 0u), 3u);
    return can.maxImageCount > 0 ? std::min(wanted, can.maxImageCount) : wanted;
}

VkCompositeAlphaFlagBitsKHR choose_alpha(const VkSurfaceCapabilitiesKHR& can) {
    for (const VkCompositeAlphaFlagBitsKHR one :
         {VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR, VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR,
          VK_COMPOSITE_ALPHA_PRE_MULTIPLIED_BIT_KHR})
        if (can.supportedCompositeAlpha & one) return one;
    return VK_COMPOSITE_ALPHA_POST_MULTIPLIED_BIT_KHR;
}

} // namespace ghost::render
