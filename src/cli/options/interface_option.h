#pragma once
// SPDX-License-Identifier: Apache-2.0
// --interface: which network card, the same for every command. An empty one, as of an unset variable of a
// shell, is refused: it would mean all of them.

#include <CLI/CLI.hpp>
#include <string>

namespace ghost::app {

inline CLI::Option*
add_interface_option(CLI::App& command, std::string& interface,
                     const std::string& what = "network interface, by name or by its IPv4 "
                                               "address; default: all") {
    return command.add_option("--interface", interface, what)
        ->check(
            [](const std::string& name) {
                return name.empty() ? "empty, expected the name of a network interface or its IPv4 address"
                                    : std::string();
            },
            "");
}

} // namespace ghost::app
