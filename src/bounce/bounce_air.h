#pragma once
// SPDX-License-Identifier: Apache-2.0
// What haze does to bounced light, as the solver's bins of directions see it. Light that forward haze bends
// by less than nine degrees counts as still in the beam: no bin could hold it. So extinction and scattering
// are lower than the haze's by that fraction; while light bounces, pictures weaken all light by this
// extinction. Pure.

#include "bounce/bounce.h"
#include "shared/types.h"

#include <array>

namespace ghost::scene {

inline constexpr float kStraightCosine = 0.98768834f; // nine degrees

struct BounceAir {
    float extinction_per_m = 0;
    float scattering_per_m = 0;
    float forward_fraction = 0; // of what is scattered
    // Per steradian, from light in one bin to another; each row sums to 1 over the sphere.
    std::array<std::array<float, kBounceBins>, kBounceBins> scatter{};
    // Mean phase over a bin of each kind by the cosine of a direction to its middle, -1 to 1.
    static constexpr std::size_t kCosines = 65;
    std::array<std::array<float, kCosines>, kBounceKinds> phase{};

    // Shares per steradian that light of one direction sends into each bin; they sum to 1 over the sphere.
    std::array<float, kBounceBins> into_bins(const glm::vec3& way) const;
};

BounceAir bounce_air(const shared::Haze& haze);

} // namespace ghost::scene
