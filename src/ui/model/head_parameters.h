#pragma once
// SPDX-License-Identifier: Apache-2.0
// Head parameters: what else hands can do with heads than intensity, colour, zoom, pan and tilt: one for each
// attribute of their channels, in groups and words of the field. Pure.

#include "link/look.h"

#include <QString>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ghost::scene {
struct Show;
struct PatchedFixture;
} // namespace ghost::scene

namespace ghost::ui {

// A stretch of a channel that means one thing: a gobo, "Closed", a strobe from slow to fast.
struct ParameterRange {
    QString name;
    float from = 0; // shares of the channel's range
    float to = 0;
    int wheel = -1; // of HeadParameter::type, with what is seen there; -1: none
    int slot = -1;
};

struct HeadParameter {
    std::string attribute; // as GDTF has it: "Prism1"
    QString group;         // "Gobo"
    QString name;          // "Gobo wheel 2"
    std::vector<ParameterRange> ranges;
    std::shared_ptr<const fixture::Type> type; // whose ranges these are
};

// Of the selected fixtures that have a type: each attribute once, by groups. ranges are those of the first
// that has it.
std::vector<HeadParameter> parameters_of(const scene::Show& show, const std::set<std::size_t>& selection);

// Share of its range that an attribute gets, by hand or from these levels, and whether by hand: what stands
// above channels (a colour, a gobo, an intensity that opens the shutter) as those channels would have it.
struct ParameterValue {
    float share = 0;
    bool by_hand = false;
    QString words;            // what it means: "Leaves", "Strobe 3.2 Hz"
    bool is_of_other = false; // by hand with another value alone: a shutter that an intensity opens
};
// In the order of the parameters; nothing: the fixture does not have it.
std::vector<std::optional<ParameterValue>> values_of(const scene::PatchedFixture& fixture,
                                                     const fixture::Programmer& programmer,
                                                     const fixture::Levels& levels,
                                                     const std::vector<HeadParameter>& parameters);

// What a value that stands above its channels (fixture/programmer.h) would have this one at; nothing: none
// does, or no place of it means that. gobo_wheel: gobo_wheel_of.
std::optional<float> share_by_value(const fixture::Programmer& programmer, const fixture::Channel& channel,
                                    int gobo_wheel);

// Type::wheels: the one whose slots fixture::gobo_names() lists; -1: there is none.
int gobo_wheel_of(const scene::PatchedFixture& fixture);

// What people call an attribute: "ColorSub_C" is cyan.
QString attribute_words(const std::string& attribute);

// What a channel is called by, what the first of its functions that a picture shows does, and its group.
std::string attribute_of(const fixture::Channel& channel);
fixture::Role role_of(const fixture::Channel& channel);
QString group_of(const fixture::Channel& channel);

} // namespace ghost::ui
