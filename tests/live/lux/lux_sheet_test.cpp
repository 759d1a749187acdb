// SPDX-License-Identifier: Apache-2.0
// Lux on lines and areas: where the points lie, what is summed up, and that the table and the sheet say so.
#include "live/lux/lux_sheet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ghost::app {
namespace {

TEST(LuxSheet, points_reach_both_ends_and_are_no_farther_apart_than_asked) {
    const auto line = line_grid({0, 0, 1}, {0, 5, 1}, 0.9f);
    ASSERT_TRUE(line.ok());
    EXPECT_EQ(line->columns, 7u);
    EXPECT_EQ(line->points_m.front(), glm::vec3(0, 0, 1));
    EXPECT_EQ(line->points_m.back(), glm::vec3(0, 5, 1));
    const auto area = area_grid({6, 4, 1.2f}, {-6, -2, 9}, 1);
    ASSERT_TRUE(area.ok());
    EXPECT_EQ(area->columns, 13u);
    EXPECT_EQ(area->rows, 7u);
    EXPECT_EQ(area->points_m.front(), glm::vec3(-6, -2, 1.2f))
        << "nearest to the audience, at the first height";
    EXPECT_EQ(area->points_m.back(), glm::vec3(6, 4, 1.2f));
    for (std::size_t i = 1; i < area->columns; ++i)
        EXPECT_LE(glm::distance(area->points_m[i - 1], area->points_m[i]), 1.0001f);
}

TEST(LuxSheet, what_cannot_be_measured_is_said) {
    EXPECT_FALSE(line_grid({0, 0, 0}, {1, 0, 0}, 0).ok());
    EXPECT_FALSE(line_grid({0, 0, 0}, {NAN, 0, 0}, 1).ok());
    EXPECT_FALSE(line_grid({0, 0, 0}, {1000, 0, 0}, 0.01f).ok()) << "too many points";
    EXPECT_FALSE(area_grid({0, 0, 0}, {200, 200, 0}, 1).ok()) << "likewise";
    const auto point = line_grid({1, 2, 3}, {1, 2, 3}, 1);
    ASSERT_TRUE(point.ok());
    EXPECT_EQ(point->points_m.size(), 2u);
}

TEST(LuxSheet, the_summary_the_table_and_the_sheet_have_the_same_figures) {
    auto grid = area_grid({0, 0, 1}, {2, 1, 1}, 1);
    ASSERT_TRUE(grid.ok());
    grid->lux = {100, 200, 300, 400, 500, 600};
    const LuxSummary all = summary_of(*grid);
    EXPECT_FLOAT_EQ(all.mean, 350);
    EXPECT_FLOAT_EQ(all.least, 100);
    EXPECT_EQ(all.most_at_m, glm::vec3(2, 1, 1));
    EXPECT_NEAR(all.uniformity(), 100.0 / 350, 1e-6);
    EXPECT_NEAR(all.diversity(), 1.0 / 6, 1e-6);
    const std::string csv = lux_csv(*grid);
    EXPECT_EQ(csv.substr(0, 40), "x_m,y_m,z_m,lux\n0.000,0.000,1.000,100\n1.");
    const std::string svg = lux_svg(*grid, "Tom & <Jerry>");
    EXPECT_NE(svg.find("Tom &amp; &lt;Jerry>"), std::string::npos);
    EXPECT_NE(svg.find(">600</text>"), std::string::npos);
    EXPECT_NE(svg.find("mean 350 lx, least 100 lx at (0.00, 0.00, 1.00)"), std::string::npos);
    EXPECT_EQ(svg.find("bounced"), std::string::npos);
    grid->bounced_lux = {10, 20, 30, 40, 50, 60};
    EXPECT_FLOAT_EQ(summary_of(*grid).mean_bounced, 35);
    EXPECT_EQ(lux_csv(*grid).substr(0, 55), "x_m,y_m,z_m,lux,bounced_lux\n0.000,0.000,1.000,100,10\n1.");
    EXPECT_NE(lux_svg(*grid, "").find("mean 350 lx, of which 35 bounced, least 100 lx"), std::string::npos);
    auto dark = line_grid({0, 0, 0}, {1, 0, 0}, 0.5f);
    dark->lux = {0, 0, 0};
    EXPECT_EQ(summary_of(*dark).uniformity(), 0);
    EXPECT_EQ(lux_svg(*dark, "dark").find("nan"), std::string::npos);
}

} // namespace
} // namespace ghost::app
