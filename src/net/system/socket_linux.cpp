// SPDX-License-Identifier: Apache-2.0
// Linux. Facts this rests on: a socket holds at most 20 group memberships (igmp_max_memberships); without
// IP_MULTICAST_ALL=0 it also gets the groups that others joined; of two sockets on one port only the one
// bound last gets unicast, unless one is bound to the very address. IPv6 has the same rules but the first.
#include "net/socket.h"

#include "net/private/ports.h"
#include "net/private/system_sizes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <map>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <netinet/in.h>
#include <netpacket/packet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ghost::dmx {

namespace {

sockaddr_in6 socket_address6(const IpAddress& ipv6, std::uint16_t port) {
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    std::memcpy(&address.sin6_addr, ipv6.bytes.data(), ipv6.bytes.size());
    address.sin6_port = htons(port);
    return address;
}

IpAddress address_of(const in6_addr& ipv6) {
    IpAddress address;
    std::memcpy(address.bytes.data(), &ipv6, address.bytes.size());
    return address;
}

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

// CAN and tunnels are no network of light.
bool is_ethernet(const sockaddr& of) {
    return of.sa_family == AF_PACKET && reinterpret_cast<const sockaddr_ll&>(of).sll_hatype == ARPHRD_ETHER;
}

bool set_int(int handle, int level, int option, int value) {
    return setsockopt(handle, level, option, &value, sizeof value) == 0;
}

} // namespace

std::vector<NetInterface> list_interfaces() {
    std::vector<NetInterface> result;
    std::map<std::string, NetInterface> ipv6, bare; // by name; bare: all, for some have no address
    ifaddrs* first = nullptr;
    if (getifaddrs(&first) != 0) return result;
    for (const ifaddrs* entry = first; entry; entry = entry->ifa_next) {
        if (!entry->ifa_addr || !(entry->ifa_flags & IFF_UP)) continue;
        const int family = entry->ifa_addr->sa_family;
        if (family != AF_INET && family != AF_INET6 && !is_ethernet(*entry->ifa_addr)) continue;
        NetInterface interface;
        interface.name = entry->ifa_name;
        interface.index = if_nametoindex(entry->ifa_name);
        interface.loopback = (entry->ifa_flags & IFF_LOOPBACK) != 0;
        interface.running = (entry->ifa_flags & IFF_RUNNING) != 0;
        if (family != AF_INET) {
            interface.ipv6 = family == AF_INET6;
            (interface.ipv6 ? ipv6 : bare).emplace(interface.name, interface);
            continue;
        }
        interface.address = ipv4_of(entry->ifa_addr);
        interface.netmask = entry->ifa_netmask ? ipv4_of(entry->ifa_netmask) : 0xFFFFFFFFu;
        interface.broadcast = interface.address | ~interface.netmask;
        result.push_back(std::move(interface));
    }
    freeifaddrs(first);
    for (NetInterface& interface : result) interface.ipv6 = ipv6.contains(interface.name);
    for (const auto* more : {&ipv6, &bare})
        for (const auto& [name, interface] : *more)
            if (std::none_of(result.begin(), result.end(),
                             [&wanted = name](const NetInterface& other) { return other.name == wanted; }))
                result.push_back(interface);
    for (NetInterface& interface : result)
        interface.bridged = ::access(("/sys/class/net/" + interface.name + "/master").c_str(), F_OK) == 0;
    return result;
}

struct UdpSocket::Batch {
    std::array<std::array<std::uint8_t, kDatagramBytes>, kBatch> bytes;
    std::array<std::array<std::uint8_t, 128>, kBatch> control;
    std::array<sockaddr_in6, kBatch> from; // holds a sockaddr_in, too
    std::array<iovec, kBatch> parts;
    std::array<mmsghdr, kBatch> messages;
    std::array<Datagram, kBatch> datagrams;
};

UdpSocket::UdpSocket(int handle, IpVersion version)
    : handle_(handle), version_(version), batch_(std::make_unique<Batch>()) {}

UdpSocket::~UdpSocket() {
    close(handle_);
}

