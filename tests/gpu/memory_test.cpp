// SPDX-License-Identifier: Apache-2.0
// Who has how much of a device's memory.
#include "gpu/buffer.h"
#include "gpu/device_memory.h"
#include "gpu/texture.h"
#include "support/must.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace ghost::gpu
