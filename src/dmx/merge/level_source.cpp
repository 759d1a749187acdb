// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/level_source.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ghost::dmx {

namespace {

constexpr std::chrono::nanoseconds kRateWindow = std::chrono::seconds(1);
constexpr double kEnoughPackets = 8;             // a desk at rest sends one a second
constexpr double kMostGaps = 0.5;                // of its packets; a network that loses as many is hardly one
constexpr double kMostSwapped = 0.5;             // of its gaps: else what is missed is not all late
constexpr double kManyLate = 4;                  // in a window
constexpr std::chrono::seconds kMostSlotsFor{3}; // senders mix whole and short packets
constexpr int kMostUndecided = 5;                // windows
constexpr double kBesideKept = 0.75;             // a window
constexpr double kTwoRows = 2;                   // far steps back in a second; who begins anew takes one

std::chrono::nanoseconds loss_after(Protocol protocol) {
    return protocol == Protocol::sacn ? kSacnLoss : protocol == Protocol::artnet ? kArtnetLoss : kUsbLoss;
}

} // namespace

const char* source_state_name(SourceState state) {
    switch (state) {
    case SourceState::waiting:
        return "waiting";
    case SourceState::silent:
        return "silent";
    case SourceState::live:
        break;
    }
    return "live";
}

std::string place_text(const SourceStatus& source) {
    return source.protocol == Protocol::usb ? source.id : address_text(source.from);
}

std::string source_id(const SourceKey& key) {
    if (key.protocol == Protocol::usb)
        return {key.id.begin(), std::find(key.id.begin(), key.id.end(), std::uint8_t{0})};
    char text[40];
    if (key.protocol == Protocol::artnet) {
        const auto& id = key.id;
        const int length = std::snprintf(text, sizeof text, "%d.%d.%d.%d", id[0], id[1], id[2], id[3]);
        if (id[4] != 0)
            std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length), "/%d", id[4]);
    } else {
        for (std::size_t i = 0; i < key.id.size(); ++i) std::snprintf(text + 2 * i, 3, "%02x", key.id[i]);
    }
    return text;
}

LevelSource::LevelSource(const Packet& first, bool joined, std::shared_ptr<std::uint64_t> sent,
                         std::chrono::nanoseconds now)
    : key_(first.source), from_(first.from), interface_index_(first.interface_index),
      priority_(first.priority), sent_(std::move(sent)), sent_before_(*sent_), joined_(joined),
      first_heard_(now), last_levels_(now), last_way_(now), window_start_(now) {}

std::chrono::nanoseconds LevelSource::expires() const {
    return last_levels_ + loss_after(key_.protocol);
}

bool LevelSource::same_way(const Packet& packet, std::chrono::nanoseconds now) {
    const bool same = packet.from == from_ && packet.interface_index == interface_index_;
    if (!same && now - last_way_ <= kWaySilence) {
        ++other_way_;
        note_other_way(packet, now);
        return false;
    }
    if (!same) {
        from_ = packet.from;
        interface_index_ = packet.interface_index;
        sequence_.forget();
        other_.reset();
        rows_.reset();
    }
    last_way_ = std::max(last_way_, now);
    return true;
}

// A desk with two network cards or two protocols sends the same by both, numbered alike or not. Of several
// other ways one is compared after the other.
void LevelSource::note_other_way(const Packet& packet, std::chrono::nanoseconds now) {
    if (key_.protocol != Protocol::sacn || packet.start_code != 0) return; // Art-Net's key is its address
    const bool same =
        other_ && other_->from == packet.from && other_->interface_index == packet.interface_index;
    if (!same) {
        const bool is_there = other_ && now - other_->heard <= kWaySilence;
        if (is_there && (!other_->pair.is_one() || other_->pair.differ(now))) return;
        other_ = std::make_unique<OtherWay>();
        other_->from = packet.from;
        other_->interface_index = packet.interface_index;
        other_->pair.restart(now);
    }
    other_->heard = now;
    other_->pair.add(1, packet.slots, now);
}

// Unnumbered packets that come by the port before the last one again, or between numbered ones. There are
// senders that take a new port for each packet.
bool LevelSource::turns_back(const Packet& packet) {
    const bool numbered = packet.sequence != 0;
    const bool by_port =
        !numbered && packet.from_port != port_ && packet.from_port == port_before_ && port_before_ != 0;
    if (packet.from_port != port_) port_before_ = std::exchange(port_, packet.from_port);
    return std::exchange(numbered_, numbered) != numbered || by_port;
}

