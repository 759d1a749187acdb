#pragma once
// SPDX-License-Identifier: Apache-2.0
// "false-colour lux 1 5000", "probe 300 200" and so on. Window thread.

#include "ui/actions/actions.h"
#include "ui/picture/view.h"

namespace ghost::ui {

void add_meter_actions(Actions& actions, AppModel& app, View& view);

} // namespace ghost::ui
