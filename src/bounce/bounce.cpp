// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {

const std::array<glm::vec3, kBounceBins>& bounce_directions() {
    static const std::array<glm::vec3, kBounceBins> all = [] {
        std::array<glm::vec3, kBounceBins> directions{};
        std::size_t count = 0;
        for (int axes = 1; axes <= 3; ++axes) // faces, edges, corners
            for (int k = 14; k < 27; ++k) {   // of two that are opposite the latter in their order
                const glm::vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                if (std::lround(glm::dot(way, way)) != axes) continue;
                directions[count++] = glm::normalize(way);
                directions[count++] = -glm::normalize(way);
            }
        return directions;
    }();
    return all;
}

std::size_t bounce_bin(const glm::vec3& way) {
    const std::array<glm::vec3, kBounceBins>& all = bounce_directions();
    std::size_t nearest = 0;
    float best = -2;
    for (std::size_t k = 0; k < kBounceBins; k += 2) {
        const float cosine = glm::dot(way, all[k]);
        if (std::abs(cosine) <= best) continue;
        best = std::abs(cosine);
        nearest = cosine < 0 ? k + 1 : k;
    }
    return nearest;
}

float bounce_steradians(std::size_t bin) {
    // Fractions of a face of the cube, all of whose directions are looked at.
    static const std::array<float, kBounceKinds> of_kinds = [] {
        constexpr int kSide = 512;
        std::array<double, kBounceKinds> sums{};
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const float u = 2 * (static_cast<float>(x) + 0.5f) / kSide - 1,
                            v = 2 * (static_cast<float>(y) + 0.5f) / kSide - 1;
                sums[bounce_kind(bounce_bin({u, v, 1}))] += std::pow(1.0 + u * u + v * v, -1.5);
            }
        const double sphere = 6 * (sums[0] + sums[1] + sums[2]);
        constexpr std::array<double, kBounceKinds> kCounts{6, 12, 8};
        std::array<float, kBounceKinds> steradians{};
        for (std::size_t k = 0; k < kBounceKinds; ++k)
            steradians[k] = static_cast<float>(12.566370614 * 6 * sums[k] / (sphere * kCounts[k]));
        return steradians;
    }();
    return of_kinds[bounce_kind(bin)];
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
