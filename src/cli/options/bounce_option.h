#pragma once
// SPDX-License-Identifier: Apache-2.0
// --bounce, of the commands that draw a free camera.

#include "bounce/bounce_detail.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <string>

namespace ghost::app {

inline CLI::Option* add_bounce_option(CLI::App& command, scene::BounceDetail& detail) {
    return command
        .add_option_function<std::string>(
            "--bounce",
            [&detail](const std::string& name) {
                const auto* const found =
                    std::find(std::begin(scene::kBounceDetails), std::end(scene::kBounceDetails), name);
                detail = static_cast<scene::BounceDetail>(found - std::begin(scene::kBounceDetails));
            },
            "light that bounces off surfaces and haze, and how finely (default: off)")
        ->check(CLI::IsMember({"off", "room", "normal", "fine"}))
        ->type_name("DETAIL");
}

} // namespace ghost::app
