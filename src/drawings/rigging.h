#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a drawing shows of a rig: how large each fixture is, how it looks from the side, and on which trusses
// and pipes they hang, by name. World metres. Pure; any thread.

#include "drawings/symbols.h"
#include "drawings/view.h"
#include "show_folder/hang.h"
#include "stage/stage.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

inline constexpr double kAssumedSize_m = 0.35; // of a body that nobody describes

struct RiggedFixture {
    std::size_t fixture = 0; // of the show
    SymbolKind kind = SymbolKind::other;
    glm::dvec2 size_m{kAssumedSize_m}; // along its own X and Y, with its head straight
    bool is_size_known = false;
    glm::mat4 to_world{1.0f};
    std::string position; // as the plot calls it, or ""
    std::string unit;
};

// A truss or pipe with fixtures on it.
struct HungBar {
    Bar bar;
    std::string name; // of the hanging position, else of the object
};

// stage: with the bodies (light/bodies.h).
std::vector<RiggedFixture> rigged_fixtures(const Show& show, const Stage& stage);
std::vector<HungBar> hung_bars(const Show& show, const Stage& stage,
                               const std::vector<RiggedFixture>& fixtures);
// Instances that are slender enough for a truss or a pipe, by index.
std::vector<bool> slender_instances(const Stage& stage);
// The bodies of each fixture as they are seen, a convex polygon for each part.
std::vector<std::vector<std::vector<glm::dvec2>>> bodies_seen(const Show& show, const Stage& stage,
                                                              const View& view);

} // namespace ghost::scene
