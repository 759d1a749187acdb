#pragma once
// SPDX-License-Identifier: Apache-2.0
// TextureArray: square RGBA8 layers with given mip levels and a trilinear sampler, clamped at the edges.
// Filled once.

#include "gpu/device.h"

#include <span>
#include <vector>

namespace ghost::gpu {

class TextureArray {
public:
    // levels[k]: layers x (size >> k)^2 x 4 bytes.
    TextureArray(const Device& device, std::uint32_t size, std::uint32_t layers,
                 std::span<const std::vector<std::uint8_t>> levels);
    ~TextureArray();
    TextureArray(const TextureArray&) = delete;
    TextureArray& operator=(const TextureArray&) = delete;

    VkImageView view() const { return view_; }
    VkSampler sampler() const { return sampler_; }

private:
    const Device& device_;
    VkImage image_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    VkSampler sampler_ = VK_NULL_HANDLE;
};

} // namespace ghost::gpu
