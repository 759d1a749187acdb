#pragma once
// SPDX-License-Identifier: Apache-2.0
// Merge: many sources, one level per slot. Highest priority wins, equal priorities merge
// highest-takes-precedence, per slot (a source does not hold the slots it does not send; sACN start code 0xDD
// gives each slot its own priority). A source leaves after 2.5 s (sACN) or 10 s (Art-Net) of silence, or when
// it says so; when the last one leaves, the last look is held and the universe marked lost. sACN
// synchronisation is not applied: levels show at once (E1.31 6.2.4.1 allows it). No clock: every call gets
// the time. One thread at a time. Shapes of E1.31-2018 6.7.2 (sequence), Art-Net 4 merging.

#include "dmx/packet.h"

#include <chrono>
#include <map>
#include <memory>
#include <vector>

namespace ghost::dmx {

inline constexpr std::chrono::milliseconds kSacnLoss{2500};
inline constexpr std::chrono::milliseconds kArtnetLoss{10000};
inline constexpr std::size_t kMaxSourcesPerUniverse = 16; // more are counted and ignored; Art-Net: 2
inline constexpr std::size_t kMaxArtnetSources = 2;
inline constexpr std::size_t kMaxUniverses = 4096;

struct MergeOptions {
    bool show_preview = false; // use packets marked "preview" (blind) as well
    bool slot_status = false;  // sources() says what each source sends: a kilobyte per source
};

// What one source sends for each slot, and how it ranks there: priority + 1, 0 where it does not hold the
// slot.
struct SourceSlots {
    Levels levels{};
    Levels rank{};
};

// One source on one universe, for people.
struct SourceStatus {
    std::uint16_t universe = 0;
    Protocol protocol = Protocol::sacn;
    std::string id;   // CID as 32 hex digits; Art-Net: "10.0.0.2" or "10.0.0.2/1" (Physical 1)
    std::string name; // sACN only
    std::uint32_t from_ipv4 = 0;
    std::uint8_t priority = 0;
    bool per_address_priority = false;
    std::uint16_t slot_count = 0;
    std::uint64_t packets = 0;         // level packets used
    std::uint64_t out_of_sequence = 0; // dropped: late or twice
    std::uint64_t missed = 0;          // gaps in the sequence numbers
    double rate_hz = 0.0;              // level packets per second over about the last second
    std::chrono::nanoseconds age{0};   // since its last packet
    std::shared_ptr<const SourceSlots> slots; // where MergeOptions::slot_status asks for it, else null
};

struct MergeCounters {
    std::uint64_t preview = 0;         // dropped
    std::uint64_t out_of_sequence = 0; // dropped
    std::uint64_t missed = 0;          // never arrived, by sequence number
    std::uint64_t too_many_sources = 0;
    std::uint64_t too_many_universes = 0;
    std::uint64_t sources_lost = 0;       // by silence
    std::uint64_t sources_terminated = 0; // by their own word
};

class Merge {
public:
    explicit Merge(MergeOptions options = {}) : options_(options) {}

    void feed(const Packet& packet, std::chrono::nanoseconds now);
    // Lets silent sources go. Call a few times a second.
    void tick(std::chrono::nanoseconds now);
    // Something changed since the last call of universes().
    bool pending() const { return !dirty_.empty(); }
    // The levels after everything fed so far.
    const Universes& universes();
    // What universes() returned last.
    const Universes& current() const { return universes_; }

    std::vector<SourceStatus> sources(std::chrono::nanoseconds now) const;
    const MergeCounters& counters() const { return counters_; }

private:
    struct Source {
        SourceKey key;
        std::string name;
        std::uint32_t from_ipv4 = 0;
        std::uint8_t priority = 100;
        std::uint8_t last_sequence = 0;
        bool has_levels = false;   // a level packet arrived, so the slots mean something
        bool has_sequence = false; // last_sequence means something
        bool per_address = false;
        std::uint16_t slot_count = 0;
        Levels slots{};
        Levels slot_priority{}; // while per_address; 0 = this source does not hold the slot
        std::chrono::nanoseconds last_levels{0};
        std::chrono::nanoseconds last_priorities{0};
        std::uint64_t packets = 0, out_of_sequence = 0, missed = 0;
        std::uint64_t window_packets = 0;
        std::chrono::nanoseconds window_start{0};
        double rate_hz = 0.0;
    };
    struct Input {
        std::vector<Source> sources;
        std::chrono::nanoseconds arrival{0};
        bool seen = false; // levels arrived at least once
        bool dirty = false;
    };

    static std::uint8_t rank_of(const Source& source, std::size_t slot);
    bool accept_sequence(Source& source, const Packet& packet);
    Source* find_or_add(Input& input, const Packet& packet, std::chrono::nanoseconds now);
    void rebuild(std::uint16_t number, Input& input);

    MergeOptions options_;
    MergeCounters counters_;
    std::map<std::uint16_t, Input> inputs_;
    std::vector<std::uint16_t> dirty_;
    Universes universes_;
};

} // namespace ghost::dmx
