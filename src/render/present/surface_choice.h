#pragma once
// SPDX-License-Identifier: Apache-2.0
// What is taken of what a surface offers: format, pace, size, number of images. Pure functions.

#include <cstdint>
#include <optional>
#include <span>
#include <vulkan/vulkan.h>

namespace ghost::render {

// How colours stand in a surface (shared/present.h).
enum class Encoding { srgb, pq, scrgb };

struct SurfaceFormat {
    VkSurfaceFormatKHR surface{};
    VkFormat drawn = VK_FORMAT_UNDEFINED; // of what is copied there as it is, byte for byte
    bool swaps = false;                   // blue stands first there
    Encoding encoding = Encoding::srgb;
};

// hdr: HDR10, else scRGB, where there is either. Nothing: none that we can fill.
std::optional<SurfaceFormat> choose_format(std::span<const VkSurfaceFormatKHR> offered, bool hdr);
// Mailbox, which never waits, else FIFO, which there always is.
VkPresentModeKHR choose_mode(std::span<const VkPresentModeKHR> offered);
// wanted: where the surface leaves it to us. A side of 0: nothing can be shown now.
VkExtent2D choose_extent(const VkSurfaceCapabilitiesKHR& can, VkExtent2D wanted);
std::uint32_t choose_images(const VkSurfaceCapabilitiesKHR& can, VkPresentModeKHR mode);
// Opaque, or what comes next to it.
VkCompositeAlphaFlagBitsKHR choose_alpha(const VkSurfaceCapabilitiesKHR& can);

} // namespace ghost::render
