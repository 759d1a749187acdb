#pragma once
// SPDX-License-Identifier: Apache-2.0
// Photometry: from what a data sheet says (lumens, beam and field angle) to the profile and the peak
// intensity that shaders/shared/beam.h uses. Beam angle: 50 % of the peak, field angle: 10 % (IES/CIE): I(r)
// = I0 exp2(-scale r^(2 power)) in gate radii r = tan / tan(field / 2). Pure.

#include "photometry/frost_flux.h"
#include "shared/types.h"

#include <array>
#include <map>

namespace ghost::scene {

struct Profile {
    float tan_field = 0;
    float power = 1;
    float scale = 1;
    float aperture = 1;   // gate radius of the open aperture
    float edge = 0.01f;   // its softness
    float cut_radius = 1; // nothing beyond
};

// Full angles in degrees, clamped to 0.1..170; a field below the beam angle is taken as equal. hard_edge:
// spots and profiles, whose field stop cuts the light at the field angle; otherwise it fades out softly.
Profile make_profile(float beam_angle_deg, float field_angle_deg, bool hard_edge);

// What a frost makes of it, which scatters light by angles of this standard deviation (gate units): wider,
// softer, and blurred alike in all planes of the gate. aperture: gate radius that the iris leaves open. Exact
// for a profile that is a Gaussian; its solid angle says by how much it is dimmer.
Profile frosted(const Profile& profile, float aperture, float sigma);

// A data sheet's angles are those of a picture on a wall, seen from the lens; the light comes from all over
// the lens and widens less. That wall is this far away, where nothing else is said.
inline constexpr float kMeasured_m = 10.0f;

struct Spread {
    float beam_deg = 0;
    float field_deg = 0;
};

// Full angles by which a beam widens that leaves a lens of this radius and has the data sheet's angles
// kMeasured_m before it; a third of the tangents at least: a lens may be wider than the picture.
// By what tangents of a beam that would be so wide from the lens become those from its apex: at least a
// third.
float lens_fraction(float tangent, float lens_radius_m);
Spread spread_of(float beam_deg, float field_deg, float lens_radius_m);

// What a meter kMeasured_m before the lens has a light's candela for, which are from its apex.
float measured_fraction(const shared::Light& light);

// Candela on the axis of an open beam of this profile that carries flux_lm.
float peak_candela(const Profile& profile, float flux_lm);

// Light::rim_fraction for an aperture of this radius.
float rim_fraction(const Profile& profile, float aperture);

// Solid angle (steradian) that a beam would fill at its peak intensity: lumens per candela on the axis.
// aperture: gate radius that the iris leaves open, profile.aperture where there is none.
float beam_solid_angle(const Profile& profile, float aperture);

// A profile and its solid angles. Finding them takes a thousand powers, and the cells of a bar and most heads
// of a rig are alike: a table gives the same numbers, each found once.
struct MeasuredProfile {
    Profile profile;
    float open_sr = 0;  // beam_solid_angle, without iris and frost
    float iris_sr = 0;  // behind the iris
    float sent_sr = 0;  // of the profile, behind iris and frost
    float aperture = 1; // gate radius that is left open
};

// Of a surface that is equally bright from every side (Lambert): within 7 % of the cosine up to 70 degrees,
// its light all within 82.
const MeasuredProfile& area_profile();

class ProfileTable {
public:
    // iris: fraction of the open aperture; frost_deg: standard deviation of the angle of its scatter.
    const MeasuredProfile& find(float beam_angle_deg, float field_angle_deg, bool hard_edge, float iris,
                                float frost_deg = 0.0f);

    // Forgets zooms and gates that were on their way, before there are too many. No reference outlives it.
    void trim();
    FrostFlux frost;

private:
    std::map<std::array<float, 5>, MeasuredProfile> found_;
};

} // namespace ghost::scene
