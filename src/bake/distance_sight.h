#pragma once
// SPDX-License-Identifier: Apache-2.0
// DistanceSight: the directions of a distance map's texels, and whether something new inside a box could
// change the map. The test is of the very rays that made the map: a box that no ray enters before it ends
// changes nothing. Whole tiles of texels are passed over first, by a cone round their directions and by the
// farthest distance in them. World metres. Const calls from any thread.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::bake {

class DistanceSight {
public:
    explicit DistanceSight(int size);

    int size() const { return size_; }
    // Per texel, row by row; unit vectors.
    const std::vector<glm::vec3>& directions() const { return directions_; }

    // Farthest distance of each tile of a map, for may_change.
    std::vector<float> farthest_m(const std::vector<std::uint16_t>& distance) const;
    bool may_change(const std::vector<std::uint16_t>& distance, const std::vector<float>& farthest_m,
                    const glm::vec3& position_m, glm::vec3 low, glm::vec3 high) const;

private:
    struct Tile {
        int x0, y0, x1, y1; // x1, y1 excluded
        glm::vec3 axis;
        float angle_rad; // of the cone round all its directions
    };

    int size_;
    std::vector<glm::vec3> directions_;
    std::vector<Tile> tiles_;
};

} // namespace ghost::bake
