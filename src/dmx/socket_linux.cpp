// SPDX-License-Identifier: Apache-2.0
// Linux. Facts this rests on: a socket holds at most 20 group memberships (igmp_max_memberships); without
// IP_MULTICAST_ALL=0 it also gets the groups that others joined; of two sockets on one port only the one
// bound last gets unicast, unless one is bound to the very address.
#include "dmx/socket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ghost::dmx {

namespace {

constexpr std::size_t kBatch = 64;
constexpr std::size_t kDatagramBytes = 1536; // more than any level packet; the rest of a longer one is cut

sockaddr_in socket_address(std::uint32_t ipv4, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(ipv4);
    address.sin_port = htons(port);
    return address;
}

std::uint32_t ipv4_of(const sockaddr* address) {
    sockaddr_in copy{};
    std::memcpy(&copy, address, sizeof copy);
    return ntohl(copy.sin_addr.s_addr);
}

std::string reason() {
    return std::strerror(errno);
}

bool set_int(int handle, int level, int option, int value) {
    return setsockopt(handle, level, option, &value, sizeof value) == 0;
}

} // namespace

std::vector<NetInterface> list_interfaces() {
    std::vector<NetInterface> result;
    ifaddrs* first = nullptr;
    if (getifaddrs(&first) != 0) return result;
    for (const ifaddrs* entry = first; entry; entry = entry->ifa_next) {
        if (!entry->ifa_addr || entry->ifa_addr->sa_family != AF_INET || !(entry->ifa_flags & IFF_UP))
            continue;
        NetInterface interface;
        interface.name = entry->ifa_name;
        interface.index = if_nametoindex(entry->ifa_name);
        interface.address = ipv4_of(entry->ifa_addr);
        interface.netmask = entry->ifa_netmask ? ipv4_of(entry->ifa_netmask) : 0xFFFFFFFFu;
        interface.broadcast = interface.address | ~interface.netmask;
        interface.loopback = (entry->ifa_flags & IFF_LOOPBACK) != 0;
        result.push_back(std::move(interface));
    }
    freeifaddrs(first);
    return result;
}

