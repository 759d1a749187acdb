#pragma once
// SPDX-License-Identifier: Apache-2.0
// --tone of the commands that draw for people's eyes. Main thread.

#include "image/tone.h"

#include <CLI/CLI.hpp>

namespace ghost::app {

// tone must outlive command.
inline CLI::Option* add_tone_option(CLI::App& command, image::Tone& tone) {
    return command
        .add_option_function<std::string>(
            "--tone", [&tone](const std::string& name) { tone = *image::tone_from(name); },
            "tone curve: agx (film: bright colours go to white), aces (more contrast and saturation) or "
            "linear (none: what is too bright is clipped)")
        ->check([](const std::string& name) {
            const auto known = image::tone_from(name);
            return known.ok() ? std::string() : known.error().text();
        })
        ->type_name("CURVE")
        ->default_str(image::name_of(tone));
}

} // namespace ghost::app