Result<std::unique_ptr<UdpSocket>> UdpSocket::open_bound(IpVersion version, std::uint32_t address,
                                                         std::uint16_t port, int receive_buffer_bytes,
                                                         bool shared) {
    const bool v6 = version == IpVersion::v6;
    const std::string place = port_place(version, address, port);
    const int handle = ::socket(v6 ? AF_INET6 : AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (handle < 0) return Error{"cannot open a socket: " + reason(), place};
    std::unique_ptr<UdpSocket> result(new UdpSocket(handle, version));
    if (!set_int(handle, SOL_SOCKET, SO_RCVBUFFORCE, receive_buffer_bytes))
        (void)set_int(handle, SOL_SOCKET, SO_RCVBUF, receive_buffer_bytes);
    const bool common = set_int(handle, SOL_SOCKET, SO_REUSEADDR, shared) &&
                        set_int(handle, SOL_SOCKET, SO_RXQ_OVFL, 1) &&
                        set_int(handle, SOL_SOCKET, SO_TIMESTAMPNS, 1);
    const bool set = common && (v6 ? set_int(handle, IPPROTO_IPV6, IPV6_V6ONLY, 1) &&
                                         set_int(handle, IPPROTO_IPV6, IPV6_RECVPKTINFO, 1) &&
                                         set_int(handle, IPPROTO_IPV6, IPV6_MULTICAST_ALL, 0)
                                   : set_int(handle, SOL_SOCKET, SO_BROADCAST, 1) &&
                                         set_int(handle, IPPROTO_IP, IP_PKTINFO, 1) &&
                                         set_int(handle, IPPROTO_IP, IP_MULTICAST_ALL, 0));
    if (!set) return Error{"cannot set up the socket: " + reason(), place};
    const sockaddr_in name = socket_address(address, port);
    const sockaddr_in6 name6 = socket_address6({}, port);
    const bool bound = v6 ? bind(handle, reinterpret_cast<const sockaddr*>(&name6), sizeof name6) == 0
                          : bind(handle, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
    if (!bound) {
        if (errno == EADDRINUSE) return port_taken(port, place);
        return Error{"cannot listen: " + reason(), place};
    }
    if (!shared) (void)set_int(handle, SOL_SOCKET, SO_REUSEADDR, 1);
    return result;
}

namespace {

ip_mreqn request4(const IpAddress& group, const NetInterface& interface) {
    ip_mreqn request{};
    request.imr_multiaddr.s_addr = htonl(group.ipv4());
    request.imr_address.s_addr = htonl(interface.address);
    request.imr_ifindex = static_cast<int>(interface.index);
    return request;
}

ipv6_mreq request6(const IpAddress& group, const NetInterface& interface) {
    ipv6_mreq request{};
    std::memcpy(&request.ipv6mr_multiaddr, group.bytes.data(), group.bytes.size());
    request.ipv6mr_interface = interface.index;
    return request;
}

} // namespace

Result<void> UdpSocket::join(const IpAddress& group, const NetInterface& interface) {
    const ip_mreqn r4 = request4(group, interface);
    const ipv6_mreq r6 = request6(group, interface);
    const int failed = version_ == IpVersion::v6
                           ? setsockopt(handle_, IPPROTO_IPV6, IPV6_JOIN_GROUP, &r6, sizeof r6)
                           : setsockopt(handle_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &r4, sizeof r4);
    if (failed == 0 || errno == EADDRINUSE) return {};
    return Error{"cannot join " + address_text(group) + ": " + reason(), interface.name};
}

void UdpSocket::leave(const IpAddress& group, const NetInterface& interface) {
    const ip_mreqn r4 = request4(group, interface);
    const ipv6_mreq r6 = request6(group, interface);
    if (version_ == IpVersion::v6)
        (void)setsockopt(handle_, IPPROTO_IPV6, IPV6_LEAVE_GROUP, &r6, sizeof r6);
    else
        (void)setsockopt(handle_, IPPROTO_IP, IP_DROP_MEMBERSHIP, &r4, sizeof r4);
}

Result<void> UdpSocket::send_multicast_through(const NetInterface& interface) {
    const ip_mreqn request = request4(std::uint32_t{0}, interface);
    const bool set =
        version_ == IpVersion::v6
            ? set_int(handle_, IPPROTO_IPV6, IPV6_MULTICAST_IF, static_cast<int>(interface.index))
            : setsockopt(handle_, IPPROTO_IP, IP_MULTICAST_IF, &request, sizeof request) == 0;
    if (set) return {};
    return Error{"cannot send multicast through it: " + reason(), interface.name};
}

Result<void> UdpSocket::send(Bytes bytes, const IpAddress& to, std::uint16_t port) {
    const sockaddr_in name = socket_address(to.ipv4(), port);
    const sockaddr_in6 name6 = socket_address6(to, port);
    for (;;) {
        const auto sent = version_ == IpVersion::v6
                              ? sendto(handle_, bytes.data(), bytes.size(), 0,
                                       reinterpret_cast<const sockaddr*>(&name6), sizeof name6)
                              : sendto(handle_, bytes.data(), bytes.size(), 0,
                                       reinterpret_cast<const sockaddr*>(&name), sizeof name);
        if (sent == static_cast<ssize_t>(bytes.size())) return {};
        if (errno == EINTR || errno == ECONNREFUSED) continue; // refused: an answer to an earlier packet
        if (errno == EAGAIN) {
            pollfd entry{handle_, POLLOUT, 0};
            if (poll(&entry, 1, 100) > 0) continue;
        }
        return Error{"cannot send: " + reason(), address_text(to) + ":" + std::to_string(port)};
    }
}

namespace {

// The kernel stamps packets with the wall clock. A stamp in the future, or an hour old, means that it was
// set.
std::chrono::nanoseconds steady_time(const timespec& stamp, std::chrono::nanoseconds steady_now,
                                     std::chrono::nanoseconds wall_now) {
    const auto age =
        wall_now - (std::chrono::seconds(stamp.tv_sec) + std::chrono::nanoseconds(stamp.tv_nsec));
    return age.count() < 0 || age > std::chrono::hours(1) ? steady_now : steady_now - age;
}

} // namespace

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
    packets_ += static_cast<std::uint64_t>(count);
    const std::chrono::nanoseconds steady_now = std::chrono::steady_clock::now().time_since_epoch();
    const std::chrono::nanoseconds wall_now = std::chrono::system_clock::now().time_since_epoch();
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        Datagram& datagram = batch.datagrams[i];
        datagram = {};
        datagram.bytes = Bytes(batch.bytes[i].data(), batch.messages[i].msg_len);
        datagram.time = steady_now;
        if (version_ == IpVersion::v6) {
            datagram.from = address_of(batch.from[i].sin6_addr);
            datagram.from_port = ntohs(batch.from[i].sin6_port);
        } else {
            datagram.from = ipv4_of(reinterpret_cast<const sockaddr*>(&batch.from[i]));
            datagram.from_port = ntohs(batch.from[i].sin6_port); // at the same place
        }
        msghdr& header = batch.messages[i].msg_hdr;
        for (cmsghdr* part = CMSG_FIRSTHDR(&header); part; part = CMSG_NXTHDR(&header, part)) {
            if (part->cmsg_level == IPPROTO_IP && part->cmsg_type == IP_PKTINFO) {
                in_pktinfo info{};
                std::memcpy(&info, CMSG_DATA(part), sizeof info);
                datagram.to = ntohl(info.ipi_addr.s_addr);
                datagram.local_ipv4 = ntohl(info.ipi_spec_dst.s_addr);
                datagram.interface_index = static_cast<unsigned>(info.ipi_ifindex);
            } else if (part->cmsg_level == IPPROTO_IPV6 && part->cmsg_type == IPV6_PKTINFO) {
                in6_pktinfo info{};
                std::memcpy(&info, CMSG_DATA(part), sizeof info);
                datagram.to = address_of(info.ipi6_addr);
                datagram.interface_index = info.ipi6_ifindex;
            } else if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_TIMESTAMPNS) {
                timespec stamp{};
                std::memcpy(&stamp, CMSG_DATA(part), sizeof stamp);
                datagram.time = steady_time(stamp, steady_now, wall_now);
            } else if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SO_RXQ_OVFL) {
                std::uint32_t dropped = 0;
                std::memcpy(&dropped, CMSG_DATA(part), sizeof dropped);
                count_overflow(dropped);
            }
        }
    }
    return {batch.datagrams.data(), static_cast<std::size_t>(count)};
}

