// SPDX-License-Identifier: Apache-2.0
#include "bake/distance_sight.h"

#include "passes/distance_maps.h"
#include "shared/octahedral.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace ghost::bake {
namespace {

constexpr int kTile = 16;
// More than halves round off.
constexpr float kRounding = 1e-3f;
// Embree moves rays into the space of each instance; boxes grow by more than that rounds off.
constexpr float kBoxGrowth = 1e-4f;

float angle_between(const glm::vec3& a, const glm::vec3& b) {
    return std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

// Where a ray from the origin enters the box, or a negative number.
float entry(const glm::vec3& direction, const glm::vec3& low, const glm::vec3& high) {
    float from = 0.0f;
    float to = 1e30f;
    for (int axis = 0; axis < 3; ++axis) {
        const float way = std::abs(direction[axis]) > 1e-12f ? direction[axis] : 1e-12f;
        const float a = low[axis] / way;
        const float b = high[axis] / way;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to ? from : -1.0f;
}

} // namespace

DistanceSight::DistanceSight(int size) : size_(size) {
    const auto texels = static_cast<std::size_t>(size);
    directions_.reserve(texels * texels);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            directions_.push_back(
                shared::direction_from_octahedral((glm::vec2(x, y) + 0.5f) / static_cast<float>(size)));
    for (int y = 0; y < size; y += kTile)
        for (int x = 0; x < size; x += kTile) {
            Tile tile{x, y, std::min(x + kTile, size), std::min(y + kTile, size), glm::vec3(0.0f), 0.0f};
            const auto each = [&](const auto& visit) {
                for (int v = tile.y0; v < tile.y1; ++v)
                    for (int u = tile.x0; u < tile.x1; ++u)
                        visit(
                            directions_[static_cast<std::size_t>(v) * texels + static_cast<std::size_t>(u)]);
            };
            each([&](const glm::vec3& direction) { tile.axis += direction; });
            tile.axis = glm::normalize(tile.axis);
            each([&](const glm::vec3& direction) {
                tile.angle_rad = std::max(tile.angle_rad, angle_between(tile.axis, direction));
            });
            tiles_.push_back(tile);
        }
}

std::vector<float> DistanceSight::farthest_m(const std::vector<std::uint16_t>& distance) const {
    std::vector<float> result;
    result.reserve(tiles_.size());
    for (const Tile& tile : tiles_) {
        std::uint16_t farthest = 0; // positive halves are ordered as their bits
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x)
                farthest = std::max(farthest, distance[static_cast<std::size_t>(y * size_ + x)]);
        result.push_back(glm::unpackHalf1x16(farthest));
    }
    return result;
}

bool DistanceSight::may_change(const std::vector<std::uint16_t>& distance,
                               const std::vector<float>& farthest_m, const glm::vec3& position_m,
                               glm::vec3 low, glm::vec3 high) const {
    const glm::vec3 largest = glm::max(glm::max(glm::abs(low), glm::abs(high)), glm::abs(position_m));
    const float growth = kBoxGrowth * (1.0f + std::max({largest.x, largest.y, largest.z}));
    low += -position_m - growth;
    high += growth - position_m;
    const glm::vec3 outside = glm::max(glm::max(low, -high), glm::vec3(0.0f));
    const float nearest_m = glm::length(outside);
    if (!(nearest_m > 0.0f)) return true; // the light is inside it
    if (nearest_m > scene::kNoSurface_m) return false;
    const glm::vec3 centre = 0.5f * (low + high);
    const float centre_m = glm::length(centre);
    const float radius = 0.5f * glm::length(high - low);
    const bool round_it = !(centre_m > radius); // the light is inside its bounding sphere
    const glm::vec3 axis = round_it ? glm::vec3(0.0f) : centre / centre_m;
    const float box_rad = round_it ? 0.0f : std::asin(radius / centre_m);
    const auto reaches = [](float end_m, float from_m) { return end_m * (1.0f + kRounding) >= from_m; };
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        const Tile& tile = tiles_[t];
        if (!reaches(farthest_m[t], nearest_m)) continue;
        if (!round_it && angle_between(axis, tile.axis) > tile.angle_rad + box_rad + kRounding) continue;
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const auto texel = static_cast<std::size_t>(y * size_ + x);
                const float from_m = entry(directions_[texel], low, high);
                if (from_m >= 0.0f && reaches(glm::unpackHalf1x16(distance[texel]), from_m)) return true;
            }
    }
    return false;
}

} // namespace ghost::bake
