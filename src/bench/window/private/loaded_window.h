#pragma once
// SPDX-License-Identifier: Apache-2.0
// The window under the load of a desk, for the benches: the show's recording comes by sACN at 44 Hz from a
// thread of this process, a script of actions does what a person would. Without a display it is drawn into
// memory. Main thread; errors: the show cannot be opened, has no recording, or a line of the script failed.

#include "bench/bench.h"
#include "show/bounce_detail.h"

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace ghost::app {

struct LoadedWindow {
    static constexpr int kWidth = 1280, kHeight = 760;
    static constexpr double kRate_hz = 44;

    std::string script; // lines of docs/guide/window.md; it begins with "wait opened" and ends with "quit"
    std::optional<scene::BounceDetail> bounce; // instead of the show's
    bool has_desk = true;                      // false: nothing is sent, and the show needs no recording
    std::function<void()> on_tick;             // ten times a second on the window's thread; may be empty
};

// Returns when the script's "quit" is done or the program is interrupted: whether it was drawn into memory.
Result<bool> run_loaded_window(const BenchOptions& options, const LoadedWindow& window);

// What the line "state FILE" wrote; the file goes. Error: there is none, or it is not whole yet.
Result<nlohmann::json> take_state(const std::filesystem::path& file);

// How much of the window is picture, panels and bars taken off.
double picture_share(const nlohmann::json& state);

// A number of the state; not a number where it is not there.
double state_number(const nlohmann::json& state, const char* group, const char* name);

} // namespace ghost::app
