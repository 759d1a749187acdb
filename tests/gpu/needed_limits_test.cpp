// SPDX-License-Identifier: Apache-2.0
// A device that has less than is needed is refused in a sentence that names the limit, each of them alone.
#include "support/must.h"

#include "gpu/device.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ghost::gpu {
namespace {

TEST(NeededLimits, ADeviceThatHasLessIsRefusedByName) {
    ASSERT_GE(needed_limits().size(), 10u);
    for (const NeededLimit& needed : needed_limits()) {
        const auto device = Device::create({.lowered_limits = {{needed.name, needed.least - 1}}});
        ASSERT_FALSE(device.ok()) << needed.name;
        const std::string expected = std::string("lacks ") + needed.name + " " +
                                     std::to_string(needed.least) + " (it has " +
                                     std::to_string(needed.least - 1) + ")";
        EXPECT_NE(device.error().text().find(expected), std::string::npos) << device.error().text();
        EXPECT_TRUE(Device::create({.lowered_limits = {{needed.name, needed.least}}}).ok()) << needed.name;
    }
    EXPECT_FALSE(Device::create({.lowered_limits = {{"maxPushDescriptors", 16}}}).ok());
}

TEST(NeededLimits, WhatIsOnlyMadeUseOfMayBeLow) {
    const auto device = must(Device::create({.lowered_limits = {{"maxImageArrayLayers", 256},
                                                                {"maxMemoryAllocationCount", 4096},
                                                                {"timestampComputeAndGraphics", 0}}}));
    EXPECT_EQ(device->limits().image_layers, 256u);
    EXPECT_LE(device->limits().memory_pieces, 4096u);
    EXPECT_FALSE(device->limits().timestamps);
}

TEST(NeededLimits, APictureBeyondTheDeviceIsSaidInNumbers) {
    const UsedLimits limits{.image_layers = 2048, .image_side = 16384};
    EXPECT_EQ(beyond_limits(limits, 16384, 1, 2048), "");
    EXPECT_EQ(beyond_limits(limits, 1, 16384, 1), "");
    EXPECT_EQ(beyond_limits(limits, 30004, 2, 768),
              "pictures of 30004 x 2 in 768 layers, and this device has them up to 16384 a side and 2048 "
              "layers");
    EXPECT_NE(beyond_limits(limits, 1, 16385, 1), "");
    EXPECT_NE(beyond_limits(limits, 12, 12, 2049), "");
}

// By its callers a driver fault ends the picture, not the program.
TEST(NeededLimits, ACallThatFailsIsThrown) {
    EXPECT_THROW(vulkan_failed("vkCreateImage", "texture.cpp", 1, VK_ERROR_FORMAT_NOT_SUPPORTED),
                 std::runtime_error);
}

} // namespace
} // namespace ghost::gpu
