// SPDX-License-Identifier: Apache-2.0
#include "stage/primitives.h"

#include <cmath>
#include <initializer_list>
#include <vector>

namespace ghost::scene {
namespace {

using glm::vec3;

constexpr int kRound = 24;
constexpr int kSquare = 4;

// One cross-section of a loft.
struct Ring {
    float z = 0.0f;
    float half_x = 0.5f;
    float half_y = 0.5f;
};

void add_triangle(Mesh& mesh, const vec3& a, const vec3& b, const vec3& c) {
    const vec3 across = glm::cross(b - a, c - a);
    if (!(glm::dot(across, across) > 1e-14f)) return;
    const vec3 normal = glm::normalize(across);
    for (const vec3& corner : {a, b, c}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(corner);
        mesh.normals.push_back(normal);
    }
}

// A skin over rings from below to above, closed at both ends. Flat for few sides; round ones are smooth
// around.
void add_loft(Mesh& mesh, const std::vector<Ring>& rings, int sides, float x = 0.0f, float y = 0.0f) {
    const bool is_round = sides > kSquare;
    const float reach = is_round ? 1.0f : std::sqrt(2.0f); // a square's corners
    const auto angle_of = [sides](int k) {
        return glm::radians(360.0f * (static_cast<float>(k) + 0.5f) / static_cast<float>(sides));
    };
    const auto rim = [&](const Ring& ring, int k) {
        const float angle = angle_of(k);
        return vec3(x + ring.half_x * reach * std::cos(angle), y + ring.half_y * reach * std::sin(angle),
                    ring.z);
    };
    for (int k = 0; k < sides; ++k) {
        for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
            const Ring& low = rings[r];
            const Ring& high = rings[r + 1];
            const std::size_t first = mesh.positions.size();
            add_triangle(mesh, rim(low, k), rim(low, k + 1), rim(high, k + 1));
            add_triangle(mesh, rim(low, k), rim(high, k + 1), rim(high, k));
            if (!is_round) continue;
            const float rise = high.z - low.z;
            const float lean = 0.5f * (low.half_x + low.half_y - high.half_x - high.half_y);
            for (std::size_t i = first; i < mesh.positions.size(); ++i) {
                const vec3& at = mesh.positions[i];
                const vec3 out(at.x - x, at.y - y, 0.0f);
                const float length = glm::length(out);
                if (length > 1e-6f) mesh.normals[i] = glm::normalize(out / length * rise + vec3(0, 0, lean));
            }
        }
        const vec3 below(x, y, rings.front().z);
        const vec3 above(x, y, rings.back().z);
        add_triangle(mesh, below, rim(rings.front(), k + 1), rim(rings.front(), k));
        add_triangle(mesh, above, rim(rings.back(), k), rim(rings.back(), k + 1));
    }
}

void add_box(Mesh& mesh, const vec3& low, const vec3& high) {
    const vec3 half = 0.5f * (high - low);
    const vec3 middle = 0.5f * (high + low);
    add_loft(mesh, {{low.z, half.x, half.y}, {high.z, half.x, half.y}}, kSquare, middle.x, middle.y);
}

void add_sphere(Mesh& mesh) {
    std::vector<Ring> rings;
    constexpr int kRings = 12;
    for (int r = 0; r <= kRings; ++r) {
        const float angle = glm::radians(180.0f * static_cast<float>(r) / kRings);
        rings.push_back({-0.5f * std::cos(angle), 0.5f * std::sin(angle), 0.5f * std::sin(angle)});
    }
    add_loft(mesh, rings, kRound);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.normals[i] = glm::normalize(mesh.positions[i]);
}

// A bar above and two arms, between which the head turns.
void add_yoke(Mesh& mesh) {
    constexpr float kArm = 0.39f;
    add_loft(mesh, {{0.12f, 0.5f, 0.5f}, {0.3f, 0.5f, 0.5f}, {0.5f, 0.36f, 0.5f}}, kSquare);
    for (const float side : {-1.0f, 1.0f}) {
        const float x = side * 0.5f * (0.5f + kArm);
        const float half = 0.5f * (0.5f - kArm);
        add_loft(mesh, {{-0.5f, half, 0.3f}, {-0.3f, half, 0.5f}, {0.12f, half, 0.5f}}, kSquare, x);
    }
}

// The lens below, narrower behind.
void add_head(Mesh& mesh) {
    add_loft(mesh,
             {{-0.5f, 0.4f, 0.4f},
              {-0.44f, 0.45f, 0.45f},
              {-0.2f, 0.5f, 0.5f},
              {0.22f, 0.5f, 0.5f},
              {0.38f, 0.4f, 0.4f},
              {0.5f, 0.27f, 0.27f}},
             kRound);
}

void add_base(Mesh& mesh) {
    add_loft(mesh, {{-0.5f, 0.46f, 0.42f}, {-0.3f, 0.5f, 0.5f}, {0.3f, 0.5f, 0.5f}, {0.5f, 0.46f, 0.42f}},
             kSquare);
}

// A can with its lens below, in a bracket.
void add_conventional(Mesh& mesh) {
    add_loft(mesh, {{-0.5f, 0.46f, 0.5f}, {-0.4f, 0.43f, 0.47f}, {0.1f, 0.43f, 0.47f}, {0.28f, 0.3f, 0.3f}},
             kRound);
    add_box(mesh, {-0.5f, -0.06f, 0.44f}, {0.5f, 0.06f, 0.5f});
    for (const float side : {-0.5f, 0.46f})
        add_box(mesh, {side, -0.06f, -0.15f}, {side + 0.04f, 0.06f, 0.44f});
}

// A box; before it, to the house, the mirror in its fork.
void add_scanner(Mesh& mesh) {
    add_box(mesh, {-0.5f, -0.18f, -0.5f}, {0.5f, 0.5f, 0.5f});
    for (const float z : {-0.34f, 0.3f}) add_box(mesh, {-0.06f, -0.45f, z}, {0.06f, -0.18f, z + 0.04f});
    add_box(mesh, {-0.22f, -0.5f, -0.3f}, {0.22f, -0.47f, 0.3f});
}

} // namespace

Mesh primitive_mesh(std::string_view type) {
    Mesh mesh;
    // The 1.1 primitives hang below their origin, the others are about it.
    vec3 shift(0.0f);
    if (type.ends_with("1_1")) {
        type.remove_suffix(3);
        shift.z = -0.5f;
    }
    if (type == "Cylinder" || type == "Pigtail")
        add_loft(mesh, {{-0.5f}, {0.5f}}, kRound);
    else if (type == "Sphere")
        add_sphere(mesh);
    else if (type == "Base")
        add_base(mesh);
    else if (type == "Yoke")
        add_yoke(mesh);
    else if (type == "Head")
        add_head(mesh);
    else if (type == "Conventional")
        add_conventional(mesh);
    else if (type == "Scanner")
        add_scanner(mesh);
    else
        add_box(mesh, vec3(-0.5f), vec3(0.5f));
    for (vec3& position : mesh.positions) position += shift;
    return mesh;
}

} // namespace ghost::scene
