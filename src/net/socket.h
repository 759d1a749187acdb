#pragma once
// SPDX-License-Identifier: Apache-2.0
// UDP over IPv4 and IPv6 and the list of network interfaces: everything that dmx asks of the operating
// system. IPv4 addresses are in host byte order. One thread per socket. Errors name the port or the
// interface.

#include "base/byte_reader.h"
#include "base/result.h"
#include "net/address.h"

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
    std::uint32_t address = 0; // 0: it has IPv6 only
    std::uint32_t netmask = 0;
    std::uint32_t broadcast = 0;
    bool loopback = false;
    bool running = true;  // the cable is in
    bool ipv6 = false;    // it has an IPv6 address, too
    bool bridged = false; // a port of a bridge, which has the address

    bool operator==(const NetInterface&) const = default;
};

// A neighbour on its network: no router is between (RFC 6762, 11).
bool is_on_link(const NetInterface& interface, const IpAddress& from);

// Interfaces that are up, one entry per IPv4 address; one more for each with IPv6 addresses only.
std::vector<NetInterface> list_interfaces();
// By name or by address; an address of a loopback network (127.0.0.2) need not be configured. Error: lists
// what there is.
Result<NetInterface> find_interface(const std::string& name_or_address);

Result<std::uint32_t> parse_ipv4(const std::string& text);
Result<IpAddress> parse_address(const std::string& text); // IPv4 or IPv6
std::string ipv4_text(std::uint32_t address);

struct Datagram {
    Bytes bytes; // valid until the next receive() of the same socket
    IpAddress from;
    std::uint16_t from_port = 0;
    IpAddress to;                 // destination in the packet: ours, a broadcast or a group
    std::uint32_t local_ipv4 = 0; // our address on the interface it came through
    unsigned interface_index = 0;
    std::chrono::nanoseconds time{0}; // when the kernel got it, as std::chrono::steady_clock
};

enum class IpVersion { v4, v6 };

class UdpSocket {
public:
    // address 0: every address. receive_buffer_bytes: asked for; receive_buffer() says what was granted.
    static Result<std::unique_ptr<UdpSocket>> open(std::uint32_t address, std::uint16_t port,
                                                   int receive_buffer_bytes);
    // Every address and this port, to send from, where no other program has it; those that come later share
    // it, and get its unicast.
    static Result<std::unique_ptr<UdpSocket>> open_if_free(std::uint16_t port, int receive_buffer_bytes);
    // Every IPv6 address, and no IPv4.
    static Result<std::unique_ptr<UdpSocket>> open_ipv6(std::uint16_t port, int receive_buffer_bytes);
    ~UdpSocket();
    UdpSocket(const UdpSocket&) = delete;
    UdpSocket& operator=(const UdpSocket&) = delete;

    // A group of the socket's IP version.
    Result<void> join(const IpAddress& group, const NetInterface& interface);
    void leave(const IpAddress& group, const NetInterface& interface); // also of an interface that is gone
    Result<void> send_multicast_through(const NetInterface& interface);
    Result<void> send(Bytes bytes, const IpAddress& to, std::uint16_t port);
    // What is waiting, at most 64; empty when nothing is.
    std::span<const Datagram> receive();
    std::uint64_t packets() const { return packets_; } // received since open
    std::uint64_t overflow();                          // dropped by the kernel since open, up to now
    IpVersion version() const { return version_; }
    int receive_buffer() const;

private:
    struct Batch;
    UdpSocket(int handle, IpVersion version);
    static Result<std::unique_ptr<UdpSocket>> open_bound(IpVersion version, std::uint32_t address,
                                                         std::uint16_t port, int receive_buffer_bytes,
                                                         bool shared = true);
    friend std::vector<bool> wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets,
                                              std::span<const int> handles, std::chrono::nanoseconds timeout);

    void count_overflow(std::uint32_t dropped);

    int handle_;
    IpVersion version_;
    std::uint64_t packets_ = 0, overflow_ = 0;
    std::unique_ptr<Batch> batch_;
};

// Processor time of the calling thread.
std::chrono::nanoseconds thread_cpu_time();

// Returns when a socket has a packet or one of the handles bytes, or after timeout; which of the sockets
// have.
std::vector<bool> wait_for_packets(std::span<const std::unique_ptr<UdpSocket>> sockets,
                                   std::span<const int> handles, std::chrono::nanoseconds timeout);

} // namespace ghost::dmx
