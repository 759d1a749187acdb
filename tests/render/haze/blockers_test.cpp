// SPDX-License-Identifier: Apache-2.0
#include "render/haze/private/blockers.h"

#include "passes/distance_maps.h"
#include "shared/blockers.h"

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <cstring>

namespace ghost::render {
namespace {

constexpr int kSide = 64;

float metres(std::uint16_t half) {
    return glm::unpackHalf1x16(half);
}

float fraction_of(const Blockers& cell) {
    return shared::unpack_parts(metres(cell.parts)).x;
}

float far_from_m(const Blockers& cell) {
    const float start = 1 / metres(cell.near_to), end = 1 / metres(cell.far_to);
    return 1 / (start + (end - start) * shared::unpack_parts(metres(cell.parts)).y);
}

std::vector<std::uint16_t> wall_at(float distance_m) {
    return std::vector<std::uint16_t>(kSide * kSide, glm::packHalf1x16(distance_m));
}

TEST(Blockers, AWallIsOneGroupInCellsOfEverySize) {
    const auto levels = blockers_of(wall_at(8), kSide);
    ASSERT_EQ(levels.size(), 3u); // 16, 8 and 4 cells a side
    for (std::size_t level = 0; level < levels.size(); ++level) {
        ASSERT_EQ(levels[level].size(), std::size_t{256} >> (2 * level));
        for (const Blockers& cell : levels[level]) {
            EXPECT_EQ(metres(cell.near_from), 8);
            EXPECT_EQ(metres(cell.near_to), 8);
            EXPECT_EQ(metres(cell.far_to), 8);
            EXPECT_EQ(fraction_of(cell), 1);
        }
    }
}

TEST(Blockers, APipeOneTexelWideKeepsItsShare) {
    auto texels = wall_at(8);
    for (int y = 0; y < kSide; ++y)
        texels[static_cast<std::size_t>(y * kSide + 21)] = glm::packHalf1x16(2.0f);
    const auto levels = blockers_of(texels, kSide);
    for (std::size_t level = 0; level < levels.size(); ++level) {
        const int cell_texels = static_cast<int>(kLeastBlockerCell) << level, cells = kSide / cell_texels;
        for (int x = 0; x < cells; ++x) {
            const Blockers& cell = levels[level][static_cast<std::size_t>(cells + x)];
            const bool has_pipe = x == 21 / cell_texels;
            EXPECT_EQ(metres(cell.near_from), has_pipe ? 2 : 8) << level << ' ' << x;
            EXPECT_NEAR(fraction_of(cell), has_pipe ? 1.0f / static_cast<float>(cell_texels) : 1,
                        0.51f / shared::kFractionSteps);
            EXPECT_EQ(metres(cell.far_to), 8);
            if (has_pipe) {
                EXPECT_NEAR(far_from_m(cell), 8, 1e-3);
            }
        }
    }
}

// A pipe, a cymbal, a wall that goes away: the widest gap divides, and where the second group begins is kept,
// rather too near than too far.
TEST(Blockers, ThreeThingsAreTwoGroups) {
    auto texels = wall_at(8);
    texels[0] = glm::packHalf1x16(1.0f);
    texels[1] = glm::packHalf1x16(4.0f);
    texels[2] = glm::packHalf1x16(8.5f);
    const Blockers cell = blockers_of(texels, kSide)[0][0];
    EXPECT_EQ(metres(cell.near_from), 1);
    EXPECT_EQ(metres(cell.near_to), 1);
    EXPECT_NEAR(fraction_of(cell), 1.0f / 16, 0.51f / shared::kFractionSteps);
    EXPECT_EQ(metres(cell.far_to), 8.5f);
    EXPECT_LE(far_from_m(cell), 4.001f);
    EXPECT_GT(far_from_m(cell), 3.5f);
}

TEST(Blockers, EvenSmallMapsKeepEnoughCellsToLookAround) {
    EXPECT_EQ(blocker_levels(4096), kBlockerLevels);
    EXPECT_EQ(blocker_levels(256), kBlockerLevels);
    EXPECT_EQ(blocker_levels(128), 4u);
    EXPECT_EQ(blocker_levels(8), 1u);
    EXPECT_EQ(blocker_levels(1), 1u);
}

// Blocks are smaller than the coarsest cells.
TEST(Blockers, blocks_that_changed_are_as_in_the_whole_map) {
    constexpr std::uint32_t kWide = 256, kBlock = scene::kDistanceBlock, kAcross = kWide / kBlock;
    std::vector<std::uint16_t> texels(kWide * kWide);
    for (std::uint32_t k = 0; k < texels.size(); ++k)
        texels[k] = glm::packHalf1x16(1.0f + static_cast<float>((k * 2654435761u) >> 24));
    auto levels = blockers_of(texels, kWide);
    const std::vector<int> blocks{5, 6, 6 + kAcross, static_cast<int>(kAcross * kAcross) - 1};
    for (const int block : blocks)
        for (std::uint32_t k = 0; k < kBlock * kBlock; ++k) {
            const std::uint32_t x = static_cast<std::uint32_t>(block) % kAcross * kBlock + k % kBlock,
                                y = static_cast<std::uint32_t>(block) / kAcross * kBlock + k / kBlock;
            texels[y * kWide + x] = glm::packHalf1x16(0.5f + static_cast<float>((x * y) % 7));
        }
    const auto wanted = blockers_of(texels, kWide);
    const auto same = [&](std::size_t l) {
        return std::memcmp(wanted[l].data(), levels[l].data(), wanted[l].size() * sizeof(Blockers)) == 0;
    };
    ASSERT_EQ(levels.size(), wanted.size());
    for (std::size_t l = 0; l < wanted.size(); ++l) EXPECT_FALSE(same(l)) << l;
    for (const BlockerSquare& square : squares_of(blocks, kBlock, kWide))
        update_blockers(texels, kWide, square, levels);
    for (std::size_t l = 0; l < wanted.size(); ++l) EXPECT_TRUE(same(l)) << l;
}

} // namespace
} // namespace ghost::render
