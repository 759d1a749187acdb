#pragma once
// SPDX-License-Identifier: Apache-2.0
// Options of commands that browsers may look on at, and how these are told where. What the options fill must
// outlive the command. Main thread.

#include "base/result.h"
#include "web/server.h"

#include <CLI/CLI.hpp>
#include <string>

namespace ghost::app {

struct WebOptions {
    std::string web; // "8010", "0.0.0.0:8010"; empty: nothing listens
    std::string host;
    double mbit = 60;
    std::string book; // folder of a cue book, or empty
    bool control = false;
};

// --web, --host, --web-mbit, --book and --control.
CLI::Option* add_web_options(CLI::App& command, WebOptions& options);
Result<web::ServerOptions> server_options(const WebOptions& options);

// The addresses with the token, a QR code of the first that others reach, and the digits, on standard output:
// in no log. Likewise those with which one may control.
void print_addresses(const web::Server& server);

} // namespace ghost::app
