// SPDX-License-Identifier: Apache-2.0
#include "net/socket.h"

#if defined(_WIN32)
#include "net/private/winsock.h"
#else
#include <arpa/inet.h>
#include <netinet/in.h>
#endif

#include <cstring>

namespace ghost::dmx {

Result<std::uint32_t> parse_ipv4(const std::string& text) {
    in_addr address{};
    if (inet_pton(AF_INET, text.c_str(), &address) != 1)
        return Error{"'" + text + "' is no IPv4 address, expected four numbers like 192.168.1.20", ""};
    return ntohl(address.s_addr);
}

Result<IpAddress> parse_address(const std::string& text) {
    in6_addr address{};
    if (inet_pton(AF_INET6, text.c_str(), &address) == 1) {
        IpAddress all;
        std::memcpy(all.bytes.data(), &address, all.bytes.size());
        return all;
    }
    const auto ipv4 = parse_ipv4(text);
    if (ipv4.ok()) return IpAddress(*ipv4);
    return Error{"'" + text + "' is no IP address, expected one like 192.168.1.20 or fe80::1", ""};
}

} // namespace ghost::dmx
