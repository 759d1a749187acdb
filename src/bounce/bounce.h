#pragma once
// SPDX-License-Identifier: Apache-2.0
// What light meets when it bounces: a room cut into cells of air and surfels, and the links along which light
// goes between them. Made once for a stage (bake/bounce.h), whatever the lamps and the haze do; solved
// whenever a light changed (bounce/bounce_solver.h). Two levels: fine cells and surfels, and blocks of 2x2x2
// cells with the surfels in them, for light that goes far. The design: docs/design/bounce.md. Plain values;
// metres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace ghost::scene {

// Directions that light in a cell travels in: faces, edges and corners of a cube; each two are opposite.
inline constexpr std::size_t kBounceBins = 26;
inline constexpr std::size_t kBounceKinds = 3; // of bins that look alike
constexpr std::size_t bounce_kind(std::size_t bin) {
    return bin < 6 ? 0 : bin < 18 ? 1 : 2;
}
const std::array<glm::vec3, kBounceBins>& bounce_directions();
std::size_t bounce_bin(const glm::vec3& way);
constexpr std::size_t bounce_reversed(std::size_t bin) { // of light that goes the other way
    return bin ^ 1u;
}
float bounce_steradians(std::size_t bin);
// Which of six sides a surface faces: +x, -x, +y ..
std::size_t bounce_side(const glm::vec3& normal);

inline constexpr int kSubsOfSurfel = 2; // sub-voxels across
inline constexpr int kSubsOfCell = 4;
inline constexpr int kSubsOfBlock = 8;

// Of a room: larger ones are neither made nor read, nor are more cells of a level read.
inline constexpr std::size_t kMostBounceSubs = 8'000'000;
inline constexpr std::size_t kMostBounceCells = 1'000'000;

struct BounceGrid {
    glm::vec3 low_m{0};
    float sub_m = 0;    // a sub-voxel
    glm::ivec3 subs{0}; // whole blocks

    std::size_t count() const {
        return static_cast<std::size_t>(subs.x) * static_cast<std::size_t>(subs.y) *
               static_cast<std::size_t>(subs.z);
    }
    glm::ivec3 voxels(int of_subs) const { return subs / of_subs; }
    glm::vec3 high_m() const { return low_m + glm::vec3(subs) * sub_m; }
    int sub_at(const glm::vec3& place_m) const; // -1: outside
    glm::vec3 sub_centre_m(int sub) const;
    // Of voxels that many sub-voxels across; places outside count to the nearest.
    int voxel_at(const glm::vec3& place_m, int of_subs) const;
};

struct BounceCell {
    glm::vec3 centre_m{0};
    float volume_m3 = 0; // that is free
    std::uint32_t block = 0;
    std::uint32_t voxel = 0;
};

struct BounceSurfel {
    glm::vec3 place_m{0};
    glm::vec3 normal{0};
    glm::vec3 albedo{0};
    float area_m2 = 0;
    std::uint32_t cluster = 0; // index among the coarse surfels
    std::uint32_t voxel = 0;
    std::uint32_t cell = 0; // of air before it
    std::uint32_t side = 0;
};

// Fields of a level have kBounceBins slots a cell, then one a surfel.
struct BounceLevel {
    std::vector<BounceCell> cells;
    std::vector<BounceSurfel> surfels;

    std::size_t slots() const { return cells.size() * kBounceBins + surfels.size(); }
    std::size_t surfel_slot(std::size_t surfel) const { return cells.size() * kBounceBins + surfel; }
    // Of a node: cells come first, then surfels.
    std::size_t first_slot(std::size_t node) const {
        return node < cells.size() ? node * kBounceBins : surfel_slot(node - cells.size());
    }
};

// What a slot receives from another one, without the haze between them.
struct BounceLink {
    std::uint32_t emitter = 0;    // slot
    std::uint16_t weight = 0;     // half float
    std::uint16_t distance_m = 0; // half float
};

struct BounceRows {
    std::vector<std::uint32_t> start; // of each receiver's links, and the end
    std::vector<BounceLink> links;
};

