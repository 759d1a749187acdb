// SPDX-License-Identifier: Apache-2.0
#include "cli/options/web_options.h"

#include "base/print.h"
#include "cli/options/number_option.h"
#include "live/inputs/remote_input.h"
#include "web/invitation.h"
#include "web/qr.h"

#include <cstdio>
#include <vector>

namespace ghost::app {

CLI::Option* add_web_options(CLI::App& command, WebOptions& options) {
    CLI::Option* const web =
        command
            .add_option("--web", options.web,
                        "let browsers look on: at this TCP port of 127.0.0.1, or at an address of ours like "
                        "0.0.0.0:8010 (plain HTTP: a network that you trust)")
            ->type_name("[ADDRESS:]PORT");
    command
        .add_option("--host", options.host,
                    "name by which a TLS proxy before --web is called, like lights.example.org")
        ->type_name("NAME")
        ->needs(web);
    command.add_option("--web-mbit", options.mbit, "of pictures a second, all browsers together")
        ->type_name("MBIT/S")
        ->check(number_in(0.1, 10'000.0))
        ->needs(web)
        ->capture_default_str();
    command.add_option("--book", options.book, "a cue book that they may read, as 'ghostlight book' made it")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory)
        ->needs(web);
    command
        .add_flag("--control", options.control,
                  "a second address is printed: who has it recalls looks, cues and cameras")
        ->needs(web);
    return web;
}

Result<web::ServerOptions> server_options(const WebOptions& options) {
    TRY(const PortOption port, parse_port(options.web, "--web"));
    if (options.host.find_first_of(" /:@") != std::string::npos)
        return Error{"'" + options.host + "', expected a name alone, like lights.example.org", "--host"};
    return web::ServerOptions{.address = port.ipv4,
                              .port = port.port,
                              .host = options.host,
                              .mbit = options.mbit,
                              .book = options.book,
                              .control = options.control};
}

void print_addresses(const web::Server& server) {
    const web::ServerOptions& options = server.options();
    const std::vector<std::string> addresses = web::addresses_of(options, server.port());
    const web::Keys keys = server.keys();
    std::string text = "in a browser:\n";
    for (const std::string& address : addresses)
        text += "    " + web::with_secret(address, keys.token) + "\n";
    text += "or " + addresses.front() + " and, within two minutes, the digits " + keys.digits + "\n";
    if (!keys.control_token.empty()) {
        text += "with control, for whom you trust with the show:\n";
        for (const std::string& address : addresses)
            text += "    " + web::with_secret(address, keys.control_token) + "\n";
    }
    const dmx::IpAddress address(options.address);
    if (options.address == 0 || !address.is_loopback())
        text += web::qr_text(web::with_secret(addresses.front(), keys.token));
    print_text("%s", text.c_str());
    (void)std::fflush(stdout);
}

} // namespace ghost::app
