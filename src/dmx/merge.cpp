// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge.h"

#include <algorithm>
#include <cstdio>

namespace ghost::dmx {

namespace {

constexpr std::chrono::nanoseconds kRateWindow = std::chrono::seconds(1);

std::chrono::nanoseconds loss_after(Protocol protocol) {
    return protocol == Protocol::sacn ? std::chrono::nanoseconds(kSacnLoss)
                                      : std::chrono::nanoseconds(kArtnetLoss);
}

std::string source_id(const SourceKey& key) {
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

} // namespace

// E1.31-2018 6.7.2: a packet is late when its number lies 0 to 19 behind the newest. Art-Net numbers 1..255
// and 0 means "not numbered"; senders that wrap through 0 exist, so a 0 is accepted and not remembered.
bool Merge::accept_sequence(Source& source, const Packet& packet) {
    if (packet.protocol == Protocol::artnet && packet.sequence == 0) return true;
    if (source.has_sequence) {
        const auto step =
            static_cast<std::int8_t>(static_cast<std::uint8_t>(packet.sequence - source.last_sequence));
        if (step <= 0 && step > -20) {
            ++source.out_of_sequence;
            ++counters_.out_of_sequence;
            return false;
        }
        // Both ends wrap differently (255 to 0 or to 1), so a gap of one across the wrap is no loss.
        const bool wrapped = packet.sequence < source.last_sequence;
        const int gap = step - 1 - (wrapped ? 1 : 0);
        if (gap > 0) {
            source.missed += static_cast<std::uint64_t>(gap);
            counters_.missed += static_cast<std::uint64_t>(gap);
        }
    }
    source.has_sequence = true;
    source.last_sequence = packet.sequence;
    return true;
}

Merge::Source* Merge::find_or_add(Input& input, const Packet& packet, std::chrono::nanoseconds now) {
    const auto same = [&](const Source& source) { return source.key == packet.source; };
    const auto found = std::find_if(input.sources.begin(), input.sources.end(), same);
    if (found != input.sources.end()) return &*found;
    const auto artnet = std::count_if(input.sources.begin(), input.sources.end(), [](const Source& source) {
        return source.key.protocol == Protocol::artnet;
    });
    const bool full = input.sources.size() >= kMaxSourcesPerUniverse ||
                      (packet.protocol == Protocol::artnet && artnet >= static_cast<int>(kMaxArtnetSources));
    if (full) {
        ++counters_.too_many_sources;
        return nullptr;
    }
    Source& source = input.sources.emplace_back();
    source.key = packet.source;
    source.window_start = source.last_levels = now;
    return &source;
}

void Merge::feed(const Packet& packet, std::chrono::nanoseconds now) {
    if (packet.preview && !options_.show_preview) {
        ++counters_.preview;
        return;
    }
    auto place = inputs_.find(packet.universe);
    if (place == inputs_.end()) {
        if (packet.terminated) return;
        if (inputs_.size() >= kMaxUniverses) {
            ++counters_.too_many_universes;
            return;
        }
        place = inputs_.emplace(packet.universe, Input{}).first;
    }
    Input& input = place->second;
    const auto mark = [&] {
        if (!input.dirty) dirty_.push_back(packet.universe);
        input.dirty = true;
    };
    if (packet.terminated) {
        if (input.dirty) rebuild(packet.universe, input); // a look that came just before is the one to hold
        const auto gone =
            std::erase_if(input.sources, [&](const Source& source) { return source.key == packet.source; });
        counters_.sources_terminated += gone;
        if (gone > 0) mark();
        return;
    }
    Source* source = find_or_add(input, packet, now);
    if (!source || !accept_sequence(*source, packet)) return;

    source->from_ipv4 = packet.from_ipv4;
    source->name = packet.source_name;
    if (packet.start_code == 0xDD) {
        source->per_address = true;
        source->slot_priority = packet.slots; // fewer than 512 values: the rest is 0, "not ours"
        source->last_priorities = now;
    } else {
        source->priority = packet.priority;
        source->slots = packet.slots;
        source->slot_count = packet.slot_count;
        source->has_levels = true;
        source->last_levels = now;
        ++source->packets;
        ++source->window_packets;
        input.arrival = now;
        input.seen = true;
    }
    mark();
}

void Merge::tick(std::chrono::nanoseconds now) {
    for (auto& [number, input] : inputs_) {
        const auto silent = [&](const Source& source) {
            return now - source.last_levels > loss_after(source.key.protocol);
        };
        if (input.dirty && std::any_of(input.sources.begin(), input.sources.end(), silent))
            rebuild(number, input);
        const auto gone = std::erase_if(input.sources, silent);
        counters_.sources_lost += gone;
        bool changed = gone > 0;
        for (Source& source : input.sources) {
            if (source.per_address && now - source.last_priorities > kSacnLoss) {
                source.per_address = false;
                changed = true;
            }
            const auto window = now - source.window_start;
            if (window >= kRateWindow) {
                source.rate_hz = static_cast<double>(source.window_packets) /
                                 std::chrono::duration<double>(window).count();
                source.window_packets = 0;
                source.window_start = now;
            }
        }
        if (changed && !input.dirty) {
            input.dirty = true;
            dirty_.push_back(number);
        }
    }
}

// Priority + 1 of the source in a slot, 0 where it does not hold it.
std::uint8_t Merge::rank_of(const Source& source, std::size_t slot) {
    if (!source.has_levels || slot >= source.slot_count) return 0;
    const std::uint8_t priority = source.per_address ? source.slot_priority[slot] : source.priority;
    if (source.per_address && (priority == 0 || priority > 200)) return 0;
    return static_cast<std::uint8_t>(priority + 1);
}

void Merge::rebuild(std::uint16_t number, Input& input) {
    // A universe appears with its first levels, not with a packet of priorities or a goodbye.
    if (!input.seen) return;
    Universe& universe = universes_.at(number);
    universe.arrival = input.arrival;
    const bool live =
        std::any_of(input.sources.begin(), input.sources.end(), [](const Source& s) { return s.has_levels; });
    universe.lost = !live;
    if (!live) return; // hold the last look

    Levels merged{};
    Levels best{}; // priority + 1 of the holder of each slot, 0 = nobody
    for (const Source& source : input.sources) {
        if (!source.has_levels) continue;
        for (std::size_t i = 0; i < source.slot_count; ++i) {
            const std::uint8_t rank = rank_of(source, i);
            if (rank == 0) continue;
            if (rank > best[i]) {
                best[i] = rank;
                merged[i] = source.slots[i];
            } else if (rank == best[i]) {
                merged[i] = std::max(merged[i], source.slots[i]);
            }
        }
    }
    if (universe.revision != 0 && *universe.levels == merged) return;
    universe.levels = std::make_shared<const Levels>(merged);
    universe.revision = ++universes_.revision;
}

const Universes& Merge::universes() {
    for (const std::uint16_t number : dirty_) {
        Input& input = inputs_.at(number);
        input.dirty = false;
        rebuild(number, input);
    }
    dirty_.clear();
    return universes_;
}

std::vector<SourceStatus> Merge::sources(std::chrono::nanoseconds now) const {
    std::vector<SourceStatus> result;
    for (const auto& [number, input] : inputs_) {
        for (const Source& source : input.sources) {
            SourceStatus status;
            status.universe = number;
            status.protocol = source.key.protocol;
            status.id = source_id(source.key);
            status.name = source.name;
            status.from_ipv4 = source.from_ipv4;
            status.priority = source.priority;
            status.per_address_priority = source.per_address;
            status.slot_count = source.slot_count;
            status.packets = source.packets;
            status.out_of_sequence = source.out_of_sequence;
            status.missed = source.missed;
            // Before the first whole second: over what has passed of it.
            const double window_s = std::chrono::duration<double>(now - source.window_start).count();
            const bool young = source.rate_hz == 0.0 && window_s > 0.2;
            status.rate_hz = young ? static_cast<double>(source.window_packets) / window_s : source.rate_hz;
            status.age = now - source.last_levels;
            if (options_.slot_status) {
                SourceSlots slots;
                slots.levels = source.slots;
                for (std::size_t i = 0; i < kSlots; ++i) slots.rank[i] = rank_of(source, i);
                status.slots = std::make_shared<const SourceSlots>(slots);
            }
            result.push_back(std::move(status));
        }
    }
    return result;
}

} // namespace ghost::dmx
