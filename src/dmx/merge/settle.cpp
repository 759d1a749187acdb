// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/settle.h"

#include "dmx/merge/merge.h"

#include <algorithm>

namespace ghost::dmx {

bool loss_is_settled(std::span<const LevelSource> sources, std::chrono::nanoseconds now) {
    std::optional<std::chrono::nanoseconds> last;
    for (const LevelSource& source : sources)
        if (source.joined() && source.expired(now))
            last = std::max(last.value_or(source.expires()), source.expires());
    if (!last) return false;
    return std::all_of(sources.begin(), sources.end(), [&](const LevelSource& source) {
        return !source.joined() || !source.has_levels() || source.expired(now) ||
               source.last_levels() > *last;
    });
}

std::optional<std::size_t> longest_silent(std::span<const LevelSource> sources, std::chrono::nanoseconds now,
                                          std::optional<Protocol> of) {
    std::optional<std::size_t> longest;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Protocol protocol = sources[i].key().protocol;
        if (protocol == Protocol::usb || (of && protocol != *of) || !sources[i].expired(now)) continue;
        if (!longest || sources[i].last_levels() < sources[*longest].last_levels()) longest = i;
    }
    return longest;
}

std::optional<std::size_t> heard_once(std::span<const LevelSource> sources, std::chrono::nanoseconds now) {
    std::optional<std::size_t> oldest;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const LevelSource& source = sources[i];
        if (source.key().protocol != Protocol::sacn || source.heard() != 1) continue;
        if (now - source.first_heard() < kReplaceable) continue;
        if (!oldest || source.first_heard() < sources[*oldest].first_heard()) oldest = i;
    }
    return oldest;
}

std::uint8_t highest_priority(const Packet& packet) {
    if (packet.start_code != 0xDD) return packet.priority;
    std::uint8_t highest = 0;
    for (const std::uint8_t one : packet.slots)
        if (one <= kMaxPriority) highest = std::max(highest, one);
    return highest;
}

std::optional<std::size_t> lowest_priority(std::span<const LevelSource> sources, std::uint8_t newcomer) {
    std::optional<std::size_t> lowest;
    const auto rank = [&](std::size_t i) {
        return std::make_pair(sources[i].priority(), -sources[i].first_heard());
    };
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (sources[i].key().protocol == Protocol::usb) continue;
        if (sources[i].priority() < newcomer && (!lowest || rank(i) < rank(*lowest))) lowest = i;
    }
    return lowest;
}

namespace {

// Which sources count: those for preview or those that are live, and of these the ones that joined.
std::vector<bool> taking_part(std::span<const LevelSource> sources, bool show_preview) {
    const auto any = [&](auto&& which) { return std::any_of(sources.begin(), sources.end(), which); };
    const bool preview =
        show_preview && any([](const LevelSource& s) { return s.has_levels() && s.key().preview; });
    const auto wanted = [&](const LevelSource& s) { return s.has_levels() && s.key().preview == preview; };
    const bool some_joined = any([&](const LevelSource& s) { return wanted(s) && s.joined(); });
    std::vector<bool> result(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
        result[i] = wanted(sources[i]) && (sources[i].joined() || !some_joined);
    return result;
}

} // namespace

namespace {

// Of each source the number of slots that it holds and for which this is true; unless moving_too, of those
// that stand still.
template <class Counts>
std::vector<std::size_t> count_held(std::span<const LevelSource> sources, bool show_preview, Counts counts,
                                    bool moving_too = false) {
    const std::vector<bool> takes_part = taking_part(sources, show_preview);
    Levels best{};
    for (std::size_t i = 0; i < sources.size(); ++i)
        for (std::size_t slot = 0; takes_part[i] && slot < sources[i].slot_count(); ++slot)
            best[slot] = std::max(best[slot], sources[i].rank(slot));
    const auto holds = [&](std::size_t i, std::size_t slot) {
        return takes_part[i] && best[slot] > 0 && sources[i].rank(slot) == best[slot];
    };
    // What differs where all that hold it stand still does so for longer than desks that follow each other
    // are apart.
    const auto stands = [&](std::size_t slot) {
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (slot < sources[i].slot_count() && holds(i, slot) && !sources[i].stands(slot)) return false;
        return true;
    };
    std::vector<std::size_t> result(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i)
        for (std::size_t slot = 0; slot < sources[i].slot_count(); ++slot)
            if (holds(i, slot) && counts(sources[i], slot) && (moving_too || stands(slot))) ++result[i];
    return result;
}

} // namespace

std::vector<std::size_t> slots_held(std::span<const LevelSource> sources, bool show_preview) {
    return count_held(
        sources, show_preview, [](const LevelSource&, std::size_t) { return true; }, true);
}

std::vector<std::size_t> slots_overruled(std::span<const LevelSource> sources, bool show_preview,
                                         const Levels& merged) {
    return count_held(sources, show_preview, [&](const LevelSource& source, std::size_t slot) {
        return source.level(slot) != merged[slot];
    });
}

std::vector<std::size_t> slots_contested(std::span<const LevelSource> sources, bool show_preview,
                                         const Levels& merged) {
    return count_held(sources, show_preview, [&](const LevelSource& source, std::size_t slot) {
        return source.level(slot) > 0 && source.level(slot) != merged[slot];
    });
}

std::uint16_t slots_sent(std::span<const LevelSource> sources, bool show_preview) {
    const std::vector<bool> takes_part = taking_part(sources, show_preview);
    std::size_t most = 0;
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (takes_part[i]) most = std::max(most, sources[i].slot_count());
    return static_cast<std::uint16_t>(most);
}

Levels merge_levels(std::span<const LevelSource> sources, bool show_preview, bool artnet_ltp) {
    const std::vector<bool> takes_part = taking_part(sources, show_preview);
    Levels merged{};
    Levels best{};                               // priority + 1 of the holder of each slot, 0 = nobody
    std::array<std::uint32_t, kSlots> changed{}; // by the Art-Net source in merged
    const auto add = [&](const LevelSource& source) {
        const bool latest = artnet_ltp && source.key().protocol == Protocol::artnet;
        for (std::size_t i = 0; i < source.slot_count(); ++i) {
            const std::uint8_t rank = source.rank(i);
            if (rank == 0 || rank < best[i]) continue;
            const bool both_artnet = latest && rank == best[i] && changed[i] != 0;
            const bool takes = rank > best[i] ||
                               (both_artnet ? source.changed(i) > changed[i] : source.level(i) > merged[i]);
            if (!takes) continue;
            best[i] = rank;
            merged[i] = source.level(i);
            changed[i] = latest ? source.changed(i) : 0;
        }
    };
    // Art-Net first: its latest level meets the others as one.
    for (const Protocol protocol : {Protocol::artnet, Protocol::sacn, Protocol::usb})
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (takes_part[i] && sources[i].key().protocol == protocol) add(sources[i]);
    return merged;
}

} // namespace ghost::dmx
