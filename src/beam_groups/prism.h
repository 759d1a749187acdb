#pragma once
// SPDX-License-Identifier: Apache-2.0
// Prisms: the pictures that the prisms in a beam make of it. Each is a light of its own, turned aside, with
// its fraction of the flux; all have the gobos, the profile and the distance map of the beam. Facets are
// GDTF's (table 28), in gate radii. A wedge turns light aside and does not turn the picture, so a facet's
// rotation is left out; a facet that stretches the picture is drawn as a row of pictures. Pure.
// docs/design/optics.md.

#include "base/report.h"
#include "fixture/state.h"
#include "fixture/type.h"
#include "shared/types.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

// More pictures of one beam than this are joined with their neighbours: as much light, in larger patches.
inline constexpr int kMostCopies = 32;

struct Copy {
    glm::vec2 aside{0.0f}; // of its middle, gate radii
    float scale = 1.0f;
    glm::vec3 fraction{1.0f}; // of the light: they add up to 1, where no facet is tinted
};

// The facets of a slot, and those that a slot without any gets by its name ("6F linear"; else three in a
// ring).
std::vector<Copy> facets_of(const fixture::Slot& slot);

// What the prisms of a beam make of it now, at most `most`: one picture in the middle where none is in. A
// prism that is on its way splits a part of the light.
std::vector<Copy> copies_of(const fixture::Type& type, const fixture::Optics& optics, int most);

// As many as copies_of will ever give for a beam (Mode::beams), 1 .. kMostCopies.
int most_copies(const fixture::Type& type, const fixture::Mode& mode, int beam);

// That picture of a beam.
shared::Light copied(const shared::Light& light, const Copy& copy);

// Prisms that are drawn with fewer pictures than they make. file: for messages.
void check_prisms(const fixture::Type& type, const std::string& file, Report& report);
void check_prisms(const Show& show, Report& report);

} // namespace ghost::scene
