// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {

const std::array<glm::vec3, kBounceBins>& bounce_directions() {
    static const std::array<glm::vec3, kBounceBins> all = [] {
        std::array<glm::vec3, kBounceBins> directions{};
        for (std::size_t k = 0; k < 6; ++k)
            directions[k][static_cast<glm::length_t>(k / 2)] = k % 2 == 0 ? 1.0f : -1.0f;
        const float part = std::sqrt(1.0f / 3.0f);
        for (std::size_t k = 0; k < 8; ++k)
            directions[6 + k] = {(k & 1) != 0 ? -part : part, (k & 2) != 0 ? -part : part,
                                 (k & 4) != 0 ? -part : part};
        return directions;
    }();
    return all;
}

std::size_t bounce_bin(const glm::vec3& way) {
    const glm::vec3 size = glm::abs(way);
    const std::size_t axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const float corner = (size.x + size.y + size.z) * 0.57735027f;
    const auto k = static_cast<glm::length_t>(axis);
    if (size[k] >= corner) return 2 * axis + (way[k] < 0 ? 1 : 0);
    return 6 + (way.x < 0 ? 1u : 0u) + (way.y < 0 ? 2u : 0u) + (way.z < 0 ? 4u : 0u);
}

float bounce_steradians(std::size_t bin) {
    // Of all directions, six faces have as many as are nearer to an axis than to a diagonal.
    static const float face = [] {
        constexpr int kSide = 512;
        double sum = 0;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double u = (x + 0.5) / kSide, v = (y + 0.5) / kSide;
                if (1.0 >= (1.0 + u + v) * 0.577350269) sum += std::pow(1 + u * u + v * v, -1.5);
            }
        return static_cast<float>(4 * sum / (kSide * kSide));
    }();
    constexpr float kSphere = 12.5663706f;
    return bin < 6 ? face : (kSphere - 6 * face) / 8;
}

std::size_t bounce_side(const glm::vec3& normal) {
    const glm::vec3 size = glm::abs(normal);
    const glm::length_t axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    return static_cast<std::size_t>(axis) * 2 + (normal[axis] < 0 ? 1 : 0);
}

int BounceGrid::sub_at(const glm::vec3& place_m) const {
    const glm::vec3 at = (place_m - low_m) / sub_m;
    for (int k = 0; k < 3; ++k)
        if (!(at[k] >= 0 && at[k] < static_cast<float>(subs[k]))) return -1;
    return (static_cast<int>(at.z) * subs.y + static_cast<int>(at.y)) * subs.x + static_cast<int>(at.x);
}

glm::vec3 BounceGrid::sub_centre_m(int sub) const {
    return low_m + (glm::vec3(sub % subs.x, sub / subs.x % subs.y, sub / subs.x / subs.y) + 0.5f) * sub_m;
}

int BounceGrid::voxel_at(const glm::vec3& place_m, int of_subs) const {
    const glm::ivec3 count = voxels(of_subs);
    const glm::vec3 at = glm::floor((place_m - low_m) / (sub_m * static_cast<float>(of_subs)));
    const glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::clamp(at, -1.0f, 1e6f)), glm::ivec3(0), count - 1);
    return (voxel.z * count.y + voxel.y) * count.x + voxel.x;
}

std::uint64_t Bounce::bytes() const {
    std::uint64_t sum = cell_of.size() * sizeof cell_of[0];
    for (const BounceRows* rows : {&near, &far})
        sum += rows->start.size() * sizeof rows->start[0] + rows->links.size() * sizeof(BounceLink);
    for (const BounceLevel* level : {&fine, &coarse})
        sum += level->cells.size() * sizeof(BounceCell) + level->surfels.size() * sizeof(BounceSurfel);
    return sum + (cell_parents.size() + surfel_parents.size()) * sizeof(BounceParents);
}

std::uint32_t packed_albedo(const glm::vec3& albedo) {
    std::uint32_t packed = 0;
    for (int c = 0; c < 3; ++c)
        packed |=
            static_cast<std::uint32_t>(std::lround(255.0f * std::sqrt(glm::clamp(albedo[c], 0.0f, 1.0f))))
            << (8 * c);
    return packed;
}

glm::vec3 unpacked_albedo(std::uint32_t packed) {
    const glm::vec3 root(packed & 255u, packed >> 8 & 255u, packed >> 16 & 255u);
    return root * root / (255.0f * 255.0f);
}

} // namespace ghost::scene
