#pragma once
// SPDX-License-Identifier: Apache-2.0
// Set pieces: which object of the stage is chosen, and where it stands, written as an [[object]] of the show,
// one step of the undo list. Errors: there is no such object, or others elsewhere are called the same, for a
// show knows objects by name; those at the same place are parts of it and go along. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

#include <QString>

namespace ghost::ui {

// Of Opened::objects; without a name, the chosen one.
Result<std::size_t> object_called(const AppModel& app, const QString& name);

// object: of Opened::objects.
Result<void> move_object(AppModel& app, ShowDocument& document, std::size_t object, const glm::vec3& by_m);

// "choose-object [OBJECT]", "move-object X Y Z [OBJECT]", and a key for each way on the floor.
void add_object_actions(Actions& actions, AppModel& app, ShowDocument& document);

} // namespace ghost::ui
