// SPDX-License-Identifier: Apache-2.0
// Windows binds no socket to an interface alone. But it takes a connection only by the interface that has the
// address that is called (the "strong host" of RFC 1122), so what was called says by which it came.
#include "net/private/system_sizes.h"
#include "net/private/winsock.h"
#include "net/socket.h"
#include "net/tcp.h"

#include <algorithm>
#include <array>

namespace ghost::dmx {

namespace {

// IPv4 addresses as mapped ones: one kind of socket for both.
sockaddr_in6 name_of(const IpAddress& address, std::uint16_t port, unsigned interface_index = 0) {
    sockaddr_in6 name{};
    name.sin6_family = AF_INET6;
    name.sin6_port = htons(port);
    name.sin6_scope_id = interface_index;
    std::memcpy(&name.sin6_addr, address.bytes.data(), address.bytes.size());
    return name;
}

IpAddress address_in(const sockaddr_in6& name) {
    IpAddress address;
    std::memcpy(address.bytes.data(), &name.sin6_addr, address.bytes.size());
    return address;
}

int open_stream() {
    const int handle = open_windows_socket(AF_INET6, SOCK_STREAM);
    if (handle == -1) return handle;
    const DWORD off = 0, on = 1;
    (void)set_option(handle, IPPROTO_IPV6, IPV6_V6ONLY, off);
    // Accepted ones have it, too. Without it a picture waits up to 40 ms behind a short message.
    (void)set_option(handle, IPPROTO_TCP, TCP_NODELAY, on);
    return handle;
}

// Of a connection that did not come about.
int refusal_of(SOCKET socket) {
    int why = 0, size = sizeof why;
    (void)::getsockopt(socket, SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&why), &size);
    return why != 0 ? why : WSAECONNREFUSED;
}

// What a call that failed means; 0: nothing yet, try again later. A connection that did not come about is
// "not connected" to reading and sending, and says why only when it is asked.
int failure_of(int handle) {
    const int code = ::WSAGetLastError();
    if (code == WSAEWOULDBLOCK || code == WSAEINTR || code == WSAEINPROGRESS) return 0;
    if (code != WSAENOTCONN) return code;
    const SOCKET socket = socket_of(handle);
    fd_set refused;
    FD_ZERO(&refused);
    FD_SET(socket, &refused);
    timeval now{0, 0};
    return ::select(0, nullptr, nullptr, &refused, &now) > 0 ? refusal_of(socket) : 0;
}

// One that ended has had another end; Wine tells of one that was refused as if it had ended.
bool was_connected(SOCKET socket) {
    sockaddr_in6 name{};
    int size = sizeof name;
    return ::getpeername(socket, reinterpret_cast<sockaddr*>(&name), &size) == 0;
}

std::string stream_place(const IpAddress& address, std::uint16_t port) {
    return address_text(address) + ", TCP port " + std::to_string(port);
}

bool has_address(const std::string& interface, const IpAddress& address) {
    const std::vector<NetInterface> all = list_interfaces();
    return std::any_of(all.begin(), all.end(), [&](const NetInterface& one) {
        if (one.name != interface) return false;
        if (one.loopback) return address.is_loopback();
        // Of IPv6 the list has no addresses; those of the link name their interface, which is looked at by
        // the caller.
        return address.is_ipv4() && one.address == address.ipv4();
    });
}

bool is_index_of(const std::string& interface, unsigned index) {
    const std::vector<NetInterface> all = list_interfaces();
    return index != 0 && std::any_of(all.begin(), all.end(), [&](const NetInterface& one) {
               return one.name == interface && one.index == index;
           });
}

} // namespace

