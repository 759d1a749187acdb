// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/private/detail_levels.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <meshoptimizer.h>
#include <tuple>

namespace ghost::render {
namespace {

constexpr float kErrors[] = {0.0003f, 0.001f, 0.002f, 0.004f, 0.008f, 0.016f, 0.03f}; // of the mesh's size
constexpr float kMostOfMean = 3; // quadrics are means over an area; a tube is off by up to 2.5 of them
constexpr std::size_t kMinTriangles = 64; // fewer are not worth a choice

// Hard edges have several vertices in one place, which would hold the mesh together as it is. Those of a
// texture's seam stay apart.
class Places {
public:
    Places(const std::vector<glm::vec3>& positions_m, const std::vector<glm::vec2>& uvs) {
        std::map<std::tuple<float, float, float, float, float>, std::uint32_t> known;
        for (std::size_t v = 0; v < positions_m.size(); ++v) {
            const glm::vec3& at = positions_m[v];
            const glm::vec2 uv = uvs.empty() ? glm::vec2(0) : uvs[v];
            const auto next = static_cast<std::uint32_t>(vertices_.size());
            const auto [found, is_new] = known.try_emplace({at.x, at.y, at.z, uv.x, uv.y}, next);
            if (is_new) vertices_.emplace_back();
            vertices_[found->second].push_back(static_cast<std::uint32_t>(of_vertex_.size()));
            of_vertex_.push_back(found->second);
        }
    }
    std::uint32_t of(std::uint32_t vertex) const { return of_vertex_[vertex]; }
    const std::vector<std::uint32_t>& vertices(std::uint32_t place) const { return vertices_[place]; }
    std::size_t count() const { return vertices_.size(); }

private:
    std::vector<std::uint32_t> of_vertex_;
    std::vector<std::vector<std::uint32_t>> vertices_;
};

} // namespace

std::vector<DetailLevel> detail_levels(const std::vector<glm::vec3>& positions_m,
                                       const std::vector<glm::vec3>& normals,
                                       const std::vector<glm::vec2>& uvs,
                                       std::span<const std::uint32_t> indices) {
    std::vector<DetailLevel> levels;
    if (indices.size() < 3 * kMinTriangles) return levels;
    const Places places(positions_m, uvs);
    std::vector<glm::vec3> at_m;
    for (std::uint32_t place = 0; place < places.count(); ++place)
        at_m.push_back(positions_m[places.vertices(place)[0]]);
    std::vector<std::uint32_t> whole;
    for (const std::uint32_t index : indices) whole.push_back(places.of(index));
    const float size_m = meshopt_simplifyScale(&at_m[0].x, at_m.size(), sizeof at_m[0]);
    std::size_t before = indices.size();
    for (const float error : kErrors) {
        std::vector<std::uint32_t> coarse(whole.size());
        coarse.resize(meshopt_simplify(coarse.data(), whole.data(), whole.size(), &at_m[0].x, at_m.size(),
                                       sizeof at_m[0], 3, error, 0, nullptr));
        if (coarse.empty() || 3 * coarse.size() > 2 * before) continue;
        before = coarse.size();
        DetailLevel& level = levels.emplace_back();
        level.error_m = kMostOfMean * error * size_m;
        for (std::size_t k = 0; k < coarse.size(); k += 3) {
            const glm::vec3 facet =
                glm::cross(at_m[coarse[k + 1]] - at_m[coarse[k]], at_m[coarse[k + 2]] - at_m[coarse[k]]);
            for (std::size_t c = k; c < k + 3; ++c) {
                const std::vector<std::uint32_t>& choice = places.vertices(coarse[c]);
                std::uint32_t best = choice[0];
                for (const std::uint32_t vertex : choice)
                    if (glm::dot(normals[vertex], facet) > glm::dot(normals[best], facet)) best = vertex;
                level.indices.push_back(best);
            }
        }
        meshopt_optimizeVertexCache(level.indices.data(), level.indices.data(), level.indices.size(),
                                    positions_m.size());
    }
    return levels;
}

} // namespace ghost::render
