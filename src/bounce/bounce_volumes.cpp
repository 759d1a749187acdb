// SPDX-License-Identifier: Apache-2.0
#include "bounce/bounce_volumes.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace ghost::scene {
namespace {

using glm::vec4;

constexpr std::size_t kSides = 6;
constexpr float kMostLight = 65000;  // of a half float
constexpr float kLeastKnown = 0.05f; // of what falls on a surface, by weight

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

// Between texels, as common/room_volume.glsl has it; voxels: place in the volume.
vec4 volume_at(const BounceVolume& volume, const glm::vec3& voxels, std::size_t side) {
    const glm::vec3 at = glm::clamp(voxels - 0.5f, glm::vec3(0), glm::vec3(volume.size - 1));
    const glm::ivec3 below(at);
    const glm::ivec3 above = glm::min(below + 1, volume.size - 1);
    const glm::vec3 fraction = at - glm::vec3(below);
    vec4 sum(0);
    for (int corner = 0; corner < 8; ++corner) {
        const bool x = (corner & 1) != 0, y = (corner & 2) != 0, z = (corner & 4) != 0;
        const glm::ivec3 texel(x ? above.x : below.x, y ? above.y : below.y, z ? above.z : below.z);
        const float weight = (x ? fraction.x : 1 - fraction.x) * (y ? fraction.y : 1 - fraction.y) *
                             (z ? fraction.z : 1 - fraction.z);
        const std::size_t index =
            side * count_of(volume.size) +
            static_cast<std::size_t>((texel.z * volume.size.y + texel.y) * volume.size.x + texel.x);
        sum += glm::unpackHalf4x16(volume.texels[index]) * weight;
    }
    return sum;
}

// By the sides that a normal faces; alpha: how much of them is known.
vec4 sides_at(const BounceVolume& volume, const glm::vec3& voxels, const glm::vec3& normal) {
    vec4 sum(0);
    for (int axis = 0; axis < 3; ++axis) {
        const float weight = normal[axis] * normal[axis];
        const auto side = static_cast<std::size_t>(2 * axis + (normal[axis] < 0 ? 1 : 0));
        if (weight > 0.02f) sum += weight * volume_at(volume, voxels, side);
    }
    return sum;
}

} // namespace

glm::vec3 lux_on(const BounceVolumes& volumes, const glm::vec3& place_m, const glm::vec3& normal) {
    vec4 found = sides_at(volumes.surfaces, (place_m - volumes.low_m) / volumes.surfel_m, normal);
    // What no surfel stands for gets what falls on a surface in the air there.
    if (found.w < kLeastKnown) {
        const glm::vec3 before_m = place_m + normal * (0.5f * volumes.cell_m);
        found = sides_at(volumes.air, (before_m - volumes.low_m) / volumes.cell_m, normal);
    }
    return found.w < kLeastKnown ? glm::vec3(0) : glm::vec3(found) / found.w;
}

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

void fill_glow(const Bounce& bounce, const BounceAir& air, const BounceSolution& solution,
               const glm::vec3& eye_m, BounceVolumes& volumes) {
    const glm::ivec3 cells = bounce.grid.voxels(kSubsOfCell);
    std::vector<vec4> sums(count_of(cells), vec4(0));
    for (std::size_t k = 0; k < bounce.fine.cells.size(); ++k) {
        const BounceCell& cell = bounce.fine.cells[k];
        const glm::vec3 away = eye_m - cell.centre_m;
        const float distance = glm::length(away);
        // What of each bin haze turns this way is what it turns of this way into the bin.
        const std::array<float, kBounceBins> of_bins =
            air.into_bins(distance > 1e-3f ? away / distance : glm::vec3(0, 0, 1));
        vec4 glow(0);
        for (std::size_t bin = 0; bin < kBounceBins; ++bin)
            glow += solution.flux[k * kBounceBins + bin] * of_bins[bin];
        sums[cell.voxel] += vec4(glm::vec3(glow) * (cell.volume_m3 * air.scattering_per_m), cell.volume_m3);
    }
    pack(cells, sums, volumes.glow);
}

} // namespace ghost::scene
