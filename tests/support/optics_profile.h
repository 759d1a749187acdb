#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests: beams of our own fixture with every optic (Ghostlight@Optics_Profile.gdtf).

#include "beam_groups/prism.h"
#include "fixture_files/gdtf/gdtf.h"
#include "light/frame_lights.h"
#include "light/gobos.h"
#include "shared/beam.h"
#include "show/show.h"
#include "support/must.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <string>

namespace ghost::scene {

using fixture::Optics;
using glm::vec2;
using glm::vec3;

inline std::shared_ptr<const fixture::Type> shared_type() {
    static const auto type = [] {
        return std::make_shared<const fixture::Type>(
            must(fixture::load_gdtf(std::filesystem::path("assets/fixtures/Ghostlight@Optics_Profile.gdtf")))
                .type);
    }();
    return type;
}

inline const fixture::Type& profile_type() {
    return *shared_type();
}

inline Show profile_show() {
    Show show;
    PatchedFixture fixture;
    fixture.name = "Profile";
    fixture.type = shared_type();
    show.fixtures.push_back(fixture);
    return show;
}

inline const GoboStack& gobos() {
    static const GoboStack stack = [] {
        Report report;
        return build_gobos(profile_show(), report);
    }();
    return stack;
}

inline int wheel_number(const std::string& name) {
    for (std::size_t k = 0; k < profile_type().wheels.size(); ++k)
        if (profile_type().wheels[k].name == name) return static_cast<int>(k);
    ADD_FAILURE() << name;
    return -1;
}

inline fixture::BeamState open_beam() {
    fixture::BeamState beam;
    for (std::size_t k = 0; k < profile_type().geometries.size(); ++k)
        if (profile_type().geometries[k].beam) beam.geometry = static_cast<int>(k);
    beam.optics.dimmer = 1.0f;
    beam.optics.zoom_deg = 20.0f;
    beam.optics.focus_m = 8.0f;
    return beam;
}

inline shared::Light light_of(const fixture::BeamState& beam) {
    return light_from(profile_type(), beam, glm::mat4(1.0f), gobos());
}

// Lumens, by integrating the beam over its gate at the distance from the lens where it is focused.
inline double flux_lm(const shared::Light& light, double from_lens_m, int steps = 400) {
    const double z = static_cast<double>(light.lens_m) + from_lens_m;
    const double reach = static_cast<double>(light.cut_radius), tan = static_cast<double>(light.tan_field);
    double sum = 0;
    for (int y = 0; y < steps; ++y)
        for (int x = 0; x < steps; ++x) {
            const double gx = (2.0 * (x + 0.5) / steps - 1.0) * reach,
                         gy = (2.0 * (y + 0.5) / steps - 1.0) * reach;
            const double tx = gx * tan, ty = gy * tan;
            const vec3 q(static_cast<float>(tx * z), static_cast<float>(ty * z), static_cast<float>(z));
            sum += static_cast<double>(shared::beam_candela(light, q, gobos().images).y) /
                   std::pow(1.0 + tx * tx + ty * ty, 1.5);
        }
    const double cell = 2.0 * reach * tan / steps;
    return sum * cell * cell;
}

inline double flux_lm(const fixture::BeamState& beam) {
    const shared::Light light = light_of(beam);
    double sum = 0;
    for (const Copy& copy : copies_of(profile_type(), beam.optics, kMostCopies)) {
        const shared::Light one = copied(light, copy);
        sum += flux_lm(one, 8.0, 200);
    }
    return sum;
}

} // namespace ghost::scene
