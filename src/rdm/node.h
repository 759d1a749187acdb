#pragma once
// SPDX-License-Identifier: Apache-2.0
// Node: all devices of a show behind their Art-Net ports: who is there, and messages to them. A node of
// Art-Net finds its devices itself, so a controller gets the table at once, in as many packets as it needs;
// of a port of ours without devices one that says so. A port is ours where ArtPollReply names it, and where
// it had devices. now: of any steady clock. No sockets, one thread.

#include "rdm/artnet.h"
#include "rdm/askers.h"
#include "rdm/responder.h"

#include <functional>
#include <map>
#include <set>

namespace ghost::rdm {

inline constexpr std::size_t kMaxDevices = 16384;

class Node {
public:
    // artnet_offset: universe = Port-Address + this.
    explicit Node(int artnet_offset = 1) : artnet_offset_(artnet_offset) {}

    // Those of the show, as they are now; the first kMaxDevices. Those that were known keep their mutes and
    // queues. Where some came, went or moved to another universe news() has the tables.
    void update(std::vector<Device> devices);

    // What goes back to who sent it; nothing where it is not ours. port_of: of a Port-Address, as our
    // ArtPollReply names it, if one does.
    using Packets = std::vector<std::vector<std::uint8_t>>;
    using PortOf = std::function<std::optional<Port>(std::uint16_t port_address)>;
    struct Sender {
        std::uint32_t ipv4 = 0; // host byte order
        std::chrono::nanoseconds now{0};
    };
    Packets take(Bytes packet, const Sender& from, const Responder::Wants& wants, const PortOf& port_of);
    // A table that changed, for a controller that asked for it before. Call until there is none.
    struct News {
        std::uint32_t to_ipv4 = 0;
        Packets packets;
    };
    std::optional<News> news(std::chrono::nanoseconds now, const PortOf& port_of);

    std::size_t devices() const { return responders_.size(); }
    const Device* find(const Uid& uid) const;
    // What the sensors of a device have now.
    void feel(const Uid& uid, std::span<const std::int16_t> values);
    // What desks know of a device.
    struct Heard {
        bool is_found = false; // it was in a table that a desk got
        std::uint64_t messages = 0;
    };
    Heard heard(const Uid& uid) const;
    std::uint64_t messages() const { return messages_; }
    std::uint64_t faults() const { return faults_; } // messages that are none

private:
    void note_changes(const std::map<int, std::set<Uid>>& before);
    void put_table(std::uint16_t port_address, const Port& port, Packets& out);
    void answer_table(std::uint16_t port_address, const Sender& from, const PortOf& port_of, Packets& out);
    void answer(const ArtRdm& rdm, const Sender& from, const Responder::Wants& wants, Packets& out);
    int universe_of(std::uint16_t port_address) const { return port_address + artnet_offset_; }

    int artnet_offset_;
    std::map<Uid, Responder> responders_;
    std::map<Uid, Heard> heard_;
    std::map<int, std::set<Uid>> by_universe_; // empty: there were some
    Askers askers_;
    std::uint64_t messages_ = 0, faults_ = 0;
};

} // namespace ghost::rdm
