#pragma once
// SPDX-License-Identifier: Apache-2.0
// Polygons to pixels. Any thread.

#include <glm/vec2.hpp>

#include <vector>

namespace ghost::image {

using Polygon = std::vector<glm::vec2>; // closed by itself; pixels, Y down

enum class FillRule { nonzero, even_odd };

// The share of every pixel that the polygons cover together, 0..1, row by row. Time: height times their
// points.
std::vector<float> coverage(const std::vector<Polygon>& polygons, FillRule rule, int width, int height);

} // namespace ghost::image
