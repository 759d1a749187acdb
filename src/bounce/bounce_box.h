#pragma once
// SPDX-License-Identifier: Apache-2.0
// The room in which light bounces: what the solver cuts into cells and where its judge has haze. Pure.

#include "shared/types.h"
#include "stage/stage.h"

#include <glm/glm.hpp>
#include <vector>

namespace ghost::scene {

struct BounceBox {
    glm::vec3 low_m{0};
    glm::vec3 high_m{0}; // both 0: there is neither stage nor lamp
};

// The stage without fixture bodies and some air round the lamps; of a field without end what lies near them.
BounceBox bounce_box(const Stage& stage, const std::vector<glm::vec3>& lamps_m);
BounceBox bounce_box(const Stage& stage, const std::vector<shared::Light>& lights);

} // namespace ghost::scene
