// SPDX-License-Identifier: Apache-2.0
#include "render/present/screen.h"

#include <algorithm>
#include <utility>

namespace ghost::render {
namespace {

// Long enough for an image that is about to be free, far shorter than a display's frame.
constexpr std::uint64_t kWaitForImage_ns = 1'000'000;

// A list that Vulkan fills.
template <class T, class Call>
std::vector<T> listed(const Call& call) {
    std::uint32_t count = 0;
    VK_CALL(call(&count, static_cast<T*>(nullptr)));
    std::vector<T> all(count);
    if (count > 0) VK_CALL(call(&count, all.data()));
    all.resize(count);
    return all;
}

VkSemaphore make_semaphore(const gpu::Device& device) {
    VkSemaphoreCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    VkSemaphore made = VK_NULL_HANDLE;
    VK_CALL(vkCreateSemaphore(device.handle(), &info, nullptr, &made));
    return made;
}

void change_layout(gpu::Commands& commands, VkImage image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    // From what the semaphore waits with, to the copy; from the copy to what the other one tells.
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = from == VK_IMAGE_LAYOUT_UNDEFINED ? 0 : VK_ACCESS_2_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = from == VK_IMAGE_LAYOUT_UNDEFINED ? VK_ACCESS_2_TRANSFER_WRITE_BIT : 0;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands.handle(), &dependency);
}

bool is_same(VkExtent2D a, VkExtent2D b) {
    return a.width == b.width && a.height == b.height;
}

} // namespace

Screen::Slot::Slot(const gpu::Device& of) : device(of), commands(of), free(make_semaphore(of)) {}

Screen::Slot::~Slot() {
    vkDestroySemaphore(device.handle(), free, nullptr);
}

Screen::Screen(const gpu::Device& device, const PresentPass& pass, VkSurfaceKHR surface, bool hdr)
    : device_(device), pass_(pass), surface_(surface), hdr_(hdr) {
    for (auto& slot : slots_) slot = std::make_unique<Slot>(device);
}

Screen::~Screen() {
    let_go();
    // Showing may still wait for semaphores; of a lost device nothing does.
    (void)vkQueueWaitIdle(device_.queue());
    for (const VkSemaphore one : drawn_) vkDestroySemaphore(device_.handle(), one, nullptr);
}

void Screen::wait() {
    for (const auto& slot : slots_) {
        if (!std::exchange(slot->is_busy, false)) continue;
        slot->commands.wait();
    }
}

void Screen::let_go() {
    is_lost_ = true;
    destroy_swapchain();
}

void Screen::destroy_swapchain() {
    if (swapchain_ == VK_NULL_HANDLE) return;
    try {
        wait();
    } catch (const std::exception&) {
        // The device is lost: nothing runs there.
    }
    vkDestroySwapchainKHR(device_.handle(), std::exchange(swapchain_, VK_NULL_HANDLE), nullptr);
    images_.clear();
}

VkSurfaceCapabilitiesKHR Screen::capabilities() {
    VkSurfaceCapabilitiesKHR can{};
    const VkResult asked = vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &can);
    if (asked == VK_ERROR_SURFACE_LOST_KHR)
        is_lost_ = true;
    else if (asked != VK_SUCCESS)
        why_never_ = "the display's surface says nothing of itself";
    return can;
}

bool Screen::find_format() {
    if (format_) return true;
    VkBool32 can = VK_FALSE;
    const VkResult asked =
        vkGetPhysicalDeviceSurfaceSupportKHR(device_.physical(), device_.queue_family(), surface_, &can);
    if (asked != VK_SUCCESS || can == VK_FALSE) {
        why_never_ = "the graphics device does not reach this display";
        return false;
    }
    std::uint32_t count = 0;
    std::vector<VkSurfaceFormatKHR> offered;
    if (vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, nullptr) == VK_SUCCESS) {
        offered.resize(count);
        (void)vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, offered.data());
        offered.resize(count);
    }
    format_ = choose_format(offered, hdr_);
    // Where it is drawn as it will be copied.
    if (format_ && device_.first_format(std::array{format_->drawn, VK_FORMAT_UNDEFINED},
                                        VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) != format_->drawn)
        format_ = choose_format(offered, false);
    if (!format_) why_never_ = "the display has no format that is known here";
    return format_.has_value();
}

