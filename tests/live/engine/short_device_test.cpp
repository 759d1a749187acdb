// SPDX-License-Identifier: Apache-2.0
// A device whose memory is at its end while the window draws: said, and drawn with less. The shortage is made
// here, by a vkAllocateMemory that stands before Vulkan's own.
#include "live/engine/opened_engine.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace {
std::atomic<bool> is_next_short{false};
std::atomic<VkDevice> short_device{VK_NULL_HANDLE}; // has nothing more to give
} // namespace

extern "C" VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                                           const VkAllocationCallbacks* callbacks,
                                                           VkDeviceMemory* memory) {
    if (is_next_short.exchange(false)) short_device = device;
    if (device == short_device.load()) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    static const auto real = reinterpret_cast<PFN_vkAllocateMemory>(dlsym(RTLD_NEXT, "vkAllocateMemory"));
    return real(device, info, callbacks, memory);
}

namespace ghost::app {
namespace {

TEST(ShortDevice, it_is_drawn_with_less_and_nothing_is_lost) {
    OpenedEngine demo;
    ASSERT_TRUE(demo.opened);
    ui::Link& link = demo.link;
    ui::ViewRequest& request = demo.request;
    std::optional<ui::Opened>& opened = demo.opened;
    demo.look_from_first_camera(64, 36);
    request.frozen = true;
    request.look.fixtures[0] = {.intensity = 1.0f, .tilt_deg = 30.0f};
    const auto settled_picture = [&](std::uint64_t number) {
        std::optional<ui::Picture> last;
        request.number = number;
        link.request.put(request);
        EXPECT_TRUE(comes_within(60, [&] {
            const auto settled = link.settled.take();
            if (auto picture = link.picture.take()) last = std::move(picture);
            return settled && *settled == number;
        }));
        return last;
    };
    const auto before = settled_picture(2);
    ASSERT_TRUE(before && before->image);
    (void)link.messages.take();

    is_next_short = true; // while a picture of another size is made
    request.camera.width = 128;
    request.camera.height = 72;
    const auto after = settled_picture(3);
    EXPECT_FALSE(is_next_short.load());
    ASSERT_TRUE(after && after->image);
    EXPECT_EQ(after->image->width, 128);
    EXPECT_GT(*std::max_element(after->image->samples.begin(), after->image->samples.begin() + 3000), 0);
    ASSERT_TRUE(comes_within(60, [&] { return (opened = link.opened.take()).has_value(); }));
    EXPECT_TRUE(opened->is_edit) << "camera, look and undo list stay";
    const auto messages = link.messages.take();
    ASSERT_TRUE(messages);
    EXPECT_EQ(std::count_if(messages->begin(), messages->end(),
                            [](const Message& message) {
                                return message.what.find("has no more memory for drawing") !=
                                       std::string::npos;
                            }),
              1);
    EXPECT_FALSE(link.failed.take());
}

} // namespace
} // namespace ghost::app
