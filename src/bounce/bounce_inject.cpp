// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_inject.h"

#include "shared/beam.h"
#include "shared/octahedral.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

namespace ghost::scene {
namespace {

constexpr int kPlainRings = 8;   // of an open beam, and as many sectors
constexpr int kShapedRings = 16; // with pictures or edges in the gate
constexpr int kLooks = 2;        // each way, at the beam in a part of the gate
constexpr float kTypical_m = 10; // where a beam that meets nothing is looked at
constexpr float kNothing_m = 1e4f;
constexpr float kFullTurn = 6.28318531f;

bool is_shaped(const shared::Light& light) {
    return light.wheel_count > 0 || light.shaped != 0 || light.slide.layer != 0 || light.figure.kind != 0 ||
           light.split < shared::kNoSplit;
}

// Entries of places that come again and again, in the order they came first.
template <class Entry>
Entry& entry_of(std::vector<std::uint32_t>& where, std::vector<Entry>& entries, std::uint32_t key) {
    if (where[key] == kNoNode) {
        where[key] = static_cast<std::uint32_t>(entries.size());
        entries.push_back({});
    }
    return entries[where[key]];
}

} // namespace

BounceEntries bounce_entries(const Bounce& bounce, const shared::Light& lamp, const shared::Gobos& gobos,
                             const LampSight& sight, float extinction_per_m) {
    BounceEntries entries;
    shared::Light light = lamp;
    light.intensity_cd = glm::vec3(1);
    std::vector<std::uint32_t> air_at(bounce.fine.cells.size(), kNoNode);
    std::vector<std::uint32_t> surface_at(bounce.fine.surfels.size(), kNoNode);
    const auto size = static_cast<float>(sight.size);
    const int rings = is_shaped(light) ? kShapedRings : kPlainRings;
    const float reach = light.cut_radius * light.tan_field;
    const float area = 0.5f * kFullTurn * reach * reach / static_cast<float>(rings * rings * kLooks * kLooks);
    for (int part = 0; part < rings * rings; ++part) {
        const auto slope_at = [&](float ring, float sector) {
            const float radius =
                reach * std::sqrt((static_cast<float>(part % rings) + ring) / static_cast<float>(rings));
            const float angle =
                kFullTurn * (static_cast<float>(part / rings) + sector) / static_cast<float>(rings);
            return glm::vec2(radius * std::cos(angle), radius * std::sin(angle));
        };
        const glm::vec2 middle = slope_at(0.5f, 0.5f);
        const glm::vec3 to_gate = light.axis_u * middle.x + light.axis_v * middle.y + light.axis_w;
        const float slant = glm::length(to_gate);
        const glm::vec3 way = to_gate / slant;
        const glm::vec2 place = shared::octahedral_from(way);
        const auto texel =
            static_cast<std::size_t>(std::min(static_cast<int>(place.y * size), sight.size - 1) * sight.size +
                                     std::min(static_cast<int>(place.x * size), sight.size - 1));
        const float met_m = glm::unpackHalf1x16(sight.distance_m[texel]);
        const float from_lens_m = met_m > 0 ? met_m : kTypical_m;
        const float z_m = light.lens_m + std::max(from_lens_m / slant, 1e-2f);
        glm::vec3 lumens(0);
        for (int look = 0; look < kLooks * kLooks; ++look) {
            const int row = look / kLooks;
            const glm::vec2 slope = slope_at((static_cast<float>(look % kLooks) + 0.5f) / kLooks,
                                             (static_cast<float>(row) + 0.5f) / kLooks);
            lumens += shared::beam_candela(light, glm::vec3(slope, 1) * z_m, gobos) *
                      (area * std::pow(1 + glm::dot(slope, slope), -1.5f));
        }
        if (lumens == glm::vec3(0)) continue;
        entries.sent += lumens;
        // Lengths of haze from the lens on.
        const glm::vec3 lens_m = light.position_m + to_gate * light.lens_m;
        const auto passing = [&](float a, float b) {
            if (extinction_per_m * (b - a) < 1e-4f) return (b - a) * std::exp(-extinction_per_m * a);
            return (std::exp(-extinction_per_m * a) - std::exp(-extinction_per_m * b)) / extinction_per_m;
        };
        // The last sub-voxel may be cut by the wall and be a cell of its other side.
        const bool lands = met_m > 0 && sight.surfel[texel] != kNoNode;
        const std::uint32_t before_wall = lands ? bounce.fine.surfels[sight.surfel[texel]].cell : kNoNode;
        const float end_m = met_m > 0 ? met_m : kNothing_m;
        walk_cells(bounce, lens_m, way, end_m, [&](std::uint32_t crossed, float a, float b) {
            const bool is_cut = lands && b >= end_m - 1e-3f && b - a < 2 * bounce.grid.sub_m;
            const std::uint32_t cell = is_cut ? before_wall : crossed;
            BounceEntries::InAir& entry = entry_of(air_at, entries.air, cell);
            const glm::vec3 more = lumens * passing(a, b);
            entry.cell = cell;
            entry.lumen_m += more;
            entry.way += way * (more.x + more.y + more.z);
        });
        if (!lands) continue;
        BounceEntries::OnSurface& entry = entry_of(surface_at, entries.surfaces, sight.surfel[texel]);
        entry.surfel = sight.surfel[texel];
        entry.reflected +=
            lumens * unpacked_albedo(sight.albedo[texel]) * std::exp(-extinction_per_m * met_m);
    }
    for (BounceEntries::InAir& entry : entries.air) {
        const float length = glm::length(entry.way);
        entry.way = length > 0 ? entry.way / length : light.axis_w;
    }
    return entries;
}

} // namespace ghost::scene
