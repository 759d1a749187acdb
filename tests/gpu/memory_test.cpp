// SPDX-License-Identifier: Apache-2.0
// Who has how much of a device's memory, and where.
#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/device_failures.h"
#include "gpu/device_memory.h"
#include "gpu/texture.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace ghost::gpu {
namespace {

constexpr std::uint64_t kMB = 1u << 20;

std::unique_ptr<Device> device_with(std::uint64_t limit_bytes) {
    return must(Device::create({.validation = true, .memory_limit_bytes = limit_bytes}));
}

TEST(Memory, is_counted_while_it_is_held) {
    const auto device = device_with(0);
    const std::uint64_t left = device->memory().left_bytes();
    EXPECT_GT(left, 64 * kMB);
    EXPECT_EQ(device->memory().used_bytes(), 0u);
    {
        Buffer buffer(*device, 3 * kMB, Access::device);
        EXPECT_GE(device->memory().used_bytes(), 3 * kMB);
        EXPECT_LE(device->memory().used_bytes(), 3 * kMB + 65536);
        const Texture texture(*device, {512, 512, 4, 1, VK_FORMAT_R16_SFLOAT});
        EXPECT_GE(device->memory().used_bytes(), 5 * kMB);
        const std::uint64_t both = device->memory().used_bytes();
        Buffer moved(std::move(buffer));
        EXPECT_EQ(device->memory().used_bytes(), both);
        moved = Buffer();
    }
    EXPECT_EQ(device->memory().used_bytes(), 0u);
    EXPECT_LE(device->memory().pieces(), 2u); // empty blocks, one of buffers and one of images
    EXPECT_EQ(device->validation_errors(), 0u);
}

TEST(Memory, a_texture_tells_its_size_before_it_is_made) {
    const auto device = device_with(0);
    for (const TextureShape& shape : {TextureShape{33, 7, 3, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false},
                                      TextureShape{256, 256, 5, 4, VK_FORMAT_R8G8B8A8_UNORM, false, true},
                                      TextureShape{1000, 1, 1, 1, VK_FORMAT_R32G32_UINT}}) {
        const Texture texture(*device, shape);
        EXPECT_EQ(texture_bytes(*device, shape), texture.bytes());
    }
    EXPECT_EQ(device->validation_errors(), 0u);
}

TEST(Memory, of_a_limit_what_is_left_is_told) {
    const auto device = device_with(16 * kMB);
    EXPECT_EQ(device->memory().left_bytes(), 16 * kMB);
    const Buffer buffer(*device, 10 * kMB, Access::upload);
    EXPECT_LE(device->memory().left_bytes(), 6 * kMB);
    EXPECT_GE(device->memory().left_bytes(), 6 * kMB - 65536);
}

// All of what a device does with a limit on how many pieces it gives.
TEST(Memory, thousands_of_small_ones_take_few_pieces) {
    constexpr std::size_t kMany = 5000;
    const auto device =
        must(Device::create({.validation = true, .lowered_limits = {{"maxMemoryAllocationCount", 12}}}));
    {
        std::vector<Buffer> buffers;
        std::vector<Texture> textures;
        for (std::size_t k = 0; k < kMany; ++k) {
            buffers.emplace_back(*device, 16 + 7 * (k % 500), Access::upload);
            std::memset(buffers.back().mapped(), static_cast<int>(k % 251), buffers.back().bytes());
            if (k % 100 != 0) continue;
            textures.emplace_back(*device, TextureShape{31, 9, 1, 1, VK_FORMAT_R8G8B8A8_UNORM});
            const std::vector<std::uint8_t> texels(std::size_t{31} * 9 * 4,
                                                   static_cast<std::uint8_t>(k % 251));
            textures.back().write(0, texels.data(), texels.size());
        }
        EXPECT_LE(device->memory().pieces(), 12u);
        // Each has what was written to it: none lies in another one, whatever its place is.
        for (std::size_t k = 0; k < kMany; ++k) {
            const auto* bytes = static_cast<const std::uint8_t*>(buffers[k].mapped());
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes) % 64, 0u);
            ASSERT_EQ(std::count(bytes, bytes + buffers[k].bytes(), k % 251),
                      static_cast<std::ptrdiff_t>(buffers[k].bytes()))
                << k;
        }
        const Buffer read(*device, std::uint64_t{31} * 9 * 4, Access::readback);
        for (std::size_t k = 0; k < textures.size(); ++k) {
            Commands commands(*device);
            commands.begin();
            commands.copy(textures[k], read);
            commands.submit_and_wait();
            const auto* bytes = static_cast<const std::uint8_t*>(read.mapped());
            ASSERT_EQ(std::count(bytes, bytes + read.bytes(), 100 * k % 251),
                      static_cast<std::ptrdiff_t>(read.bytes()))
                << k;
        }
    }
    EXPECT_EQ(device->validation_errors(), 0u);
}

