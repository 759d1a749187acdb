#pragma once
// SPDX-License-Identifier: Apache-2.0
// Look: all that a person changed by hand about how the show looks now, beside DMX and beside the show file:
// fixtures, air, even light, objects, surfaces. An empty look is the show as it is. Values that can be
// compared, so one undo step is the look before. Units as in the show; colours linear Rec.2020.

#include "fixture/programmer.h"
#include "show/looks.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace ghost::ui {

using scene::SceneLook;

inline constexpr int kHazeSamples = 24; // where no hand says how many

// Instead of what the model says of a material.
struct SurfaceLook {
    std::optional<glm::vec3> colour;
    std::optional<float> specular; // 0: none .. 1: as glass or lacquer
    std::optional<float> roughness;

    bool is_empty() const { return *this == SurfaceLook{}; }
    bool operator==(const SurfaceLook&) const = default;
};

struct Look {
    std::map<std::size_t, fixture::Programmer> fixtures; // by index of the show; no empty ones
    SceneLook scene;
    std::map<std::size_t, bool> shown;                // by Object::instance
    std::map<std::size_t, SurfaceLook> surfaces;      // by index of the material; no empty ones
    std::set<std::size_t> solo;                       // these fixtures alone shine; empty: all do
    std::optional<int> haze_samples;                  // along a ray through one beam
    std::map<std::size_t, std::vector<float>> movers; // by index of the show: values of all their axes

    bool is_empty() const { return *this == Look{}; }
    bool operator==(const Look&) const = default;
};

} // namespace ghost::ui
