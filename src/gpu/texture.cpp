// SPDX-License-Identifier: Apache-2.0
#include "gpu/texture.h"

#include "base/check.h"
#include "gpu/buffer.h"
#include "gpu/commands.h"

#include <algorithm>
#include <cstring>

namespace ghost::gpu {
namespace {

bool is_depth(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM;
}

VkImageUsageFlags usage_of(const TextureShape& shape) {
    VkImageUsageFlags usage =
        VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (shape.storage) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (shape.attachment)
        usage |= is_depth(shape.format) ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                        : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    return usage;
}

// Linear in memory that is ours, too: a processor's driver has no other way to lay an image out.
bool is_mapped(const Device& device, const TextureShape& shape) {
    if (!device.is_cpu() || !shape.storage || shape.attachment || shape.levels > 1 || shape.samples > 1)
        return false;
    VkImageFormatProperties has{};
    const VkResult known = vkGetPhysicalDeviceImageFormatProperties(
        device.physical(), shape.format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_LINEAR, usage_of(shape), 0, &has);
    return known == VK_SUCCESS && has.maxArrayLayers >= shape.layers && has.maxExtent.width >= shape.width &&
           has.maxExtent.height >= shape.height;
}

VkImageCreateInfo image_info(const Device& device, const TextureShape& shape) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = shape.format;
    info.extent = {shape.width, shape.height, 1};
    info.mipLevels = shape.levels;
    info.arrayLayers = shape.layers;
    CHECK(shape.samples == 1 || (shape.attachment && shape.layers == 1 && shape.levels == 1));
    info.samples = static_cast<VkSampleCountFlagBits>(shape.samples);
    info.usage = usage_of(shape);
    info.tiling = is_mapped(device, shape) ? VK_IMAGE_TILING_LINEAR : VK_IMAGE_TILING_OPTIMAL;
    return info;
}

} // namespace

std::uint64_t texture_bytes(const Device& device, const TextureShape& shape) {
    const VkImageCreateInfo info = image_info(device, shape);
    VkDeviceImageMemoryRequirements asked{};
    asked.sType = VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS;
    asked.pCreateInfo = &info;
    VkMemoryRequirements2 needs{};
    needs.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2;
    vkGetDeviceImageMemoryRequirements(device.handle(), &asked, &needs);
    return needs.memoryRequirements.size;
}

