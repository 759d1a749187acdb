// SPDX-License-Identifier: Apache-2.0
#include "gpu/texture_array.h"

#include "base/check.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"

#include <cstring>

namespace ghost::gpu {

TextureArray::TextureArray(const Device& device, std::uint32_t size, std::uint32_t layers,
                           std::span<const std::vector<std::uint8_t>> levels)
    : device_(device) {
    const auto level_count = static_cast<std::uint32_t>(levels.size());
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_R8G8B8A8_UNORM;
    info.extent = {size, size, 1};
    info.mipLevels = level_count;
    info.arrayLayers = layers;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VK_CALL(vkCreateImage(device.handle(), &info, nullptr, &image_));
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device.handle(), image_, &needs);
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = needs.size;
    allocate.memoryTypeIndex = device.memory_type(needs.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    VK_CALL(vkAllocateMemory(device.handle(), &allocate, nullptr, &memory_));
    VK_CALL(vkBindImageMemory(device.handle(), image_, memory_, 0));

    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = image_;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    view.format = info.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, level_count, 0, layers};
    VK_CALL(vkCreateImageView(device.handle(), &view, nullptr, &view_));

    VkSamplerCreateInfo sampler{};
    sampler.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    sampler.magFilter = VK_FILTER_LINEAR;
    sampler.minFilter = VK_FILTER_LINEAR;
    sampler.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
    sampler.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    sampler.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    // Equal minLod and maxLod (zero) would double the time of a whole shader on lavapipe.
    sampler.maxLod = VK_LOD_CLAMP_NONE;
    VK_CALL(vkCreateSampler(device.handle(), &sampler, nullptr, &sampler_));

    std::uint64_t total = 0;
    for (const std::vector<std::uint8_t>& level : levels) total += level.size();
    const Buffer staging(device, total, Access::upload);
    std::vector<VkBufferImageCopy> regions;
    std::uint64_t offset = 0;
    for (std::uint32_t k = 0; k < level_count; ++k) {
        const std::uint32_t side = size >> k;
        CHECK_EQ(levels[k].size(), static_cast<std::size_t>(side) * side * layers * 4);
        std::memcpy(static_cast<std::uint8_t*>(staging.mapped()) + offset, levels[k].data(),
                    levels[k].size());
        VkBufferImageCopy region{};
        region.bufferOffset = offset;
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, k, 0, layers};
        region.imageExtent = {side, side, 1};
        regions.push_back(region);
        offset += levels[k].size();
    }

    Commands commands(device);
    commands.begin();
    // Every image lives in GENERAL: one transition for its whole life.
    VkImageMemoryBarrier2 to_general{};
    to_general.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    to_general.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    to_general.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    to_general.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    to_general.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    to_general.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    to_general.image = image_;
    to_general.subresourceRange = view.subresourceRange;
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &to_general;
    vkCmdPipelineBarrier2(commands.handle(), &dependency);
    vkCmdCopyBufferToImage(commands.handle(), staging.handle(), image_, VK_IMAGE_LAYOUT_GENERAL,
                           static_cast<std::uint32_t>(regions.size()), regions.data());
    commands.submit_and_wait();
}

TextureArray::~TextureArray() {
    vkDestroySampler(device_.handle(), sampler_, nullptr);
    vkDestroyImageView(device_.handle(), view_, nullptr);
    vkDestroyImage(device_.handle(), image_, nullptr);
    vkFreeMemory(device_.handle(), memory_, nullptr);
}

} // namespace ghost::gpu