// The rule is that nothing is odd, and nothing is compared.
void LevelSource::note_rows(const Packet& packet, bool odd, std::chrono::nanoseconds now) {
    if (packet.start_code != 0) return;
    if (odd) {
        odd_at_ = now;
        if (!rows_) rows_ = std::make_unique<SharedRows>();
    }
    if (!rows_) return;
    if (now - odd_at_ > kDoubleForgotten)
        rows_.reset();
    else
        rows_->add(packet, now);
}

// How many of the missing can have been lost since the newest. Who begins anew begins with another number,
// and after a pause by another port. Of who sends evenly what is lost leaves a pause; what went elsewhere
// does not.
unsigned LevelSource::lost_of(unsigned missed, bool began_anew, std::chrono::nanoseconds now) const {
    constexpr double kHaste = 1.5; // a desk whose looks move sends faster than one at rest
    constexpr double kAtOnce = 8;
    constexpr double kPause = 5;       // intervals
    constexpr double kEven = 0.25;     // jitter, of the interval
    if (interval_ms_ == 0.0) return 0; // two packets tell no interval
    const double passed =
        std::chrono::duration<double, std::milli>(now - last_levels_).count() / interval_ms_;
    if (began_anew && passed > kPause) return 0;
    if (missed > kHaste * passed + kAtOnce) return 0;
    if (jitter_ms_ > kEven * interval_ms_) return missed;
    return std::min(missed, static_cast<unsigned>(std::max(0.0, std::round(passed) - 1)));
}

// Art-Net numbers 1..255 and 0 means "not numbered"; senders that wrap through 0 exist, so a 0 is accepted
// and not remembered.
std::optional<unsigned> LevelSource::in_sequence(const Packet& packet, std::chrono::nanoseconds now) {
    const auto elsewhere = static_cast<double>(*sent_ - std::exchange(sent_before_, *sent_ + 1));
    ++*sent_;
    if (packet.protocol == Protocol::usb) return 0; // a cable keeps the order
    const bool turned = packet.protocol == Protocol::artnet && turns_back(packet);
    if (packet.protocol == Protocol::artnet && packet.sequence == 0) {
        note_rows(packet, turned, now);
        return 0;
    }
    const std::optional<unsigned> missed = sequence_.accept(packet.sequence);
    const bool by_other_port = std::exchange(numbered_port_, packet.from_port) != packet.from_port;
    note_rows(packet, turned || !missed || sequence_.stepped_back(), now);
    if (missed) {
        missed_ += *missed;
        const unsigned lost = lost_of(*missed, by_other_port, now);
        gaps_.next(lost);
        gaps_beyond_.next(std::min<double>(lost, std::max(0.0, *missed - elsewhere)));
        if (elsewhere > 0) ++(*missed > 0 ? gaps_beside_ : none_beside_);
        window_.odd += *missed > 0 || sequence_.stepped_back() ? 1 : 0;
        window_.back += sequence_.stepped_back() ? 1 : 0;
    } else {
        ++out_of_sequence_;
        ++window_.late;
        if (sequence_.swapped()) {
            ++window_.swapped;
            gaps_.came_late();
            gaps_beyond_.came_late();
        }
    }
    return missed;
}

void LevelSource::keep(const Packet& packet, bool hold, std::uint32_t stamp, std::chrono::nanoseconds now) {
    ++heard_;
    name_ = packet.source_name;
    wrong_group_ = packet.wrong_group;
    wrong_length_ = packet.wrong_length;
    sync_universe_ = packet.sync_universe;
    force_sync_ = packet.force_sync;
    const bool priorities = packet.start_code == 0xDD;
    const Held held{packet.slots, packet.slot_count, packet.priority, stamp};
    if (priorities) {
        last_priorities_ = std::max(last_priorities_, now);
        if (packets_ == 0) last_levels_ = std::max(last_levels_, now); // it is there, without levels
        joined_ = true;                                                // nothing better is to come
    } else {
        if (packets_ > 0) measure_jitter(now - last_levels_);
        if (other_) other_->pair.add(0, packet.slots, now);
        last_levels_ = std::max(last_levels_, now);
        ++packets_;
        ++window_.packets;
        if (packet.slot_count >= most_slots_ || now - most_slots_at_ > kMostSlotsFor) {
            most_slots_ = packet.slot_count;
            most_slots_at_ = now;
        }
    }
    if (hold) {
        if (!holding()) held_since_ = now;
        auto& place = priorities ? held_priorities_ : held_levels_;
        place ? void(*place = held) : void(place = std::make_unique<Held>(held));
    } else if (priorities) {
        held_priorities_.reset();
        per_address_ = true;
        slot_priority_ = held.slots; // fewer than 512 values: the rest is 0, "not ours"
        priority_count_ = held.slot_count;
    } else {
        held_levels_.reset();
        show(held);
    }
}

