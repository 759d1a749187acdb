#pragma once
// SPDX-License-Identifier: Apache-2.0
// "look-store Verse", "look-recall Verse 3", "solo", "gel #4060ff", "lamp 2 3200" and so on. Window thread.

#include "ui/actions/programmer_actions.h"
#include "ui/model/looks.h"

namespace ghost::ui {

void add_look_actions(Actions& actions, AppModel& app, Looks& looks);

} // namespace ghost::ui
