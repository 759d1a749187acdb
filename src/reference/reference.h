#pragma once
// SPDX-License-Identifier: Apache-2.0
// The reference picture: the light of beams on surfaces and in haze (single scattering) by brute force and in
// double precision, against which every fast integrator is judged. It shares the tracer's first hits and
// shadow rays with the baker, and nothing with the live renderer (reference_beam.h). Each camera ray takes
// air_samples midpoints per light in the equi-angular variable (Kulla and Fajardo 2012), over all of it that
// lies before the lens, each with its own shadow ray: no cone, no table, no noise. cd/m^2, linear Rec.2020.
// The same input gives the same bytes on any number of threads.

#include "base/result.h"
#include "image/image.h"
#include "rays/tracer.h"
#include "reference/reference_beam.h"
#include "shared/attenuation.h"
#include "show/camera.h"

#include <functional>
#include <vector>

namespace ghost::bake {

struct ReferenceOptions {
    int air_samples = 4096;
    int pixel_samples = 1; // positions per axis under a box of one pixel; 1: the pixel's centre
    int lens_samples =
        1;           // more: shadows of a disc of Light::disc_radius_m about the light instead of a point
    int every = 1;   // only each n-th pixel across and down; the picture is that much smaller
    int threads = 0; // 0: one per core
    bool surfaces = true; // light on surfaces; without it they still end the rays
    bool air = true;
    bool shadows = true;
    float far_m = 60.0f;                           // of a ray that meets no surface: View::far_m
    shared::Attenuation attenuation{0, 0, 1};      // taste; this is physics
    HazeDensity density;                           // none: even haze
    int density_samples = 64;                      // on the way from the light, where the haze is not even
    BeamOverride beam;                             // candela of every light, for tests
    std::function<bool()> stop;                    // asked from any thread
    std::function<void(double fraction)> progress; // never two calls at once
};

// Picture of a stage under lights, camera and haze, 3 channels. tracer null: no geometry. Errors: options out
// of range, stopped, pixels that are not finite (their number and the first one).
Result<image::ImageF> reference_picture(const Tracer* tracer, const scene::Camera& camera,
                                        const std::vector<shared::Light>& lights, const shared::Gobos& gobos,
                                        const shared::Haze& haze, float ambient_lux,
                                        const ReferenceOptions& options);

} // namespace ghost::bake
