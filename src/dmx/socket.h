#pragma once
// SPDX-License-Identifier: Apache-2.0
// UDP over IPv4 and the list of network interfaces: everything that dmx asks of the operating system. IPv4
// addresses are in host byte order. One thread per socket. Errors name the port or the interface.

#include "base/byte_reader.h"
#include "base/result.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ghost::dmx {

struct NetInterface {
    std::string name;
    unsigned index = 0;
    std::uint32_t address = 0;
    std::uint32_t netmask = 0;
    std::uint32_t broadcast = 0;
    bool loopback = false;
};

// Interfaces that are up and have an IPv4 address, one entry per address.
std::vector<NetInterface> list_interfaces();
// By name or by address; an address of a loopback network (127.0.0.2) need not be configured. Error: lists
// what there is.
Result<NetInterface> find_interface(const std::string& name_or_address);

Result<std::uint32_t> parse_ipv4(const std::string& text);
std::string ipv4_text(std::uint32_t address);

struct Datagram {
    Bytes bytes; // valid until the next receive() of the same socket
    std::uint32_t from_ipv4 = 0;
    std::uint16_t from_port = 0;
    std::uint32_t to_ipv4 = 0;    // destination in the packet: ours, a broadcast or a group
    std::uint32_t local_ipv4 = 0; // our address on the interface it came through
    unsigned interface_index = 0;
};

class UdpSocket {
public:
    // address 0: every address. receive_buffer_bytes: asked for; receive_buffer() says what was granted.
    static Result<std::unique_ptr<UdpSocket>> open(std::uint32_t address, std::uint16_t port,
                                                   int receive_buffer_bytes);
    ~UdpSocket();
    UdpSocket(const UdpSocket&) = delete;
    UdpSocket& operator=(const UdpSocket&) = delete;

    Result<void> join(std::uint32_t group, const NetInterface& interface);
    Result<void> send_multicast_through(const NetInterface& interface);
    Result<void> send(Bytes bytes, std::uint32_t ipv4, std::uint16_t port);
    // What is waiting, at most 64; empty when nothing is.
    std::span<const Datagram> receive();
    std::uint64_t overflow() const { return overflow_; } // dropped by the kernel since open
    int receive_buffer() const;

private:
    struct Batch;
    explicit UdpSocket(int handle);
    friend void wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets,
                                 std::chrono::nanoseconds timeout);

    int handle_;
    std::uint64_t overflow_ = 0;
    std::unique_ptr<Batch> batch_;
};

// Returns when a socket has a packet, or after timeout.
void wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets, std::chrono::nanoseconds timeout);

} // namespace ghost::dmx
