#pragma once
// SPDX-License-Identifier: Apache-2.0
// NeededLimits: what a device must allow, and what of it we only make use of. Any thread.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vulkan/vulkan.h>

namespace ghost::gpu {

// Limits by their names in Vulkan, as if a device had no more than that: for tests.
using LoweredLimits = std::map<std::string, std::uint64_t>;

struct NeededLimit {
    const char* name;
    std::uint64_t least;
    std::uint64_t (*of)(const VkPhysicalDeviceLimits&);
};
// A shader that binds more than these say does not get a pipeline (gpu/push_layout.h).
inline constexpr std::uint64_t kMostStorageImages = 9, kMostStorageBuffers = 7, kMostSampledImages = 5,
                               kMostUniformBuffers = 4, kMostBindings = 17;
std::span<const NeededLimit> needed_limits();

// "maxUniformBufferRange 65536 (it has 16384)", or "".
std::string missing_limit(VkPhysicalDevice physical, const VkPhysicalDeviceLimits& limits,
                          const LoweredLimits& lowered);

// What is made use of as far as there is of it.
struct UsedLimits {
    std::uint32_t image_layers = 256;           // maxImageArrayLayers
    std::uint32_t image_side = 4096;            // maxImageDimension2D
    std::uint32_t work_group_invocations = 128; // maxComputeWorkGroupInvocations
    std::uint32_t work_groups = 65535;          // maxComputeWorkGroupCount, in x
    std::uint32_t memory_pieces = 4096;         // maxMemoryAllocationCount
    std::uint32_t clip_distances = 0;           // maxClipDistances; 0: not a feature of the device
    std::uint32_t drawn_layers = 1;             // maxFramebufferLayers; 1: shaders cannot choose one
    bool timestamps = false;                    // timestampComputeAndGraphics: else spans have no times
};
UsedLimits used_limits(const VkPhysicalDeviceLimits& limits, const LoweredLimits& lowered);

// What Vulkan promises nothing for: "pictures of 30004 x 2 in 768 layers, and this device has them up to
// 16384 a side and 2048 layers"; "" where it fits.
std::string beyond_limits(const UsedLimits& limits, std::uint64_t width, std::uint64_t height,
                          std::uint64_t layers);

} // namespace ghost::gpu
