#pragma once
// SPDX-License-Identifier: Apache-2.0
// The gate of a beam: gobo wheels, animation wheel, iris and framing blades, each in its own plane, as
// shaders/shared/beam.h draws them. No file says where the planes stand: the depths are ours. Pure.
// docs/design/optics.md.

#include "fixture/state.h"
#include "fixture/type.h"
#include "light/gobos.h"
#include "shared/types.h"

#include <array>

namespace ghost::scene {

// Depths of the planes (shared::Light::focus_per_m): from the lamp to the lens.
inline constexpr float kDiscDepth = -0.02f;
inline constexpr std::array<float, 3> kGoboDepth{0.0f, 0.02f, 0.04f};
inline constexpr float kIrisDepth = 0.05f;
inline constexpr std::array<float, 4> kBladeDepth{0.07f, 0.075f, 0.08f, 0.085f};

// Of an iris, gate radii: one that is wider cuts nothing, none is narrower.
inline constexpr float kOpenIris = 0.995f;
inline constexpr float kLeastIris = 0.02f;

// The two slots of a wheel that share the gate.
struct SlotPair {
    const fixture::Slot* a = nullptr;
    const fixture::Slot* b = nullptr;
    float shift = 0; // 0 = a centred .. 1 = b centred
};
SlotPair slots_at(const fixture::Type& type, const fixture::WheelState& state);

// The half plane that a blade of the four (0 top, 1 right, 2 bottom, 3 left) covers, in gate radii; all_deg:
// of the whole assembly. A blade that is out covers nothing.
shared::Blade blade_plane(const fixture::Blade& blade, int which, float all_deg);

// Where light that a frost has scattered came from: of a gate radius, 0..1. Exact for a field that is a
// Gaussian: what is seen at g was let through about g x pull. sigma: see frosted (photometry.h); width:
// standard deviation of the field.
float frost_pull(float sigma, float width);

// Wheels, disc, blades and the depths of a light whose lens and focus are set.
void set_gate(const fixture::Type& type, const fixture::Optics& optics, const GoboStack& gobos, float pull,
              shared::Light& light);

// Fraction of the light of an open gate that passes, about: of bounced light.
glm::vec3 gate_transmittance(const shared::Light& light, const shared::Gobos& gobos);

} // namespace ghost::scene
