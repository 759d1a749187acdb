// SPDX-License-Identifier: Apache-2.0
#include "net/tcp.h"

#include "net/private/system_sizes.h"

#include "net/socket.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

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

int open_socket() {
    const int handle = ::socket(AF_INET6, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (handle < 0) return handle;
    const int off = 0, on = 1;
    (void)setsockopt(handle, IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off);
    // Accepted ones have it, too. Without it a picture waits up to 40 ms behind a short message.
    (void)setsockopt(handle, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return handle;
}

bool would_wait() {
    return errno == EAGAIN || errno == EINTR || errno == ENOTCONN || errno == EINPROGRESS;
}

std::string place(const IpAddress& address, std::uint16_t port) {
    return address_text(address) + ", TCP port " + std::to_string(port);
}

} // namespace

Result<std::unique_ptr<TcpStream>> TcpStream::connect(const IpAddress& to, std::uint16_t port,
                                                      unsigned interface_index) {
    const int handle = open_socket();
    if (handle < 0)
        return Error{std::string("cannot open a socket: ") + std::strerror(errno), place(to, port)};
    std::unique_ptr<TcpStream> stream(new TcpStream(handle, to));
    const sockaddr_in6 name = name_of(to, port, interface_index);
    if (::connect(handle, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 && errno != EINPROGRESS)
        return Error{std::string("cannot connect: ") + std::strerror(errno), place(to, port)};
    return stream;
}

TcpStream::~TcpStream() {
    ::close(handle_);
}

std::optional<Bytes> TcpStream::read() {
    buffer_.resize(kReadBytes);
    const ssize_t count = ::recv(handle_, buffer_.data(), buffer_.size(), 0);
    if (count > 0) return Bytes(buffer_.data(), static_cast<std::size_t>(count));
    if (count < 0 && would_wait()) return Bytes();
    if (count < 0 && problem_.empty()) problem_ = std::strerror(errno);
    return std::nullopt;
}

std::optional<std::size_t> TcpStream::send(Bytes bytes) {
    const ssize_t count = ::send(handle_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (would_wait()) return std::size_t{0};
    if (problem_.empty()) problem_ = std::strerror(errno);
    return std::nullopt;
}

void TcpStream::finish() {
    (void)::shutdown(handle_, SHUT_WR);
}

Result<std::unique_ptr<TcpListener>> TcpListener::open(std::uint32_t address, std::uint16_t port,
                                                       const std::string& interface) {
    const IpAddress at = address ? IpAddress(address) : IpAddress();
    const int handle = open_socket();
    if (handle < 0)
        return Error{std::string("cannot open a socket: ") + std::strerror(errno), place(at, port)};
    std::unique_ptr<TcpListener> listener(new TcpListener(handle, port));
    const int on = 1;
    (void)setsockopt(handle, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (!interface.empty() && setsockopt(handle, SOL_SOCKET, SO_BINDTODEVICE, interface.c_str(),
                                         static_cast<socklen_t>(interface.size() + 1)) != 0)
        return Error{"cannot listen on the interface " + interface + " alone: " + std::strerror(errno),
                     place(at, port)};
    sockaddr_in6 name = name_of(at, port);
    socklen_t size = sizeof name;
    if (bind(handle, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 ||
        listen(handle, kWaiting) != 0 || getsockname(handle, reinterpret_cast<sockaddr*>(&name), &size) != 0)
        return Error{std::string("cannot listen: ") + std::strerror(errno), place(at, port)};
    listener->port_ = ntohs(name.sin6_port);
    return listener;
}

TcpListener::~TcpListener() {
    ::close(handle_);
}

std::unique_ptr<TcpStream> TcpListener::accept() {
    sockaddr_in6 name{};
    socklen_t size = sizeof name;
    const int handle =
        ::accept4(handle_, reinterpret_cast<sockaddr*>(&name), &size, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (handle < 0) return nullptr;
    IpAddress peer;
    std::memcpy(peer.bytes.data(), &name.sin6_addr, peer.bytes.size());
    return std::unique_ptr<TcpStream>(new TcpStream(handle, peer));
}

Result<std::unique_ptr<StreamWake>> StreamWake::open() {
    const int handle = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (handle < 0) return Error{std::string("cannot make an event: ") + std::strerror(errno), ""};
    return std::unique_ptr<StreamWake>(new StreamWake(handle));
}

StreamWake::~StreamWake() {
    ::close(handle_);
}

// A count that is full, or empty, is as good.
void StreamWake::raise() {
    (void)::eventfd_write(handle_, 1);
}

void StreamWake::clear() {
    eventfd_t count = 0;
    (void)::eventfd_read(handle_, &count);
}

void wait_for_streams(std::span<const WaitFor> streams, std::chrono::milliseconds timeout) {
    std::vector<pollfd> entries;
    entries.reserve(streams.size());
    for (const WaitFor& stream : streams)
        entries.push_back({stream.handle, static_cast<short>(stream.to_send ? POLLIN | POLLOUT : POLLIN), 0});
    (void)poll(entries.data(), entries.size(), static_cast<int>(timeout.count()));
}

std::string host_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

} // namespace ghost::dmx
