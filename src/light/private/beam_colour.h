#pragma once
// SPDX-License-Identifier: Apache-2.0
// The colour of a beam in linear Rec.2020, in the order of the light's way: source (lamp, or emitters, or an
// indirect colour), correction (CTO, CTC, CTB, tint), flags, wheels. Luminance 1 is the Beam's luminous flux,
// before dimmer and shutter. Components are never negative. Formulas, defaults, sources:
// docs/design/colour.md. Pure.

#include "fixture/state.h"

#include <glm/vec3.hpp>

namespace ghost::scene {

// Of source and correction, without flags and wheels.
glm::vec3 source_colour(const fixture::Type& type, const fixture::Beam& beam, const fixture::Optics& optics);

// What all flags together let through.
glm::vec3 flags_colour(const fixture::Type& type, const fixture::Beam& beam, const fixture::Optics& optics);

// What a filter of this colour lets through; its luminance is Y / 100, unless a component would gain light.
glm::vec3 filter_colour(const fixture::Type& type, const fixture::Beam& beam, const fixture::ColorCie& color);

glm::vec3 slot_colour(const fixture::Type& type, const fixture::Beam& beam, const fixture::Slot& slot);

} // namespace ghost::scene
