#pragma once
// SPDX-License-Identifier: Apache-2.0
// Head values: what hands set of heads by one word for all of them: intensity, zoom, pan, tilt, gobo, colour,
// or an attribute of their channels ("Iris"): as it is shown, set, held. Fractions 0 to 1, degrees, slots;
// colours linear Rec.2020, largest component 1. Pure.

#include "link/link.h"

#include <optional>
#include <string>
#include <variant>

namespace ghost::scene {
struct PatchedFixture;
} // namespace ghost::scene

namespace ghost::ui {

using HeadValue = std::variant<float, glm::vec3>;

bool has_value(const scene::PatchedFixture& fixture, const std::string& word);

// Of a fixture now: what hands set, else what the desk asks for. Nothing: it has no such thing, or it is dark
// and nobody can say its colour.
class HeadReader {
public:
    // All of them must outlive it.
    HeadReader(const scene::Show& show, const Look& look, const RigNow& rig);
    std::optional<HeadValue> value(std::size_t fixture, const std::string& word) const;

private:
    const scene::Show& show_;
    const Look& look_;
    const RigNow& rig_;
    fixture::Levels levels_;
};

// As far as the fixture goes. A value of another type than the word's, or of what the fixture does not have,
// sets nothing.
void set_value(const scene::PatchedFixture& fixture, const std::string& word, const HeadValue& value,
               fixture::Programmer& programmer);
// All channels of that attribute; share nothing: given back. What was asked for last wins: a value that
// stands above those channels (fixture/programmer.h) is given back.
void set_parameter(const scene::PatchedFixture& fixture, const std::string& attribute,
                   std::optional<float> share, fixture::Programmer& programmer);

// What comes from the desk for each channel, or what levels by hand have there, becomes the hand's as single
// channels; what a hand has stays.
void hold(const scene::PatchedFixture& fixture, const fixture::Levels& levels,
          fixture::Programmer& programmer);
// Its levels by hand, where it has any, as single channels.
fixture::Programmer in_channels(const scene::PatchedFixture& fixture, fixture::Programmer programmer);
// Whether hands have channels of that role, and giving these back.
bool holds(const scene::PatchedFixture& fixture, fixture::Role role, const fixture::Programmer& programmer);
void give_back(const scene::PatchedFixture& fixture, fixture::Role role, fixture::Programmer& programmer);

fixture::Levels levels_of(const dmx::Universes& universes);

} // namespace ghost::ui
