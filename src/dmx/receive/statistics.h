#pragma once
// SPDX-License-Identifier: Apache-2.0
// Statistics: what the receiver knows of the network, for people: who sends what and how, what was dropped
// and why, what is on the network beside it. Values only; a copy is handed from the receiver's thread to the
// reader's.

#include "dmx/merge/discovery.h"
#include "dmx/merge/latency.h"
#include "dmx/merge/merge.h"
#include "dmx/receive/usb_ports.h"
#include "dmx/timecode/midi_input.h"
#include "net/port_users.h"
#include "net/socket.h"

#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace ghost::dmx {

// One socket. overflow: packets that the kernel dropped because it was full.
struct SocketStatus {
    std::string name; // "sACN groups", "sACN", "sACN 10.0.0.2", "Art-Net" ...
    Protocol protocol = Protocol::sacn;
    std::uint16_t port = 0;
    bool ipv6 = false;
    std::size_t groups = 0;
    int receive_buffer_bytes = 0;
    std::uint64_t packets = 0;
    std::uint64_t overflow = 0;
};

// A universe that sends and was not asked for.
struct UnlistedUniverse {
    std::uint16_t universe = 0;
    Protocol protocol = Protocol::sacn;
    IpAddress from; // of its sender, of several the first by name and address
    std::uint64_t packets = 0;
    std::chrono::nanoseconds age{0};
    std::string name;        // of sACN
    bool has_others = false; // several send it
};

// A universe that comes in by an interface that we were told not to listen to.
struct ElsewhereUniverse {
    unsigned interface_index = 0;
    std::uint16_t universe = 0;
    Protocol protocol = Protocol::sacn;
    std::string name; // of sACN
    IpAddress from;   // of the newest packet
    std::uint64_t packets = 0;
    std::chrono::nanoseconds age{0};
};

// What we listen to, and how: what a person may have chosen wrongly.
struct Listening {
    bool sacn = true;
    bool artnet = true;
    std::string interface; // as asked for; empty: all
    int artnet_offset = 1;
    bool show_preview = false;
    std::chrono::nanoseconds since{0}; // steady time of its beginning
    std::string problem;               // why we do not listen at all: a port that is taken, as a rule
    bool artnet_ltp = false;           // of two Art-Net sources; else HTP
    bool answers_polls = true;         // else it keeps silent where somebody asks for Art-Net
    std::size_t wider = 0;             // universes that are listened for besides (wider.h)
};

// Packets that cannot be read, by why.
using Refused = std::array<std::uint64_t, static_cast<std::size_t>(Drop::kCount)>;

// What got lost in the last ten to twenty seconds, in packets.
struct RecentLoss {
    std::uint64_t lost = 0;     // as MergeCounters::lost
    std::uint64_t overflow = 0; // dropped by the kernel
    std::uint64_t too_many_universes = 0;
    std::uint64_t polls = 0, polls_refused = 0;
    Refused refused{};              // as Statistics::drops
    Refused refused_sacn{};         // of these on the port of sACN
    std::uint64_t reverse_path = 0; // of all programs: dropped by the kernel (net/reverse_path.h)

    RecentLoss operator-(const RecentLoss& before) const;
};

struct TimeCodeStatus {
    TimeCode time;
    IpAddress from;
    std::uint16_t from_port = 0;
    std::uint64_t packets = 0;
    std::chrono::nanoseconds arrival{0};
};

struct TriggerStatus {
    std::uint64_t number = 0; // counts from 1, so that a reader knows which it has seen
    Trigger trigger;
    IpAddress from;
    std::chrono::nanoseconds arrival{0};
};

// An interface that came, went, got or lost its cable or changed its address.
struct LinkChange {
    std::uint64_t number = 0; // counts from 1
    std::string text;         // "eth0: cable pulled", ...
    std::chrono::nanoseconds time{0};
    bool is_loss = false; // it went, or lost its cable
    unsigned interface_index = 0;
};

struct Statistics {
    std::chrono::nanoseconds time{0}; // when it was taken
    Listening listening;
    std::vector<NetInterface> interfaces; // of this machine, that are up
    std::vector<PortUser> port_users;     // other programs on our ports
    std::uint64_t packets_sacn = 0;       // everything that arrived on the port, but our own replies
    std::uint64_t packets_artnet = 0;
    std::uint64_t unlisted = 0; // for universes that were not asked for
    std::uint64_t overflow = 0; // dropped by the kernel: socket buffer full; of all sockets since the start
    RecentLoss recent;
    std::uint64_t wrong_group = 0;  // levels that came by the multicast group of another universe
    std::uint64_t wrong_length = 0; // levels that came in packets that declare more of them; they are used
    std::array<std::uint64_t, static_cast<std::size_t>(Notice::kCount)> notices{};
    Refused drops{};                      // since the start
    Refused drops_sacn{};                 // of these on the port of sACN
    std::uint64_t poll_replies_sent = 0;  // to those who asked
    std::uint64_t announcements_sent = 0; // the same replies, unasked, at start
    std::uint64_t polls_refused = 0;      // asked too often, too many askers, or from no local network
    std::uint64_t pauses = 0;             // times that the receiver was kept from running
    bool sampling = false;                // nothing is shown yet: who sends is still being found out
    MergeCounters merge;
    std::vector<SourceStatus> sources; // by universe
    std::vector<IgnoredSource> ignored;
    std::vector<LostUniverse> lost;
    std::vector<SyncStatus> sync;
    std::vector<DiscoveredSource> discovered;
    std::vector<UnlistedUniverse> unlisted_universes;   // at most kMaxUnlisted
    std::vector<ElsewhereUniverse> elsewhere_universes; // at most kMaxUnlisted
    std::vector<SocketStatus> sockets;
    std::vector<UsbPortStatus> usb;
    MidiStatus midi;
    std::optional<TimeCodeStatus> timecode; // the newest
    // Of stream 0: the newest of the sender that is followed, which came first, and of another one.
    std::array<std::optional<TimeCodeStatus>, 2> followed_timecodes;
    std::vector<TriggerStatus> triggers;  // the newest kMaxRemembered
    std::vector<LinkChange> link_changes; // the newest kMaxRemembered
    Latency latency;                      // from the kernel's receipt of a level packet to its publication
    std::chrono::nanoseconds cpu{0};      // processor time of the receiver's thread
};

inline constexpr std::size_t kMaxUnlisted = 256;
inline constexpr std::size_t kMaxRemembered = 32;

} // namespace ghost::dmx