namespace {

VkImageAspectFlags aspect_of(VkFormat format) {
    return is_depth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageView view_of(const Device& device, const TextureShape& shape, VkImage image, std::uint32_t level,
                    std::uint32_t levels) {
    VkImageViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    info.image = image;
    info.viewType = shape.samples > 1 ? VK_IMAGE_VIEW_TYPE_2D : VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    info.format = shape.format;
    info.subresourceRange = {aspect_of(shape.format), level, levels, 0, shape.layers};
    VkImageView view = VK_NULL_HANDLE;
    VK_CALL(vkCreateImageView(device.handle(), &info, nullptr, &view));
    return view;
}

// What stands on an image that has its memory; it is in the GENERAL layout then.
void finish_image(const Device& device, const TextureShape& shape, Texture::Handles& handles) {
    handles.view = view_of(device, shape, handles.image, 0, shape.levels);

    VkSamplerCreateInfo sampler{};
    sampler.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    sampler.magFilter = shape.linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    sampler.minFilter = sampler.magFilter;
    sampler.mipmapMode = shape.linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
    sampler.addressModeU =
        shape.repeat ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    sampler.addressModeV = sampler.addressModeU;
    sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    // Equal minLod and maxLod (zero) would double the time of a whole shader on lavapipe.
    sampler.maxLod = VK_LOD_CLAMP_NONE;
    VK_CALL(vkCreateSampler(device.handle(), &sampler, nullptr, &handles.sampler));

    VkImageMemoryBarrier2 to_general{};
    to_general.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    to_general.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    to_general.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    to_general.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    to_general.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    to_general.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    to_general.image = handles.image;
    to_general.subresourceRange = {aspect_of(shape.format), 0, shape.levels, 0, shape.layers};
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &to_general;
    Commands commands(device);
    commands.begin();
    vkCmdPipelineBarrier2(commands.handle(), &dependency);
    commands.submit_and_wait();
}

} // namespace

Texture::Texture(const Device& device, const TextureShape& shape) : device_(&device), shape_(shape) {
    const VkImageCreateInfo info = image_info(device, shape);
    VK_CALL(vkCreateImage(device.handle(), &info, nullptr, &own_.image));
    constexpr VkMemoryPropertyFlags kOurs =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const bool ours = info.tiling == VK_IMAGE_TILING_LINEAR || !device.workers().empty();
    try {
        memory_ = device.memory().bind(own_.image, info.tiling,
                                       VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | (ours ? kOurs : 0));
    } catch (...) {
        vkDestroyImage(device.handle(), own_.image, nullptr);
        throw;
    }
    if (info.tiling == VK_IMAGE_TILING_LINEAR && memory_.mapped) find_texels();
    finish_image(device, shape, own_);
    for (std::uint32_t level = 0; shape.storage && shape.levels > 1 && level < shape.levels; ++level)
        level_views_.push_back(view_of(device, shape, own_.image, level, 1));
}

const Texture::Handles& Texture::on_worker(const Device& worker) const {
    if (const auto known = on_workers_.find(&worker); known != on_workers_.end()) return known->second;
    Handles made;
    VkExternalMemoryImageCreateInfo shared{};
    shared.sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO;
    shared.handleTypes = VK_EXTERNAL_MEMORY_HANDLE_TYPE_HOST_ALLOCATION_BIT_EXT;
    VkImageCreateInfo info = image_info(worker, shape_);
    info.pNext = &shared;
    VK_CALL(vkCreateImage(worker.handle(), &info, nullptr, &made.image));
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(worker.handle(), made.image, &needs);
    CHECK_EQ(needs.size, memory_.bytes);
    made.memory = worker.memory().share(memory_.mapped, memory_.bytes);
    VK_CALL(vkBindImageMemory(worker.handle(), made.image, made.memory, 0));
    finish_image(worker, shape_, made);
    return on_workers_.emplace(&worker, made).first->second;
}

void Texture::find_texels() {
    const VkImageSubresource first{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0};
    VkSubresourceLayout layout;
    vkGetImageSubresourceLayout(device_->handle(), own_.image, &first, &layout);
    mapped_ = memory_.mapped + layout.offset;
    row_bytes_ = layout.rowPitch;
    layer_bytes_ = layout.arrayPitch;
}

VkImageAspectFlags Texture::aspect() const {
    return aspect_of(shape_.format);
}

void Texture::write(std::uint32_t level, const void* data, std::uint64_t bytes) {
    upload(level, 0, shape_.layers, data, bytes);
}

void Texture::write_layer(std::uint32_t layer, const void* data, std::uint64_t bytes, std::uint32_t level) {
    upload(level, layer, 1, data, bytes);
}

void Texture::upload(std::uint32_t level, std::uint32_t layer, std::uint32_t layers, const void* data,
                     std::uint64_t bytes) {
    CHECK(level < shape_.levels && layer + layers <= shape_.layers);
    const Buffer staging(*device_, bytes, Access::upload);
    std::memcpy(staging.mapped(), data, bytes);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, layer, layers};
    region.imageExtent = {std::max(shape_.width >> level, 1u), std::max(shape_.height >> level, 1u), 1};
    Commands commands(*device_);
    commands.begin();
    vkCmdCopyBufferToImage(commands.handle(), staging.handle(), own_.image, VK_IMAGE_LAYOUT_GENERAL, 1,
                           &region);
    commands.submit_and_wait();
}

namespace {

void destroy_image(const Device& device, const Texture::Handles& handles) {
    vkDestroySampler(device.handle(), handles.sampler, nullptr);
    vkDestroyImageView(device.handle(), handles.view, nullptr);
    vkDestroyImage(device.handle(), handles.image, nullptr);
}

} // namespace

Texture::~Texture() {
    if (!device_) return;
    for (const auto& [worker, handles] : on_workers_) {
        destroy_image(*worker, handles);
        vkFreeMemory(worker->handle(), handles.memory, nullptr);
    }
    for (const VkImageView view : level_views_) vkDestroyImageView(device_->handle(), view, nullptr);
    destroy_image(*device_, own_);
    device_->memory().release(memory_);
}

void Texture::swap(Texture& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(shape_, other.shape_);
    std::swap(own_, other.own_);
    std::swap(level_views_, other.level_views_);
    std::swap(on_workers_, other.on_workers_);
    std::swap(memory_, other.memory_);
    std::swap(mapped_, other.mapped_);
    std::swap(row_bytes_, other.row_bytes_);
    std::swap(layer_bytes_, other.layer_bytes_);
}

} // namespace ghost::gpu
