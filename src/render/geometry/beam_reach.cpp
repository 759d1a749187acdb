// SPDX-License-Identifier: Apache-2.0
#include "render/geometry/beam_reach.h"

#include "base/check.h"
#include "passes/distance_maps.h"
#include "shared/beam.h"
#include "shared/octahedral.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace ghost::render {
namespace {

constexpr int kRimRays = 16;
constexpr float kBetweenRays = 1.1f; // the rim leaves the box a little later between two of them
constexpr float kLeast_m = 0.1f;
constexpr float kSurface_m = 0.99f * scene::kNoSurface_m;

// Of a ray from inside or outside; as a multiple of its direction. Below 0: the box lies behind.
float leaves_at(const SeenBox& box, const glm::vec3& from_m, const glm::vec3& way) {
    float leaves = kEndless_m;
    for (int c = 0; c < 3; ++c) {
        if (std::abs(way[c]) < 1e-9f) continue;
        leaves = std::min(leaves, ((way[c] > 0 ? box.high_m[c] : box.low_m[c]) - from_m[c]) / way[c]);
    }
    return leaves;
}

glm::vec3 way_to(std::size_t x, std::size_t y, float at) {
    return shared::direction_from_octahedral((glm::vec2(static_cast<float>(x), static_cast<float>(y)) + at) /
                                             static_cast<float>(kFarSide));
}

struct Part {
    glm::vec3 way; // unit, to its middle
    float radius_rad;
};

const std::array<Part, kFarSide * kFarSide>& parts_of_sphere() {
    static const auto parts = [] {
        std::array<Part, kFarSide * kFarSide> result;
        for (std::size_t y = 0; y < kFarSide; ++y)
            for (std::size_t x = 0; x < kFarSide; ++x) {
                Part& part = result[y * kFarSide + x];
                part.way = way_to(x, y, 0.5f);
                float cosine = 1;
                for (const std::size_t dx : {0u, 1u})
                    for (const std::size_t dy : {0u, 1u})
                        cosine = std::min(cosine, glm::dot(part.way, way_to(x + dx, y + dy, 0)));
                part.radius_rad = std::acos(cosine);
            }
        return result;
    }();
    return parts;
}

} // namespace

float reach_in(const SeenBox& box, const shared::Light& light) {
    if (!box.closed) return kEndless_m;
    float reach = std::max(leaves_at(box, light.position_m, light.axis_w), kLeast_m);
    const float rim = light.tan_field * light.cut_radius;
    for (int k = 0; k < kRimRays; ++k) {
        const float turn = 2 * shared::kPi * static_cast<float>(k) / kRimRays;
        const glm::vec3 aside = std::cos(turn) * light.axis_u + std::sin(turn) * light.axis_v;
        reach = std::max(reach, leaves_at(box, light.position_m, light.axis_w + rim * aside));
    }
    reach *= kBetweenRays;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 at_m{corner & 1 ? box.high_m.x : box.low_m.x, corner & 2 ? box.high_m.y : box.low_m.y,
                             corner & 4 ? box.high_m.z : box.low_m.z};
        const glm::vec3 q = shared::to_gate(light, at_m - light.position_m);
        if (q.z > 0 && glm::length(glm::vec2(q)) <= rim * q.z) reach = std::max(reach, q.z);
    }
    return std::min(reach, kEndless_m);
}

FarParts far_parts(const std::vector<std::uint16_t>& texels, std::size_t side) {
    CHECK_EQ(texels.size(), side * side);
    FarParts parts;
    update_far_parts(texels, side, 0, 0, side, parts);
    return parts;
}

void update_far_parts(const std::vector<std::uint16_t>& texels, std::size_t side, std::size_t x0,
                      std::size_t y0, std::size_t width, FarParts& parts) {
    const auto end = [&](std::size_t from) { return ((from + width) * kFarSide + side - 1) / side; };
    for (std::size_t y = y0 * kFarSide / side; y < end(y0); ++y)
        for (std::size_t x = x0 * kFarSide / side; x < end(x0); ++x) {
            std::uint16_t most = 0; // half floats above 0 are in the order of their bits
            for (std::size_t row = y * side / kFarSide; row * kFarSide < (y + 1) * side; ++row)
                for (std::size_t column = x * side / kFarSide; column * kFarSide < (x + 1) * side; ++column)
                    most = std::max(most, texels[row * side + column]);
            parts[y * kFarSide + x] = glm::unpackHalf1x16(most);
        }
}

float reach_in(const FarParts& parts, const shared::Light& light) {
    const auto& sphere = parts_of_sphere();
    const float rim_rad = std::atan(light.tan_field * light.cut_radius);
    float farthest = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        if (parts[k] <= farthest) continue;
        const float cosine = std::clamp(glm::dot(sphere[k].way, light.axis_w), -1.0f, 1.0f);
        if (cosine > std::cos(std::min(rim_rad + sphere[k].radius_rad, shared::kPi))) farthest = parts[k];
    }
    if (farthest >= kSurface_m) return kEndless_m;
    // The map is seen from the head's middle, the beam from its apex.
    return std::max(farthest + glm::length(light.off_map_m), kLeast_m);
}

} // namespace ghost::render