void LevelSource::show(const Held& levels) {
    if (key_.protocol == Protocol::artnet) {
        if (changed_.empty()) changed_.assign(kSlots, levels.stamp);
        for (std::size_t i = 0; i < kSlots; ++i)
            if (levels.slots[i] != levels_[i]) changed_[i] = levels.stamp;
    }
    priority_ = levels.priority;
    levels_ = levels.slots;
    if (!has_levels_) samples_ = {levels_, levels_};
    slot_count_ = levels.slot_count;
    has_levels_ |= levels.slot_count > 0;
}

bool LevelSource::release() {
    if (!holding()) return false;
    if (held_priorities_) {
        per_address_ = true;
        slot_priority_ = held_priorities_->slots;
        priority_count_ = held_priorities_->slot_count;
        held_priorities_.reset();
    }
    if (held_levels_) {
        show(*held_levels_);
        held_levels_.reset();
    }
    return true;
}

bool LevelSource::drop_old_priorities(std::chrono::nanoseconds now) {
    if (!per_address_ || now - last_priorities_ <= kSacnLoss) return false;
    per_address_ = false;
    return true;
}

// As RFC 3550 smooths it, against the mean interval.
void LevelSource::measure_jitter(std::chrono::nanoseconds interval) {
    const double ms = std::chrono::duration<double, std::milli>(interval).count();
    if (interval_ms_ == 0.0) interval_ms_ = ms;
    interval_ms_ += (ms - interval_ms_) / 16.0;
    jitter_ms_ += (std::abs(ms - interval_ms_) - jitter_ms_) / 16.0;
}

void LevelSource::measure_rate(std::chrono::nanoseconds now) {
    const auto window = now - window_start_;
    if (window < kRateWindow) return;
    const double window_s = std::chrono::duration<double>(window).count();
    if (window_.late == 0) is_reordered_ = false;
    if (window_.packets >= kEnoughPackets) {
        is_reordered_ = window_.swapped > kMostSwapped * window_.odd && window_.odd >= kManyLate &&
                        window_.late >= kManyLate;
        has_gaps_ = !is_reordered_ && window_.odd > kMostGaps * window_.packets;
    }
    // What two senders in one row of numbers seem to miss is not lost; what is not known yet waits.
    const bool two = window_.back >= kTwoRows || (rows_ && rows_->are_two(now));
    const double lost = gaps_.settle(), lost_beyond = gaps_beyond_.settle();
    if (has_gaps_ || two)
        gaps_ = gaps_beyond_ = {};
    else
        pending_lost_ += static_cast<std::uint64_t>(gaps_beside_ > none_beside_ ? lost_beyond : lost);
    if (two) pending_lost_ = 0;
    undecided_windows_ = rows_ && rows_->undecided() ? undecided_windows_ + 1 : 0;
    if (undecided_windows_ % kMostUndecided == 0) lost_ += std::exchange(pending_lost_, 0);
    rates_hz_ = {.packets = window_.packets / window_s, .late = window_.late / window_s};
    window_ = {};
    window_start_ = now;
    gaps_beside_ *= kBesideKept;
    none_beside_ *= kBesideKept;
    samples_[1] = samples_[0];
    samples_[0] = levels_;
}

bool LevelSource::rivals(const LevelSource& other) const {
    return joined_ && other.joined_ && has_levels_ && other.has_levels_ &&
           key_.preview == other.key_.preview && priority() == other.priority();
}

void LevelSource::compare_with(const std::vector<const LevelSource*>& rivals, std::chrono::nanoseconds now) {
    std::erase_if(rivalries_, [&](const Rivalry& one) {
        return std::none_of(rivals.begin(), rivals.end(),
                            [&](const LevelSource* rival) { return one.other() == rival->key_; });
    });
    for (const LevelSource* const rival : rivals) {
        const auto found = std::find_if(rivalries_.begin(), rivalries_.end(),
                                        [&](const Rivalry& one) { return one.other() == rival->key_; });
        if (found == rivalries_.end())
            rivalries_.emplace_back(rival->key_, now);
        else
            found->conclude(levels_, rival->levels_, now);
    }
}

