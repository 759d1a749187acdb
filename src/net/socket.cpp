// SPDX-License-Identifier: Apache-2.0
#include "net/socket.h"

#include "net/port_users.h"
#include "net/private/ports.h"

#include <array>

namespace ghost::dmx {

std::string port_place(IpVersion version, std::uint32_t address, std::uint16_t port) {
    return "UDP port " + std::to_string(port) +
           (version == IpVersion::v6 ? " of IPv6"
            : address                ? " of " + ipv4_text(address)
                                     : "");
}

Error port_taken(std::uint16_t port, const std::string& place) {
    const std::vector<PortUser> users = port_users(std::array{port});
    const std::string who = users.empty() ? std::string("another program") : program_text(users.front());
    return Error{"the port is taken by " + who + ", which does not share it; close it and try again", place};
}

bool is_on_link(const NetInterface& interface, const IpAddress& from) {
    if (!from.is_ipv4()) return from.bytes[0] == 0xFE && (from.bytes[1] & 0xC0) == 0x80; // fe80::/10
    return interface.address != 0 && ((from.ipv4() ^ interface.address) & interface.netmask) == 0;
}

Result<NetInterface> find_interface(const std::string& name_or_address) {
    const std::vector<NetInterface> all = list_interfaces();
    const Result<std::uint32_t> address = parse_ipv4(name_or_address);
    std::string names;
    for (const NetInterface& interface : all) {
        if (interface.name == name_or_address ||
            (address.ok() && *address != 0 && interface.address == *address))
            return interface;
        names += (names.empty() ? "" : ", ") + interface.name + " (" +
                 (interface.address ? ipv4_text(interface.address)
                  : interface.ipv6  ? "IPv6"
                                    : "no address") +
                 ")";
    }
    for (NetInterface interface : all) {
        if (!address.ok() || !interface.loopback) continue;
        if (((interface.address ^ *address) & interface.netmask) != 0) continue;
        interface.address = *address;
        return interface;
    }
    return Error{"no network interface '" + name_or_address +
                     "', expected one of: " + (names.empty() ? "none is up" : names),
                 "--interface"};
}

std::string ipv4_text(std::uint32_t address) {
    return std::to_string(address >> 24) + "." + std::to_string((address >> 16) & 255) + "." +
           std::to_string((address >> 8) & 255) + "." + std::to_string(address & 255);
}

Result<std::unique_ptr<UdpSocket>> UdpSocket::open(std::uint32_t address, std::uint16_t port,
                                                   int receive_buffer_bytes) {
    return open_bound(IpVersion::v4, address, port, receive_buffer_bytes);
}

Result<std::unique_ptr<UdpSocket>> UdpSocket::open_if_free(std::uint16_t port, int receive_buffer_bytes) {
    return open_bound(IpVersion::v4, 0, port, receive_buffer_bytes, false);
}

Result<std::unique_ptr<UdpSocket>> UdpSocket::open_ipv6(std::uint16_t port, int receive_buffer_bytes) {
    return open_bound(IpVersion::v6, 0, port, receive_buffer_bytes);
}

} // namespace ghost::dmx
