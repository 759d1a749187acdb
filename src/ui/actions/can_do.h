#pragma once
// SPDX-License-Identifier: Apache-2.0
// can_do: whether an action can be done now: what menus grey. Asked all the same, it says itself why not.
// Window thread.

#include "ui/model/app_model.h"
#include "ui/model/show_document.h"

#include <QString>

#include <set>

namespace ghost::ui {

// name: as the table of actions has it; one of no table needs a show.
bool can_do(const QString& name, const AppModel& app, const ShowDocument& document);

// Whether it is an edit of the show or its looks: what is refused of it is said over the picture.
bool is_edit(const std::string& name);

// All that the lists name by which the two above go; panels and languages go by their beginning.
std::set<QString> listed_actions();

} // namespace ghost::ui
