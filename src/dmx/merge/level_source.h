#pragma once
// SPDX-License-Identifier: Apache-2.0
// LevelSource: one sender on one universe, as the merge sees it: its newest levels and priorities, what waits
// for synchronisation, and whether it takes part. A desk with two network cards, or a network that both of
// ours reach, brings every packet twice: the way it first came by counts, until that is silent for
// kWaySilence. No clock.

#include "dmx/merge/doubles.h"
#include "dmx/merge/rivalry.h"
#include "dmx/merge/source_status.h"
#include "dmx/wire/packet.h"
#include "dmx/wire/sequence.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ghost::dmx {

inline constexpr std::chrono::milliseconds kSacnLoss{2500};    // E131_NETWORK_DATA_LOSS_TIMEOUT
inline constexpr std::chrono::milliseconds kArtnetLoss{10000}; // unchanged levels come every 4 s or so
inline constexpr std::chrono::milliseconds kUsbLoss{2500};     // a widget repeats what it hears
inline constexpr std::uint8_t kMaxPriority = 200;              // E1.31-2018 6.2.3
inline constexpr std::chrono::milliseconds kWaySilence{1250};  // unchanged sACN levels come every 0.8 to 1 s

// Packets that were missed and may still come late: before kMostLate newer ones, and in a second or two. What
// does not is lost.
class OpenGaps {
public:
    // At each packet that is newer than all before it.
    void next(double missed) {
        Gap& gap = gaps_[at_ = (at_ + 1) % gaps_.size()];
        lost_ += gap.packets;
        gap = {missed, false};
    }
    // The newest gap first: an older one is likelier to stay.
    void came_late() {
        for (std::size_t k = 0; k < gaps_.size(); ++k)
            if (Gap& gap = gaps_[(at_ + gaps_.size() - k) % gaps_.size()]; gap.packets > 0) {
                gap.packets = std::max(0.0, gap.packets - 1);
                return;
            }
    }
    // Once a second. Returns what was lost since the last time.
    double settle() {
        for (Gap& gap : gaps_) {
            if (gap.is_old) lost_ += std::exchange(gap.packets, 0);
            gap.is_old = true;
        }
        return std::exchange(lost_, 0);
    }

private:
    struct Gap {
        double packets = 0;
        bool is_old = false; // it was open when the second before ended
    };
    static constexpr std::size_t kMostLate = 20; // Sequence takes what is further behind for newer
    std::array<Gap, kMostLate> gaps_;
    std::size_t at_ = 0; // of the newest packet
    double lost_ = 0;
};

class LevelSource {
public:
    // joined: takes part in the merge at once. sent: packets of its sender, on all universes together;
    // in_sequence() counts its own.
    LevelSource(const Packet& first, bool joined, std::shared_ptr<std::uint64_t> sent,
                std::chrono::nanoseconds now);

    const SourceKey& key() const { return key_; }
    bool has_levels() const { return has_levels_; }
    bool joined() const { return joined_; }
    std::uint64_t heard() const { return heard_; } // packets accepted, and what came while it had no place
    void was_heard_before() { ++heard_; }
    std::chrono::nanoseconds first_heard() const { return first_heard_; }
    std::chrono::nanoseconds last_levels() const { return last_levels_; }
    bool expired(std::chrono::nanoseconds now) const { return now > expires(); }
    std::chrono::nanoseconds expires() const;

    // Whether a packet came the way that counts. One that says goodbye by another way is not believed.
    bool same_way(const Packet& packet, std::chrono::nanoseconds now);
    // Missed packets before this one, nothing where it is late.
    std::optional<unsigned> in_sequence(const Packet& packet, std::chrono::nanoseconds now);
    // A packet of the same row of numbers that is none of this source's, and so many before it that were
    // missed there: none of them is missed here.
    void pass(std::uint8_t number, unsigned missed = 0) { sequence_.pass(number, missed); }
    // Keeps it; where hold: until release(). True: levels or priorities changed hands now.
    void keep(const Packet& packet, bool hold, std::uint32_t stamp, std::chrono::nanoseconds now);
    // What was held is shown from now on. False: nothing was.
    bool release();
    bool holding() const { return held_levels_ || held_priorities_; }
    std::uint16_t sync_universe() const { return sync_universe_; }
    bool force_sync() const { return force_sync_; }

