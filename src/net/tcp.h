#pragma once
// SPDX-License-Identifier: Apache-2.0
// TCP connections that never wait: what dmx asks of the operating system besides UDP (net/socket.h). Errors
// name the address. One thread per connection.

#include "base/byte_reader.h"
#include "base/result.h"
#include "net/address.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ghost::dmx {

class TcpStream {
public:
    // Begins to; read() and send() say whether it came about. interface_index: for IPv6 addresses of the
    // link.
    static Result<std::unique_ptr<TcpStream>> connect(const IpAddress& to, std::uint16_t port,
                                                      unsigned interface_index = 0);
    ~TcpStream();
    TcpStream(const TcpStream&) = delete;
    TcpStream& operator=(const TcpStream&) = delete;

    // What has arrived, at most 64 KiB, valid until the next call; empty: nothing yet. nullopt: it is closed.
    std::optional<Bytes> read();
    // How many bytes were taken. nullopt: it is closed, or did not come about.
    std::optional<std::size_t> send(Bytes bytes);
    // Nothing more will be sent; what is on its way arrives. The other end may go on.
    void finish();
    // Why it is closed, or did not come about; empty: the other end closed it.
    const std::string& problem() const { return problem_; }
    const IpAddress& peer() const { return peer_; }
    int handle() const { return handle_; }

private:
    friend class TcpListener;
    TcpStream(int handle, const IpAddress& peer) : handle_(handle), peer_(peer) {}

    int handle_;
    IpAddress peer_;
    std::vector<std::uint8_t> buffer_;
    std::string problem_;
};

class TcpListener {
public:
    // address 0: every IPv4 and IPv6 address. port 0: one that is free. interface: the name of the only one
    // that connections may come through, whatever address they call; empty: all.
    static Result<std::unique_ptr<TcpListener>> open(std::uint32_t address, std::uint16_t port,
                                                     const std::string& interface = {});
    ~TcpListener();
    TcpListener(const TcpListener&) = delete;
    TcpListener& operator=(const TcpListener&) = delete;

    // Null: nobody is waiting.
    std::unique_ptr<TcpStream> accept();
    std::uint16_t port() const { return port_; }
    int handle() const { return handle_; }

private:
    TcpListener(int handle, std::uint16_t port) : handle_(handle), port_(port) {}

    int handle_;
    std::uint16_t port_;
    std::string interface_; // where the system does not hold to it by itself
};

// Ends a wait_for_streams() of another thread.
class StreamWake {
public:
    static Result<std::unique_ptr<StreamWake>> open();
    ~StreamWake();
    StreamWake(const StreamWake&) = delete;
    StreamWake& operator=(const StreamWake&) = delete;

    void raise(); // any thread
    void clear();
    int handle() const { return handle_; }

private:
    explicit StreamWake(int handle) : handle_(handle) {}

    int handle_;
};

struct WaitFor {
    int handle = -1;
    bool to_send = false; // also until bytes can be sent
};
// Returns when one of them has something, or after timeout.
void wait_for_streams(std::span<const WaitFor> streams, std::chrono::milliseconds timeout);

// Of this machine; empty where it has none.
std::string host_name();

} // namespace ghost::dmx
