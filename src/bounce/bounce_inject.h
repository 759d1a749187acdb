#pragma once
// SPDX-License-Identifier: Apache-2.0
// Where the light of one lamp goes first: cells that its beam crosses and surfels that it lands on, by
// directions through its gate, each with the candela that shared/beam.h has there. Made at an intensity of
// one, so that a dimmer or the colour of the first filter changes nothing. Pure.

#include "bounce/bounce.h"
#include "shared/gobos.h"
#include "shared/types.h"

#include <vector>

namespace ghost::scene {

struct BounceEntries {
    struct InAir {
        std::uint32_t cell;
        glm::vec3 way;       // unit, the mean
        glm::vec3 lumen_m{}; // flux times path
    };
    struct OnSurface {
        std::uint32_t surfel;
        glm::vec3 reflected{}; // lumens
    };
    std::vector<InAir> air;
    std::vector<OnSurface> surfaces;
    glm::vec3 sent{}; // lumens
};

// sight: of the light's place. extinction_per_m: of BounceAir.
BounceEntries bounce_entries(const Bounce& bounce, const shared::Light& light, const shared::Gobos& gobos,
                             const LampSight& sight, float extinction_per_m);

} // namespace ghost::scene
