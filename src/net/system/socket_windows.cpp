// SPDX-License-Identifier: Apache-2.0
// Windows. Facts this rests on: of sockets that share a port (SO_REUSEADDR, all of them) which gets unicast
// is not said, and one that asks for nothing is refused where another has the port, but keeps none out that
// share; an answer "nobody listens there" would end the next receive, unless that is turned off
// (SIO_UDP_CONNRESET). Packets of groups that others joined are left out here, whether the system hands them
// on (Wine) or not. Windows tells neither when a packet came nor how many it dropped.
#include "net/private/ports.h"
#include "net/private/system_sizes.h"
#include "net/private/winsock.h"
#include "net/socket.h"

#include <algorithm>
#include <array>
#include <set>
#include <thread>
#include <utility>

#ifndef SIO_UDP_CONNRESET
#define SIO_UDP_CONNRESET _WSAIOW(IOC_VENDOR, 12)
#endif

namespace ghost::dmx {

namespace {

constexpr std::chrono::seconds kListEvery{2};

sockaddr_in6 socket_address6(const IpAddress& ipv6, std::uint16_t port) {
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    std::memcpy(&address.sin6_addr, ipv6.bytes.data(), ipv6.bytes.size());
    address.sin6_port = htons(port);
    return address;
}

sockaddr_in socket_address(std::uint32_t ipv4, std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(ipv4);
    address.sin_port = htons(port);
    return address;
}

IpAddress address_of(const in6_addr& ipv6) {
    IpAddress address;
    std::memcpy(address.bytes.data(), &ipv6, address.bytes.size());
    return address;
}

// The call that tells where a packet was sent to; null: there is none.
LPFN_WSARECVMSG receive_call(int handle) {
    GUID which = WSAID_WSARECVMSG;
    LPFN_WSARECVMSG call = nullptr;
    DWORD size = 0;
    return ::WSAIoctl(socket_of(handle), SIO_GET_EXTENSION_FUNCTION_POINTER, &which, sizeof which, &call,
                      sizeof call, &size, nullptr, nullptr) == 0
               ? call
               : nullptr;
}

} // namespace

int open_windows_socket(int family, int type) {
    if (!need_winsock()) return -1;
    const SOCKET socket =
        ::WSASocketW(family, type, 0, nullptr, 0, WSA_FLAG_OVERLAPPED | WSA_FLAG_NO_HANDLE_INHERIT);
    u_long on = 1;
    if (socket != INVALID_SOCKET) (void)::ioctlsocket(socket, static_cast<long>(FIONBIO), &on);
    return number_of(socket);
}

struct UdpSocket::Batch {
    std::array<std::array<std::uint8_t, kDatagramBytes>, kBatch> bytes;
    std::array<Datagram, kBatch> datagrams;
    alignas(WSACMSGHDR) std::array<char, 256> control;
    LPFN_WSARECVMSG receive = nullptr;
    std::set<std::pair<IpAddress, unsigned>> groups; // that it is in, each with the interface
    // Which address of ours a packet to a group or to all came by.
    std::vector<NetInterface> interfaces;
    std::chrono::nanoseconds listed{0};