// bufferImageGranularity: what lies in a driver's own order and what does not never meet.
TEST(Memory, images_and_buffers_have_blocks_of_their_own) {
    const auto device = device_with(0);
    const Buffer buffer(*device, 100, Access::device), other(*device, 100, Access::device);
    EXPECT_EQ(device->memory().pieces(), 1u);
    const Texture texture(*device, {8, 8, 1, 1, VK_FORMAT_R8G8B8A8_UNORM});
    EXPECT_EQ(device->memory().pieces(), 2u);
}

TEST(Memory, more_pieces_than_a_device_gives_is_memory_at_its_end) {
    const auto device = must(Device::create({.lowered_limits = {{"maxMemoryAllocationCount", 3}}}));
    std::vector<Buffer> large;
    const std::uint64_t bytes = device->memory().block_bytes();
    for (int k = 0; k < 3; ++k) large.emplace_back(*device, bytes, Access::device);
    EXPECT_THROW(Buffer(*device, bytes, Access::device), OutOfDeviceMemory);
    EXPECT_THROW(Buffer(*device, 16, Access::device), OutOfDeviceMemory);
    large.pop_back();
    EXPECT_NO_THROW(Buffer(*device, 16, Access::device));
}

TEST(Memory, an_empty_block_goes_where_another_one_is_empty) {
    const auto device = device_with(64 * kMB);
    const DeviceMemory& memory = device->memory();
    const std::uint64_t bytes = memory.block_bytes() / 8; // the most that lies in a block
    std::vector<Buffer> buffers;
    while (memory.held_bytes() < 5 * memory.block_bytes())
        buffers.emplace_back(*device, bytes, Access::device);
    const std::uint64_t pieces = memory.pieces(), held = memory.held_bytes();
    EXPECT_GT(pieces, 4u);
    EXPECT_LT(pieces, buffers.size() / 2);
    EXPECT_EQ(memory.left_bytes(), 64 * kMB - held);
    // A hole is filled before another block is asked for.
    buffers.erase(buffers.begin() + 3, buffers.begin() + 5);
    while (memory.used_bytes() < held) buffers.emplace_back(*device, bytes, Access::device);
    EXPECT_EQ(memory.held_bytes(), held);
    buffers.clear();
    EXPECT_EQ(memory.used_bytes(), 0u);
    EXPECT_EQ(memory.pieces(), 1u);
    EXPECT_EQ(memory.held_bytes(), memory.block_bytes());
    EXPECT_EQ(memory.left_bytes(), 64 * kMB) << "it goes before anything is refused";
    EXPECT_NO_THROW(Buffer(*device, 64 * kMB, Access::device));
    EXPECT_EQ(memory.pieces(), 0u);
    EXPECT_EQ(device->validation_errors(), 0u);
}

TEST(Memory, its_end_is_reached_to_the_last_piece_and_said) {
    const auto device = device_with(16 * kMB);
    const DeviceMemory& memory = device->memory();
    EXPECT_THROW(Buffer(*device, 17 * kMB, Access::device), OutOfDeviceMemory);
    std::vector<Buffer> buffers;
    const auto fill = [&](std::uint64_t bytes) {
        while (true) buffers.emplace_back(*device, bytes, Access::device);
    };
    constexpr std::uint64_t kSmall = 20000;
    EXPECT_THROW(fill(kSmall), OutOfDeviceMemory);
    EXPECT_LE(memory.held_bytes(), 16 * kMB);
    EXPECT_GT(memory.used_bytes(), 15 * kMB);
    EXPECT_LT(memory.left_bytes(), kSmall + 64);
    buffers.clear();
    EXPECT_NO_THROW(Buffer(*device, 15 * kMB, Access::device));
    EXPECT_EQ(device->validation_errors(), 0u);
}

} // namespace
} // namespace ghost::gpu
