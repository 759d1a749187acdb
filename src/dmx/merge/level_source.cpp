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
constexpr std::chrono::seconds kMostSlotsFor{3}; // senders mix whole and short packets
constexpr std::chrono::nanoseconds kDoubleForgotten =
    std::chrono::seconds(3); // unchanged levels: one a second

// Never 0.
std::uint64_t look_of(const Levels& levels) {
    std::uint64_t sum = 0x9E3779B97F4A7C15u;
    for (const std::uint8_t level : levels) sum = (sum ^ level) * 0x100000001B3u; // FNV-1a
    return sum | 1;
}

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

LevelSource::LevelSource(const Packet& first, bool joined, std::chrono::nanoseconds now)
    : key_(first.source), from_(first.from), interface_index_(first.interface_index),
      priority_(first.priority), joined_(joined), first_heard_(now), last_levels_(now), last_way_(now),
      window_start_(now) {}

std::chrono::nanoseconds LevelSource::expires() const {
    return last_levels_ + loss_after(key_.protocol);
}

bool LevelSource::same_way(const Packet& packet, std::chrono::nanoseconds now) {
    const bool same = packet.from == from_ && packet.interface_index == interface_index_;
    if (!same && now - last_way_ <= kWaySilence) {
        ++other_way_;
        if (!is_copy(packet)) note_double(packet.from, now);
        return false;
    }
    if (!same) {
        from_ = packet.from;
        interface_index_ = packet.interface_index;
        sequence_.forget();
        double_.reset();
        looks_.reset();
    }
    last_way_ = std::max(last_way_, now);
    return true;
}

// Who sends every packet by two ways numbers both alike and shows the same in both, however late the other
// way is; with a row of numbers for each it shows the same at least while it stands still.
bool LevelSource::is_copy(const Packet& packet) {
    if (key_.protocol != Protocol::sacn || packet.start_code != 0)
        return true; // Art-Net's key is its address
    if (!looks_) looks_ = std::make_unique<Looks>();
    looks_->from = packet.from;
    const int ahead = sequence_.ahead(packet.sequence);
    const auto count = static_cast<int>(looks_->here.size());
    const std::uint64_t look = look_of(packet.slots);
    const std::size_t place = packet.sequence % looks_->here.size();
    if (ahead > 0 && ahead < count) {
        looks_->there[place] = {look, packet.sequence}; // to be compared when it comes by the way that counts
        return true;
    }
    if (ahead > -count && ahead <= 0) {
        const Look& here = looks_->here[place];
        return here.look == 0 || here.number != packet.sequence || here.look == look;
    }
    return !has_levels_ || packet.slots == levels_;
}

// Levels that are accepted, by what they show.
void LevelSource::note_look(const Packet& packet, std::chrono::nanoseconds now) {
    // Without numbers, ports: the same two by turns. There are senders that take a new one for each packet.
    bool steps_back = sequence_.stepped_back();
    if (sequence_.is_unused() && packet.from_port < port_) {
        steps_back = packet.from_port == lower_port_ && port_ == higher_port_;
        lower_port_ = packet.from_port;
        higher_port_ = port_;
    }
    port_ = packet.from_port;
    if (!looks_ && !steps_back && look_back_ == 0) return; // the rule: nobody asks
    const std::uint64_t look = look_of(packet.slots);
    // Two that take turns: this look, that one, and this again.
    window_.back += steps_back && look == look_back_ && look != look_ ? 1 : 0;
    if (steps_back) look_back_ = look;
    look_ = look;
    if (!looks_) return;
    const std::size_t place = packet.sequence % looks_->here.size();
    looks_->here[place] = {look, packet.sequence};
    const Look there = std::exchange(looks_->there[place], Look{});
    if (there.look != 0 && there.number == packet.sequence && there.look != look)
        note_double(looks_->from, now);
}

void LevelSource::note_double(const IpAddress& from, std::chrono::nanoseconds now) {
    if (!double_ || now - double_->last > kDoubleForgotten) double_ = Double{from, now, now};
    double_->from = from;
    double_->last = now;
}