    std::uint32_t local_ipv4(std::uint32_t to, unsigned index, std::chrono::nanoseconds now) {
        if (interfaces.empty() || now - listed > kListEvery) {
            interfaces = list_interfaces();
            listed = now;
        }
        std::uint32_t first = 0;
        for (const NetInterface& one : interfaces) {
            if (one.index != index) continue;
            if (one.address == to ||
                (one.loopback && to != one.broadcast && ((one.address ^ to) & one.netmask) == 0))
                return to;
            if (first == 0) first = one.address;
        }
        return first;
    }
};

UdpSocket::UdpSocket(int handle, IpVersion version)
    : handle_(handle), version_(version), batch_(std::make_unique<Batch>()) {
    batch_->receive = receive_call(handle);
}

UdpSocket::~UdpSocket() {
    ::closesocket(socket_of(handle_));
}

Result<std::unique_ptr<UdpSocket>> UdpSocket::open_bound(IpVersion version, std::uint32_t address,
                                                         std::uint16_t port, int receive_buffer_bytes,
                                                         bool shared) {
    const bool v6 = version == IpVersion::v6;
    const std::string place = port_place(version, address, port);
    const int handle = open_windows_socket(v6 ? AF_INET6 : AF_INET, SOCK_DGRAM);
    if (handle == -1) return Error{"cannot open a socket: " + socket_reason(), place};
    std::unique_ptr<UdpSocket> result(new UdpSocket(handle, version));
    (void)set_option(handle, SOL_SOCKET, SO_RCVBUF, receive_buffer_bytes);
    const DWORD on = 1;
    BOOL reports = FALSE;
    DWORD size = 0;
    (void)::WSAIoctl(socket_of(handle), SIO_UDP_CONNRESET, &reports, sizeof reports, nullptr, 0, &size,
                     nullptr, nullptr);
    const bool set = (!shared || set_option(handle, SOL_SOCKET, SO_REUSEADDR, on)) &&
                     result->batch_->receive != nullptr &&
                     (v6 ? set_option(handle, IPPROTO_IPV6, IPV6_V6ONLY, on) &&
                               set_option(handle, IPPROTO_IPV6, IPV6_PKTINFO, on)
                         : set_option(handle, SOL_SOCKET, SO_BROADCAST, on) &&
                               set_option(handle, IPPROTO_IP, IP_PKTINFO, on));
    if (!set) return Error{"cannot set up the socket: " + socket_reason(), place};
    const sockaddr_in name = socket_address(address, port);
    const sockaddr_in6 name6 = socket_address6({}, port);
    const bool bound =
        v6 ? ::bind(socket_of(handle), reinterpret_cast<const sockaddr*>(&name6), sizeof name6) == 0
           : ::bind(socket_of(handle), reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
    if (!bound) {
        const int code = ::WSAGetLastError();
        if (code == WSAEADDRINUSE || code == WSAEACCES) return port_taken(port, place);
        return Error{"cannot listen: " + socket_reason(code), place};
    }
    if (!shared)
        (void)set_option(handle, SOL_SOCKET, SO_REUSEADDR, on); // refused by Windows, asked for by Wine
    return result;
}

namespace {

// An interface without IPv4 goes by its number, which stands in place of an address: 0.x.x.x.
ip_mreq request4(const IpAddress& group, const NetInterface& interface) {
    ip_mreq request{};
    request.imr_multiaddr.s_addr = htonl(group.ipv4());
    request.imr_interface.s_addr = htonl(interface.address != 0 ? interface.address : interface.index);
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
    const bool joined =
        version_ == IpVersion::v6
            ? set_option(handle_, IPPROTO_IPV6, IPV6_ADD_MEMBERSHIP, request6(group, interface))
            : set_option(handle_, IPPROTO_IP, IP_ADD_MEMBERSHIP, request4(group, interface));
    const int code = joined ? 0 : ::WSAGetLastError();
    // Of a group that it is in already Windows says that it cannot be had again.
    if (!joined && code != WSAEADDRINUSE && code != WSAEINVAL)
        return Error{"cannot join " + address_text(group) + ": " + socket_reason(code), interface.name};
    batch_->groups.insert({group, interface.index});
    return {};
}

void UdpSocket::leave(const IpAddress& group, const NetInterface& interface) {
    if (version_ == IpVersion::v6)
        (void)set_option(handle_, IPPROTO_IPV6, IPV6_DROP_MEMBERSHIP, request6(group, interface));
    else
        (void)set_option(handle_, IPPROTO_IP, IP_DROP_MEMBERSHIP, request4(group, interface));
    batch_->groups.erase({group, interface.index});
}

Result<void> UdpSocket::send_multicast_through(const NetInterface& interface) {
    const bool set =
        version_ == IpVersion::v6
            ? set_option(handle_, IPPROTO_IPV6, IPV6_MULTICAST_IF, static_cast<DWORD>(interface.index))
            : set_option(handle_, IPPROTO_IP, IP_MULTICAST_IF,
                         request4(std::uint32_t{0}, interface).imr_interface);
    if (set) return {};
    return Error{"cannot send multicast through it: " + socket_reason(), interface.name};
}

Result<void> UdpSocket::send(Bytes bytes, const IpAddress& to, std::uint16_t port) {
    const sockaddr_in name = socket_address(to.ipv4(), port);
    const sockaddr_in6 name6 = socket_address6(to, port);
    const bool v6 = version_ == IpVersion::v6;
    for (;;) {
        const int sent = ::sendto(
            socket_of(handle_), reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size()),
            0, v6 ? reinterpret_cast<const sockaddr*>(&name6) : reinterpret_cast<const sockaddr*>(&name),
            v6 ? sizeof name6 : sizeof name);
        if (sent == static_cast<int>(bytes.size())) return {};
        const int code = ::WSAGetLastError();
        if (code == WSAECONNRESET) continue; // an answer to an earlier packet
        if (code == WSAEWOULDBLOCK) {
            WSAPOLLFD entry{socket_of(handle_), POLLWRNORM, 0};
            if (::WSAPoll(&entry, 1, 100) > 0) continue;
        }
        return Error{"cannot send: " + socket_reason(code), address_text(to) + ":" + std::to_string(port)};
    }
}

std::span<const Datagram> UdpSocket::receive() {
    Batch& batch = *batch_;
    std::size_t count = 0;
    const std::chrono::nanoseconds now = std::chrono::steady_clock::now().time_since_epoch();
    int refused = 0;
    for (std::size_t tries = 0; tries < kBatch && count < kBatch; ++tries) {
        sockaddr_in6 from{}; // holds a sockaddr_in, too
        WSABUF part{static_cast<ULONG>(kDatagramBytes), reinterpret_cast<char*>(batch.bytes[count].data())};
        WSAMSG message{};
        message.name = reinterpret_cast<sockaddr*>(&from);
        message.namelen = sizeof from;
        message.lpBuffers = &part;
        message.dwBufferCount = 1;
        message.Control = {static_cast<ULONG>(batch.control.size()), batch.control.data()};
        DWORD size = 0;
        if (batch.receive(socket_of(handle_), &message, &size, nullptr, nullptr) != 0) {
            const int code = ::WSAGetLastError();
            if (code == WSAEMSGSIZE)
                size = static_cast<DWORD>(kDatagramBytes); // cut
            else if (code == WSAECONNRESET && ++refused < static_cast<int>(kBatch))
                continue;
            else
                break;
        }
        Datagram& datagram = batch.datagrams[count];
        datagram = {};
        datagram.bytes = Bytes(batch.bytes[count].data(), std::min<std::size_t>(size, kDatagramBytes));
        datagram.time = now;
        datagram.from_port = ntohs(from.sin6_port); // of a sockaddr_in at the same place
        if (version_ == IpVersion::v6) {
            datagram.from = address_of(from.sin6_addr);
        } else {
            sockaddr_in from4{};
            std::memcpy(&from4, &from, sizeof from4);
            datagram.from = ntohl(from4.sin_addr.s_addr);
        }
        for (WSACMSGHDR* head = WSA_CMSG_FIRSTHDR(&message); head != nullptr;
             head = WSA_CMSG_NXTHDR(&message, head)) {
            if (head->cmsg_level == IPPROTO_IP && head->cmsg_type == IP_PKTINFO) {
                IN_PKTINFO info{};
                std::memcpy(&info, WSA_CMSG_DATA(head), sizeof info);
                datagram.to = ntohl(info.ipi_addr.s_addr);
                datagram.interface_index = info.ipi_ifindex;
                datagram.local_ipv4 = batch.local_ipv4(ntohl(info.ipi_addr.s_addr), info.ipi_ifindex, now);
            } else if (head->cmsg_level == IPPROTO_IPV6 && head->cmsg_type == IPV6_PKTINFO) {
                IN6_PKTINFO info{};
                std::memcpy(&info, WSA_CMSG_DATA(head), sizeof info);
                datagram.to = address_of(info.ipi6_addr);
                datagram.interface_index = info.ipi6_ifindex;
            }
        }
        if (datagram.to.is_multicast() && !batch.groups.contains({datagram.to, datagram.interface_index}))
            continue;
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
    int size = sizeof bytes;
    return ::getsockopt(socket_of(handle_), SOL_SOCKET, SO_RCVBUF, reinterpret_cast<char*>(&bytes), &size) ==
                   0
               ? bytes
               : 0;
}

std::chrono::nanoseconds thread_cpu_time() {
    FILETIME begun{}, ended{}, kernel{}, user{};
    if (!::GetThreadTimes(::GetCurrentThread(), &begun, &ended, &kernel, &user))
        return std::chrono::nanoseconds(0);
    const auto ticks = [](const FILETIME& time) {
        return static_cast<std::int64_t>(std::uint64_t{time.dwHighDateTime} << 32 | time.dwLowDateTime);
    };
    return std::chrono::nanoseconds(100 * (ticks(kernel) + ticks(user)));
}

namespace {

// Windows waits in whole milliseconds; a wait that is over too early would only be asked for again and again.
DWORD whole_ms(std::chrono::nanoseconds time) {
    const auto ms = std::chrono::ceil<std::chrono::milliseconds>(std::max(time, std::chrono::nanoseconds(0)));
    return static_cast<DWORD>(std::min<std::int64_t>(ms.count(), 0x7FFFFFFF));
}

} // namespace

// Handles are events (serial ports) and cannot be polled together with sockets; so those tell an event, too.
std::vector<bool> wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets,
                                   std::span<const int> handles, std::chrono::nanoseconds timeout) {
    std::vector<bool> ready(sockets.size());
    std::vector<WSAPOLLFD> entries;
    for (const auto& socket : sockets) entries.push_back({socket_of(socket->handle_), POLLRDNORM, 0});
    const auto poll = [&](DWORD wait_ms) {
        return !entries.empty() &&
               ::WSAPoll(entries.data(), static_cast<ULONG>(entries.size()), static_cast<INT>(wait_ms)) > 0;
    };
    const auto found = [&] {
        for (std::size_t i = 0; i < ready.size(); ++i) ready[i] = entries[i].revents != 0;
        return ready;
    };
    if (handles.empty()) {
        if (entries.empty()) std::this_thread::sleep_for(std::max(timeout, std::chrono::nanoseconds(0)));
        return poll(whole_ms(timeout)) ? found() : ready;
    }
    const WSAEVENT event = ::WSACreateEvent();
    for (const auto& socket : sockets)
        (void)::WSAEventSelect(socket_of(socket->handle_), event, FD_READ | FD_CLOSE);
    std::vector<HANDLE> all{event};
    for (std::size_t k = 0; k < handles.size() && all.size() < MAXIMUM_WAIT_OBJECTS; ++k)
        all.push_back(reinterpret_cast<HANDLE>(static_cast<INT_PTR>(handles[k])));
    (void)::WaitForMultipleObjects(static_cast<DWORD>(all.size()), all.data(), FALSE, whole_ms(timeout));
    for (const auto& socket : sockets) (void)::WSAEventSelect(socket_of(socket->handle_), nullptr, 0);
    ::WSACloseEvent(event);
    return poll(0) ? found() : ready;
}

} // namespace ghost::dmx
