// SPDX-License-Identifier: Apache-2.0
// Textures as attachments and samplers: what Raster stands on. Raster itself is drawn with in
// tests/render/geometry/g_buffer_test.cpp, where its shaders are.
#include "gpu/raster.h"

#include "gpu/buffer.h"
#include "gpu/texture.h"
#include "support/must.h"
#include "support/one_device.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

namespace ghost::gpu {
namespace {

class RasterTest : public ::testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(device().validation_errors(), 0u); }
};

Texture attachment(VkFormat format, std::uint32_t samples) {
    TextureShape shape{40, 24, 1, 1, format};
    shape.attachment = true;
    shape.samples = samples;
    return {device(), shape};
}

TEST_F(RasterTest, DrawingNothingClearsToZero) {
    Texture colour = attachment(VK_FORMAT_R8G8B8A8_UNORM, 1);
    const Texture depth = attachment(VK_FORMAT_D32_SFLOAT, 1);
    const std::vector<std::uint32_t> filled(40 * 24, 0x12345678u);
    colour.write(0, filled.data(), filled.size() * 4);
    const Buffer read(device(), filled.size() * 4, Access::readback);
    Commands commands(device());
    commands.begin();
    begin_drawing(commands, {&colour}, depth);
    end_drawing(commands);
    commands.copy(colour, read);
    commands.submit_and_wait();
    const std::vector<std::uint32_t> zero(filled.size(), 0);
    EXPECT_EQ(std::memcmp(read.mapped(), zero.data(), filled.size() * 4), 0);
}

TEST_F(RasterTest, MultisampledAttachmentsTakeMemoryForEachSample) {
    const Texture one = attachment(VK_FORMAT_R16G16B16A16_SFLOAT, 1);
    const Texture four = attachment(VK_FORMAT_R16G16B16A16_SFLOAT, 4);
    EXPECT_GE(four.bytes(), 4u * 40 * 24 * 8);
    EXPECT_GT(four.bytes(), 2 * one.bytes());
    const Texture depth = attachment(VK_FORMAT_D32_SFLOAT, 4);
    Commands commands(device());
    commands.begin();
    begin_drawing(commands, {&four}, depth);
    end_drawing(commands);
    commands.submit_and_wait();
}

TEST_F(RasterTest, LevelsOfATextureThatIsNotSquareEndAtOneTexel) {
    TextureShape shape{64, 4, 1, 7, VK_FORMAT_R8G8B8A8_SRGB};
    shape.linear = true;
    shape.repeat = true;
    Texture texture(device(), shape);
    for (std::uint32_t level = 0; level < 7; ++level) {
        const std::uint32_t texels = std::max(64u >> level, 1u) * std::max(4u >> level, 1u);
        const std::vector<std::uint32_t> values(texels, level);
        texture.write(level, values.data(), values.size() * 4); // validation checks the sizes
    }
}

} // namespace
} // namespace ghost::gpu
