#pragma once
// SPDX-License-Identifier: Apache-2.0
// One source on one universe, for people: what the merge knows of it. Values only.

#include "dmx/wire/packet.h"

#include <bitset>
#include <chrono>
#include <memory>
#include <optional>
#include <string>

namespace ghost::dmx {

// What one source sends for each slot, how it ranks there (priority + 1, 0 where it does not hold the slot),
// and where it has sent the same for one to two seconds.
struct SourceSlots {
    Levels levels{};
    Levels rank{};
    std::bitset<kSlots> stands;
};

enum class SourceState : std::uint8_t {
    live,    // takes part in the merge
    waiting, // new beside others: its priorities per address may still come
    silent   // sends no more; leaves as soon as the others of its universe were heard again
};
const char* source_state_name(SourceState state);

// A source whose levels nobody looks at.
struct IgnoredSource {
    enum class Why : std::uint8_t {
        preview, // its packets are marked "not for live output", and these are not asked for
        too_many // all places of its universe are taken; of Art-Net there are two
    };
    std::uint16_t universe = 0;
    Protocol protocol = Protocol::sacn;
    Why why = Why::preview;
    std::string name; // not of Art-Net
    IpAddress from;
    std::uint64_t packets = 0;
    std::chrono::nanoseconds age{0}; // of the newest
};

// A universe whose last source is gone.
struct LostUniverse {
    std::uint16_t universe = 0;
    bool black = false; // else its last look is held
    std::chrono::nanoseconds since{0};
    bool ended = false;                 // its last source said goodbye
    std::chrono::nanoseconds silent{0}; // since its newest levels
    unsigned interface_index = 0;       // that these came by; 0: not told
    std::string source;                 // that sent these: SourceStatus::id; empty: not told
};

struct SourceStatus {
    std::uint16_t universe = 0;
    Protocol protocol = Protocol::sacn;
    SourceState state = SourceState::live;
    // CID as 32 hex digits; Art-Net: "10.0.0.2" or "10.0.0.2/1" (Physical 1); USB: last letters of the port
    std::string id;
    std::string name; // not of Art-Net
    IpAddress from;
    unsigned interface_index = 0;         // where it comes in; 0: not told
    bool preview = false;                 // its packets are marked "not for live output"
    bool wrong_group = false;             // its newest packet came by the multicast group of another universe
    bool wrong_length = false;            // its newest packet declares more levels than came
    std::uint16_t sync_universe = 0;      // that its newest packet names
    bool held = false;                    // levels wait for a synchronisation packet
    std::chrono::nanoseconds held_for{0}; // these that wait for longest
    std::uint8_t priority = 0;
    bool per_address_priority = false;
    std::uint8_t highest_priority = 0; // of its addresses; without such priorities the same
    std::uint16_t priority_count = 0;  // of its list of them
    std::uint16_t bad_priorities = 0;  // of these above 200, which is none: such a slot is not held
    std::uint16_t slot_count = 0;      // of its newest packet
    std::uint16_t most_slots = 0;      // of one in the last seconds
    std::uint64_t packets = 0;         // level packets used
    std::uint64_t out_of_sequence = 0; // dropped: late or twice
    std::uint64_t missed = 0;          // gaps in the sequence numbers
    std::uint64_t other_way = 0;       // dropped: came by another interface or from another address as well
    double rate_hz = 0.0;              // level packets per second over about the last second
    double late_hz = 0.0;              // of them that are dropped: late or twice
    // Two senders, of one way, take turns in its name and show different things: by two rows of numbers, or
    // by the two ports of unnumbered ones (else 0).
    bool is_shared = false;
    std::uint16_t port = 0, other_port = 0;
    bool has_gaps = false;     // most of its packets come after a gap in the numbers
    bool is_reordered = false; // its packets come late, after their successors: what is late is dropped
    double jitter_ms = 0.0;    // how far its packets come from an even beat, in the mean
    // Whoever sends other packets in its name at the same time, from another address or by another interface.
    std::optional<IpAddress> double_from;
    bool is_dark = false;       // nothing that it sends is above 0
    std::size_t slots_held = 0; // of slot_count: where nobody on its universe ranks higher
    // Of slots_held: where another of its rank has another level that shows, of those that stand still, and
    // those where one of both covers the other (Rivalry).
    std::size_t slots_overruled = 0;
    std::size_t slots_contested = 0; // of these: where its own level is above 0, or was
    std::size_t slots_shared = 0;    // that it and another of its rank have up at different times (Rivalry)
    std::chrono::nanoseconds age{0}; // since its last level packet, without time in which we did not listen
    std::shared_ptr<const SourceSlots> slots; // where MergeOptions::slot_status asks for it, else null
};

// Its address, or the port of a widget.
std::string place_text(const SourceStatus& source);

// The id of a source as text, as in SourceStatus.
std::string source_id(const SourceKey& key);

} // namespace ghost::dmx
