// SPDX-License-Identifier: Apache-2.0
// A device that has less than is needed is refused in a sentence that names the limit, each of them alone.
#include "support/must.h"

#include "gpu/device.h"

#include <gtest/gtest.h>

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
    const auto device = must(Device::create(
        {.lowered_limits = {{"maxImageArrayLayers", 256}, {"timestampComputeAndGraphics", 0}}}));
    EXPECT_EQ(device->limits().image_layers, 256u);
    EXPECT_FALSE(device->limits().timestamps);
}

} // namespace
} // namespace ghost::gpu
