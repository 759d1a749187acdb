#pragma once
// SPDX-License-Identifier: Apache-2.0
// Listener: the receiver's sockets: which addresses, ports and groups it listens on, and what becomes of them
// when interfaces come and go (looked at once a second). Hands on each datagram once, whichever sockets got a
// copy. Opened by one thread, then used by one.

#include "dmx/receive/private/groups.h"
#include "dmx/receive/receiver_options.h"
#include "dmx/receive/statistics.h"

#include <functional>
#include <optional>

namespace ghost::dmx {

class Listener {
public:
    // Error: unknown interface, or a port that is taken (named). announced: universes whose groups are
    // joined.
    static Result<std::unique_ptr<Listener>> open(const ReceiverOptions& options,
                                                  const std::vector<std::uint16_t>& announced);

    // Returns when a packet is there or one of the handles has bytes, or after timeout.
    void wait(std::span<const int> handles, std::chrono::nanoseconds timeout) {
        ready_ = wait_for_packets(sockets_, handles, timeout);
    }
    // Everything that waited then, at most 4096 packets a socket. False: there is more.
    // elsewhere: gets what came by another interface than the chosen one.
    using Take = std::function<void(const Datagram&, Protocol)>;
    bool drain(const Take& take, const Take& elsewhere);
    // Sorted universes whose groups are joined, too: on our interfaces, and on all others where one was
    // chosen.
    struct More {
        std::vector<std::uint16_t> here, elsewhere;
        bool operator==(const More&) const = default;
    };
    // Looks at the interfaces again.
    void check(const More& more, std::chrono::nanoseconds now);

    // Joins the groups of these universes instead, without a gap for those that stay. What cannot be joined
    // is noted with the changes of links.
    void announce(const std::vector<std::uint16_t>& universes, std::chrono::nanoseconds now);

    UdpSocket* artnet_out() const { return artnet_out_; } // null: no Art-Net
    const std::optional<NetInterface>& chosen() const { return chosen_; }
    const std::vector<NetInterface>& interfaces() const { return interfaces_; } // each once, the chosen only
    bool is_own(const IpAddress& address) const;
    bool is_local_network(std::uint32_t ipv4) const;
    const std::vector<std::string>& warnings() const { return warnings_; }
    // Packets that the kernel dropped because a socket was full, up to now.
    std::uint64_t overflow() const;
    void report(Statistics& statistics) const;

private:
    struct Role {
        Protocol protocol = Protocol::sacn;
        std::string name;
        bool groups = false; // made for multicast: what is broadcast reaches another socket as well
    };

    explicit Listener(const ReceiverOptions& options) : options_(options) {}
    Result<void> open_all(const std::vector<std::uint16_t>& announced);
    Result<UdpSocket*> add(Protocol protocol, std::uint32_t address, bool groups, bool ipv6);
    Result<void> open_chosen();
    void close(UdpSocket* socket);
    void look_at_interfaces();
    void note(const std::string& text, std::chrono::nanoseconds now, bool is_loss = false,
              unsigned interface_index = 0);
    std::string failed_joins() const;
    void join_groups(const More& more);
    std::vector<NetInterface> other_interfaces() const;
    enum class Way { ours, elsewhere, twice };
    Way way_of(const Datagram& datagram, const Role& role) const;

    ReceiverOptions options_;
    std::vector<std::uint16_t> announced_;
    std::vector<NetInterface> all_, interfaces_;
    std::optional<NetInterface> chosen_;
    std::vector<std::unique_ptr<UdpSocket>> sockets_;
    std::vector<Role> roles_; // of sockets_
    std::vector<bool> ready_; // which of them have packets
    UdpSocket* artnet_plain_ = nullptr;
    UdpSocket* artnet_out_ = nullptr;
    std::optional<Groups> groups4_, groups6_;
    std::optional<Groups> elsewhere4_; // on interfaces that are not ours
    More more_;
    std::vector<std::string> warnings_;
    std::uint64_t closed_overflow_ = 0;
    std::vector<LinkChange> link_changes_;
};

} // namespace ghost::dmx
