// SPDX-License-Identifier: Apache-2.0
// Workers see the memory of the device that they stand beside.
#include "support/worker_device.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/texture.h"

#include <cstring>
#include <vector>

namespace ghost::gpu {
namespace {

TEST(Workers, WriteWhatTheDeviceReads) {
    const Device* device = kWorkerDevice->get();
    if (!device) GTEST_SKIP() << "a graphics card draws here, or LP_NUM_THREADS is set: there are no workers";
    Buffer buffer(*device, 4 * sizeof(std::uint32_t), Access::device);
    Texture texture(*device, {33, 5, 2, 1, VK_FORMAT_R16G16B16A16_SFLOAT, true, false});
    std::uint32_t value = 0;
    for (const auto& worker : device->workers()) {
        for (std::uint32_t layer = 0; layer < 2; ++layer)
            std::memset(texture.mapped(layer), 0x3c, texture.row_bytes() * 5);
        const std::vector<std::uint32_t> written{++value, ++value, ++value, ++value};
        Commands commands(*worker);
        commands.begin();
        commands.write(buffer, written);
        commands.clear(texture);
        commands.submit_and_wait();
        EXPECT_EQ(std::memcmp(buffer.mapped(), written.data(), written.size() * sizeof written[0]), 0);
        for (std::uint32_t layer = 0; layer < 2; ++layer)
            for (std::size_t row = 0; row < 5; ++row)
                for (std::size_t byte = 0; byte < 33 * 8; ++byte)
                    ASSERT_EQ(texture.mapped(layer)[row * texture.row_bytes() + byte], 0)
                        << row << ", " << byte;
    }
    EXPECT_EQ(device->validation_errors(), 0u);
}

TEST(Workers, AreDevicesOfTheirOwn) {
    const Device* device = kWorkerDevice->get();
    if (!device) GTEST_SKIP() << "a graphics card draws here, or LP_NUM_THREADS is set: there are no workers";
    EXPECT_EQ(device->worker(), -1);
    for (std::size_t k = 0; k < device->workers().size(); ++k) {
        const Device& worker = *device->workers()[k];
        EXPECT_EQ(worker.worker(), static_cast<int>(k));
        EXPECT_NE(worker.handle(), device->handle());
        EXPECT_EQ(worker.name(), device->name());
        EXPECT_TRUE(worker.workers().empty());
    }
    // Where memory is limited nobody shares it.
    const auto limited =
        must(Device::create({.memory_limit_bytes = std::uint64_t{1} << 30, .workers = true}));
    EXPECT_TRUE(limited->workers().empty());
}

} // namespace
} // namespace ghost::gpu
