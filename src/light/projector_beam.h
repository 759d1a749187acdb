#pragma once
// SPDX-License-Identifier: Apache-2.0
// Video projectors: any fixture whose gate holds a moving picture instead of a lamp's round field. Optical
// geometry as makers state it: throw ratio (distance over width), lens shift in fractions of the picture, the
// panel that is lit a little where it is black. What the beam then is: shaders/shared/beam.h,
// slide_transmittance. Pure. docs/design/projectors.md.

#include "fixture/state.h"
#include "shared/types.h"
#include "show/media.h"
#include "show/projector.h"

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace ghost::scene {

// Where the rays of the panel go: from the optical axis to its middle, and its slide, for a panel that is
// seen in the gate's units. Made from settings and picture alone.
struct Throw {
    glm::mat3 turn{1.0f};  // gate of the beam -> frame of the optical axis; columns: u, v, w of the beam
    float tan_field = 0;   // to the panel's farthest corner, from the beam's axis
    float solid_angle = 0; // lumens per candela of the brightest corner, at full white
    shared::Slide slide{}; // without layer and moment
};

// throw_ratio: of the settings, or what the zoom makes of it. picture: width over height.
Throw throw_of(const Projector& projector, float throw_ratio, const MediaNow& now);

// Throw ratio at which the panel's diagonal is this full angle.
float throw_ratio_for(float diagonal_deg, float aspect);

// Puts it into a beam whose fixture has set place, lens and colour; optics: of it. now: what the medium
// shows, layer: which it is. Lumens per candela of light.intensity_cd at full white.
float project(const Projector& projector, const fixture::Optics& optics, const MediaNow& now,
              std::uint32_t layer, shared::Light& light);

// Fraction of the lumens of full white that the picture of a medium makes.
glm::vec3 picture_transmittance(const Projector& projector, const MediaNow& now);

} // namespace ghost::scene