// What a fine node takes of coarse ones: all of which it sees, trilinear; node kNoNode: no more.
struct BounceParents {
    std::array<std::uint32_t, 8> node;
    std::array<float, 8> fraction;
};
inline constexpr std::uint32_t kNoNode = 0xffffffffu;

inline bool is_share(float share) {
    return share >= 0 && share <= 1;
}

struct Bounce {
    BounceGrid grid;
    std::vector<std::uint32_t> cell_of; // of each sub-voxel; kNoNode: in a solid, or out of the room
    BounceLevel fine, coarse;
    BounceRows near, far; // of the fine level, of the coarse one
    // Of what comes to a fine slot where all that sends is equally bright, how much comes along coarse links:
    // nothing in a niche, nearly all in the middle of a hall.
    std::vector<float> far_share;
    std::vector<BounceParents> cell_parents, surfel_parents;

    bool empty() const { return fine.cells.empty() && fine.surfels.empty(); }
    std::uint64_t bytes() const;
};

// Where the light of a lamp lands, in all directions (shared/octahedral.h).
inline constexpr int kLampSightSize = 256; // of lamps that stay where they are
inline constexpr int kSmallLampSightSize = 128;
struct LampSight {
    glm::vec3 position_m{0};
    int size = 0;                          // texels a side
    std::vector<std::uint32_t> surfel;     // kNoNode: none
    std::vector<std::uint16_t> distance_m; // half floats; 0: nothing is hit
    std::vector<std::uint32_t> albedo;     // of the place for light from there (packed_albedo)
};
// Roots, 8 bits each: stages are dark.
std::uint32_t packed_albedo(const glm::vec3& albedo);
glm::vec3 unpacked_albedo(std::uint32_t packed);

// Cells along a ray up to end_m from its begin: air(cell, from_m, to_m). A sub-voxel in no cell counts to the
// cell before it. Returns the last cell, or kNoNode.
template <class Air>
std::uint32_t walk_cells(const Bounce& bounce, const glm::vec3& from_m, const glm::vec3& way, float end_m,
                         const Air& air) {
    const BounceGrid& grid = bounce.grid;
    constexpr float kNever = 1e30f;
    const glm::vec3 high_m = grid.high_m();
    float begin = 0, end = end_m;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(way[k]) < 1e-9f) {
            if (from_m[k] < grid.low_m[k] || from_m[k] > high_m[k]) return kNoNode;
            continue;
        }
        const float a = (grid.low_m[k] - from_m[k]) / way[k], b = (high_m[k] - from_m[k]) / way[k];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (!(begin < end)) return kNoNode;
    const glm::vec3 first_m = from_m + way * (begin + 1e-4f);
    int at[3], step[3];
    float next[3], width[3];
    for (int k = 0; k < 3; ++k) {
        at[k] = glm::clamp(static_cast<int>((first_m[k] - grid.low_m[k]) / grid.sub_m), 0, grid.subs[k] - 1);
        step[k] = way[k] > 0 ? 1 : -1;
        const bool moves = std::abs(way[k]) >= 1e-9f;
        width[k] = moves ? grid.sub_m / std::abs(way[k]) : kNever;
        const int edge = at[k] + (way[k] > 0 ? 1 : 0);
        next[k] =
            moves ? (grid.low_m[k] + static_cast<float>(edge) * grid.sub_m - from_m[k]) / way[k] : kNever;
    }
    std::uint32_t cell = kNoNode;
    float t = begin, since = begin;
    while (t < end) {
        const int k = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        const std::uint32_t here =
            bounce.cell_of[(static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(grid.subs.y) +
                            static_cast<std::size_t>(at[1])) *
                               static_cast<std::size_t>(grid.subs.x) +
                           static_cast<std::size_t>(at[0])];
        if (here != kNoNode && here != cell) {
            if (cell != kNoNode) {
                air(cell, since, t);
                since = t;
            }
            cell = here;
        }
        t = std::min(next[k], end);
        at[k] += step[k];
        next[k] += width[k];
        if (at[k] < 0 || at[k] >= grid.subs[k]) break;
    }
    if (cell != kNoNode) air(cell, since, std::min(end, t));
    return cell;
}

} // namespace ghost::scene
