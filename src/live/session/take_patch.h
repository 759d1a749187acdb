#pragma once
// SPDX-License-Identifier: Apache-2.0
// take_patch: the quick way for an edited show to come into the picture. Engine thread.

#include "live/session/session.h"

namespace ghost::app {

// True: the two differ at most in names, addresses, cues and palettes, and the session has those of the
// edited one, with the messages of its report instead of the old ones. False: nothing was done; stage,
// shadows or pictures have to follow, so the show must be opened anew. All but the fixtures must be the same.
//
// The rig goes on from where it was.
bool take_patch(Session& session, const scene::Show& edited, const Report& report);

} // namespace ghost::app
