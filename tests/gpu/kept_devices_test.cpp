// SPDX-License-Identifier: Apache-2.0
// A device that goes leaves its pipelines to the next one, where somebody keeps devices; counters, limits and
// what validation says are of the new one alone.
#include "support/made_shader.h"
#include "support/must.h"

#include "gpu/commands.h"
#include "gpu/device_failures.h"
#include "gpu/device_memory.h"
#include "gpu/kept_devices.h"

#include <gtest/gtest.h>
#include <vector>

namespace ghost::gpu {
namespace {

std::unique_ptr<Device> checked_device(DeviceOptions options = {}) {
    options.validation = true;
    return must(Device::create(options));
}

// How many pipelines a device has that follows one with a single pipeline.
std::size_t pipelines_after(const DeviceOptions& first = {}, const DeviceOptions& second = {}) {
    {
        const auto device = checked_device(first);
        (void)Program(*device, kNothing).handle();
    }
    return checked_device(second)->pipelines().count();
}

TEST(KeptDevices, NothingIsKeptWhereNobodySaysSo) {
    EXPECT_EQ(pipelines_after(), 0u);
}

TEST(KeptDevices, TheNextDeviceHasThePipelines) {
    const KeptDevices keeper;
    EXPECT_EQ(pipelines_after(), 1u);
    VkPipeline before = VK_NULL_HANDLE;
    {
        const auto device = checked_device();
        before = Program(*device, kNothing).handle();
        device->work().dispatches = 5;
    }
    const auto device = checked_device({.memory_limit_bytes = 1 << 20});
    EXPECT_EQ(Program(*device, kNothing).handle(), before);
    EXPECT_EQ(device->work().dispatches, 0u);
    EXPECT_EQ(device->memory().left_bytes(), 1u << 20);
    EXPECT_EQ(device->validation_errors(), 0u);
}

TEST(KeptDevices, WhatIsStillToBeMadeIsMade) {
    const KeptDevices keeper;
    constexpr std::uint32_t kPrograms = 40;
    {
        const auto device = checked_device();
        for (std::uint32_t k = 0; k < kPrograms; ++k) Program(*device, kNothing, std::vector{k});
    }
    const auto device = checked_device();
    EXPECT_EQ(device->pipelines().count(), kPrograms);
    const std::uint64_t waited = device->pipelines().waited_for();
    (void)Program(*device, kNothing, std::vector{kPrograms - 1}).handle();
    EXPECT_EQ(device->pipelines().waited_for(), waited);
}

TEST(KeptDevices, TwoAtOnceShareNothing) {
    const KeptDevices keeper;
    (void)checked_device();
    const auto one = checked_device(), other = checked_device();
    EXPECT_NE(one->handle(), other->handle());
}

TEST(KeptDevices, AsManyAreKeptAsThereIsRoomFor) {
    const auto count_twice = [](std::size_t room) {
        const KeptDevices keeper(room);
        {
            const auto one = checked_device(), other = checked_device();
            (void)Program(*one, kNothing).handle();
            (void)Program(*other, kNothing).handle();
        }
        const auto one = checked_device(), other = checked_device();
        return one->pipelines().count() + other->pipelines().count();
    };
    EXPECT_EQ(count_twice(1), 1u);
    EXPECT_EQ(count_twice(2), 2u);
    EXPECT_EQ(pipelines_after(), 0u) << "nobody keeps any more";
}

TEST(KeptDevices, ValidationSpeaksToTheNewOne) {
    const KeptDevices keeper;
    (void)checked_device();
    const auto device = checked_device();
    VkBufferCreateInfo nothing{};
    nothing.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO; // of no bytes, for no use
    VkBuffer buffer = VK_NULL_HANDLE;
    (void)vkCreateBuffer(device->handle(), &nothing, nullptr, &buffer);
    EXPECT_GT(device->validation_errors(), 0u);
    if (buffer != VK_NULL_HANDLE) vkDestroyBuffer(device->handle(), buffer, nullptr);
}

TEST(KeptDevices, OneWithAnotherValidationIsAnother) {
    const KeptDevices keeper;
    {
        const auto device = checked_device();
        (void)Program(*device, kNothing).handle();
    }
    EXPECT_EQ(must(Device::create({}))->pipelines().count(), 0u);
}

TEST(KeptDevices, OneThatKeepsStatisticsIsNeitherKeptNorTakenUp) {
    const KeptDevices keeper;
    EXPECT_EQ(pipelines_after({.pipeline_statistics = true}), 0u);
    EXPECT_EQ(pipelines_after({}, {.pipeline_statistics = true}), 0u);
}

TEST(KeptDevices, ADeviceWhosePipelineFailedGoes) {
    const KeptDevices keeper;
    {
        const auto device = checked_device();
        (void)device->pipelines().begin({}, {kNothing, {}, false, 0, {}},
                                        []() -> Pipeline { throw DeviceLost("gone"); });
    }
    EXPECT_EQ(checked_device()->pipelines().count(), 0u);
}

TEST(KeptDevices, AnotherNameThatIsNoDeviceLeavesWhatIsKept) {
    const KeptDevices keeper;
    {
        const auto device = checked_device();
        (void)Program(*device, kNothing).handle();
    }
    EXPECT_FALSE(Device::create({.name = "no such device", .validation = true}).ok());
    EXPECT_EQ(checked_device()->pipelines().count(), 1u);
}

} // namespace
} // namespace ghost::gpu
