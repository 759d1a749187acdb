// SPDX-License-Identifier: Apache-2.0
// Compiled nowhere so far: no compiler for macOS was at hand.
// macOS. Facts this rests on: a packet's destination and interface are two parts of what comes with it
// (IP_RECVDSTADDR, IP_RECVIF), there is no call for many packets at once, and a socket that is bound to every
// address gets the groups that others joined, too: what it is not in is left out here. How many packets were
// dropped the system does not tell a socket.
#include "net/private/ports.h"
#include "net/private/system_sizes.h"
#include "net/socket.h"

#define __APPLE_USE_RFC_3542 // for IPV6_PKTINFO, before the system's header

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <map>
#include <set>
#include <utility>

#include <arpa/inet.h>
#include <fcntl.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <net/if_dl.h>
#include <net/if_types.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace ghost::dmx {

namespace {

sockaddr_in6 socket_address6(const IpAddress& ipv6, std::uint16_t port) {
    sockaddr_in6 address{};
    address.sin6_len = sizeof address;
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
    address.sin_len = sizeof address;
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

bool is_ethernet(const sockaddr& of) {
    return of.sa_family == AF_LINK && reinterpret_cast<const sockaddr_dl&>(of).sdl_type == IFT_ETHER;
}

template <class Value>
bool set_option(int handle, int level, int option, const Value& value) {
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
        NetInterface one;
        one.name = entry->ifa_name;
        one.index = if_nametoindex(entry->ifa_name);
        one.loopback = (entry->ifa_flags & IFF_LOOPBACK) != 0;
        one.running = (entry->ifa_flags & IFF_RUNNING) != 0;
        if (family != AF_INET) {
            one.ipv6 = family == AF_INET6;
            (one.ipv6 ? ipv6 : bare).emplace(one.name, one);
            continue;
        }
        one.address = ipv4_of(entry->ifa_addr);
        one.netmask = entry->ifa_netmask ? ipv4_of(entry->ifa_netmask) : 0xFFFFFFFFu;
        one.broadcast = one.address | ~one.netmask;
        result.push_back(std::move(one));
    }
    freeifaddrs(first);
    for (NetInterface& one : result) one.ipv6 = ipv6.contains(one.name);
    for (const auto* more : {&ipv6, &bare})
        for (const auto& [name, one] : *more)
            if (std::none_of(result.begin(), result.end(),
                             [&wanted = name](const NetInterface& other) { return other.name == wanted; }))
                result.push_back(one);
    return result;
}

struct UdpSocket::Batch {
    std::array<std::array<std::uint8_t, kDatagramBytes>, kBatch> bytes;
    std::array<Datagram, kBatch> datagrams;
    alignas(cmsghdr) std::array<char, 256> control;
    std::set<std::pair<IpAddress, unsigned>> groups; // that it is in, each with the interface
    std::map<unsigned, std::uint32_t> own;           // by interface: our first address there
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
    const int handle = ::socket(v6 ? AF_INET6 : AF_INET, SOCK_DGRAM, 0);
    if (handle < 0) return Error{"cannot open a socket: " + reason(), place};
    std::unique_ptr<UdpSocket> result(new UdpSocket(handle, version));
    (void)fcntl(handle, F_SETFD, FD_CLOEXEC);
    (void)fcntl(handle, F_SETFL, O_NONBLOCK);
    (void)set_option(handle, SOL_SOCKET, SO_RCVBUF, receive_buffer_bytes);
    const int on = 1, share = shared ? 1 : 0;
    // Several that get the same packets have to say so by SO_REUSEPORT there.
    const bool common = set_option(handle, SOL_SOCKET, SO_REUSEADDR, share) &&
                        set_option(handle, SOL_SOCKET, SO_REUSEPORT, share) &&
                        set_option(handle, SOL_SOCKET, SO_TIMESTAMP, on);
    const bool set = common && (v6 ? set_option(handle, IPPROTO_IPV6, IPV6_V6ONLY, on) &&
                                         set_option(handle, IPPROTO_IPV6, IPV6_RECVPKTINFO, on)
                                   : set_option(handle, SOL_SOCKET, SO_BROADCAST, on) &&
                                         set_option(handle, IPPROTO_IP, IP_RECVDSTADDR, on) &&
                                         set_option(handle, IPPROTO_IP, IP_RECVIF, on));
    if (!set) return Error{"cannot set up the socket: " + reason(), place};
    const sockaddr_in name = socket_address(address, port);
    const sockaddr_in6 name6 = socket_address6({}, port);
    const bool bound = v6 ? bind(handle, reinterpret_cast<const sockaddr*>(&name6), sizeof name6) == 0
                          : bind(handle, reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
    if (!bound) {
        if (errno == EADDRINUSE) return port_taken(port, place);
        return Error{"cannot listen: " + reason(), place};
    }
    if (!shared) {
        (void)set_option(handle, SOL_SOCKET, SO_REUSEADDR, on);
        (void)set_option(handle, SOL_SOCKET, SO_REUSEPORT, on);
    }
    return result;
}

namespace {

ip_mreqn request4(const IpAddress& group, const NetInterface& one) {
    ip_mreqn request{};
    request.imr_multiaddr.s_addr = htonl(group.ipv4());
    request.imr_address.s_addr = htonl(one.address);
    request.imr_ifindex = static_cast<int>(one.index);
    return request;
}

ipv6_mreq request6(const IpAddress& group, const NetInterface& one) {
    ipv6_mreq request{};
    std::memcpy(&request.ipv6mr_multiaddr, group.bytes.data(), group.bytes.size());
    request.ipv6mr_interface = one.index;
    return request;
}

} // namespace

Result<void> UdpSocket::join(const IpAddress& group, const NetInterface& one) {
    const bool joined = version_ == IpVersion::v6
                            ? set_option(handle_, IPPROTO_IPV6, IPV6_JOIN_GROUP, request6(group, one))
                            : set_option(handle_, IPPROTO_IP, IP_ADD_MEMBERSHIP, request4(group, one));
    if (!joined && errno != EADDRINUSE)
        return Error{"cannot join " + address_text(group) + ": " + reason(), one.name};
    batch_->groups.insert({group, one.index});
    return {};
}

void UdpSocket::leave(const IpAddress& group, const NetInterface& one) {
    if (version_ == IpVersion::v6)
        (void)set_option(handle_, IPPROTO_IPV6, IPV6_LEAVE_GROUP, request6(group, one));
    else
        (void)set_option(handle_, IPPROTO_IP, IP_DROP_MEMBERSHIP, request4(group, one));
    batch_->groups.erase({group, one.index});
}

Result<void> UdpSocket::send_multicast_through(const NetInterface& one) {
    const bool set = version_ == IpVersion::v6
                         ? set_option(handle_, IPPROTO_IPV6, IPV6_MULTICAST_IF, one.index)
                         : set_option(handle_, IPPROTO_IP, IP_MULTICAST_IF, request4(std::uint32_t{0}, one));
    if (set) return {};
    return Error{"cannot send multicast through it: " + reason(), one.name};
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
        if (errno == EAGAIN || errno == ENOBUFS) {
            pollfd entry{handle_, POLLOUT, 0};
            if (poll(&entry, 1, 100) > 0 && errno != ENOBUFS) continue;
        }
        return Error{"cannot send: " + reason(), address_text(to) + ":" + std::to_string(port)};
    }
}

namespace {

// The kernel stamps packets with the wall clock. A stamp in the future, or an hour old, means that it was
// set.
std::chrono::nanoseconds steady_time(const timeval& stamp, std::chrono::nanoseconds steady_now,
                                     std::chrono::nanoseconds wall_now) {
    const auto age =
        wall_now - (std::chrono::seconds(stamp.tv_sec) + std::chrono::microseconds(stamp.tv_usec));
    return age.count() < 0 || age > std::chrono::hours(1) ? steady_now : steady_now - age;
}

// Our address on an interface. Loopback networks have every address of theirs.
std::uint32_t own_ipv4(std::map<unsigned, std::uint32_t>& known, const IpAddress& to, unsigned index) {
    if (!to.is_multicast() && to.is_loopback()) return to.ipv4();
    if (!known.contains(index)) {
        known.clear();
        for (const NetInterface& one : list_interfaces())
            if (one.address != 0) known.emplace(one.index, one.address);
        known.emplace(index, 0);
    }
    return known[index];
}

} // namespace

std::span<const Datagram> UdpSocket::receive() {
    Batch& batch = *batch_;
    const std::chrono::nanoseconds steady_now = std::chrono::steady_clock::now().time_since_epoch();
    const std::chrono::nanoseconds wall_now = std::chrono::system_clock::now().time_since_epoch();
    std::size_t count = 0;
    for (std::size_t tries = 0; tries < kBatch; ++tries) {
        sockaddr_in6 from{}; // holds a sockaddr_in, too
        iovec part{batch.bytes[count].data(), kDatagramBytes};
        msghdr header{};
        header.msg_name = &from;
        header.msg_namelen = sizeof from;
        header.msg_iov = &part;
        header.msg_iovlen = 1;
        header.msg_control = batch.control.data();
        header.msg_controllen = batch.control.size();
        const ssize_t size = recvmsg(handle_, &header, 0);
        if (size < 0 && (errno == EINTR || errno == ECONNREFUSED)) continue;
        if (size < 0) break;
        Datagram& datagram = batch.datagrams[count];
        datagram = {};
        datagram.bytes = Bytes(batch.bytes[count].data(), static_cast<std::size_t>(size));
        datagram.time = steady_now;
        datagram.from_port = ntohs(from.sin6_port); // of a sockaddr_in at the same place
        if (version_ == IpVersion::v6)
            datagram.from = address_of(from.sin6_addr);
        else
            datagram.from = ipv4_of(reinterpret_cast<const sockaddr*>(&from));
        for (cmsghdr* head = CMSG_FIRSTHDR(&header); head; head = CMSG_NXTHDR(&header, head)) {
            if (head->cmsg_level == IPPROTO_IP && head->cmsg_type == IP_RECVDSTADDR) {
                in_addr to{};
                std::memcpy(&to, CMSG_DATA(head), sizeof to);
                datagram.to = ntohl(to.s_addr);
            } else if (head->cmsg_level == IPPROTO_IP && head->cmsg_type == IP_RECVIF) {
                sockaddr_dl link{};
                std::memcpy(&link, CMSG_DATA(head),
                            std::min<std::size_t>(sizeof link, head->cmsg_len - CMSG_LEN(0)));
                datagram.interface_index = link.sdl_index;
            } else if (head->cmsg_level == IPPROTO_IPV6 && head->cmsg_type == IPV6_PKTINFO) {
                in6_pktinfo info{};
                std::memcpy(&info, CMSG_DATA(head), sizeof info);
                datagram.to = address_of(info.ipi6_addr);
                datagram.interface_index = info.ipi6_ifindex;
            } else if (head->cmsg_level == SOL_SOCKET && head->cmsg_type == SCM_TIMESTAMP) {
                timeval stamp{};
                std::memcpy(&stamp, CMSG_DATA(head), sizeof stamp);
                datagram.time = steady_time(stamp, steady_now, wall_now);
            }
        }
        if (datagram.to.is_multicast() && !batch.groups.contains({datagram.to, datagram.interface_index}))
            continue;
        if (version_ == IpVersion::v4)
            datagram.local_ipv4 = own_ipv4(batch.own, datagram.to, datagram.interface_index);
        ++count;
    }
    packets_ += count;
    return {batch.datagrams.data(), count};
}

void UdpSocket::count_overflow(std::uint32_t dropped) {
    overflow_ += dropped;
}

std::uint64_t UdpSocket::overflow() {
    return overflow_;
}

int UdpSocket::receive_buffer() const {
    int bytes = 0;
    socklen_t size = sizeof bytes;
    return getsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &bytes, &size) == 0 ? bytes : 0;
}

std::chrono::nanoseconds thread_cpu_time() {
    timespec time{};
    return clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0
               ? std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec)
               : std::chrono::nanoseconds(0);
}

// There is no ppoll(): whole milliseconds, and rather too long than again and again.
std::vector<bool> wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets,
                                   std::span<const int> handles, std::chrono::nanoseconds timeout) {
    std::vector<pollfd> entries;
    entries.reserve(sockets.size() + handles.size());
    for (const auto& socket : sockets) entries.push_back({socket->handle_, POLLIN, 0});
    for (const int handle : handles) entries.push_back({handle, POLLIN, 0});
    const auto limit =
        std::chrono::ceil<std::chrono::milliseconds>(std::max(timeout, std::chrono::nanoseconds(0)));
    const auto wait_ms = static_cast<int>(std::min<std::int64_t>(limit.count(), 0x7FFFFFFF));
    std::vector<bool> ready(sockets.size());
    if (poll(entries.data(), static_cast<nfds_t>(entries.size()), wait_ms) <= 0) return ready;
    for (std::size_t i = 0; i < ready.size(); ++i) ready[i] = entries[i].revents != 0;
    return ready;
}

} // namespace ghost::dmx
