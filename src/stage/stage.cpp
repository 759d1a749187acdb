// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

namespace ghost::scene {

std::size_t Stage::stored_triangles() const {
    std::size_t count = 0;
    for (const Mesh& mesh : meshes) count += mesh.indices.size() / 3;
    return count;
}

std::size_t Stage::drawn_triangles() const {
    std::size_t count = 0;
    for (const Instance& instance : instances)
        count += meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    return count;
}

} // namespace ghost::scene
