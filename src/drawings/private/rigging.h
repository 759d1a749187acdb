#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a drawing shows of a rig: how large each fixture is, how it looks from the side, and on which trusses
// and pipes they hang, by name. World metres. Pure; any thread.

#include "drawings/private/symbols.h"
#include "drawings/private/view.h"
#include "fixture/state.h"
#include "show_folder/hang.h"
#include "stage/stage.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;
struct PatchedFixture;

inline constexpr std::size_t kMostBars = 4'000; // pieces that are joined, those with fixtures first
inline constexpr double kAssumedSize_m = 0.35;  // of a body that nobody describes

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

struct Rigging {
    std::vector<RiggedFixture> fixtures; // of the show that have a place, in its order
    std::vector<HungBar> bars;
    std::vector<bool> are_slender;   // instances of the stage that are a truss or a pipe
    std::size_t pieces_left_out = 0; // of trusses and pipes: there are more than kMostBars
};

// stage: with the bodies (light/bodies.h).
Rigging rigging_of(const Show& show, const Stage& stage);
// Parts of a fixture whose axes all stand at 0. Its type has a mode.
std::vector<fixture::PartState> straight_parts(const PatchedFixture& fixture);
// The bodies of each fixture as they are seen, a convex polygon for each part; of a wall its panel.
std::vector<std::vector<std::vector<glm::dvec2>>> bodies_seen(const Show& show, const Stage& stage,
                                                              const View& view);

} // namespace ghost::scene