bool Screen::make(VkExtent2D wanted) {
    if (!find_format()) return false;
    const VkSurfaceCapabilitiesKHR can = capabilities();
    if (is_lost_ || !why_never_.empty()) return false;
    const VkExtent2D extent = choose_extent(can, wanted);
    if (extent.width == 0 || extent.height == 0) return false;
    if ((can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT) == 0) {
        why_never_ = "nothing can be copied to the display's pictures";
        return false;
    }
    const std::vector<VkPresentModeKHR> modes = listed<VkPresentModeKHR>([&](auto* count, auto* all) {
        return vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physical(), surface_, count, all);
    });
    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = surface_;
    info.presentMode = choose_mode(modes);
    info.minImageCount = choose_images(can, info.presentMode);
    info.imageFormat = format_->surface.format;
    info.imageColorSpace = format_->surface.colorSpace;
    info.imageExtent = extent;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = can.currentTransform;
    info.compositeAlpha = choose_alpha(can);
    info.clipped = VK_TRUE;
    destroy_swapchain();
    const VkResult made = vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &swapchain_);
    if (made == VK_ERROR_SURFACE_LOST_KHR || made == VK_ERROR_NATIVE_WINDOW_IN_USE_KHR) {
        is_lost_ = true;
        return false;
    }
    VK_CALL(made);
    images_ = listed<VkImage>([&](auto* count, auto* all) {
        return vkGetSwapchainImagesKHR(device_.handle(), swapchain_, count, all);
    });
    while (drawn_.size() < images_.size()) drawn_.push_back(make_semaphore(device_));
    if (!is_same(extent, extent_) || all_.shape().format != format_->drawn || all_.bytes() == 0)
        all_ = gpu::Texture(device_, {extent.width, extent.height, 1, 1, format_->drawn, true, false});
    extent_ = extent;
    made_for_ = wanted;
    return true;
}

void Screen::take_covers(const std::shared_ptr<const image::Image8>& covers) {
    if (covers == covers_of_) return;
    covers_of_ = covers;
    if (!covers || covers->empty()) return;
    const auto width = static_cast<std::uint32_t>(covers->width),
               height = static_cast<std::uint32_t>(covers->height);
    if (covers_.bytes() == 0 || covers_.shape().width != width || covers_.shape().height != height) {
        wait();
        covers_ = gpu::Texture(device_, {width, height, 1, 1, VK_FORMAT_B8G8R8A8_UNORM, false, false});
    }
    covers_.write(0, covers->samples.data(), covers->samples.size());
}

Screen::Shown Screen::show(const ScreenPicture& picture, const PicturePlace& place, VkExtent2D wanted,
                           const std::shared_ptr<const image::Image8>& covers) {
    // The window may have another size before its surface does, and a surface before anybody says so.
    const bool fits = swapchain_ != VK_NULL_HANDLE && is_same(wanted, made_for_);
    if (!is_lost_ && why_never_.empty() && (!fits || !is_same(extent_, wanted))) {
        const bool is_other = !fits || !is_same(choose_extent(capabilities(), wanted), extent_);
        if (is_other && !is_lost_ && why_never_.empty() && !make(wanted) && !is_lost_ && why_never_.empty())
            return Shown::later;
    }
    if (!why_never_.empty()) return Shown::never;
    if (is_lost_) return Shown::lost;
    Slot& slot = *slots_[next_];
    if (std::exchange(slot.is_busy, false)) slot.commands.wait();
    std::uint32_t image = 0;
    const VkResult acquired = vkAcquireNextImageKHR(device_.handle(), swapchain_, kWaitForImage_ns, slot.free,
                                                    VK_NULL_HANDLE, &image);
    switch (acquired) {
    case VK_SUCCESS:
    case VK_SUBOPTIMAL_KHR:
        break;
    case VK_NOT_READY:
    case VK_TIMEOUT:
        return Shown::later;
    case VK_ERROR_OUT_OF_DATE_KHR:
        destroy_swapchain();
        return Shown::later;
    case VK_ERROR_SURFACE_LOST_KHR:
        is_lost_ = true;
        return Shown::lost;
    default:
        VK_CALL(acquired);
    }
    take_covers(covers);
    next_ = (next_ + 1) % slots_.size();
    return present(slot, image, picture, place);
}

Screen::Shown Screen::present(Slot& slot, std::uint32_t image, const ScreenPicture& picture,
                              const PicturePlace& place) {
    gpu::Commands& commands = slot.commands;
    commands.begin();
    const bool covers = covers_of_ && covers_.bytes() > 0 && covers_.shape().width == extent_.width &&
                        covers_.shape().height == extent_.height;
    pass_.record(commands, picture, place, covers ? &covers_ : nullptr, *format_, all_);
    copy_to(commands, images_[image]);
    commands.submit(slot.free, drawn_[image]);
    slot.is_busy = true;
    VkPresentInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &drawn_[image];
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &image;
    const VkResult presented = vkQueuePresentKHR(device_.queue(), &info);
    switch (presented) {
    case VK_SUCCESS:
    case VK_SUBOPTIMAL_KHR: // another size, which show() looks for
        return Shown::yes;
    case VK_ERROR_OUT_OF_DATE_KHR:
        destroy_swapchain();
        return Shown::later;
    case VK_ERROR_SURFACE_LOST_KHR:
        is_lost_ = true;
        return Shown::lost;
    default:
        VK_CALL(presented);
    }
    return Shown::yes;
}

void Screen::copy_to(gpu::Commands& commands, VkImage image) const {
    change_layout(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkImageCopy part{};
    part.srcSubresource = part.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    part.extent = {extent_.width, extent_.height, 1};
    vkCmdCopyImage(commands.handle(), all_.handles(device_).image, VK_IMAGE_LAYOUT_GENERAL, image,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &part);
    change_layout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
}

} // namespace ghost::render
