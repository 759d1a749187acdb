#pragma once
// SPDX-License-Identifier: Apache-2.0
// Light that bounces, under the hand: how finely is an edit of the show, one step of the undo list; the
// making of its links is given up and begun again beside that. Error: it cannot be edited; then nothing is.
// Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

namespace ghost::ui {

// Links that were given up are made after all.
Result<void> set_bounce(AppModel& app, ShowDocument& document, scene::BounceDetail detail);
void stop_bounce(AppModel& app, bool stops);

// "links are being made, 40 %, 12 s left".
QString words_of(const BounceNow& bounce);
const char* state_name(BounceNow::State state); // "makes_links"

// "bounce normal", "cancel-bounce".
void add_bounce_actions(Actions& actions, AppModel& app, ShowDocument& document);

} // namespace ghost::ui
