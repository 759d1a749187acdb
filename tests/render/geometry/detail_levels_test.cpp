// SPDX-License-Identifier: Apache-2.0
// Coarser meshes: fewer triangles of the same vertices, no farther from the shape than they say, normals of
// the side that they show; a mesh of few triangles has none.
#include "render/geometry/private/detail_levels.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace ghost::render {
namespace {

struct Shape {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::uint32_t> indices;
};

// A tube along z with caps, hard edges between them: the vertices of the rims are there twice.
Shape tube(float radius_m, float length_m, std::uint32_t sides) {
    Shape shape;
    const auto rim = [&](float z_m, float out) {
        const auto first = static_cast<std::uint32_t>(shape.positions.size());
        for (std::uint32_t k = 0; k < sides; ++k) {
            const float a = 6.2831853f * static_cast<float>(k) / static_cast<float>(sides);
            const glm::vec3 way(std::cos(a), std::sin(a), 0);
            shape.positions.push_back(radius_m * way + glm::vec3(0, 0, z_m));
            shape.normals.push_back(out == 0.0f ? way : glm::vec3(0, 0, out));
        }
        return first;
    };
    const std::uint32_t low = rim(0, 0), high = rim(length_m, 0), floor = rim(0, -1), roof = rim(length_m, 1);
    for (std::uint32_t k = 0; k < sides; ++k) {
        const std::uint32_t n = (k + 1) % sides;
        shape.indices.insert(shape.indices.end(), {low + k, low + n, high + k, high + k, low + n, high + n});
        if (k > 0 && n > 0) shape.indices.insert(shape.indices.end(), {floor, floor + n, floor + k});
        if (k > 0 && n > 0) shape.indices.insert(shape.indices.end(), {roof, roof + k, roof + n});
    }
    return shape;
}

TEST(DetailLevels, TubeKeepsItsShape) {
    const Shape shape = tube(0.2f, 0.5f, 256);
    const auto levels = detail_levels(shape.positions, shape.normals, {}, shape.indices);
    ASSERT_GE(levels.size(), 2u);
    std::size_t before = shape.indices.size();
    float error_m = 0;
    for (const DetailLevel& level : levels) {
        ASSERT_EQ(level.indices.size() % 3, 0u);
        ASSERT_FALSE(level.indices.empty());
        EXPECT_LE(3 * level.indices.size(), 2 * before);
        EXPECT_GT(level.error_m, error_m);
        before = level.indices.size();
        error_m = level.error_m;
        for (std::size_t k = 0; k < level.indices.size(); k += 3) {
            const std::uint32_t* i = level.indices.data() + k;
            for (int c = 0; c < 3; ++c) ASSERT_LT(i[c], shape.positions.size());
            const glm::vec3 a = shape.positions[i[0]], b = shape.positions[i[1]], d = shape.positions[i[2]];
            const glm::vec3 facet = glm::normalize(glm::cross(b - a, d - a));
            if (std::abs(facet.z) < 0.01f) {
                // Of the side: its middle is no deeper inside than the error.
                for (const glm::vec3& middle : {0.5f * (a + b), 0.5f * (b + d), 0.5f * (d + a)})
                    EXPECT_GT(std::hypot(middle.x, middle.y), 0.2f - level.error_m);
            }
            for (int c = 0; c < 3; ++c) EXPECT_GT(glm::dot(shape.normals[i[c]], facet), 0.7f);
        }
    }
    EXPECT_LT(before, shape.indices.size() / 4);
}

TEST(DetailLevels, FewTrianglesStay) {
    const Shape shape = tube(0.2f, 0.5f, 12);
    EXPECT_TRUE(detail_levels(shape.positions, shape.normals, {}, shape.indices).empty());
    EXPECT_TRUE(detail_levels({}, {}, {}, {}).empty());
}

} // namespace
} // namespace ghost::render
