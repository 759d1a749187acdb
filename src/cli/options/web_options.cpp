// SPDX-License-Identifier: Apache-2.0
#include "cli/options/web_options.h"

#include "base/print.h"
#include "cli/options/number_option.h"
#include "live/inputs/remote_input.h"
#include "net/socket.h"
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
    return web;
}

Result<web::ServerOptions> server_options(const WebOptions& options) {
    TRY(const PortOption port, parse_port(options.web, "--web"));
    if (options.host.find_first_of(" /:@") != std::string::npos)
        return Error{"'" + options.host + "', expected a name alone, like lights.example.org", "--host"};
    return web::ServerOptions{port.ipv4, port.port, options.host, options.mbit};
}

void print_addresses(const web::Server& server, const web::ServerOptions& options) {
    std::vector<std::string> hosts;
    if (options.address != 0) hosts.push_back(dmx::ipv4_text(options.address));
    for (const dmx::NetInterface& interface : dmx::list_interfaces())
        if (options.address == 0 && interface.address != 0 && !interface.loopback)
            hosts.push_back(dmx::ipv4_text(interface.address));
    if (hosts.empty()) hosts.emplace_back("127.0.0.1");
    std::string text = "in a browser:\n";
    const auto base = [&](const std::string& host) {
        return "http://" + host + ":" + std::to_string(server.port()) + "/";
    };
    const std::string secret = "#t=" + server.token();
    for (const std::string& host : hosts) text += "    " + base(host) + secret + "\n";
    if (!options.host.empty()) text += "    https://" + options.host + "/" + secret + "\n";
    text += "or " + base(hosts.front()) + " and, within two minutes, the digits " + server.digits() + "\n";
    const dmx::IpAddress address(options.address);
    if (options.address == 0 || !address.is_loopback()) text += web::qr_text(base(hosts.front()) + secret);
    print_text("%s", text.c_str());
    (void)std::fflush(stdout);
}

} // namespace ghost::app
