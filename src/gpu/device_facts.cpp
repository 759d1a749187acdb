// SPDX-License-Identifier: Apache-2.0
#include "gpu/device_facts.h"

namespace ghost::gpu {
namespace {

std::string version_text(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

const char* type_text(VkPhysicalDeviceType type) {
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "processor";
    default:
        return "other";
    }
}

std::string mib_text(std::uint64_t bytes) {
    return std::to_string(bytes >> 20) + " MiB";
}

} // namespace

std::vector<std::pair<std::string, std::string>> facts_of(const Device& device) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceSubgroupProperties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    subgroup.pNext = &driver;
    VkPhysicalDevicePushDescriptorPropertiesKHR push{};
    push.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PUSH_DESCRIPTOR_PROPERTIES_KHR;
    push.pNext = &subgroup;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &push;
    vkGetPhysicalDeviceProperties2(device.physical(), &properties);
    const VkPhysicalDeviceProperties& p = properties.properties;
    const VkPhysicalDeviceLimits& limits = p.limits;

    std::vector<std::pair<std::string, std::string>> facts{
        {"name", p.deviceName},
        {"type", type_text(p.deviceType)},
        {"driver", std::string(driver.driverName) + " " + driver.driverInfo},
        {"Vulkan", version_text(p.apiVersion)},
        {"vendor, device", std::to_string(p.vendorID) + ", " + std::to_string(p.deviceID)}};
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(device.physical(), &memory);
    for (std::uint32_t k = 0; k < memory.memoryHeapCount; ++k) {
        const bool local = (memory.memoryHeaps[k].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT) != 0;
        facts.emplace_back("memory heap " + std::to_string(k),
                           mib_text(memory.memoryHeaps[k].size) + (local ? ", the device's" : ""));
    }
    const auto add = [&](const char* name, std::uint64_t value) {
        facts.emplace_back(name, std::to_string(value));
    };
    add("subgroupSize", subgroup.subgroupSize);
    add("maxComputeWorkGroupCount[0]", limits.maxComputeWorkGroupCount[0]);
    add("maxComputeWorkGroupInvocations", limits.maxComputeWorkGroupInvocations);
    add("maxComputeSharedMemorySize", limits.maxComputeSharedMemorySize);
    add("maxUniformBufferRange", limits.maxUniformBufferRange);
    add("minUniformBufferOffsetAlignment", limits.minUniformBufferOffsetAlignment);
    add("maxStorageBufferRange", limits.maxStorageBufferRange);
    add("maxPushConstantsSize", limits.maxPushConstantsSize);
    add("maxPushDescriptors", push.maxPushDescriptors);
    add("maxPerStageDescriptorStorageImages", limits.maxPerStageDescriptorStorageImages);
    add("maxPerStageDescriptorStorageBuffers", limits.maxPerStageDescriptorStorageBuffers);
    add("maxImageDimension2D", limits.maxImageDimension2D);
    add("maxImageArrayLayers", limits.maxImageArrayLayers);
    add("timestampComputeAndGraphics", limits.timestampComputeAndGraphics);
    facts.emplace_back("timestampPeriod", std::to_string(limits.timestampPeriod) + " ns");
    return facts;
}

} // namespace ghost::gpu
