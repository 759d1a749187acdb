#pragma once
// SPDX-License-Identifier: Apache-2.0
// BeamGroups: how the beams of a multi-cell fixture (bar, matrix, stick of lasers) become lights and distance
// maps. Cells too near to one another to be told apart are one light; beams that only glow are none; lights
// near one another share a distance map. Decided by the type alone, never by what the desk sends, so that
// the number of lights stays. Metres, in the frame of the fixture. Pure. docs/design/multi-cell.md.

#include "fixture/type.h"

#include <glm/vec3.hpp>
#include <vector>

namespace ghost::scene {

// Cells are one light where each is nearer to the middle of them than this fraction of the radius that one
// beam has at this distance, at its narrowest zoom (radius: to half the peak).
inline constexpr float kMergeShare = 0.5f;
inline constexpr float kMergeDistance_m = 5.0f;
// And point the same way, within this fraction of half the beam angle.
inline constexpr float kMergeTurn = 0.25f;
// Lights share a distance map made so far away from them at most.
inline constexpr float kMapShare_m = 0.25f;

struct BeamGroup {
    std::vector<int> beams;     // Mode::beams: its cells, in their order; never empty
    std::vector<float> weights; // of each cell: fraction of the lumens of all, which add up to 1
    int place = 0;              // BeamGroups::places_m
    int copies = 1;             // lights that its prisms (prism.h) or its scanner (laser.h) may need
};

struct BeamGroups {
    std::vector<BeamGroup> lights;   // by their first beams
    std::vector<glm::vec3> places_m; // where distance maps are made; none where all beams only glow
    glm::vec3 middle_m{0.0f};        // of the places, or of the fixture's light: where passes are made
};

// BeamType None and Glow: no beam, the geometry itself is seen to glow.
bool only_glows(const fixture::Beam& beam);

// Channels of this beam (Mode::beams) choose figures.
bool draws_figures(const fixture::Mode& mode, int beam);

// is_laser: a scanner splits each light, whatever the type's channels say.
BeamGroups beam_groups_of(const fixture::Type& type, const fixture::Mode& mode, bool is_laser = false);

// The light that beam (index into Mode::beams) is part of, or -1.
int beam_group_of(const BeamGroups& emitters, int beam);

} // namespace ghost::scene
