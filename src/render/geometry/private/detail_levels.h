#pragma once
// SPDX-License-Identifier: Apache-2.0
// Coarser versions of a mesh for where it is small in the picture: the same vertices, fewer triangles. What a
// level is off by at most comes from its quadrics (Garland, Heckbert 1997), in the mesh's own metres.
// Corners get the normals that fit; textures slide a little, but never across their seams. Pure function.

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ghost::render {

struct DetailLevel {
    std::vector<std::uint32_t> indices; // triangles, wound as they were; at least one
    float error_m = 0;
};

// positions, unit normals and, where they matter, places in textures: of the vertices, finite; indices:
// triangles. Each level is coarser than the one
// before it by a third at least; none where the mesh is as simple as it can be.
std::vector<DetailLevel> detail_levels(const std::vector<glm::vec3>& positions_m,
                                       const std::vector<glm::vec3>& normals,
                                       const std::vector<glm::vec2>& uvs,
                                       std::span<const std::uint32_t> indices);

} // namespace ghost::render