// Of the two sources of the kernel's count, which wraps, that of a packet is as old as the packet.
void UdpSocket::count_overflow(std::uint32_t dropped) {
    const auto more = static_cast<std::int32_t>(dropped - static_cast<std::uint32_t>(overflow_));
    if (more > 0) overflow_ += static_cast<std::uint64_t>(more);
}

std::uint64_t UdpSocket::overflow() {
    std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
    socklen_t size = sizeof memory;
    if (getsockopt(handle_, SOL_SOCKET, SO_MEMINFO, memory.data(), &size) == 0 &&
        size > SK_MEMINFO_DROPS * sizeof(std::uint32_t))
        count_overflow(memory[SK_MEMINFO_DROPS]);
    return overflow_;
}

int UdpSocket::receive_buffer() const {
    int bytes = 0;
    socklen_t size = sizeof bytes;
    return getsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &bytes, &size) == 0 ? bytes / 2
                                                                          : 0; // the kernel doubles it
}

std::chrono::nanoseconds thread_cpu_time() {
    timespec time{};
    return clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0
               ? std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec)
               : std::chrono::nanoseconds(0);
}

std::vector<bool> wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets,
                                   std::span<const int> handles, std::chrono::nanoseconds timeout) {
    std::vector<pollfd> entries;
    entries.reserve(sockets.size() + handles.size());
    for (const auto& socket : sockets) entries.push_back({socket->handle_, POLLIN, 0});
    for (const int handle : handles) entries.push_back({handle, POLLIN, 0});
    const auto limit = std::max(timeout, std::chrono::nanoseconds(0));
    const timespec time{static_cast<time_t>(limit.count() / 1'000'000'000),
                        static_cast<long>(limit.count() % 1'000'000'000)};
    std::vector<bool> ready(sockets.size());
    if (ppoll(entries.data(), entries.size(), &time, nullptr) <= 0) return ready;
    for (std::size_t i = 0; i < ready.size(); ++i) ready[i] = entries[i].revents != 0;
    return ready;
}

} // namespace ghost::dmx