void LevelSource::follow(const LevelSource& other, std::chrono::nanoseconds now) {
    const auto found = std::find_if(rivalries_.begin(), rivalries_.end(),
                                    [&](const Rivalry& one) { return one.other() == other.key_; });
    if (found == rivalries_.end()) return;
    if (!per_address_ && !other.per_address_) {
        found->follow(levels_, other.levels_, now);
        return;
    }
    Levels mine = levels_, others = other.levels_;
    for (std::size_t i = 0; i < kSlots; ++i)
        if (rank(i) != other.rank(i)) mine[i] = others[i] = 0;
    found->follow(mine, others, now);
}

const Rivalry* LevelSource::rivalry(const LevelSource& other) const {
    const auto found = std::find_if(rivalries_.begin(), rivalries_.end(),
                                    [&](const Rivalry& one) { return one.other() == other.key_; });
    return found == rivalries_.end() ? nullptr : &*found;
}

void LevelSource::resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now) {
    for (std::chrono::nanoseconds* time :
         {&last_levels_, &last_priorities_, &last_way_, &first_heard_, &held_since_})
        *time = std::max(*time, std::min(*time + pause, now)); // what came in the middle of the pause
    sequence_.forget();
}

std::uint8_t LevelSource::rank(std::size_t slot) const {
    if (!has_levels_ || slot >= slot_count_) return 0;
    const std::uint8_t priority = per_address_ ? slot_priority_[slot] : priority_;
    if (per_address_ && (priority == 0 || priority > kMaxPriority)) return 0;
    return static_cast<std::uint8_t>(priority + 1);
}

std::uint8_t LevelSource::priority() const {
    if (!per_address_) return priority_;
    std::uint8_t highest = 0;
    for (const std::uint8_t one : slot_priority_)
        if (one <= kMaxPriority) highest = std::max(highest, one);
    return highest;
}

SourceStatus LevelSource::status(std::uint16_t universe, bool with_slots,
                                 std::chrono::nanoseconds now) const {
    SourceStatus status;
    status.universe = universe;
    status.protocol = key_.protocol;
    status.state = expired(now) ? SourceState::silent : joined_ ? SourceState::live : SourceState::waiting;
    status.id = source_id(key_);
    status.name = name_;
    status.from = from_;
    status.interface_index = interface_index_;
    status.preview = key_.preview;
    status.wrong_group = wrong_group_;
    status.wrong_length = wrong_length_;
    status.sync_universe = sync_universe_;
    status.held = holding();
    if (status.held) status.held_for = now - held_since_;
    status.priority = priority_;
    status.per_address_priority = per_address_;
    status.highest_priority = priority();
    status.priority_count = per_address_ ? priority_count_ : 0;
    status.bad_priorities = static_cast<std::uint16_t>(
        per_address_ ? std::count_if(slot_priority_.begin(), slot_priority_.end(),
                                     [](std::uint8_t one) { return one > kMaxPriority; })
                     : 0);
    status.slot_count = slot_count_;
    status.most_slots = most_slots_;
    status.is_dark =
        std::all_of(levels_.begin(), levels_.end(), [](std::uint8_t level) { return level == 0; });
    status.packets = packets_;
    status.out_of_sequence = out_of_sequence_;
    status.missed = missed_;
    status.other_way = other_way_;
    // Before the first whole second: over what has passed of it.
    const double window_s = std::chrono::duration<double>(now - window_start_).count();
    const bool young = rates_hz_.packets == 0.0 && window_s > 0.2;
    status.rate_hz = young ? window_.packets / window_s : rates_hz_.packets;
    status.late_hz = young ? window_.late / window_s : rates_hz_.late;
    status.has_gaps = has_gaps_;
    status.is_reordered = is_reordered_;
    if (rows_ && rows_->are_two(now)) {
        status.is_shared = true;
        const auto [lower, higher] = rows_->ports();
        status.port = lower;
        status.other_port = higher;
    }
    if (other_ && other_->pair.differ(now)) status.double_from = other_->from;
    status.jitter_ms = jitter_ms_;
    status.age = now - last_levels_;
    if (with_slots) {
        SourceSlots slots;
        slots.levels = levels_;
        for (std::size_t i = 0; i < kSlots; ++i) {
            slots.rank[i] = rank(i);
            slots.stands[i] = stands(i);
        }
        status.slots = std::make_shared<const SourceSlots>(slots);
    }
    return status;
}

} // namespace ghost::dmx
