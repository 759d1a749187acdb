// SPDX-License-Identifier: Apache-2.0
#include "render/haze/memory_order.h"

#include "gpu/buffer.h"
#include "support/must.h"

#include <gtest/gtest.h>

#include <array>

namespace ghost::render {
namespace {

TEST(MemoryOrder, all_that_is_short_is_said_in_one_sentence_what_goes_first_first) {
    const std::array shortages{Shortage{Kept::batch, 5, 128}, Shortage{Kept::maps, 64, 512},
                               Shortage{Kept::images, 9, 64}, Shortage{Kept::visibility, 0, 4096},
                               Shortage{Kept::tables, 1, 60}};
    EXPECT_EQ(sentence_of(shortages),
              "1 kept tables of haze instead of 60, 0 KB of kept visibility instead of 4096, 9 kept images "
              "instead of 64, shadow maps of 64 texels a side instead of 512, 5 lights at once instead of "
              "128");
}

TEST(MemoryOrder, what_has_all_that_it_wants_is_not_named) {
    const std::array shortages{Shortage{Kept::tables, 60, 60}, Shortage{Kept::maps, 64, 512},
                               Shortage{Kept::images, 70, 64}};
    EXPECT_EQ(sentence_of(shortages), "shadow maps of 64 texels a side instead of 512");
    EXPECT_EQ(sentence_of({}), "");
}

TEST(MemoryOrder, shares_are_of_what_is_left) {
    constexpr std::uint64_t kLimit = std::uint64_t{64} << 20;
    const auto device = must(gpu::Device::create({.memory_limit_bytes = kLimit}));
    EXPECT_EQ(share_of(Kept::maps, *device), kLimit / 2);
    EXPECT_EQ(share_of(Kept::tables, *device), kLimit / 16);
    const gpu::Buffer half(*device, kLimit / 2, gpu::Access::device);
    EXPECT_EQ(share_of(Kept::maps, *device), kLimit / 4);
    EXPECT_EQ(share_of(Kept::images, *device), kLimit / 2 / 8 * 7);
}

} // namespace
} // namespace ghost::render