Result<NetInterface> find_interface(const std::string& name_or_address) {
    const std::vector<NetInterface> all = list_interfaces();
    const Result<std::uint32_t> address = parse_ipv4(name_or_address);
    std::string names;
    for (const NetInterface& interface : all) {
        if (interface.name == name_or_address || (address.ok() && interface.address == *address))
            return interface;
        names += (names.empty() ? "" : ", ") + interface.name + " (" + ipv4_text(interface.address) + ")";
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

Result<std::uint32_t> parse_ipv4(const std::string& text) {
    in_addr address{};
    if (inet_pton(AF_INET, text.c_str(), &address) != 1)
        return Error{"'" + text + "' is no IPv4 address, expected four numbers like 192.168.1.20", ""};
    return ntohl(address.s_addr);
}

std::string ipv4_text(std::uint32_t address) {
    return std::to_string(address >> 24) + "." + std::to_string((address >> 16) & 255) + "." +
           std::to_string((address >> 8) & 255) + "." + std::to_string(address & 255);
}

struct UdpSocket::Batch {
    std::array<std::array<std::uint8_t, kDatagramBytes>, kBatch> bytes;
    std::array<std::array<std::uint8_t, 128>, kBatch> control;
    std::array<sockaddr_in, kBatch> from;
    std::array<iovec, kBatch> parts;
    std::array<mmsghdr, kBatch> messages;
    std::array<Datagram, kBatch> datagrams;
};

UdpSocket::UdpSocket(int handle) : handle_(handle), batch_(std::make_unique<Batch>()) {}

UdpSocket::~UdpSocket() {
    close(handle_);
}

Result<std::unique_ptr<UdpSocket>> UdpSocket::open(std::uint32_t address, std::uint16_t port,
                                                   int receive_buffer_bytes) {
    const std::string place =
        "UDP port " + std::to_string(port) + (address ? " of " + ipv4_text(address) : "");
    const int handle = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (handle < 0) return Error{"cannot open a socket: " + reason(), place};
    std::unique_ptr<UdpSocket> result(new UdpSocket(handle));
    if (!set_int(handle, SOL_SOCKET, SO_RCVBUFFORCE, receive_buffer_bytes))
        (void)set_int(handle, SOL_SOCKET, SO_RCVBUF, receive_buffer_bytes);
    const bool set =
        set_int(handle, SOL_SOCKET, SO_REUSEADDR, 1) && set_int(handle, SOL_SOCKET, SO_BROADCAST, 1) &&
        set_int(handle, SOL_SOCKET, SO_RXQ_OVFL, 1) && set_int(handle, IPPROTO_IP, IP_PKTINFO, 1) &&
        set_int(handle, IPPROTO_IP, IP_MULTICAST_ALL, 0);
    if (!set) return Error{"cannot set up the socket: " + reason(), place};
    const sockaddr_in name = socket_address(address, port);
    if (bind(handle, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0) {
        if (errno == EADDRINUSE)
            return Error{
                "the port is taken by another program that does not share it; close it and try again", place};
        return Error{"cannot listen: " + reason(), place};
    }
    return result;
}

Result<void> UdpSocket::join(std::uint32_t group, const NetInterface& interface) {
    ip_mreqn request{};
    request.imr_multiaddr.s_addr = htonl(group);
    request.imr_address.s_addr = htonl(interface.address);
    request.imr_ifindex = static_cast<int>(interface.index);
    if (setsockopt(handle_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request) == 0 ||
        errno == EADDRINUSE)
        return {};
    return Error{"cannot join " + ipv4_text(group) + ": " + reason(), interface.name};
}

Result<void> UdpSocket::send_multicast_through(const NetInterface& interface) {
    ip_mreqn request{};
    request.imr_address.s_addr = htonl(interface.address);
    request.imr_ifindex = static_cast<int>(interface.index);
    if (setsockopt(handle_, IPPROTO_IP, IP_MULTICAST_IF, &request, sizeof request) == 0) return {};
    return Error{"cannot send multicast through it: " + reason(), interface.name};
}

Result<void> UdpSocket::send(Bytes bytes, std::uint32_t ipv4, std::uint16_t port) {
    const sockaddr_in name = socket_address(ipv4, port);
    for (;;) {
        const auto sent = sendto(handle_, bytes.data(), bytes.size(), 0,
                                 reinterpret_cast<const sockaddr*>(&name), sizeof name);
        if (sent == static_cast<ssize_t>(bytes.size())) return {};
        if (errno == EINTR || errno == ECONNREFUSED) continue; // refused: an answer to an earlier packet
        if (errno == EAGAIN) {
            pollfd entry{handle_, POLLOUT, 0};
            if (poll(&entry, 1, 100) > 0) continue;
        }
        return Error{"cannot send: " + reason(), ipv4_text(ipv4) + ":" + std::to_string(port)};
    }
}

std::span<const Datagram> UdpSocket::receive() {
    Batch& batch = *batch_;
    for (std::size_t i = 0; i < kBatch; ++i) {
        batch.parts[i] = {batch.bytes[i].data(), kDatagramBytes};
        msghdr& header = batch.messages[i].msg_hdr;
        header = {};
        header.msg_name = &batch.from[i];
        header.msg_namelen = sizeof batch.from[i];
        header.msg_iov = &batch.parts[i];
        header.msg_iovlen = 1;
        header.msg_control = batch.control[i].data();
        header.msg_controllen = batch.control[i].size();
    }
    const int count = recvmmsg(handle_, batch.messages.data(), kBatch, 0, nullptr);
    if (count <= 0) return {};
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        Datagram& datagram = batch.datagrams[i];
        datagram = {};
        datagram.bytes = Bytes(batch.bytes[i].data(), batch.messages[i].msg_len);
        datagram.from_ipv4 = ntohl(batch.from[i].sin_addr.s_addr);
        datagram.from_port = ntohs(batch.from[i].sin_port);
        msghdr& header = batch.messages[i].msg_hdr;
        for (cmsghdr* part = CMSG_FIRSTHDR(&header); part; part = CMSG_NXTHDR(&header, part)) {
            if (part->cmsg_level == IPPROTO_IP && part->cmsg_type == IP_PKTINFO) {
                in_pktinfo info{};
                std::memcpy(&info, CMSG_DATA(part), sizeof info);
                datagram.to_ipv4 = ntohl(info.ipi_addr.s_addr);
                datagram.local_ipv4 = ntohl(info.ipi_spec_dst.s_addr);
                datagram.interface_index = static_cast<unsigned>(info.ipi_ifindex);
            } else if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SO_RXQ_OVFL) {
                std::uint32_t dropped = 0;
                std::memcpy(&dropped, CMSG_DATA(part), sizeof dropped);
                overflow_ += static_cast<std::uint32_t>(dropped - static_cast<std::uint32_t>(overflow_));
            }
        }
    }
    return {batch.datagrams.data(), static_cast<std::size_t>(count)};
}

int UdpSocket::receive_buffer() const {
    int bytes = 0;
    socklen_t size = sizeof bytes;
    return getsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &bytes, &size) == 0 ? bytes / 2
                                                                          : 0; // the kernel doubles it
}

void wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets, std::chrono::nanoseconds timeout) {
    std::vector<pollfd> entries;
    entries.reserve(sockets.size());
    for (const auto& socket : sockets) entries.push_back({socket->handle_, POLLIN, 0});
    const auto limit = std::max(timeout, std::chrono::nanoseconds(0));
    const timespec time{static_cast<time_t>(limit.count() / 1'000'000'000),
                        static_cast<long>(limit.count() % 1'000'000'000)};
    (void)ppoll(entries.data(), entries.size(), &time, nullptr);
}

} // namespace ghost::dmx
