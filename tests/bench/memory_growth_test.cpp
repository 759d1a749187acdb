// SPDX-License-Identifier: Apache-2.0
// An hour's memory is judged by rows that had the same pictures.
#include "bench/window/private/memory_growth.h"

#include <gtest/gtest.h>

#include <vector>

namespace ghost::app {
namespace {

// An hour, a row a minute; pictures are large at both ends and small between, as on a machine that others use.
std::vector<MemoryRow> hour(double leak_mb_per_row) {
    std::vector<MemoryRow> rows;
    for (int k = 0; k < 60; ++k) {
        const double device_mb = k < 20 || k >= 50 ? 900.0 : 600.0;
        rows.push_back({device_mb + 500 + leak_mb_per_row * k, device_mb});
    }
    return rows;
}

TEST(MemoryGrowth, pictures_that_come_and_go_are_none) {
    EXPECT_NEAR(memory_growth_mb(hour(0), 10).value(), 0, 1e-9);
}

TEST(MemoryGrowth, what_stays_is_found_beside_them) {
    EXPECT_GT(memory_growth_mb(hour(0.3), 10).value(), 5);
    EXPECT_LT(memory_growth_mb(hour(-0.3), 10).value(), -5);
}

TEST(MemoryGrowth, says_nothing_where_no_row_is_like_one_before) {
    std::vector<MemoryRow> rows(20, {1400, 900});
    for (std::size_t k = 10; k < 20; ++k) rows[k] = {1100, 600};
    EXPECT_FALSE(memory_growth_mb(rows, 0));
    EXPECT_FALSE(memory_growth_mb(rows, 20));
    EXPECT_FALSE(memory_growth_mb({}, 0));
}

} // namespace
} // namespace ghost::app
