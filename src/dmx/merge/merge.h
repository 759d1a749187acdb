#pragma once
// SPDX-License-Identifier: Apache-2.0
// Merge: many sources, one level per slot. Highest priority wins, equal priorities merge
// highest-takes-precedence, per slot (a source does not hold the slots it does not send; sACN start code 0xDD
// gives each slot its own priority); two Art-Net sources also latest-takes-precedence, by choice. A source
// leaves after 2.5 s (sACN, USB) or 10 s (Art-Net) of silence, or when it says so. Silence is settled per
// universe: a source leaves only when every other one was heard since or is silent, too, so a pulled cable
// shows no intermediate look. A universe has kMaxSourcesPerUniverse places, for those of the highest priority
// and, of these, the longest known. When the last one leaves, the universe is marked lost and LossPolicy says
// what is shown. Preview packets are left out, or, by choice, replace the live ones of their universe. No
// clock: every call gets the time. One thread at a time. E1.31-2018 6.2 and 6.7, Art-Net 4 merging, ETC's
// rules for 0xDD.

#include "dmx/merge/level_source.h"
#include "dmx/merge/sync.h"

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kMaxSourcesPerUniverse = 16; // more are counted and ignored; Art-Net: 2
inline constexpr std::size_t kMaxArtnetSources = 2;
inline constexpr std::size_t kMaxUniverses = 4096;
inline constexpr std::size_t kMaxSyncGroups = 32; // a group on each interface, 20 of them a descriptor
// On all universes together that nobody asked for; from there on only the first source of each gets in.
inline constexpr std::size_t kMaxOtherSources = 8192;
inline constexpr std::size_t kMaxIgnored = 64; // of sources that are only told of
inline constexpr std::chrono::milliseconds kSamplingPeriod{1500};
inline constexpr std::chrono::milliseconds kPriorityWait{1500};
inline constexpr std::chrono::milliseconds kReplaceable{100}; // a source heard once, that long ago
inline constexpr std::chrono::seconds kIgnoredForgotten{10};
inline constexpr std::size_t kForgottenAtOnce = 512; // universes that make room for others

// What a universe shows when its last source is gone.
struct LossPolicy {
    // Black this long after the loss, at 0 at once; none: the last look is held.
    std::optional<std::chrono::nanoseconds> black_after;
};

struct MergeOptions {
    bool show_preview = false; // packets marked "preview" (blind), where there are any, instead of live ones
    std::vector<std::uint16_t> preview_universes; // sorted; only of these; empty: of all
    // Sorted. Universes that are patched or asked for: they always find a place, and each has all its
    // sources. Where all places are taken, others that nobody sends any more make room, the longest silent
    // first. Empty: whoever came first keeps its place.
    std::vector<std::uint16_t> asked;
    bool slot_status = false; // sources() says what each source sends: a kilobyte per source
    bool artnet_ltp = false;  // of two Art-Net sources the one that changed a slot last holds it
    LossPolicy loss;
    // After listen() nothing is shown for so long, so that all sources of a universe are known
    // (kSamplingPeriod).
    std::chrono::nanoseconds sampling{0};
    // A new sACN source beside others takes part when its 0xDD packet came, at the latest after so long and
    // with its second packet (kPriorityWait). 0: at once.
    std::chrono::nanoseconds priority_wait{0};
};

struct MergeCounters {
    std::uint64_t preview = 0;         // dropped
    std::uint64_t out_of_sequence = 0; // dropped
    std::uint64_t missed = 0;          // never arrived, by sequence number
    std::uint64_t lost = 0;            // of these, where no other reason is known (LevelSource::take_lost)
    std::uint64_t other_way = 0;       // dropped: known source, by another interface or from another address
    std::uint64_t held = 0;            // level packets that waited for synchronisation
    std::uint64_t too_many_sources = 0;
    std::uint64_t too_many_universes = 0;
    std::uint64_t universes_forgotten = 0; // nobody had asked for them and nobody sent them any more
    // Gone for a newcomer where all places were taken: silent, heard only once, or of a lower priority.
    std::uint64_t sources_replaced = 0;
    std::uint64_t sources_lost = 0;       // by silence
    std::uint64_t sources_terminated = 0; // by their own word
};

class Merge {
public:
    explicit Merge(MergeOptions options = {}) : options_(std::move(options)) {}

