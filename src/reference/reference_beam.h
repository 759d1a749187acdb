#pragma once
// SPDX-License-Identifier: Apache-2.0
// The light model of shaders/shared/{beam,gobos,haze,brdf}.h written a second time, in double precision and
// from the documented formulas: field profile, aperture and focus blur of each plane, gobo wheels, animation
// wheel, framing blades, split colour, figures of lasers; two-term
// Henyey-Greenstein and transmittance; metallic-roughness reflection (glTF 2.0, appendix B). Only the
// reference picture and tests call it: two definitions that agree are the proof of both. Metres, candela,
// 1/m, linear Rec.2020. Const calls from any thread; light and gobos must outlive the beam.

#include "shared/brdf.h"
#include "shared/gobos.h"
#include "shared/types.h"

#include <functional>
#include <glm/glm.hpp>

namespace ghost::bake {

// Candela towards a point in gate coordinates (along axis_u, axis_v, axis_w), metres from the apex. For tests
// against renderers whose lamps have another profile.
using BeamOverride = std::function<glm::dvec3(const glm::dvec3& gate_m)>;

// Times the haze's extinction and scattering at a place in the world.
using HazeDensity = std::function<double(const glm::dvec3& place_m)>;

class ReferenceBeam {
public:
    ReferenceBeam(const shared::Light& light, const shared::Gobos& gobos, BeamOverride instead = {});

    glm::dvec3 to_gate(const glm::dvec3& offset_m) const;
    glm::dvec3 candela(const glm::dvec3& gate_m) const;

private:
    double blur_at(double z_m, double depth) const;
    double slit(int first, const glm::dvec2& gate, double z_m) const;
    glm::dvec3 disc_colour(const glm::dvec2& gate, double blur) const;
    glm::dvec3 wheel_colour(const shared::Wheel& wheel, const glm::dvec2& gate, double blur) const;
    glm::dvec3 slide_colour(const glm::dvec2& gate, double blur) const;
    double figure_transmittance(const glm::dvec2& gate, double blur) const;
    glm::dvec3 gobo_colour(std::uint32_t layer, const glm::dvec2& gate, double blur) const;

    const shared::Light& light_;
    const shared::Gobos& gobos_;
    BeamOverride instead_;
    glm::dmat3 axes_; // rows: axis_u, axis_v, axis_w
};

class ReferenceMedium {
public:
    ReferenceMedium(const shared::Haze& haze, HazeDensity density, int path_samples);

    bool homogeneous() const { return !density_; }
    double density(const glm::dvec3& place_m) const { return density_ ? density_(place_m) : 1.0; }
    double extinction_per_m() const { return haze_.extinction_per_m; }
    double scattering_per_m() const { return haze_.scattering_per_m; }
    // 1/sr; cosine of the angle between the light's way and the scattered way.
    double phase(double cosine, double narrow = 1.0) const; // see shared::haze_phase
    // Extinction integrated from one point to another: closed where the haze is even, else path_samples
    // midpoints.
    double optical_depth(const glm::dvec3& from_m, const glm::dvec3& to_m) const;

private:
    shared::Haze haze_;
    HazeDensity density_;
    int path_samples_;
};

// f(l, v) cos(n, l); unit vectors away from the surface.
glm::dvec3 reference_brdf_times_cosine(const shared::Brdf& brdf, const glm::dvec3& n, const glm::dvec3& v,
                                       const glm::dvec3& l);

// Fraction of even light that leaves at this cosine to the normal (the fit of Karis 2014, as brdf_albedo).
glm::dvec3 reference_brdf_albedo(const shared::Brdf& brdf, double nv);

} // namespace ghost::bake
