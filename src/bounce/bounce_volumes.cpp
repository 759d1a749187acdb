// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_volumes.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace ghost::scene {
namespace {

using glm::vec4;

constexpr std::size_t kSides = 6;
constexpr float kLeastCosine = 0.55f; // of bins that an eye sees
constexpr float kMostLight = 65000;   // of a half float

std::size_t count_of(const glm::ivec3& size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           static_cast<std::size_t>(size.z);
}

// sums: light times weight, weight.
void pack(const glm::ivec3& size, const std::vector<vec4>& sums, BounceVolume& volume) {
    volume.size = size;
    volume.texels.resize(sums.size());
    for (std::size_t k = 0; k < sums.size(); ++k)
        volume.texels[k] =
            sums[k].w > 0
                ? glm::packHalf4x16(glm::min(vec4(glm::vec3(sums[k]) / sums[k].w, 1), vec4(kMostLight)))
                : 0;
}

} // namespace

void fill_lux(const Bounce& bounce, const BounceSolution& solution, BounceVolumes& volumes) {
    const BounceGrid& grid = bounce.grid;
    volumes.low_m = grid.low_m;
    volumes.surfel_m = grid.sub_m * kSubsOfSurfel;
    volumes.cell_m = grid.sub_m * kSubsOfCell;
    const glm::ivec3 surfels = grid.voxels(kSubsOfSurfel), cells = grid.voxels(kSubsOfCell);
    std::vector<vec4> sums(kSides * count_of(surfels), vec4(0));
    for (std::size_t k = 0; k < bounce.fine.surfels.size(); ++k) {
        const BounceSurfel& surfel = bounce.fine.surfels[k];
        sums[surfel.side * count_of(surfels) + surfel.voxel] +=
            vec4(glm::vec3(solution.lux[k]) * surfel.area_m2, surfel.area_m2);
    }
    pack(surfels, sums, volumes.surfaces);
    sums.assign(kSides * count_of(cells), vec4(0));
    for (std::size_t k = 0; k < bounce.fine.cells.size(); ++k) {
        const BounceCell& cell = bounce.fine.cells[k];
        for (std::size_t side = 0; side < kSides; ++side) {
            const glm::vec3 normal = bounce_directions()[side];
            vec4 lux(0);
            for (std::size_t bin = 0; bin < kBounceBins; ++bin)
                lux += solution.flux[k * kBounceBins + bin] *
                       std::max(0.0f, -glm::dot(bounce_directions()[bin], normal));
            sums[side * count_of(cells) + cell.voxel] +=
                vec4(glm::vec3(lux) * cell.volume_m3, cell.volume_m3);
        }
    }
    pack(cells, sums, volumes.air);
}

void fill_glow(const Bounce& bounce, const BounceSolution& solution, const glm::vec3& eye_m,
               BounceVolumes& volumes) {
    const glm::ivec3 cells = bounce.grid.voxels(kSubsOfCell);
    std::vector<vec4> sums(count_of(cells), vec4(0));
    for (std::size_t k = 0; k < bounce.fine.cells.size(); ++k) {
        const BounceCell& cell = bounce.fine.cells[k];
        const glm::vec3 away = eye_m - cell.centre_m;
        const float distance = glm::length(away);
        const glm::vec3 way = distance > 1e-3f ? away / distance : glm::vec3(0, 0, 1);
        vec4 glow(0);
        float weight = 0;
        for (std::size_t bin = 0; bin < kBounceBins; ++bin) {
            const float over = glm::dot(way, bounce_directions()[bin]) - kLeastCosine;
            if (over <= 0) continue;
            glow += solution.glow[k * kBounceBins + bin] * (over * over);
            weight += over * over;
        }
        if (weight > 0) sums[cell.voxel] += vec4(glm::vec3(glow) * (cell.volume_m3 / weight), cell.volume_m3);
    }
    pack(cells, sums, volumes.glow);
}

} // namespace ghost::scene
