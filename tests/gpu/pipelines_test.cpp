// SPDX-License-Identifier: Apache-2.0
// Pipelines that are made side by side: each once, whoever asks; a failure reaches who uses it; a device may
// go while some are not made.
#include "support/made_shader.h"
#include "support/must.h"

#include "gpu/commands.h"
#include "gpu/device_failures.h"

#include <atomic>
#include <gtest/gtest.h>
#include <set>
#include <thread>

namespace ghost::gpu {
namespace {

std::unique_ptr<Device> own_device() {
    return must(Device::create({.validation = true}));
}

PipelineKey key_of(std::uint64_t number) {
    PipelineKey key;
    key.add(number);
    return key;
}

TEST(Pipelines, ManyPeopleAskAndEachIsMadeOnce) {
    const auto device = own_device();
    constexpr std::uint32_t kPrograms = 60;
    std::vector<std::unique_ptr<Program>> programs;
    for (std::uint32_t k = 0; k < kPrograms; ++k)
        programs.push_back(std::make_unique<Program>(*device, kNothing, std::vector{k / 2}));
    EXPECT_EQ(device->pipelines().count(), kPrograms / 2);
    std::vector<std::thread> people;
    std::vector<std::vector<VkPipeline>> seen(4);
    for (std::vector<VkPipeline>& mine : seen)
        people.emplace_back([&] {
            for (const auto& program : programs) mine.push_back(program->handle());
        });
    for (std::thread& person : people) person.join();
    for (const std::vector<VkPipeline>& mine : seen) EXPECT_EQ(mine, seen.front());
    EXPECT_EQ(std::set<VkPipeline>(seen.front().begin(), seen.front().end()).size(), kPrograms / 2);
    const std::vector<PipelineMade> made = device->pipelines().made();
    ASSERT_EQ(made.size(), kPrograms / 2);
    EXPECT_EQ(made[7].constants, std::vector{7u}) << "in the order in which they were asked for";
    const std::uint64_t waited = device->pipelines().waited_for();
    (void)programs.front()->handle();
    EXPECT_EQ(device->pipelines().waited_for(), waited) << "nobody waits for what is there";
    EXPECT_EQ(device->validation_errors(), 0u);
}

TEST(Pipelines, AFailureReachesEverybodyWhoUsesIt) {
    const auto device = own_device();
    Pipelines& pipelines = device->pipelines();
    Pipelines::Entry& lost = pipelines.begin(key_of(1), {kNothing, {}, false, 0, {}},
                                             []() -> Pipeline { throw DeviceLost("gone"); });
    for (int k = 0; k < 2; ++k) EXPECT_THROW((void)pipelines.finish(lost), DeviceLost);
}

TEST(Pipelines, ADeviceGoesWhileSomeAreNotMade) {
    std::atomic<int> made = 0;
    constexpr int kAsked = 200;
    {
        const auto device = own_device();
        for (int k = 0; k < kAsked; ++k)
            (void)device->pipelines().begin(key_of(static_cast<std::uint64_t>(k)),
                                            {kNothing, {}, false, 0, {}}, [&] {
                                                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                                                ++made;
                                                return Pipeline{};
                                            });
    }
    EXPECT_LT(made, kAsked);
}

TEST(Pipelines, WhatMayNeverBeUsedIsMadeWhenSomebodySaysSo) {
    const auto device = own_device();
    Pipelines& pipelines = device->pipelines();
    std::atomic<int> made = 0;
    const auto make = [&] {
        ++made;
        return Pipeline{};
    };
    for (std::uint64_t k = 0; k < 6; ++k)
        for (int twice = 0; twice < 2; ++twice)
            pipelines.begin_late(key_of(k), {kNothing, {static_cast<std::uint32_t>(k)}, false, 0, {}}, make);
    EXPECT_EQ(pipelines.late_count(), 6u);
    (void)pipelines.finish(pipelines.begin(key_of(2), {kNothing, {2}, false, 0, {}}, make));
    EXPECT_EQ(made, 1) << "the one that is used, and no other";
    EXPECT_EQ(pipelines.late_count(), 5u);
    ASSERT_EQ(pipelines.made().size(), 1u);
    pipelines.make_late();
    while (pipelines.late_count() > 0 || made < 6) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(pipelines.made().size(), 6u);
    const std::uint64_t waited = pipelines.waited_for();
    (void)pipelines.finish(pipelines.begin(key_of(4), {kNothing, {4}, false, 0, {}}, make));
    EXPECT_EQ(pipelines.waited_for(), waited);
    EXPECT_EQ(made, 6);
    EXPECT_EQ(pipelines.count(), 6u);
}

TEST(Pipelines, ADeviceGoesWhileLateOnesAreNotMade) {
    std::atomic<int> made = 0;
    {
        const auto device = own_device();
        device->pipelines().make_late();
        for (std::uint64_t k = 0; k < 200; ++k)
            device->pipelines().begin_late(key_of(k), {kNothing, {}, false, 0, {}}, [&] {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                ++made;
                return Pipeline{};
            });
    }
    EXPECT_LT(made, 200);
}

// As a show that is closed while it opens.
TEST(Pipelines, ADeviceGoesWhileProgramsAreMade) {
    for (int round = 0; round < 20; ++round) {
        const auto device = own_device();
        for (std::uint32_t k = 0; k < 100; ++k) (void)Program(*device, kNothing, {k});
    }
}

} // namespace
} // namespace ghost::gpu