    void join() { joined_ = true; }
    // Back to the packet's priority where priorities per address stopped. True: they did.
    bool drop_old_priorities(std::chrono::nanoseconds now);
    void measure_rate(std::chrono::nanoseconds now);
    // Packets that got lost since the last call, as far as numbers tell it: a sender that counts all its
    // universes in one row misses none that came for another; where most of them come after a gap it does
    // so, too, or as many get lost (SourceStatus::has_gaps).
    std::uint64_t take_lost() { return std::exchange(lost_, 0); }
    void resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now);

    // Priority + 1 in a slot (0-based), 0 where it does not hold it.
    std::uint8_t rank(std::size_t slot) const;
    // The highest of its slots: its own, or of its priorities per address.
    std::uint8_t priority() const;
    std::uint8_t level(std::size_t slot) const { return levels_[slot]; }
    std::size_t slot_count() const { return slot_count_; }
    // The slot has the level that it had one and two seconds ago or so (measure_rate).
    bool stands(std::size_t slot) const {
        return levels_[slot] == samples_[0][slot] && levels_[slot] == samples_[1][slot];
    }
    // Both take part, and neither goes before the other.
    bool rivals(const LevelSource& other) const;
    // Those that were there before it and that it is compared with, now and then.
    void compare_with(const std::vector<const LevelSource*>& rivals, std::chrono::nanoseconds now);
    // It or that one shows something new.
    void follow(const LevelSource& other, std::chrono::nanoseconds now);
    // With that one; null: they are no rivals.
    const Rivalry* rivalry(const LevelSource& other) const;
    // When the slot changed last, as the stamp that keep() was given; 0 where that is not recorded (sACN).
    std::uint32_t changed(std::size_t slot) const { return changed_.empty() ? 0 : changed_[slot]; }

    SourceStatus status(std::uint16_t universe, bool with_slots, std::chrono::nanoseconds now) const;

private:
    struct Held {
        Levels slots{};
        std::uint16_t slot_count = 0;
        std::uint8_t priority = 0;
        std::uint32_t stamp = 0;
    };
    void show(const Held& levels);
    void measure_jitter(std::chrono::nanoseconds interval);
    unsigned lost_of(unsigned missed, bool began_anew, std::chrono::nanoseconds now) const;
    void note_other_way(const Packet& packet, std::chrono::nanoseconds now);
    bool turns_back(const Packet& packet);
    void note_rows(const Packet& packet, bool odd, std::chrono::nanoseconds now);

    SourceKey key_;
    std::string name_;
    IpAddress from_;
    unsigned interface_index_ = 0;
    std::uint16_t sync_universe_ = 0;
    bool force_sync_ = false;
    bool wrong_group_ = false, wrong_length_ = false;
    std::uint8_t priority_ = 100;
    Sequence sequence_;
    std::shared_ptr<std::uint64_t> sent_;
    std::uint64_t sent_before_;                // at its last packet
    double gaps_beside_ = 0, none_beside_ = 0; // of late, of packets after some of the sender's elsewhere
    bool has_levels_ = false;                  // a packet with levels was shown, so the slots mean something
    bool joined_ = false;
    bool per_address_ = false;
    std::uint16_t slot_count_ = 0, priority_count_ = 0;
    Levels levels_{};
    Levels slot_priority_{};          // while per_address; 0 = this source does not hold the slot
    std::array<Levels, 2> samples_{}; // of the last two seconds; of its first ones the first levels
    std::vector<std::uint32_t> changed_;
    std::unique_ptr<Held> held_levels_, held_priorities_;
    std::chrono::nanoseconds held_since_{0};
    std::chrono::nanoseconds first_heard_{0}, last_levels_{0}, last_priorities_{0}, last_way_{0};
    std::uint64_t heard_ = 0, packets_ = 0, out_of_sequence_ = 0, missed_ = 0, other_way_ = 0;
    // back: far behind the newest; odd: after a gap or a step back; swapped: of the late ones those that came
    // after their successors.
    struct Window {
        double packets = 0, late = 0, back = 0, odd = 0, swapped = 0;
    };
    Window window_, rates_hz_; // counted since window_start_, and of the whole second before
    std::chrono::nanoseconds window_start_{0};
    OpenGaps gaps_, gaps_beyond_;               // all, and without what the sender sent elsewhere meanwhile
    std::uint64_t lost_ = 0, pending_lost_ = 0; // that were not taken yet; that may be another sender's
    int undecided_windows_ = 0;                 // in which these wait
    bool has_gaps_ = false, is_reordered_ = false;
    struct OtherWay {
        IpAddress from;
        unsigned interface_index = 0;
        std::chrono::nanoseconds heard{0};
        LookPair pair{2}; // 0: the way that counts
    };
    std::unique_ptr<OtherWay> other_;  // while there is one
    std::unique_ptr<SharedRows> rows_; // while numbers or ports are those of two senders, perhaps
    std::vector<Rivalry> rivalries_;   // with others that have the same say
    std::chrono::nanoseconds odd_at_{0};
    std::uint16_t numbered_port_ = 0;          // of the newest packet with a number
    std::uint16_t port_ = 0, port_before_ = 0; // of the newest packet, and of the newest by another port
    bool numbered_ = true;                     // the newest packet
    std::uint16_t most_slots_ = 0;             // of late
    std::chrono::nanoseconds most_slots_at_{0};
    double interval_ms_ = 0.0, jitter_ms_ = 0.0; // means of the last 16 packets or so
};

} // namespace ghost::dmx
