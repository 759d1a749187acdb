#pragma once
// SPDX-License-Identifier: Apache-2.0
// FrostFlux: frost scatters what the gate lets through, and nothing is lost. The beam blurs each plane of the
// gate and the field by itself (shaders/shared/beam.h), and their product carries more or less light than the
// gate let through where they hang together: a blade that covers the middle, a gobo under an iris. So both
// are measured, and the frosted beam gets the lumens of the clear one. docs/design/optics.md. One thread.

#include "shared/gobos.h"
#include "shared/types.h"

#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <string>

namespace ghost::scene {

// Lumens of a light: red, green and blue, as far as its candela are. The planes are blurred as they are at
// this distance from the apex. points: of the gate that are looked at.
glm::vec3 flux_through(const shared::Light& light, const shared::Gobos& gobos, float at_m, int points);

class FrostFlux {
public:
    // By what the frosted light is to be multiplied; clear() makes the one without frost, where it is needed.
    // A gate is measured once, which takes a millisecond; so is a picture that turns, in each of 256 places.
    glm::vec3 correction(const std::function<shared::Light()>& clear, const shared::Light& frosted,
                         const shared::Gobos& gobos, float at_m);
    // Forgets gates that were on their way, before there are too many.
    void trim();

private:
    std::map<std::string, glm::vec3> found_;
};

} // namespace ghost::scene
