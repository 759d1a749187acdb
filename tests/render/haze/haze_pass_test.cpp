// SPDX-License-Identifier: Apache-2.0
#include "render/haze/haze_pass.h"

#include <gtest/gtest.h>

namespace ghost::render {
namespace {

// Lights of a picture at rest are drawn one by one, each a chunk that begins at a place of its own.
TEST(HazePass, EveryDrawOfEveryLightHasRoomForItsFan) {
    constexpr std::uint64_t kChunkBegins = 256; // bytes
    for (const std::uint32_t lights : {1u, 10u, 187u, 400u, 2000u}) {
        std::uint64_t used = 0;
        for (std::uint64_t draw = 0; draw < kMostDraws * lights; ++draw) {
            used += fan_room(1);
            EXPECT_EQ(used % kChunkBegins, 0u);
        }
        EXPECT_GE(fan_room(1), sizeof(shared::Fan));
        EXPECT_LE(used + shared::kLightsPerChunk * sizeof(shared::Fan), fan_buffer_bytes(lights)) << lights;
    }
}

} // namespace
} // namespace ghost::render
