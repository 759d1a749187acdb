#pragma once
// SPDX-License-Identifier: Apache-2.0
// The first half of bake/bounce.h: cells, surfels and what of the stage each of them stands for.

#include "bake/bounce.h"

#include <cstdint>
#include <vector>

namespace ghost::bake {

// A place on a surface, on one of its sides.
struct SurfacePoint {
    glm::vec3 place_m{0};
    glm::vec3 normal{0};
    glm::vec3 albedo{0};
    float area_m2 = 0;
    std::uint32_t cell = scene::kNoNode; // of air before it
    std::uint32_t instance = 0;
};

struct BounceNodes {
    std::vector<SurfacePoint> points;
    // Of each cell and block its sub-voxels, of each surfel and cluster its points.
    std::vector<std::vector<std::uint32_t>> subs_of_cell, subs_of_block, points_of_surfel, points_of_cluster;
};

// Fractions of all work, for the bar; a guess.
inline constexpr double kNodesMade = 0.1, kNearMade = 0.5, kFarMade = 0.9;

// Grid, cells, surfels and their parents; links stay empty. False: stopped.
bool make_bounce_nodes(const Tracer& tracer, const BounceOptions& options, float cell_m,
                       scene::Bounce& bounce, BounceNodes& nodes);

// Rows and prolongation. False: stopped.
bool make_bounce_links(const Tracer& tracer, const BounceOptions& options, const BounceNodes& nodes,
                       scene::Bounce& bounce);

// Whether nothing stands between two places.
inline bool sees(const Tracer& tracer, const glm::vec3& from_m, const glm::vec3& to_m) {
    const glm::vec3 way = to_m - from_m;
    const float length_m = glm::length(way);
    constexpr float kSkin_m = 1e-4f;
    if (length_m < 2 * kSkin_m) return true;
    const glm::vec3 unit = way / length_m;
    return tracer.meet(from_m + unit * kSkin_m, unit, length_m - 2 * kSkin_m).instance < 0;
}

// Numbers of a sequence of its own, PCG32 of O'Neill.
class BounceRandom {
public:
    explicit BounceRandom(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15ull + 0x853c49e6748fea9bull) {
        next();
        next();
    }
    float operator()() { return static_cast<float>(next() >> 8) * 0x1p-24f; }

private:
    std::uint32_t next() {
        const std::uint64_t before = state_;
        state_ = before * 6364136223846793005ull + 1442695040888963407ull;
        const auto mixed = static_cast<std::uint32_t>(((before >> 18) ^ before) >> 27);
        const auto turn = static_cast<std::uint32_t>(before >> 59);
        return (mixed >> turn) | (mixed << ((32 - turn) & 31));
    }
    std::uint64_t state_;
};

} // namespace ghost::bake
