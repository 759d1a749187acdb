#pragma once
// SPDX-License-Identifier: Apache-2.0
// --units and --language of what is printed.

#include "print/print_style.h"

#include <CLI/CLI.hpp>
#include <string>

namespace ghost::app {

struct PrintOptions {
    std::string units = "metric";
    std::string language = "en";

    scene::PrintStyle style() const {
        return {language == "de" ? scene::Language::german : scene::Language::english,
                units == "imperial" ? scene::Units::imperial : scene::Units::metric};
    }
};

// options: alive as long as the command.
inline void add_print_options(CLI::App& command, PrintOptions& options) {
    command.add_option("--units", options.units, "metric, or imperial: feet and inches, pounds")
        ->check(CLI::IsMember({"metric", "imperial"}))
        ->capture_default_str();
    command.add_option("--language", options.language, "of what is printed: en or de")
        ->check(CLI::IsMember({"en", "de"}))
        ->capture_default_str();
}

} // namespace ghost::app
