// SPDX-License-Identifier: Apache-2.0
// Swapchains of a surface without a display (VK_EXT_headless_surface), under the validation layer.
#include "render/present/screen.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <memory>

namespace ghost::render {
namespace {

class ScreenTest : public testing::Test {
protected:
    void SetUp() override {
        gpu::DeviceOptions options;
        options.validation = true;
        options.presents = true;
        device_ = must(gpu::Device::create(options));
        const auto instance = device_->instance_of_surfaces();
        const auto make = instance ? reinterpret_cast<PFN_vkCreateHeadlessSurfaceEXT>(vkGetInstanceProcAddr(
                                         instance->handle(), "vkCreateHeadlessSurfaceEXT"))
                                   : nullptr;
        if (!make) GTEST_SKIP() << "this driver has no surfaces without a display";
        VkHeadlessSurfaceCreateInfoEXT info{};
        info.sType = VK_STRUCTURE_TYPE_HEADLESS_SURFACE_CREATE_INFO_EXT;
        ASSERT_EQ(make(instance->handle(), &info, nullptr, &surface_), VK_SUCCESS);
        pass_ = std::make_unique<PresentPass>(*device_);
        picture_ = gpu::Texture(*device_, {64, 36, 1, 1, VK_FORMAT_R8G8B8A8_UNORM, true, true});
        const std::vector<std::uint8_t> grey(std::size_t{4} * 64 * 36, 128);
        picture_.write(0, grey.data(), grey.size());
    }
    void TearDown() override {
        if (!device_) return;
        picture_ = {};
        pass_.reset();
        if (surface_ != VK_NULL_HANDLE)
            vkDestroySurfaceKHR(device_->instance_of_surfaces()->handle(), surface_, nullptr);
        EXPECT_EQ(device_->validation_errors(), 0u);
    }

    // Once there is an image for it.
    static Screen::Shown show(Screen& screen, const ScreenPicture& picture, VkExtent2D size,
                              const std::shared_ptr<const image::Image8>& covers = nullptr) {
        Screen::Shown shown = Screen::Shown::later;
        for (int tries = 0; tries < 1000 && shown == Screen::Shown::later; ++tries)
            shown = screen.show(picture,
                                {0, 0, static_cast<double>(size.width), static_cast<double>(size.height)},
                                size, covers);
        return shown;
    }

    static std::shared_ptr<const image::Image8> covers_of(VkExtent2D size) {
        return std::make_shared<image::Image8>(static_cast<int>(size.width), static_cast<int>(size.height),
                                               4);
    }

    std::unique_ptr<gpu::Device> device_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    std::unique_ptr<PresentPass> pass_;
    gpu::Texture picture_;
};

TEST_F(ScreenTest, picture_after_picture_is_shown_in_any_size) {
    Screen screen(*device_, *pass_, surface_, false);
    const VkExtent2D first{64, 36}, second{200, 100};
    for (int k = 0; k < 8; ++k) ASSERT_EQ(show(screen, {&picture_}, first), Screen::Shown::yes) << k;
    EXPECT_EQ(screen.extent().width, 64u);
    for (int k = 0; k < 8; ++k)
        ASSERT_EQ(show(screen, {&picture_}, second, covers_of(second)), Screen::Shown::yes) << k;
    EXPECT_EQ(screen.extent().width, 200u);
    // What lies over it is still that of the size before.
    ASSERT_EQ(show(screen, {&picture_}, first, covers_of(second)), Screen::Shown::yes);
    ASSERT_EQ(show(screen, {}, first), Screen::Shown::yes) << "no picture yet";
    screen.wait();
    EXPECT_EQ(screen.encoding(), Encoding::srgb);
}

TEST_F(ScreenTest, hdr_is_not_taken_where_the_display_has_none) {
    Screen screen(*device_, *pass_, surface_, true);
    ASSERT_EQ(show(screen, {&picture_}, {64, 36}), Screen::Shown::yes);
    EXPECT_EQ(screen.encoding(), Encoding::srgb);
}

TEST_F(ScreenTest, a_surface_that_was_let_go_is_lost_and_serves_another_screen) {
    auto screen = std::make_unique<Screen>(*device_, *pass_, surface_, false);
    ASSERT_EQ(show(*screen, {&picture_}, {64, 36}), Screen::Shown::yes);
    screen->let_go();
    EXPECT_EQ(show(*screen, {&picture_}, {64, 36}), Screen::Shown::lost);
    Screen other(*device_, *pass_, surface_, false);
    ASSERT_EQ(show(other, {&picture_}, {64, 36}), Screen::Shown::yes);
    screen.reset();
    ASSERT_EQ(show(other, {&picture_}, {64, 36}), Screen::Shown::yes);
}

// Devices come and go with what is opened.
TEST_F(ScreenTest, a_surface_outlives_the_device) {
    {
        Screen screen(*device_, *pass_, surface_, false);
        ASSERT_EQ(show(screen, {&picture_}, {64, 36}), Screen::Shown::yes);
    }
    gpu::DeviceOptions options;
    options.validation = true;
    options.presents = true;
    const auto next = must(gpu::Device::create(options));
    ASSERT_EQ(next->instance_of_surfaces(), device_->instance_of_surfaces());
    const PresentPass pass(*next);
    Screen screen(*next, pass, surface_, false);
    ASSERT_EQ(show(screen, {}, {64, 36}), Screen::Shown::yes);
}

} // namespace
} // namespace ghost::render
