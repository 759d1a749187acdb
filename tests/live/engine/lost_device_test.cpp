// SPDX-License-Identifier: Apache-2.0
// A device that is lost while the window draws: said, and the picture comes back with all that hands did. The
// loss is made here, by a vkQueueSubmit2 that stands before Vulkan's own.
#include "live/engine/opened_engine.h"

#include <cstdlib>
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace {
std::atomic<int> losses{0}; // that are still to come
}

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkQueueSubmit2(VkQueue queue, std::uint32_t count,
                                                         const VkSubmitInfo2* submits, VkFence fence) {
    if (losses.load() > 0) {
        --losses;
        return VK_ERROR_DEVICE_LOST;
    }
    static const auto real = reinterpret_cast<PFN_vkQueueSubmit2>(dlsym(RTLD_NEXT, "vkQueueSubmit2"));
    return real(queue, count, submits, fence);
}

namespace ghost::app {
namespace {

TEST(LostDevice, the_picture_comes_back_with_what_hands_did) {
    OpenedEngine demo;
    ASSERT_TRUE(demo.opened);
    ui::Link& link = demo.link;
    ui::ViewRequest& request = demo.request;
    std::optional<ui::Opened>& opened = demo.opened;
    demo.look_from_first_camera(64, 36);
    request.frozen = true;
    request.look.fixtures[0] = {.intensity = 1.0f, .tilt_deg = 30.0f};
    request.number = 2;
    link.request.put(request);
    std::optional<ui::Picture> before, after;
    ASSERT_TRUE(comes_within(60, [&] {
        const auto settled = link.settled.take(); // before its picture, which stands there by then
        if (auto picture = link.picture.take()) before = std::move(picture);
        return settled && *settled == 2;
    }));
    ASSERT_TRUE(before && before->image);
    (void)link.messages.take();

    losses = 1;
    request.black_out = true; // something is to be drawn
    request.number = 3;
    link.request.put(request);
    ASSERT_TRUE(comes_within(60, [&] { return (opened = link.opened.take()).has_value(); }));
    EXPECT_TRUE(opened->is_edit) << "camera, look and undo list stay";
    EXPECT_EQ(losses.load(), 0);
    request.black_out = false;
    request.number = 4;
    link.request.put(request);
    ASSERT_TRUE(comes_within(60, [&] {
        const auto settled = link.settled.take();
        if (auto picture = link.picture.take()) after = std::move(picture);
        return settled && *settled == 4;
    }));
    ASSERT_TRUE(after && after->image);
    ASSERT_EQ(after->image->samples.size(), before->image->samples.size());
    // A G-buffer that was updated has room for other fragments of silhouettes than one drawn anew: in so
    // small a picture that is seen in some of its pixels.
    std::size_t differing = 0;
    for (std::size_t k = 0; k < before->image->samples.size(); ++k)
        differing += std::abs(after->image->samples[k] - before->image->samples[k]) > 2 ? 1 : 0;
    EXPECT_LE(differing, before->image->samples.size() / 20);
    const auto messages = link.messages.take();
    ASSERT_TRUE(messages);
    EXPECT_TRUE(std::any_of(messages->begin(), messages->end(), [](const Message& message) {
        return message.what.find("device was lost") != std::string::npos;
    }));
    EXPECT_FALSE(link.failed.take());
}

} // namespace
} // namespace ghost::app
