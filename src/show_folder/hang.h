#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hang: where fixtures hang under a truss or a pipe. A truss of several pieces in a row counts as one; what
// lies level is one, what stands is none. Metres of the show. Pure.

#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace ghost::scene {

// The middle line of an object's underside, along it. From left to right as the house sees it; what runs
// up-stage begins down-stage.
struct Bar {
    glm::vec3 from_m{0};
    glm::vec3 to_m{0};
    float across_m = 0;    // the wider of its two sides
    float height_m = 0.1f; // from its underside to its top
    float bow_m = 0;       // of one that is bent in plan: its middle from its ends, to the left of its way

    float length_m() const { return glm::distance(from_m, to_m); }
    // at: 0 where it begins, 1 where it ends.
    glm::vec3 place_m(float at) const;
    bool operator==(const Bar&) const = default;
};

// Of the corners of a mesh. Nothing: it stands upright rather than lies, or it has no length.
std::optional<Bar> bar_of(std::span<const glm::vec3> positions, const glm::mat4& world);

// Slender enough for a truss or a pipe; a wall, a curtain or a floor is not, nor a tape on it.
bool is_slender(const Bar& bar);

// The piece with all those that go on where it ends. taken: which they are, one for each.
Bar joined(const Bar& piece, std::span<const Bar> all, std::vector<bool>& taken);
Bar joined(const Bar& piece, std::span<const Bar> all);

// How far a place is from the middle line of a bar, where what is there hangs under it or is clamped to it;
// nothing: it does not.
std::optional<float> hangs_away_m(const Bar& bar, const glm::vec3& place_m);

// Of slender ones, those first that are no lower than it; nothing: there is none.
std::optional<std::size_t> nearest_bar(std::span<const Bar> all, const glm::vec3& to_m);

// One goes to the place nearest to where it is; several spread evenly, each in the middle of its share.
std::vector<glm::vec3> places_under(const Bar& bar, std::span<const glm::vec3> are_m);

// What hangs under a bar, or shall: where it is, and how much of the bar's length it takes.
struct BarLoad {
    glm::vec3 place_m{0};
    float width_m = 0;
};
// As places_under, beside what hangs there: several spread over what is free of the bar. Nothing: there is no
// room beside the others.
std::optional<std::vector<glm::vec3>> places_beside(const Bar& bar, std::span<const BarLoad> shall,
                                                    std::span<const BarLoad> there);

} // namespace ghost::scene
