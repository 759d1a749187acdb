// SPDX-License-Identifier: Apache-2.0
#include "gpu/free_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace ghost::gpu {
namespace {

TEST(FreeRanges, the_first_place_that_fits_is_taken) {
    FreeRanges free(1000);
    EXPECT_EQ(free.take(100, 1), 0u);
    EXPECT_EQ(free.take(200, 1), 100u);
    EXPECT_EQ(free.take(100, 1), 300u);
    free.give_back(100, 200);
    EXPECT_EQ(free.take(201, 1), 400u); // the hole is one too small
    EXPECT_EQ(free.take(150, 1), 100u);
    EXPECT_EQ(free.take(50, 1), 250u);
    EXPECT_EQ(free.take(400, 1), std::nullopt); // 399 are left
    EXPECT_EQ(free.take(399, 1), 601u);
    EXPECT_EQ(free.free_bytes(), 0u);
    EXPECT_EQ(free.take(1, 1), std::nullopt);
}

TEST(FreeRanges, what_is_skipped_for_the_sake_of_alignment_stays_free) {
    FreeRanges free(1024);
    EXPECT_EQ(free.take(10, 1), 0u);
    EXPECT_EQ(free.take(100, 256), 256u);
    EXPECT_EQ(free.free_bytes(), 1024u - 110u);
    EXPECT_EQ(free.take(246, 1), 10u);
    EXPECT_EQ(free.take(700, 512), std::nullopt);
    EXPECT_EQ(free.take(512, 512), 512u);
}

TEST(FreeRanges, neighbours_merge_whichever_comes_back_first) {
    std::vector<std::uint64_t> order{0, 1, 2, 3};
    do {
        FreeRanges free(400);
        for (std::uint64_t k = 0; k < 4; ++k) ASSERT_EQ(free.take(100, 1), 100 * k);
        EXPECT_FALSE(free.is_whole());
        for (const std::uint64_t k : order) free.give_back(100 * k, 100);
        EXPECT_EQ(free.count(), 1u);
        EXPECT_TRUE(free.is_whole());
        EXPECT_EQ(free.take(400, 1), 0u);
    } while (std::next_permutation(order.begin(), order.end()));
}

// Against a byte for each byte, 20,000 steps.
TEST(FreeRanges, nothing_is_given_twice_and_nothing_is_lost) {
    constexpr std::uint64_t kBytes = 4096;
    struct Range {
        std::uint64_t begin, bytes;
    };
    std::mt19937 random(7);
    FreeRanges free(kBytes);
    std::vector<bool> taken(kBytes, false);
    std::vector<Range> ranges;
    std::size_t refused = 0;
    for (int step = 0; step < 20000; ++step) {
        if (ranges.empty() || random() % 100 < 55) {
            const std::uint64_t bytes = 1 + random() % 300, align = std::uint64_t{1} << random() % 8;
            const auto at = free.take(bytes, align);
            const auto fits = [&](std::uint64_t from) {
                for (std::uint64_t k = from; k < from + bytes; ++k)
                    if (k >= kBytes || taken[k]) return false;
                return true;
            };
            if (!at) {
                ++refused;
                for (std::uint64_t from = 0; from < kBytes; from += align) ASSERT_FALSE(fits(from));
                continue;
            }
            ASSERT_EQ(*at % align, 0u);
            ASSERT_TRUE(fits(*at));
            for (std::uint64_t k = 0; k < bytes; ++k) taken[*at + k] = true;
            ranges.push_back({*at, bytes});
        } else {
            std::swap(ranges[random() % ranges.size()], ranges.back());
            free.give_back(ranges.back().begin, ranges.back().bytes);
            for (std::uint64_t k = 0; k < ranges.back().bytes; ++k) taken[ranges.back().begin + k] = false;
            ranges.pop_back();
        }
        std::uint64_t free_bytes = 0, runs = 0;
        for (std::uint64_t k = 0; k < kBytes; ++k) {
            free_bytes += taken[k] ? 0 : 1;
            runs += !taken[k] && (k == 0 || taken[k - 1]) ? 1 : 0;
        }
        ASSERT_EQ(free.free_bytes(), free_bytes);
        ASSERT_EQ(free.count(), runs); // free neighbours are one
    }
    EXPECT_GT(refused, 100u);
    for (const Range& range : ranges) free.give_back(range.begin, range.bytes);
    EXPECT_TRUE(free.is_whole());
}

TEST(FreeRanges, what_is_free_is_not_given_back_again) {
    GTEST_FLAG_SET(death_test_style, "threadsafe"); // devices of other tests have threads
    FreeRanges free(100);
    ASSERT_EQ(free.take(50, 1), 0u);
    free.give_back(0, 50);
    EXPECT_DEATH(free.give_back(0, 50), "CHECK failed: ");
    EXPECT_DEATH(free.give_back(90, 20), "CHECK failed: ");
}

} // namespace
} // namespace ghost::gpu
