#pragma once
// SPDX-License-Identifier: Apache-2.0
// Intake: what a datagram does to our picture of the network: parsed, counted, merged or noted. The receiver
// without sockets, thread and clock, so that tests and fuzzers can feed it. Everything in it is bounded.

#include "dmx/merge/discovery.h"
#include "dmx/merge/merge.h"
#include "dmx/receive/statistics.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace ghost::dmx {

struct IntakeOptions {
    std::vector<std::uint16_t> universes; // sorted; to accept; they always find a place in the merge
    bool accept_others = false;           // than those; without any all are accepted
    int artnet_offset = 1;
    MergeOptions merge;
    // Levels for this universe are about to be merged.
    std::function<void(std::uint16_t universe)> before_levels;
    // Of stream 0 that of one sender, until it is silent for a second; of other streams all.
    std::function<void(const TimeCode&, std::chrono::nanoseconds arrival)> on_timecode;
};

// How a datagram came.
struct Arrival {
    Protocol protocol = Protocol::sacn; // of the port
    IpAddress from, to;
    std::uint16_t from_port = 0;
    unsigned interface_index = 0;
    bool own = false; // from one of our addresses and our port
    std::chrono::nanoseconds time{0};
};

class Intake {
public:
    explicit Intake(const IntakeOptions& options);

    // A poll that asks for an answer, if it is one.
    std::optional<PollPacket> take(Bytes bytes, const Arrival& arrival);
    // One that came where we were told not to listen: only told of.
    void take_elsewhere(Bytes bytes, const Arrival& arrival);
    void tick(std::chrono::nanoseconds now);

    // Instead of IntakeOptions::universes; what was known of others is forgotten where they are not accepted.
    // Sorted.
    void listen_to(std::vector<std::uint16_t> universes);

    Merge& merge() { return merge_; }
    const Merge& merge() const { return merge_; }
    // Packets that are none of ours, so far.
    std::uint64_t others() const { return counted_.notices[static_cast<std::size_t>(Notice::other)]; }
    // All that it knows; what belongs to sockets is left as it is.
    void report(Statistics& statistics, std::chrono::nanoseconds now) const;

private:
    bool accepts(std::uint16_t universe) const;
    void take_levels(Packet& packet, const Arrival& arrival);
    void take_timecode(const TimeCodeStatus& now); // of stream 0

    IntakeOptions options_;
    Merge merge_;
    Discovery discovery_, nodes_;                        // of sACN, of Art-Net
    Statistics counted_;                                 // the counters of packets
    std::uint64_t followed_in_a_row_ = 0;                // time codes of the port that is followed
    std::array<std::uint16_t, 8> left_timecode_ports_{}; // of that machine, followed before
    struct Unlisted {
        UnlistedUniverse told;                         // age: arrival
        std::chrono::nanoseconds named{0};             // when the sender that it names was heard last,
        std::optional<std::chrono::nanoseconds> other; // and another one
    };
    std::map<std::pair<std::uint16_t, Protocol>, Unlisted> unlisted_;
    std::map<std::tuple<unsigned, std::uint16_t, Protocol>, ElsewhereUniverse> elsewhere_; // age: arrival
};

} // namespace ghost::dmx
