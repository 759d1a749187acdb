// SPDX-License-Identifier: Apache-2.0
#include "stage/box.h"

#include "stage/stage.h"

namespace ghost::scene {
namespace {

// Round its corners, as the matrix puts them.
Box placed(const Box& box, const glm::mat4& matrix) {
    Box result;
    for (int k = 0; k < 8 && !box.is_empty(); ++k)
        result.add(glm::vec3(matrix * glm::vec4((k & 1) != 0 ? box.high_m.x : box.low_m.x,
                                                (k & 2) != 0 ? box.high_m.y : box.low_m.y,
                                                (k & 4) != 0 ? box.high_m.z : box.low_m.z, 1.0f)));
    return result;
}

} // namespace

std::vector<Box> boxes_of(const Stage& stage) {
    std::vector<Box> own(stage.meshes.size()), boxes;
    for (std::size_t m = 0; m < own.size(); ++m)
        for (const glm::vec3& place_m : stage.meshes[m].positions) own[m].add(place_m);
    for (const Instance& instance : stage.instances)
        boxes.push_back(placed(own[static_cast<std::size_t>(instance.mesh)], instance.world));
    return boxes;
}

} // namespace ghost::scene
