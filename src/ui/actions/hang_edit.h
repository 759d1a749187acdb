#pragma once
// SPDX-License-Identifier: Apache-2.0
// Hanging the selected fixtures under a truss or a pipe of the stage (show_folder/hang.h), and a truss on two
// hoists ([[mover]] of the show); each one step of the undo list. Errors: nothing is selected, or there is no
// such truss. Window thread.

#include "show/show.h"
#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

#include <QString>

#include <string>

namespace ghost::ui {

// Beside what hangs there; where the truss goes with a mover, they do, too. object: of Opened::objects.
Result<void> hang_under(AppModel& app, ShowDocument& document, std::size_t object);
// The same under the truss nearest to them; pattern: of the objects called so, if it is not empty.
Result<void> hang(AppModel& app, ShowDocument& document, const QString& pattern);

// For a new fixture: under the truss or pipe above a place of the floor, or the nearest one, beside those of
// the others that hang there; where there is no such truss, at least at lowest_m.
glm::vec3 place_above(const std::vector<Object>& objects, const std::vector<scene::PatchedFixture>& others,
                      const scene::PatchedFixture& made, const glm::vec3& floor_m, float lowest_m);

// The mover of the truss under which a place is, by name; "": none.
std::string carrier_at(const AppModel& app, const glm::vec3& place_m);

// The truss with all its pieces and what hangs under it, on hoists a fifth from its ends, at a free address.
// object: of Opened::objects.
Result<void> fly_on_hoists(AppModel& app, ShowDocument& document, std::size_t object);

// "hang [OBJECT]", "fly-on-hoists [OBJECT]", "mover-address NAME UNIVERSE.ADDRESS [BITS]".
void add_hang_action(Actions& actions, AppModel& app, ShowDocument& document);

} // namespace ghost::ui
