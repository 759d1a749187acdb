#pragma once
// SPDX-License-Identifier: Apache-2.0
// LuxSheet: illuminance at points of a line or of a level area, as a light meter would read them: a table
// (.csv), or a sheet to print (.svg) with the values, the least, the mean and the most. Metres of the show,
// lux. Pure.

#include "base/result.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::app {

// Rows of points, the first one nearest to the audience; a line is one row. Evenly spaced.
struct LuxGrid {
    std::size_t columns = 0, rows = 0;
    std::vector<glm::vec3> points_m; // row after row
    std::vector<float> lux;          // as many
    std::vector<float> bounced_lux;  // of them; none: no light bounces
};

inline constexpr std::size_t kMostLuxPoints = 20000;

// Points at most step_m apart, both ends among them. Errors: a length or a step that is none, too many
// points.
Result<LuxGrid> line_grid(const glm::vec3& from_m, const glm::vec3& to_m, float step_m);
// Between two corners, at their height.
Result<LuxGrid> area_grid(const glm::vec3& corner_m, const glm::vec3& opposite_m, float step_m);

struct LuxSummary {
    float least = 0, mean = 0, most = 0;
    float mean_bounced = 0; // of the mean
    glm::vec3 least_at_m{0}, most_at_m{0};
    // As EN 12464 has it: least over mean, and least over most; 0 where all is dark.
    float uniformity() const { return mean > 0 ? least / mean : 0; }
    float diversity() const { return most > 0 ? least / most : 0; }
};
LuxSummary summary_of(const LuxGrid& grid);

// "x_m,y_m,z_m,lux", a line for each point; where light bounces, bounced_lux behind.
std::string lux_csv(const LuxGrid& grid);
// title: of the sheet; any text.
std::string lux_svg(const LuxGrid& grid, const std::string& title);

} // namespace ghost::app