Result<std::unique_ptr<TcpStream>> TcpStream::connect(const IpAddress& to, std::uint16_t port,
                                                      unsigned interface_index) {
    const int handle = open_stream();
    if (handle == -1) return Error{"cannot open a socket: " + socket_reason(), stream_place(to, port)};
    std::unique_ptr<TcpStream> stream(new TcpStream(handle, to));
    const sockaddr_in6 name = name_of(to, port, interface_index);
    if (::connect(socket_of(handle), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 &&
        ::WSAGetLastError() != WSAEWOULDBLOCK)
        return Error{"cannot connect: " + socket_reason(), stream_place(to, port)};
    return stream;
}

TcpStream::~TcpStream() {
    ::closesocket(socket_of(handle_));
}

std::optional<Bytes> TcpStream::read() {
    buffer_.resize(kReadBytes);
    const int count =
        ::recv(socket_of(handle_), reinterpret_cast<char*>(buffer_.data()), static_cast<int>(kReadBytes), 0);
    if (count > 0) return Bytes(buffer_.data(), static_cast<std::size_t>(count));
    const SOCKET socket = socket_of(handle_);
    if (count == 0 && was_connected(socket)) return std::nullopt;
    const int why = count == 0 ? refusal_of(socket) : failure_of(handle_);
    if (why == 0) return Bytes();
    if (problem_.empty()) problem_ = socket_reason(why);
    return std::nullopt;
}

std::optional<std::size_t> TcpStream::send(Bytes bytes) {
    const auto most = static_cast<int>(std::min<std::size_t>(bytes.size(), std::size_t{1} << 20));
    const int count = ::send(socket_of(handle_), reinterpret_cast<const char*>(bytes.data()), most, 0);
    if (count >= 0) return static_cast<std::size_t>(count);
    const int why = failure_of(handle_);
    if (why == 0) return std::size_t{0};
    if (problem_.empty()) problem_ = socket_reason(why);
    return std::nullopt;
}

void TcpStream::finish() {
    (void)::shutdown(socket_of(handle_), SD_SEND);
}

Result<std::unique_ptr<TcpListener>> TcpListener::open(std::uint32_t address, std::uint16_t port,
                                                       const std::string& interface) {
    const IpAddress at = address ? IpAddress(address) : IpAddress();
    const int handle = open_stream();
    if (handle == -1) return Error{"cannot open a socket: " + socket_reason(), stream_place(at, port)};
    std::unique_ptr<TcpListener> listener(new TcpListener(handle, port));
    listener->interface_ = interface;
    if (!interface.empty() && !find_interface(interface).ok())
        return Error{"cannot listen on the interface " + interface + " alone: there is none of this name",
                     stream_place(at, port)};
    // What elsewhere lets a port be used again at once would here let another program take it.
    const DWORD on = 1;
    (void)set_option(handle, SOL_SOCKET, SO_EXCLUSIVEADDRUSE, on);
    sockaddr_in6 name = name_of(at, port);
    int size = sizeof name;
    const SOCKET socket = socket_of(handle);
    if (::bind(socket, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 ||
        ::listen(socket, kWaiting) != 0 ||
        ::getsockname(socket, reinterpret_cast<sockaddr*>(&name), &size) != 0)
        return Error{"cannot listen: " + socket_reason(), stream_place(at, port)};
    listener->port_ = ntohs(name.sin6_port);
    return listener;
}

TcpListener::~TcpListener() {
    ::closesocket(socket_of(handle_));
}

std::unique_ptr<TcpStream> TcpListener::accept() {
    for (;;) {
        sockaddr_in6 name{}, called{};
        int size = sizeof name, called_size = sizeof called;
        const SOCKET socket = ::accept(socket_of(handle_), reinterpret_cast<sockaddr*>(&name), &size);
        if (socket == INVALID_SOCKET) return nullptr;
        std::unique_ptr<TcpStream> stream(new TcpStream(number_of(socket), address_in(name)));
        (void)::SetHandleInformation(reinterpret_cast<HANDLE>(socket), HANDLE_FLAG_INHERIT, 0);
        u_long on = 1;
        (void)::ioctlsocket(socket, static_cast<long>(FIONBIO), &on);
        if (interface_.empty()) return stream;
        (void)::getsockname(socket, reinterpret_cast<sockaddr*>(&called), &called_size);
        if (has_address(interface_, address_in(called)) || is_index_of(interface_, called.sin6_scope_id))
            return stream;
    }
}

// Windows can wait for sockets alone: one that is connected to itself.
Result<std::unique_ptr<StreamWake>> StreamWake::open() {
    const int handle = open_windows_socket(AF_INET, SOCK_DGRAM);
    if (handle == -1) return Error{"cannot make an event: " + socket_reason(), ""};
    std::unique_ptr<StreamWake> wake(new StreamWake(handle));
    const SOCKET socket = socket_of(handle);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    int size = sizeof name;
    if (::bind(socket, reinterpret_cast<const sockaddr*>(&name), size) != 0 ||
        ::getsockname(socket, reinterpret_cast<sockaddr*>(&name), &size) != 0 ||
        ::connect(socket, reinterpret_cast<const sockaddr*>(&name), size) != 0)
        return Error{"cannot make an event: " + socket_reason(), ""};
    return wake;
}

StreamWake::~StreamWake() {
    ::closesocket(socket_of(handle_));
}

// Where there is no room for one more byte, there are enough.
void StreamWake::raise() {
    (void)::send(socket_of(handle_), "!", 1, 0);
}

void StreamWake::clear() {
    std::array<char, 16> bytes;
    while (::recv(socket_of(handle_), bytes.data(), static_cast<int>(bytes.size()), 0) > 0) {
    }
}

void wait_for_streams(std::span<const WaitFor> streams, std::chrono::milliseconds timeout) {
    std::vector<WSAPOLLFD> entries;
    entries.reserve(streams.size());
    for (const WaitFor& stream : streams)
        if (stream.handle != -1)
            entries.push_back({socket_of(stream.handle),
                               static_cast<SHORT>(stream.to_send ? POLLRDNORM | POLLWRNORM : POLLRDNORM), 0});
    const auto wait_ms = static_cast<INT>(timeout.count());
    if (entries.empty())
        ::Sleep(static_cast<DWORD>(std::max(wait_ms, 0)));
    else
        (void)::WSAPoll(entries.data(), static_cast<ULONG>(entries.size()), wait_ms);
}

std::string host_name() {
    std::array<char, 256> name{};
    return need_winsock() && ::gethostname(name.data(), static_cast<int>(name.size()) - 1) == 0
               ? std::string(name.data())
               : std::string();
}

} // namespace ghost::dmx
