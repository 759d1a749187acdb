#pragma once
// SPDX-License-Identifier: Apache-2.0
// The actions that choose the tone curve of the picture. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

namespace ghost::ui {

void add_tone_actions(Actions& actions, AppModel& app);

} // namespace ghost::ui