    // Listening begins: the sampling period with it.
    void listen(std::chrono::nanoseconds now);
    void feed(const Packet& packet, std::chrono::nanoseconds now);
    void feed(const SyncPacket& packet, std::chrono::nanoseconds now);
    // Levels of a start code that we do not use: only their number counts.
    void pass(const Passing& packet);
    // Levels for a universe that is not merged, of a sender that may have others which are.
    void pass_elsewhere(const SourceKey& source);
    // Lets silent sources go and newcomers in. Call a few times a second.
    void tick(std::chrono::nanoseconds now);
    // We did not listen for this long up to now (the program was stopped): that was no silence of the
    // sources, and the next number of each counts whatever it is.
    void resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now);

    // Nothing is known of other universes any more. Sorted.
    void keep_only(const std::vector<std::uint16_t>& universes);
    // Instead of MergeOptions::asked. Sorted.
    void ask_for(const std::vector<std::uint16_t>& universes);

    // Something changed since the last call of universes().
    bool pending() const { return !dirty_.empty() && !sampling_until_; }
    bool pending(std::uint16_t universe) const;
    // The levels after everything fed so far; while sampling none.
    const Universes& universes();
    // What universes() returned last.
    const Universes& current() const { return universes_; }

    // Whether all sources that a universe has were heard after this.
    bool all_heard_since(std::uint16_t universe, std::chrono::nanoseconds since) const;

    // How many sources of a protocol a universe has.
    std::size_t count(std::uint16_t universe, Protocol protocol) const;

    // Somebody sends it, and takes part.
    bool has_source(std::uint16_t universe) const;

    bool sampling() const { return sampling_until_.has_value(); }
    std::vector<SourceStatus> sources(std::chrono::nanoseconds now) const;
    std::vector<IgnoredSource> ignored(std::chrono::nanoseconds now) const;
    std::vector<LostUniverse> lost(std::chrono::nanoseconds now) const;
    // Universes whose synchronisation packets somebody waits for, sorted: their groups have to be joined. At
    // most kMaxSyncGroups, those that the most universes name.
    std::vector<std::uint16_t> sync_universes() const;
    const SyncStreams& sync() const { return sync_; }
    const MergeCounters& counters() const { return counters_; }

private:
    struct Input {
        std::vector<LevelSource> sources;
        std::chrono::nanoseconds arrival{0};
        unsigned interface_index = 0;      // by which levels came last
        SourceKey source;                  // of whom
        std::chrono::nanoseconds heard{0}; // newest packet of a source that has a place
        std::optional<std::chrono::nanoseconds> lost_since;
        bool ended = false;     // the last source that left said goodbye
        bool asked = false;     // for: MergeOptions::asked
        bool seen = false;      // levels were shown at least once
        bool black_due = false; // lost for so long that the policy takes the look away
        bool dirty = false;
    };

    std::shared_ptr<std::uint64_t> sent_by(const SourceKey& source);
    void pass_to_twin(Input& input, const Packet& packet, unsigned missed);
    void mark(std::uint16_t number, Input& input);
    bool shows_preview(std::uint16_t number) const;
    void ignore(const Packet& packet, IgnoredSource::Why why, std::chrono::nanoseconds now);
    bool asked_for(std::uint16_t number) const;
    Input* find_or_make_input(std::uint16_t number);
    void forget(const std::function<bool(std::uint16_t)>& which);
    void forget_silent();
    std::optional<std::size_t> place_for(const Input& input, const Packet& packet,
                                         std::chrono::nanoseconds now, bool& full) const;
    LevelSource* find_or_add(Input& input, const Packet& packet, std::chrono::nanoseconds now);
    void terminate(std::uint16_t number, Input& input, const Packet& packet, std::chrono::nanoseconds now);
    bool must_hold(const Input& input, const LevelSource& source, const Packet& packet,
                   std::chrono::nanoseconds now) const;
    template <class Which>
    std::size_t remove_sources(Input& input, Which which);
    bool release_unsynchronised(Input& input, std::chrono::nanoseconds now);
    bool let_newcomers_in(Input& input, std::chrono::nanoseconds now);
    void rebuild(std::uint16_t number, Input& input);
    void apply_loss_policy(std::uint16_t number, Input& input, std::chrono::nanoseconds now);

    MergeOptions options_;
    MergeCounters counters_;
    std::map<std::uint16_t, Input> inputs_;
    SyncStreams sync_;
    // By sender, while a source of it has a place: its packets on all universes together.
    std::map<SourceKey, std::weak_ptr<std::uint64_t>> sent_;
    std::vector<std::uint16_t> dirty_;
    std::size_t other_sources_ = 0; // on universes that nobody asked for
    bool refused_ = false;          // a universe, since places were looked for
    std::uint32_t stamp_ = 0;       // of the newest packet
    std::map<std::pair<std::uint16_t, SourceKey>, IgnoredSource> ignored_; // age: arrival
    std::optional<std::chrono::nanoseconds> sampling_until_;
    Universes universes_;
};

} // namespace ghost::dmx
