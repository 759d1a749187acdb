// SPDX-License-Identifier: Apache-2.0
#include "gpu/needed_limits.h"

#include <algorithm>

namespace ghost::gpu {
namespace {

constexpr NeededLimit kNeeded[] = {
    {"maxUniformBufferRange", 65536,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxUniformBufferRange; }},
    {"maxPushConstantsSize", 128,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxPushConstantsSize; }},
    {"maxStorageBufferRange", std::uint64_t{1} << 27,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxStorageBufferRange; }},
    {"maxPerStageDescriptorStorageImages", kMostStorageImages,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxPerStageDescriptorStorageImages; }},
    {"maxPerStageDescriptorStorageBuffers", kMostStorageBuffers,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxPerStageDescriptorStorageBuffers; }},
    {"maxPerStageDescriptorSampledImages", kMostSampledImages,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxPerStageDescriptorSampledImages; }},
    {"maxPerStageDescriptorUniformBuffers", kMostUniformBuffers,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxPerStageDescriptorUniformBuffers; }},
    {"maxPerStageResources", kMostBindings,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxPerStageResources; }},
    {"maxComputeWorkGroupInvocations", 256,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxComputeWorkGroupInvocations; }},
    {"maxComputeWorkGroupCount", 65535,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxComputeWorkGroupCount[0]; }},
    {"maxComputeSharedMemorySize", 16384,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxComputeSharedMemorySize; }},
    {"maxColorAttachments", 4,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxColorAttachments; }},
    {"maxImageDimension2D", 4096,
     [](const VkPhysicalDeviceLimits& l) -> std::uint64_t { return l.maxImageDimension2D; }}};

std::uint64_t lowered_to(const LoweredLimits& lowered, const std::string& name, std::uint64_t has) {
    const auto found = lowered.find(name);
    return found == lowered.end() ? has : std::min(has, found->second);
}

std::string lack(const std::string& name, std::uint64_t least, std::uint64_t has) {
    return has >= least ? "" : name + " " + std::to_string(least) + " (it has " + std::to_string(has) + ")";
}

} // namespace

std::span<const NeededLimit> needed_limits() {
    return kNeeded;
}

std::string missing_limit(VkPhysicalDevice physical, const VkPhysicalDeviceLimits& limits,
                          const LoweredLimits& lowered) {
    for (const NeededLimit& needed : kNeeded) {
        const std::string missing =
            lack(needed.name, needed.least, lowered_to(lowered, needed.name, needed.of(limits)));
        if (!missing.empty()) return missing;
    }
    VkPhysicalDevicePushDescriptorPropertiesKHR push{};
    push.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PUSH_DESCRIPTOR_PROPERTIES_KHR;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &push;
    vkGetPhysicalDeviceProperties2(physical, &properties);
    return lack("maxPushDescriptors", kMostBindings,
                lowered_to(lowered, "maxPushDescriptors", push.maxPushDescriptors));
}

UsedLimits used_limits(const VkPhysicalDeviceLimits& limits, const LoweredLimits& lowered) {
    UsedLimits used;
    used.image_layers =
        static_cast<std::uint32_t>(lowered_to(lowered, "maxImageArrayLayers", limits.maxImageArrayLayers));
    used.image_side =
        static_cast<std::uint32_t>(lowered_to(lowered, "maxImageDimension2D", limits.maxImageDimension2D));
    used.work_group_invocations = static_cast<std::uint32_t>(
        lowered_to(lowered, "maxComputeWorkGroupInvocations", limits.maxComputeWorkGroupInvocations));
    used.work_groups = static_cast<std::uint32_t>(
        lowered_to(lowered, "maxComputeWorkGroupCount", limits.maxComputeWorkGroupCount[0]));
    used.memory_pieces = static_cast<std::uint32_t>(
        lowered_to(lowered, "maxMemoryAllocationCount", limits.maxMemoryAllocationCount));
    used.clip_distances =
        static_cast<std::uint32_t>(lowered_to(lowered, "maxClipDistances", limits.maxClipDistances));
    used.drawn_layers =
        static_cast<std::uint32_t>(lowered_to(lowered, "maxFramebufferLayers", limits.maxFramebufferLayers));
    used.timestamps =
        lowered_to(lowered, "timestampComputeAndGraphics", limits.timestampComputeAndGraphics) != 0;
    return used;
}

std::string beyond_limits(const UsedLimits& limits, std::uint64_t width, std::uint64_t height,
                          std::uint64_t layers) {
    if (std::max(width, height) <= limits.image_side && layers <= limits.image_layers) return "";
    return "pictures of " + std::to_string(width) + " x " + std::to_string(height) + " in " +
           std::to_string(layers) + " layers, and this device has them up to " +
           std::to_string(limits.image_side) + " a side and " + std::to_string(limits.image_layers) +
           " layers";
}

} // namespace ghost::gpu
