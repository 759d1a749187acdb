#pragma once
// SPDX-License-Identifier: Apache-2.0
// What every pipeline of ours binds: one set of push descriptors, bindings 0, 1, .. of the given types, and
// push constants. Shared by Program and Raster; the caller owns both handles.

#include "base/check.h"
#include "gpu/device.h"
#include "gpu/shader.h"

#include <algorithm>
#include <vector>

namespace ghost::gpu {

inline constexpr std::uint32_t kPushBytes = 128; // the least that every Vulkan device has

struct PushLayout {
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout pipeline = VK_NULL_HANDLE;
};

inline PushLayout make_push_layout(const Device& device, const std::vector<VkDescriptorType>& bindings,
                                   VkShaderStageFlags stages) {
    PushLayout made;
    std::vector<VkDescriptorSetLayoutBinding> places;
    for (std::size_t number = 0; number < bindings.size(); ++number) {
        if (bindings[number] == kNoBinding) continue;
        VkDescriptorSetLayoutBinding place{};
        place.binding = static_cast<std::uint32_t>(number);
        place.descriptorType = bindings[number];
        place.descriptorCount = 1;
        place.stageFlags = stages;
        places.push_back(place);
    }
    CHECK(places.size() <= kMostBindings);
    const auto count = [&](VkDescriptorType type) {
        return static_cast<std::uint64_t>(std::count(bindings.begin(), bindings.end(), type));
    };
    CHECK(count(VK_DESCRIPTOR_TYPE_STORAGE_IMAGE) <= kMostStorageImages);
    CHECK(count(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER) <= kMostStorageBuffers);
    CHECK(count(VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER) <= kMostSampledImages);
    CHECK(count(VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER) <= kMostUniformBuffers);
    VkDescriptorSetLayoutCreateInfo set{};
    set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    set.bindingCount = static_cast<std::uint32_t>(places.size());
    set.pBindings = places.data();
    VK_CALL(vkCreateDescriptorSetLayout(device.handle(), &set, nullptr, &made.set));
    const VkPushConstantRange push{stages, 0, kPushBytes};
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &made.set;
    layout.pushConstantRangeCount = 1;
    layout.pPushConstantRanges = &push;
    VK_CALL(vkCreatePipelineLayout(device.handle(), &layout, nullptr, &made.pipeline));
    return made;
}

} // namespace ghost::gpu
