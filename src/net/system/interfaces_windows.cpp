// SPDX-License-Identifier: Apache-2.0
// Interfaces go by the names that people see: "Ethernet 2". A port of a bridge has no address there and is
// not listed.
#include "net/private/winsock.h"
#include "net/socket.h"

#include <algorithm>

namespace ghost::dmx {

namespace {

constexpr int kListTries = 4;

// All of the machine's, of which one follows the other; empty: the system does not say.
std::vector<std::uint64_t> adapters() {
    std::vector<std::uint64_t> memory(2048);
    for (int tries = 0; tries < kListTries; ++tries) {
        auto size = static_cast<ULONG>(memory.size() * sizeof(std::uint64_t));
        const ULONG code = ::GetAdaptersAddresses(
            AF_UNSPEC, GAA_FLAG_SKIP_ANYCAST | GAA_FLAG_SKIP_MULTICAST | GAA_FLAG_SKIP_DNS_SERVER, nullptr,
            reinterpret_cast<IP_ADAPTER_ADDRESSES*>(memory.data()), &size);
        if (code == NO_ERROR) return memory;
        if (code != ERROR_BUFFER_OVERFLOW) return {};
        memory.resize(size / sizeof(std::uint64_t) + 1);
    }
    return {};
}

std::uint32_t ipv4_in(const SOCKET_ADDRESS& address) {
    sockaddr_in copy{};
    std::memcpy(&copy, address.lpSockaddr, sizeof copy);
    return ntohl(copy.sin_addr.s_addr);
}

} // namespace

std::vector<NetInterface> list_interfaces() {
    std::vector<NetInterface> result, bare; // bare: those without IPv4
    const std::vector<std::uint64_t> memory = adapters();
    if (memory.empty()) return result;
    for (auto* one = reinterpret_cast<const IP_ADAPTER_ADDRESSES*>(memory.data()); one != nullptr;
         one = one->Next) {
        const bool is_loopback = one->IfType == IF_TYPE_SOFTWARE_LOOPBACK;
        const bool is_card = one->IfType == IF_TYPE_ETHERNET_CSMACD || one->IfType == IF_TYPE_IEEE80211;
        NetInterface interface;
        interface.name = utf8_text(one->FriendlyName);
        interface.index = one->IfIndex != 0 ? one->IfIndex : one->Ipv6IfIndex;
        interface.loopback = is_loopback;
        interface.running = one->OperStatus == IfOperStatusUp;
        if (!interface.running && !is_card) continue;
        const std::size_t before = result.size();
        for (auto* unicast = one->FirstUnicastAddress; unicast != nullptr; unicast = unicast->Next) {
            const int family = unicast->Address.lpSockaddr->sa_family;
            if (family == AF_INET6) interface.ipv6 = true;
            if (family != AF_INET) continue;
            NetInterface ipv4 = interface;
            const unsigned bits = std::min<unsigned>(unicast->OnLinkPrefixLength, 32);
            ipv4.address = ipv4_in(unicast->Address);
            ipv4.netmask = bits == 0 ? 0 : 0xFFFFFFFFu << (32 - bits);
            ipv4.broadcast = ipv4.address | ~ipv4.netmask;
            result.push_back(std::move(ipv4));
        }
        for (std::size_t k = before; k < result.size(); ++k) result[k].ipv6 = interface.ipv6;
        if (result.size() == before && (interface.ipv6 || is_card)) bare.push_back(std::move(interface));
    }
    result.insert(result.end(), bare.begin(), bare.end());
    return result;
}

} // namespace ghost::dmx
