#pragma once
// SPDX-License-Identifier: Apache-2.0
// Video projectors: any fixture whose gate holds a moving picture instead of a lamp's round field. Optical
// geometry as makers state it: throw ratio (distance over width), lens shift in shares of the picture, the
// panel that is lit a little where it is black. What the beam then is: shaders/shared/beam.h, slide_share.
// Pure. docs/projectors.md.

#include "fixture/state.h"
#include "scene/media.h"
#include "shared/types.h"

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace ghost::scene {

enum class Fit {
    contain, // the whole picture, black beside it
    cover,   // the whole panel, the picture's ends cut off
    stretch,
};

struct Projector {
    int media = -1;   // Show::media; -1: a test card
    float lumens = 0; // of full white; 0: as the fixture's lamp
    float throw_ratio =
        0; // distance over width of the panel's picture; 0: its diagonal fills the fixture's field
    float aspect = 16.0f / 9.0f; // of the panel
    glm::vec2 lens_shift{0.0f};  // to the right and up, in widths and heights of the panel's picture
    glm::vec2 keystone_deg{
        0.0f}; // the picture is right on a wall turned by so much, about the vertical and the horizontal
    float contrast = 2000; // white over black
    glm::vec4 blend{0.0f}; // left, right, bottom, top: share of the picture that fades out
    Fit fit = Fit::contain;
    float focus_m = 0; // where the picture is sharp; 0: as the fixture is focused
    // A DMX channel that chooses the medium: 0 leaves `media`, n is the n-th of the show.
    int universe = 0;
    int address = 0; // 1-based; 0: none
};

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

// Share of the lumens of full white that the picture of a medium makes.
glm::vec3 picture_share(const Projector& projector, const MediaNow& now);

// Turn of a fixture that shines downwards (rotation_deg of a show) so that it shines there with its picture
// upright.
glm::vec3 rotation_towards(const glm::vec3& from_m, const glm::vec3& target_m);

} // namespace ghost::scene
