// SPDX-License-Identifier: Apache-2.0
// Bodies without a mesh: closed, of the stated size, in their frame, and shaped as their names say.
#include "stage/primitives.h"

#include <gtest/gtest.h>
#include <numbers>

namespace ghost::scene {
namespace {

using glm::vec3;

const char* const kTypes[] = {"Cube",         "Cylinder",        "Sphere",  "Base",    "Yoke",
                              "Head",         "Scanner",         "Pigtail", "Base1_1", "Scanner1_1",
                              "Conventional", "Conventional1_1", "Nobody"};

double volume(const Mesh& mesh) {
    double six = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        six += static_cast<double>(
            glm::dot(mesh.positions[mesh.indices[i]],
                     glm::cross(mesh.positions[mesh.indices[i + 1]], mesh.positions[mesh.indices[i + 2]])));
    return six / 6.0;
}

// Whether a ray meets the mesh.
bool stops(const Mesh& mesh, const vec3& from, const vec3& way) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const vec3& a = mesh.positions[mesh.indices[i]];
        const vec3 ab = mesh.positions[mesh.indices[i + 1]] - a;
        const vec3 ac = mesh.positions[mesh.indices[i + 2]] - a;
        const vec3 p = glm::cross(way, ac);
        const float det = glm::dot(ab, p);
        if (det == 0.0f) continue;
        const float u = glm::dot(from - a, p) / det;
        const vec3 q = glm::cross(from - a, ab);
        const float v = glm::dot(way, q) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && glm::dot(ac, q) / det > 0) return true;
    }
    return false;
}

TEST(primitives, fill_their_box_and_are_closed) {
    for (const std::string type : kTypes) {
        const Mesh mesh = primitive_mesh(type);
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << type;
        vec3 low(1e9f);
        vec3 high(-1e9f);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            low = glm::min(low, mesh.positions[i]);
            high = glm::max(high, mesh.positions[i]);
            EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-4f) << type;
        }
        const float top = type.ends_with("1_1") ? 0.0f : 0.5f;
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(high[k] - low[k], 1.0f, 0.01f) << type << k; // 24 sides are not quite a circle
            EXPECT_NEAR(high[k], k == 2 ? top : 0.5f, 0.005f) << type << k;
        }
        // Faces that look outward make a positive volume.
        EXPECT_GT(volume(mesh), 0.05) << type;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const vec3& a = mesh.positions[mesh.indices[i]];
            const vec3 across =
                glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a);
            EXPECT_GT(glm::dot(across, mesh.normals[mesh.indices[i]]), 0.0f) << type;
        }
    }
}

TEST(primitives, look_like_their_names) {
    EXPECT_NEAR(volume(primitive_mesh("Cube")), 1.0, 1e-5);
    EXPECT_NEAR(volume(primitive_mesh("Cylinder")), std::numbers::pi / 4, 0.01);
    EXPECT_NEAR(volume(primitive_mesh("Sphere")), std::numbers::pi / 6, 0.02);
    // A head turns and shines between the arms of its yoke; a bar closes it above.
    const Mesh yoke = primitive_mesh("Yoke");
    const vec3 lamp(0, 0, -0.2f);
    for (const vec3 way : {vec3(0, 0, -1), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0.5f, 0, -1)})
        EXPECT_FALSE(stops(yoke, lamp, way)) << way.x << way.y << way.z;
    for (const vec3 way : {vec3(0, 0, 1), vec3(1, 0, 0), vec3(-1, 0, 0)}) EXPECT_TRUE(stops(yoke, lamp, way));
    // Wider at the lens than behind.
    const Mesh head = primitive_mesh("Head");
    EXPECT_TRUE(stops(head, {0.38f, 0, -1}, {0, 0, 1}));
    EXPECT_FALSE(stops(head, {0.48f, 0, 0.45f}, {-0.01f, 0, 1}));
}

} // namespace
} // namespace ghost::scene
