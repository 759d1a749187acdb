// SPDX-License-Identifier: Apache-2.0
// 3DS files made here, chunk by chunk: what is whole passes, what lies is named.
#include "fixture_files/common/mesh_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace ghost::fixture {
namespace {

using Bytes8 = std::vector<std::uint8_t>;

Bytes8 u16(std::initializer_list<int> numbers) {
    Bytes8 out;
    for (const int number : numbers) {
        out.push_back(static_cast<std::uint8_t>(number & 255));
        out.push_back(static_cast<std::uint8_t>(number >> 8));
    }
    return out;
}

Bytes8 operator+(Bytes8 left, const Bytes8& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

Bytes8 chunk(int identifier, const Bytes8& inside) {
    const int length = static_cast<int>(inside.size()) + 6;
    return u16({identifier, length & 0xffff, length >> 16}) + inside;
}

// A mesh of three vertices with one triangle a corner list.
Bytes8 file_with(const std::vector<std::array<int, 3>>& triangles) {
    Bytes8 faces = u16({static_cast<int>(triangles.size())});
    for (const auto& corner : triangles) faces = faces + u16({corner[0], corner[1], corner[2], 7});
    const Bytes8 vertices = u16({3}) + Bytes8(3 * 12, 0);
    const Bytes8 mesh = chunk(0x4100, chunk(0x4120, faces) + chunk(0x4110, vertices));
    return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, Bytes8{'b', 'o', 'x', 0} + mesh)));
}

TEST(MeshCheck, triangles_that_name_missing_vertices_are_counted) {
    EXPECT_EQ(fault_of_mesh(file_with({{0, 1, 2}}), "3ds"), "");
    EXPECT_EQ(count_triangles_beyond_3ds(file_with({{0, 1, 2}, {2, 1, 0}})), 0u);
    EXPECT_EQ(count_triangles_beyond_3ds(file_with({{0, 1, 2}, {0, 1, 3}, {65535, 1, 2}})), 2u);
}

// Nodes with these parents (-1: none), by name n0, n1, ..
Bytes8 tree_of(const std::vector<int>& parents) {
    Bytes8 nodes;
    for (const int parent : parents)
        nodes = nodes + chunk(0xb002, chunk(0xb010, Bytes8{'n', 0} + u16({0, 0, parent & 0xffff})));
    return chunk(0x4d4d, chunk(0xb000, nodes));
}

TEST(MeshCheck, nodes_in_each_other_have_a_limit) {
    std::vector<int> chain, flat(3000, -1), pairs;
    for (int k = 0; k < 1000; ++k) chain.push_back(k - 1);
    for (int k = 0; k < 3000; k += 2) pairs.insert(pairs.end(), {-1, k});
    EXPECT_EQ(fault_of_mesh(tree_of(chain), "3ds"), "");
    EXPECT_EQ(fault_of_mesh(tree_of(flat), "3ds"), "");
    EXPECT_EQ(fault_of_mesh(tree_of(pairs), "3ds"), "");
    chain.push_back(999);
    EXPECT_NE(fault_of_mesh(tree_of(chain), "3ds").find("nodes more than 1000 deep"), std::string::npos);
    const Bytes8 half =
        chunk(0x4d4d, chunk(0xb000, chunk(0xb002, chunk(0xb010, Bytes8{'n', 0, 0, 0, 0, 0, 0}))));
    EXPECT_NE(fault_of_mesh(half, "3ds").find("without its place"), std::string::npos);
}

TEST(MeshCheck, a_file_cut_anywhere_is_refused_or_counted_without_reading_past_its_end) {
    const Bytes8 whole = file_with({{0, 1, 9}});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Bytes8 cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_NE(fault_of_mesh(cut, "3ds"), "") << size;
        EXPECT_EQ(count_triangles_beyond_3ds(cut), 0u) << size;
    }
}

} // namespace
} // namespace ghost::fixture
