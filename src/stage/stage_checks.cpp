// SPDX-License-Identifier: Apache-2.0
#include "stage/stage_checks.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <unordered_map>
#include <utility>
#include <vector>

namespace ghost::scene {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr std::size_t kManyTriangles = 1'000'000;  // of one mesh
constexpr std::size_t kEdgesOfTriangles = 200'000; // of one mesh: larger ones are not looked at edge by edge

bool has_area(const vec3& a, const vec3& b, const vec3& c) {
    const dvec3 cross = glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
    return glm::dot(cross, cross) > 0.0;
}

std::size_t without_area(const Mesh& mesh) {
    std::size_t count = 0;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3)
        count += has_area(mesh.positions[mesh.indices[k]], mesh.positions[mesh.indices[k + 1]],
                          mesh.positions[mesh.indices[k + 2]])
                     ? 0
                     : 1;
    return count;
}

// Vertices of one place are one vertex: normals and texture coordinates split them at every seam.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
    struct Hash {
        std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const {
            std::uint64_t hash = 0;
            for (const std::uint32_t word : bits) hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
            return hash ^ (hash >> 29);
        }
    };
    std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, Hash> first;
    std::vector<std::uint32_t> of(mesh.positions.size());
    for (std::size_t v = 0; v < of.size(); ++v) {
        const vec3 place = mesh.positions[v] + 0.0f; // -0 is 0
        std::array<std::uint32_t, 3> bits{};
        std::memcpy(bits.data(), &place, sizeof bits);
        of[v] = first.emplace(bits, static_cast<std::uint32_t>(v)).first->second;
    }
    return of;
}

std::size_t crowded_edges(const Mesh& mesh) {
    const std::vector<std::uint32_t> vertex = welded(mesh);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3)
        for (std::size_t e = 0; e < 3; ++e) {
            const std::uint32_t a = vertex[mesh.indices[k + e]];
            const std::uint32_t b = vertex[mesh.indices[k + (e + 1) % 3]];
            if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    std::size_t crowded = 0;
    for (std::size_t k = 0; k < edges.size();) {
        std::size_t same = 1;
        while (k + same < edges.size() && edges[k + same] == edges[k]) ++same;
        crowded += same > 2 ? 1 : 0;
        k += same;
    }
    return crowded;
}

} // namespace

std::string name_of(const Stage& stage, int instance) {
    const Instance& found = stage.instances[static_cast<std::size_t>(instance)];
    return found.name.empty() ? stage.meshes[static_cast<std::size_t>(found.mesh)].name : found.name;
}

void check_geometry(const Stage& stage, const std::string& file, Report& report) {
    // A mesh goes by the first object that shows it.
    std::vector<std::string> objects(stage.meshes.size());
    for (std::size_t k = stage.instances.size(); k-- > 0;)
        objects[static_cast<std::size_t>(stage.instances[k].mesh)] = name_of(stage, static_cast<int>(k));
    std::vector<std::string> flat, crowded, mirrored, large;
    for (std::size_t m = 0; m < stage.meshes.size(); ++m) {
        const Mesh& mesh = stage.meshes[m];
        const std::string& object = objects[m].empty() ? mesh.name : objects[m];
        if (without_area(mesh) > 0) flat.push_back(object);
        const std::size_t triangles = mesh.indices.size() / 3;
        if (triangles > kManyTriangles) large.push_back(object);
        if (triangles <= kEdgesOfTriangles && crowded_edges(mesh) > 0) crowded.push_back(object);
    }
    for (const Instance& instance : stage.instances)
        if (glm::determinant(glm::mat3(instance.world)) < 0.0f) mirrored.push_back(instance.name);
    const auto say = [&](const std::vector<std::string>& names, Severity severity, const std::string& what) {
        if (!names.empty()) report.add(severity, file, what + ": " + name_list(names));
    };
    say(flat, Severity::warning, "objects with triangles that have no area; those are not seen");
    // Half of all models have such edges, and they cost nothing.
    say(crowded, Severity::note,
        "objects with edges of more than two triangles, of which none is inside or outside; they are "
        "drawn as they are");
    say(mirrored, Severity::warning,
        "objects are mirrored (negative scale), and so are the pictures on them");
    say(large, Severity::warning,
        "objects of more than a million triangles, which take long to draw and to trace");
}

} // namespace ghost::scene