// Whether so many can have been sent since the newest: who begins anew begins with another number.
bool LevelSource::may_be_lost(unsigned missed, std::chrono::nanoseconds now) const {
    constexpr double kHaste = 1.5; // a desk whose looks move sends faster than one at rest
    constexpr double kAtOnce = 8;
    const double passed_ms = std::chrono::duration<double, std::milli>(now - last_levels_).count();
    return interval_ms_ == 0.0 || missed <= kHaste * passed_ms / interval_ms_ + kAtOnce;
}

// Art-Net numbers 1..255 and 0 means "not numbered"; senders that wrap through 0 exist, so a 0 is accepted
// and not remembered.
std::optional<unsigned> LevelSource::in_sequence(const Packet& packet, std::chrono::nanoseconds now) {
    if (packet.protocol == Protocol::usb) return 0; // a cable keeps the order
    if (packet.protocol == Protocol::artnet && packet.sequence == 0) return 0;
    const std::optional<unsigned> missed = sequence_.accept(packet.sequence);
    if (missed) {
        missed_ += *missed;
        window_.missed += may_be_lost(*missed, now) ? *missed : 0;
        window_.odd += *missed > 0 || sequence_.stepped_back() ? 1 : 0;
    } else {
        ++out_of_sequence_;
        ++window_.late;
        window_.swapped += sequence_.swapped() ? 1 : 0;
        // One number, two looks.
        const bool again = newest_is_levels_ && !held_levels_ && sequence_.is_newest(packet.sequence);
        window_.back += again && packet.start_code == 0 && packet.slots != levels_ ? 1 : 0;
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
    newest_is_levels_ = !priorities;
    const Held held{packet.slots, packet.slot_count, packet.priority, stamp};
    if (priorities) {
        last_priorities_ = std::max(last_priorities_, now);
        if (packets_ == 0) last_levels_ = std::max(last_levels_, now); // it is there, without levels
        joined_ = true;                                                // nothing better is to come
    } else {
        if (packets_ > 0) measure_jitter(now - last_levels_);
        note_look(packet, now);
        last_levels_ = std::max(last_levels_, now);
        ++packets_;
        ++window_.packets;
        if (packet.slot_count >= most_slots_ || now - most_slots_at_ > kMostSlotsFor) {
            most_slots_ = packet.slot_count;
            most_slots_at_ = now;
        }
    }
    if (hold) {
        auto& place = priorities ? held_priorities_ : held_levels_;
        place ? void(*place = held) : void(place = std::make_unique<Held>(held));
    } else if (priorities) {
        held_priorities_.reset();
        per_address_ = true;
        slot_priority_ = held.slots; // fewer than 512 values: the rest is 0, "not ours"
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
    if (window_.packets >= kEnoughPackets) has_gaps_ = window_.odd > kMostGaps * window_.packets;
    const bool two_rows = window_.back > 0; // of two senders
    if (!has_gaps_ && !two_rows && window_.missed > window_.swapped)
        lost_ += static_cast<std::uint64_t>(window_.missed - window_.swapped);
    rates_hz_ = {window_.packets / window_s, window_.late / window_s, window_.back / window_s};
    window_ = {};
    window_start_ = now;
    samples_[1] = samples_[0];
    samples_[0] = levels_;
}

void LevelSource::resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now) {
    for (std::chrono::nanoseconds* time : {&last_levels_, &last_priorities_, &last_way_, &first_heard_})
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
    status.priority = priority_;
    status.per_address_priority = per_address_;
    status.highest_priority = priority();
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
    status.back_hz = young ? window_.back / window_s : rates_hz_.back;
    status.port = lower_port_;
    status.other_port = higher_port_;
    // One that came to another address, or its way back, is heard in one place at a time.
    if (double_ && last_way_ > double_->first && now - double_->last <= kDoubleForgotten)
        status.double_from = double_->from;
    status.jitter_ms = jitter_ms_;
    status.age = now - last_levels_;
    if (with_slots) {
        SourceSlots slots;
        slots.levels = levels_;
        for (std::size_t i = 0; i < kSlots; ++i) slots.rank[i] = rank(i);
        status.slots = std::make_shared<const SourceSlots>(slots);
    }
    return status;
}

} // namespace ghost::dmx
