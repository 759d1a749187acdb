#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixtureValues: what a fixture does at a moment, as a crew reads it: light, colour, gobo, zoom. From its
// decoded state, not from DMX, so two desks or two modes that make the same light are equal. Percent,
// degrees, hertz. Pure, any thread.

#include "fixture/programmer.h"
#include "fixture/state.h"
#include "print/print_style.h"

#include <array>
#include <optional>
#include <string>

namespace ghost::scene {

struct FixtureValues {
    float light_percent = 0; // of its full; colour apart. The mean of its beams
    float zoom_deg = 0;      // full field angle
    float iris_percent = 100;
    float frost_percent = 0;
    float blades_percent = 0;               // the one that is farthest in
    std::array<fixture::Blade, 4> blades{}; // each of them, and all together:
    float shaper_deg = 0;
    float focus_percent = 50; // 0 near, 100 far
    float strobe_hz = 0;
    float gobo_deg = 0; // turn of the picture, of all its gobos together; 0 where one of them turns by itself
    float gobo_deg_s = 0;
    float effects_deg = 0; // the same of prisms and animation discs that are in
    float effects_deg_s = 0;
    float tint_percent = 0; // -100 magenta .. 100 green
    std::optional<fixture::LaserCurve> figure;
    float pan_deg = 0;
    float tilt_deg = 0;
    std::string colour = "open";
    std::string gobo = "open";
    std::string effects = "open"; // prisms and animation discs
    std::string cells;            // of more than one beam: what each of them does

    // Seen by nobody, whatever else it does.
    bool is_dark() const { return light_percent < 1.0f; }
};

// programmer: of the fixture, for what hands put before the light (gel, another lamp), or null.
FixtureValues values_of(const fixture::Type& type, const fixture::State& state,
                        const fixture::Programmer* programmer = nullptr, const PrintStyle& style = {});

// A slot of a wheel that leaves the light as it is.
bool is_open(const fixture::Slot& slot);

// Of a filter: "#ff8000", as bright as that colour can be.
std::string colour_text(const fixture::ColorCie& colour);

// Lumens of all its beams at full, as the file says them; 0: it has none.
float full_lm(const fixture::Type& type, const fixture::Mode& mode);

} // namespace ghost::scene
