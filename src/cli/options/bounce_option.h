#pragma once
// SPDX-License-Identifier: Apache-2.0
// --bounce, of the commands that draw a free camera or measure light.

#include "show/bounce_detail.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace ghost::app {

inline CLI::Option* add_bounce_option(CLI::App& command, std::optional<scene::BounceDetail>& detail) {
    return command
        .add_option_function<std::string>(
            "--bounce", [&detail](const std::string& name) { detail = scene::find_bounce_detail(name); },
            "light that bounces off surfaces and haze, and how finely (default: what the show says, off)")
        ->check([](const std::string& name) {
            return scene::find_bounce_detail(name) ? std::string() : scene::no_such_bounce_detail(name);
        })
        ->type_name("DETAIL");
}

} // namespace ghost::app
