#pragma once
// SPDX-License-Identifier: Apache-2.0
// Fan, align and hold: the values of several heads against each other, and against the desk. Each is one step
// of the undo list. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/fan.h"
#include "ui/model/head_values.h"

#include <optional>
#include <string>
#include <utility>

namespace ghost::ui {

// Words of ui/model/head_values.h that every head is asked for; beside them there are attributes.
inline constexpr std::array<const char*, 6> kHeadWords{"intensity", "zoom", "pan", "tilt", "gobo", "colour"};

struct FanRequest {
    std::string word;
    std::optional<std::pair<HeadValue, HeadValue>> values; // none: those of the first and of the last head
    Fan fan = Fan::line;
    HeadOrder order = HeadOrder::selection;
};
// Of the selected heads that have such a value. Error: none has, or there is nothing to begin with.
Result<void> fan_selected(AppModel& app, const FanRequest& request);

enum class AlignTo { first, last };
// All of them get the value of the first or the last one that was selected; word "all": everything that hands
// set of that one.
Result<void> align_values(AppModel& app, const std::string& word, AlignTo to);

// What comes from the desk for the selected heads becomes the hand's.
Result<void> hold_selected(AppModel& app);

// "fan pan -30 30", "fan colour #ff0000 #0000ff", "align-values last tilt", "hold".
void add_fan_actions(Actions& actions, AppModel& app);

} // namespace ghost::ui
