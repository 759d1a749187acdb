#pragma once
// SPDX-License-Identifier: Apache-2.0
// How large a beam is in a picture along its way, and the levels of a shaped beam's table, which are places
// of that way (shaders/shared/fan.h). Pure.

#include "shared/fan.h"
#include "shared/types.h"

namespace ghost::render {

enum class FanDetail {
    fine,  // rows closer than pixels: what one ray through the middle of each meets
    plain, // about as many rows as pixels, half as many columns, gobos at the nearest level of blur
};

inline float rows_per_pixel(FanDetail detail) {
    return detail == FanDetail::fine ? 2.0f : 1.25f;
}

// A beam as one eye sees it.
struct BeamExtent {
    double eye_m = 0; // from the beam's apex
    double cosine =
        0; // between the way from the eye to the apex and what of the beam comes nearest to the eye
    double reach_m = 0;     // along the beam, from the apex: nothing of it is seen beyond
    float pixels = 0;       // width of the beam where it is as far from its apex as from the eye
    bool surrounds = false; // the eye is in the beam, or in the one that shines the opposite way

    // Width of the beam so far from its apex. Nearer to the eye than to the apex no more is counted.
    float pixels_at(double along_m) const;
    // Of its widest part.
    float widest_pixels() const { return pixels_at(reach_m); }
};

// tangent: of the beam's rim.
BeamExtent extent_of(const shared::Planes& beam, double tangent, float pixels_per_rad, float reach_m,
                     bool surrounds);

// Sets levels, node, place and plain of a shaped beam; its size (the most rows) must be known.
void set_nodes(shared::Fan& fan, const shared::Light& light, const BeamExtent& extent, FanDetail detail);

} // namespace ghost::render
