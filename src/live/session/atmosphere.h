#pragma once
// SPDX-License-Identifier: Apache-2.0
// Atmosphere: what a frame has between lamps and camera, and the even light in it: what the show says, with
// what a look and a remote control put on top. The show stays as it was read. Pure; any thread.

#include "shared/air.h"
#include "shared/haze.h"
#include "show/looks.h"
#include "show/show.h"

#include <vector>

namespace ghost::app {

struct Atmosphere {
    scene::HazeMedium haze;
    std::vector<scene::Hazer> hazers;
    scene::Attenuation attenuation;
    glm::vec3 ambient{0}; // lux of even light, linear Rec.2020

    // What hangs in the air, where it is even.
    shared::Haze medium() const;
    bool is_uneven() const;
    // Attenuation, swirls and plumes at a moment; where it is even the same at any.
    shared::Air field(double time_s = 0) const;
};

// density: times the show's and the look's.
Atmosphere atmosphere_of(const scene::Show& show, const scene::SceneLook& look = {}, float density = 1);

} // namespace ghost::app
