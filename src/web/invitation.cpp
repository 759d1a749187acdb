// SPDX-License-Identifier: Apache-2.0
#include "web/invitation.h"

#include "net/socket.h"

namespace ghost::web {

std::vector<Place> places() {
    std::vector<Place> all{{"this machine alone", 0x7F000001}};
    for (const dmx::NetInterface& interface : dmx::list_interfaces())
        if (interface.address != 0 && !interface.loopback) all.push_back({interface.name, interface.address});
    all.push_back({"whoever reaches this machine", 0});
    return all;
}

std::vector<std::string> addresses_of(const ServerOptions& options, std::uint16_t port) {
    std::vector<std::string> hosts;
    if (options.address != 0) hosts.push_back(dmx::ipv4_text(options.address));
    for (const dmx::NetInterface& interface : dmx::list_interfaces())
        if (options.address == 0 && interface.address != 0 && !interface.loopback)
            hosts.push_back(dmx::ipv4_text(interface.address));
    if (hosts.empty()) hosts.emplace_back("127.0.0.1");
    std::vector<std::string> addresses;
    for (const std::string& host : hosts)
        addresses.push_back("http://" + host + ":" + std::to_string(port) + "/");
    if (!options.host.empty()) addresses.push_back("https://" + options.host + "/");
    return addresses;
}

std::string with_secret(const std::string& address, const std::string& token) {
    return address + "#t=" + token;
}

} // namespace ghost::web
