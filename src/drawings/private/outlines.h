#pragma once
// SPDX-License-Identifier: Apache-2.0
// Outlines: what a stage's objects look like as lines: silhouettes, sharp edges, borders. Nothing hides
// anything. An object with more lines than a sheet takes is its outermost line (convex). Metres of the view.
// Pure; any thread.

#include "drawings/private/view.h"
#include "stage/stage.h"

#include <cstddef>
#include <vector>

namespace ghost::scene {

struct Outline {
    std::size_t instance = 0;       // Stage::instances
    std::vector<glm::dvec2> ends_m; // every two are a line
    Extent2 extent;
};

struct Outlines {
    std::vector<Outline> objects;
    std::size_t simplified = 0; // of them
    std::size_t left_out = 0;   // there are too many
};

// Of all that is shown and is no part of a fixture. finest_m: shorter lines are left out.
Outlines outlines_of(const Stage& stage, const View& view, double finest_m);

// The outermost line, anticlockwise; fewer than 3 points where it has no area.
std::vector<glm::dvec2> hull_of(std::vector<glm::dvec2> points);

} // namespace ghost::scene
