#pragma once
// SPDX-License-Identifier: Apache-2.0
// The window, as the command open starts it. All of Qt stays behind this header. Main thread.

#include "base/result.h"
#include "link/link.h"

#include <functional>
#include <memory>
#include <string>

namespace ghost::web {
class Browsers;
} // namespace ghost::web

namespace ghost::ui {

struct WindowOptions {
    std::string show;      // empty: the window waits for one
    std::string demo;      // folder of the show that comes with the program; empty: it is not there
    std::string docs;      // folder of the guide; empty: it is not there
    std::string fixtures;  // folder of fixture files that come with the program, or empty
    std::string script;    // file with lines of actions, run when the show is open; empty: none
    std::string socket;    // name of a local socket that takes the same lines; empty: none
    std::string language;  // one of kLanguages, like "de"; empty: as it was chosen, else the desktop's
    bool remembers = true; // layout from the last time, and for the next
    int width = 0;         // of the window; 0: as it was, or what fits the screen
    int height = 0;
    bool full_screen = false;
    bool draws_into_memory = false;    // nobody sees it; for measurements without a display
    bool takes_desk = true;            // false: nothing listens to a desk, and the window does not promise it
    RdmAccess rdm = RdmAccess::off;    // whether desks find the fixtures from the beginning
    web::Browsers* browsers = nullptr; // that the window switches on and off; null: it cannot
    // Starts what fills the link; what it returns is destroyed before the window is.
    std::function<std::shared_ptr<void>()> begin;
    std::function<bool()> should_close; // asked a few times a second
};

bool has_display();

// Returns when the window was closed. Error: there is no display, or the script failed.
Result<void> open_window(Link& link, const WindowOptions& options);

} // namespace ghost::ui
