#pragma once
// SPDX-License-Identifier: Apache-2.0
// A session (session.h) of a show that is no file but was made by the program. Main thread.

#include "live/session/session.h"

namespace ghost::app {

// options: show and text are not used. report: what making the show has said.
Result<std::unique_ptr<Session>> open_session(const SessionOptions& options, scene::Show show, Report report);

} // namespace ghost::app
