#pragma once
// SPDX-License-Identifier: Apache-2.0
// The actions that edit the show: "address 2.101", "duplicate 1 0 0", "save" and so on. Window thread.

#include "ui/actions/actions.h"
#include "ui/actions/patch_edit.h"

namespace ghost::ui {

void add_patch_actions(Actions& actions, AppModel& app, ShowDocument& document);
void add_document_actions(Actions& actions, ShowDocument& document);

// "2.101" (universe.channel), "101" (of universe 1), "none".
Result<fixture::Address> address_of(const QString& words);

} // namespace ghost::ui
