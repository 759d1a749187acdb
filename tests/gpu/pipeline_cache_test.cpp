// SPDX-License-Identifier: Apache-2.0
// What a driver made is there at the next start, with Mesa's driver for AMD too, which keeps what it compiled
// and needs no card for it; files that are damaged, or of another device, are made anew.
#include "support/made_shader.h"
#include "support/must.h"
#include "support/test_folder.h"

#include "disk/crc32.h"
#include "disk/files.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/pipeline_cache.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace ghost::gpu {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kHeadBytes = 12, kVulkanHeadBytes = 32; // ours; Vulkan's, 10.6.1

std::unique_ptr<Device> device_with(const fs::path& folder, const std::string& name = "") {
    return must(Device::create({.name = name, .kept_pipelines = folder.string()}));
}

// The one file that a device left there.
fs::path file_in(const fs::path& folder) {
    fs::path found;
    for (const auto& entry : fs::directory_iterator(folder)) {
        EXPECT_TRUE(found.empty()) << entry.path();
        found = entry.path();
    }
    return found;
}

std::vector<std::uint8_t> bytes_of(const fs::path& file) {
    return must(read_file(file, 1 << 20));
}

void put(const fs::path& file, std::vector<std::uint8_t> bytes, bool right_crc) {
    if (right_crc) {
        const std::uint32_t crc = crc32(Bytes(bytes).subspan(kHeadBytes));
        for (std::size_t i = 0; i < 4; ++i) bytes[8 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    }
    ASSERT_TRUE(write_file_atomic(file, Bytes(bytes)).ok());
}

TEST(PipelineCache, WhatWasMadeIsThereAtTheNextStart) {
    const TestFolder folder;
    const fs::path kept = folder.path / "cache" / "pipelines";
    {
        const auto device = device_with(kept);
        EXPECT_EQ(device->pipeline_cache().bytes_read(), 0u);
        (void)Program(*device, kNothing, {}).handle();
    }
    const fs::path file = file_in(kept);
    ASSERT_FALSE(file.empty());
    const auto device = device_with(kept);
    EXPECT_EQ(device->pipeline_cache().file(), file);
    EXPECT_EQ(device->pipeline_cache().bytes_read(), fs::file_size(file) - kHeadBytes);
    EXPECT_GE(device->pipeline_cache().bytes_read(), kVulkanHeadBytes);
}

TEST(PipelineCache, ADamagedFileIsMadeAnew) {
    const TestFolder folder;
    { const auto device = device_with(folder.path); }
    const fs::path file = file_in(folder.path);
    const std::vector<std::uint8_t> good = bytes_of(file);
    std::vector<std::vector<std::uint8_t>> bad{
        {}, {good.begin(), good.begin() + 11}, {good.begin(), good.end() - 1}};
    for (const std::size_t at : {std::size_t{0}, std::size_t{9}, kHeadBytes + 4, good.size() - 1}) {
        bad.push_back(good);
        bad.back()[at] ^= 1;
    }
    for (const std::vector<std::uint8_t>& bytes : bad) {
        put(file, bytes, false);
        {
            const auto device = device_with(folder.path);
            EXPECT_EQ(device->pipeline_cache().bytes_read(), 0u);
        }
        EXPECT_EQ(bytes_of(file), good);
    }
}

TEST(PipelineCache, NoFileAboveTheLimitIsRead) {
    const TestFolder folder;
    { const auto device = device_with(folder.path); }
    const fs::path file = file_in(folder.path);
    fs::resize_file(file, (std::uintmax_t{256} << 20) + 1); // sparse
    {
        const auto device = device_with(folder.path);
        EXPECT_EQ(device->pipeline_cache().bytes_read(), 0u);
    }
    EXPECT_LT(fs::file_size(file), 1u << 20);
}

TEST(PipelineCache, AnotherDevicesFileIsNotBelieved) {
    const TestFolder folder;
    { const auto device = device_with(folder.path); }
    const fs::path file = file_in(folder.path);
    const std::vector<std::uint8_t> good = bytes_of(file);
    // Length of its head, version, vendor, device, driver.
    for (const std::size_t at : {3u, 4u, 8u, 12u, 16u, 31u}) {
        std::vector<std::uint8_t> other = good;
        other[kHeadBytes + at] ^= 0x40;
        put(file, other, true);
        EXPECT_EQ(device_with(folder.path)->pipeline_cache().bytes_read(), 0u) << at;
    }
    put(file, good, true);
    EXPECT_EQ(device_with(folder.path)->pipeline_cache().bytes_read(), good.size() - kHeadBytes);
}

TEST(PipelineCache, FilesOfOlderDriversGoAndNothingElse) {
    const TestFolder folder;
    { const auto device = device_with(folder.path); }
    const fs::path file = file_in(folder.path);
    const std::string name = file.filename().string();
    const fs::path older =
        folder.path / (name.substr(0, name.rfind('-') + 1) + std::string(32, '0') + ".pipelines");
    const fs::path others = folder.path / ("ffff-ffff-" + std::string(32, '0') + ".pipelines");
    for (const fs::path& path : {older, others, folder.path / "notes.txt"}) std::ofstream(path) << "x";
    fs::remove(file);
    { const auto device = device_with(folder.path); }
    EXPECT_TRUE(fs::exists(file));
    EXPECT_FALSE(fs::exists(older));
    EXPECT_TRUE(fs::exists(others));
    EXPECT_TRUE(fs::exists(folder.path / "notes.txt"));
}

TEST(PipelineCache, WhereNothingCanBeKeptADeviceWorks) {
    const TestFolder folder;
    std::ofstream(folder.path / "plain") << "x";
    const auto device = device_with(folder.path / "plain" / "pipelines");
    EXPECT_TRUE(device->pipeline_cache().file().empty());
    EXPECT_NE(Program(*device, kNothing, {}).handle(), VkPipeline{VK_NULL_HANDLE});
}

TEST(PipelineCache, ALinkIsReplacedAndNotWrittenThrough) {
    const TestFolder folder;
    const fs::path kept = folder.path / "kept", victim = folder.path / "victim";
    { const auto device = device_with(kept); }
    const fs::path file = file_in(kept);
    std::ofstream(victim) << "precious";
    fs::remove(file);
    fs::create_symlink(victim, file);
    { const auto device = device_with(kept); }
    EXPECT_FALSE(fs::is_symlink(file));
    EXPECT_EQ(fs::file_size(victim), 8u);
}

TEST(PipelineCache, ADriverThatCompilesFindsItsWorkAgain) {
    const TestFolder folder;
    ::setenv("RADV_FORCE_FAMILY", "navi21", 1); // Mesa's driver for AMD makes pipelines without a card then
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    struct Unset {
        ~Unset() {
            ::unsetenv("RADV_FORCE_FAMILY");
            ::unsetenv("MESA_SHADER_CACHE_DISABLE");
        }
    } unset;
    if (!Device::create({.name = "navi21"}).ok())
        GTEST_SKIP() << "Mesa's driver for AMD is not installed, or makes no device of navi21";
    {
        const auto device = device_with(folder.path, "navi21");
        for (std::uint32_t k = 0; k < 3; ++k) (void)Program(*device, kNothing, {k}).handle();
    }
    const std::uintmax_t bytes = fs::file_size(file_in(folder.path));
    EXPECT_GT(bytes, kHeadBytes + kVulkanHeadBytes + 100) << "what it compiled";
    EXPECT_EQ(device_with(folder.path, "navi21")->pipeline_cache().bytes_read(), bytes - kHeadBytes);
}

} // namespace
} // namespace ghost::gpu
