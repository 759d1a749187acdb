// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/merge.h"

#include "dmx/merge/settle.h"

#include <algorithm>
#include <utility>

namespace ghost::dmx {

void Merge::listen(std::chrono::nanoseconds now) {
    if (options_.sampling.count() > 0) sampling_until_ = now + options_.sampling;
}

void Merge::mark(std::uint16_t number, Input& input) {
    if (!input.dirty) dirty_.push_back(number);
    input.dirty = true;
}

bool Merge::shows_preview(std::uint16_t number) const {
    const std::vector<std::uint16_t>& only = options_.preview_universes;
    return options_.show_preview && (only.empty() || std::binary_search(only.begin(), only.end(), number));
}

void Merge::ignore(const Packet& packet, IgnoredSource::Why why, std::chrono::nanoseconds now) {
    ++(why == IgnoredSource::Why::preview ? counters_.preview : counters_.too_many_sources);
    const auto key = std::make_pair(packet.universe, packet.source);
    const auto place = ignored_.find(key);
    if (place == ignored_.end() && ignored_.size() >= kMaxIgnored) return;
    IgnoredSource& entry = place == ignored_.end() ? ignored_[key] : place->second;
    entry.universe = packet.universe;
    entry.protocol = packet.protocol;
    entry.why = why;
    entry.name = packet.source_name;
    entry.from = packet.from;
    entry.age = now;
    ++entry.packets;
}

bool Merge::asked_for(std::uint16_t number) const {
    return std::binary_search(options_.asked.begin(), options_.asked.end(), number);
}

void Merge::forget(const std::function<bool(std::uint16_t)>& which) {
    for (const auto& [number, input] : inputs_)
        if (!input.asked && which(number)) other_sources_ -= input.sources.size();
    std::erase_if(inputs_, [&](const auto& input) { return which(input.first); });
    std::erase_if(ignored_, [&](const auto& entry) { return which(entry.first.first); });
    std::erase_if(dirty_, which);
    if (std::erase_if(universes_.list, [&](const Universe& one) { return which(one.number); }) > 0)
        ++universes_.revision;
}

// Where all places are taken: one of those that were asked for takes that of the longest silent one that was
// not; the others wait for forget_silent().
Merge::Input* Merge::find_or_make_input(std::uint16_t number) {
    const auto place = inputs_.find(number);
    if (place != inputs_.end()) return &place->second;
    const bool asked = asked_for(number);
    const auto refuse = [&] {
        ++counters_.too_many_universes;
        refused_ = true;
        return nullptr;
    };
    if (inputs_.size() >= kMaxUniverses) {
        if (!asked) return refuse(); // without a search: there may be a hundred thousand a second
        const auto oldest =
            std::min_element(inputs_.begin(), inputs_.end(), [](const auto& a, const auto& b) {
                return a.second.asked != b.second.asked ? b.second.asked : a.second.heard < b.second.heard;
            });
        if (oldest->second.asked) return refuse();
        ++counters_.universes_forgotten;
        forget([gone = oldest->first](std::uint16_t one) { return one == gone; });
    }
    Input& input = inputs_[number];
    input.asked = asked;
    return &input;
}

void Merge::forget_silent() {
    if (!std::exchange(refused_, false) || options_.asked.empty()) return;
    std::vector<std::pair<std::chrono::nanoseconds, std::uint16_t>> silent;
    for (const auto& [number, input] : inputs_)
        if (!input.asked && input.sources.empty()) silent.emplace_back(input.heard, number);
    const std::size_t count = std::min(silent.size(), kForgottenAtOnce);
    std::partial_sort(silent.begin(), silent.begin() + static_cast<std::ptrdiff_t>(count), silent.end());
    std::vector<std::uint16_t> gone;
    for (std::size_t i = 0; i < count; ++i) gone.push_back(silent[i].second);
    std::sort(gone.begin(), gone.end());
    counters_.universes_forgotten += count;
    forget([&](std::uint16_t number) { return std::binary_search(gone.begin(), gone.end(), number); });
}

// Whether all places that the source could have are taken; then which of the sources may go for it, if any.
std::optional<std::size_t> Merge::place_for(const Input& input, const Packet& packet,
                                            std::chrono::nanoseconds now, bool& full) const {
    const bool artnet = packet.protocol == Protocol::artnet;
    full = artnet && count(packet.universe, Protocol::artnet) >= kMaxArtnetSources;
    if (full) return longest_silent(input.sources, now, Protocol::artnet);
    full = input.sources.size() >= kMaxSourcesPerUniverse ||
           (!input.asked && !input.sources.empty() && other_sources_ >= kMaxOtherSources);
    if (!full) return std::nullopt;
    if (const auto silent = longest_silent(input.sources, now)) return silent;
    if (const auto once = heard_once(input.sources, now)) return once;
    // Not with its first packet: whoever forges ever new sources of the highest priority evicts nobody.
    if (!ignored_.contains({packet.universe, packet.source})) return std::nullopt;
    return lowest_priority(input.sources, highest_priority(packet));
}

LevelSource* Merge::find_or_add(Input& input, const Packet& packet, std::chrono::nanoseconds now) {
    std::vector<LevelSource>& sources = input.sources;
    const auto same = [&](const LevelSource& source) { return source.key() == packet.source; };
    const auto found = std::find_if(sources.begin(), sources.end(), same);
    if (found != sources.end()) return &*found;
    bool full = false;
    const std::optional<std::size_t> place = place_for(input, packet, now, full);
    if (full && !place) {
        ignore(packet, IgnoredSource::Why::too_many, now);
        return nullptr;
    }
    if (place) {
        sources.erase(sources.begin() + static_cast<std::ptrdiff_t>(*place));
        ++counters_.sources_replaced;
        mark(packet.universe, input);
    } else {
        other_sources_ += input.asked ? 0 : 1;
    }
    const bool was_ignored = ignored_.erase({packet.universe, packet.source}) > 0;
    const bool alone = std::none_of(sources.begin(), sources.end(),
                                    [](const LevelSource& source) { return source.has_levels(); });
    const bool joined =
        packet.protocol != Protocol::sacn || alone || sampling_until_ || options_.priority_wait.count() == 0;
    LevelSource& added = sources.emplace_back(packet, joined, sent_by(packet.source), now);
    if (was_ignored) added.was_heard_before();
    return &added;
}

void Merge::terminate(std::uint16_t number, Input& input, const Packet& packet,
                      std::chrono::nanoseconds now) {
    const auto same = [&](const LevelSource& source) { return source.key() == packet.source; };
    const auto found = std::find_if(input.sources.begin(), input.sources.end(), same);
    if (found == input.sources.end()) return;
    if (!found->same_way(packet, now)) { // whoever forges it, or a second way of the same desk
        ++counters_.other_way;
        return;
    }
    if (found->release()) mark(number, input);
    if (input.dirty) rebuild(number, input); // a look that came just before is the one to hold
    input.sources.erase(found);
    input.ended = true;
    other_sources_ -= input.asked ? 0 : 1;
    ++counters_.sources_terminated;
    mark(number, input);
    apply_loss_policy(number, input, now); // nobody looks between what is gone and what is lost
}

namespace {

// A source shows something new.
void tell_rivals(std::vector<LevelSource>& all, LevelSource& source, std::chrono::nanoseconds now) {
    for (LevelSource& other : all) {
        if (&other == &source) continue;
        other.follow(source, now);
        source.follow(other, now);
    }
}

// Of each of them with those before it.
void compare_rivals(std::vector<LevelSource>& all, std::chrono::nanoseconds now) {
    constexpr std::size_t kMostRivals = 3; // what a packet costs is bounded
    for (auto source = all.begin(); all.size() > 1 && source != all.end(); ++source) {
        std::vector<const LevelSource*> rivals;
        for (auto before = all.begin(); before != source && rivals.size() < kMostRivals; ++before)
            if (source->rivals(*before)) rivals.push_back(&*before);
        source->compare_with(rivals, now);
    }
}

} // namespace

// ArtSync is ignored while two Art-Net sources merge (Art-Net 4).
bool Merge::must_hold(const Input& input, const LevelSource& source, const Packet& packet,
                      std::chrono::nanoseconds now) const {
    if (packet.protocol != Protocol::artnet && packet.sync_universe == 0) return false;
    if (!sync_.holds(source.key(), packet.sync_universe, packet.force_sync, now)) return false;
    return packet.protocol == Protocol::sacn ||
           std::count_if(input.sources.begin(), input.sources.end(), [](const LevelSource& other) {
               return other.key().protocol == Protocol::artnet;
           }) == 1;
}

std::shared_ptr<std::uint64_t> Merge::sent_by(const SourceKey& source) {
    std::weak_ptr<std::uint64_t>& known = sent_[sender_of(source)];
    std::shared_ptr<std::uint64_t> sent = known.lock();
    if (!sent) known = sent = std::make_shared<std::uint64_t>(0);
    return sent;
}

void Merge::pass_elsewhere(const SourceKey& source) {
    const auto known = sent_.find(sender_of(source));
    if (known == sent_.end()) return;
    if (const auto sent = known->second.lock()) ++*sent;
}

// A source numbers what it sends on a universe in one row: live, for preview, and what we do not use.
void Merge::pass(const Passing& packet) {
    pass_elsewhere(packet.source);
    const auto place = inputs_.find(packet.universe);
    if (place == inputs_.end()) return;
    for (LevelSource& source : place->second.sources)
        if (source.key().id == packet.source.id && source.key().protocol == packet.source.protocol)
            source.pass(packet.sequence);
}

// What it missed is missed once.
void Merge::pass_to_twin(Input& input, const Packet& packet, unsigned missed) {
    SourceKey twin = packet.source;
    twin.preview = !twin.preview;
    for (LevelSource& source : input.sources)
        if (packet.protocol == Protocol::sacn && source.key() == twin) source.pass(packet.sequence, missed);
}

void Merge::feed(const Packet& packet, std::chrono::nanoseconds now) {
    if (packet.source.preview && !shows_preview(packet.universe)) {
        pass({packet.source, packet.universe, packet.sequence});
        ignore(packet, IgnoredSource::Why::preview, now);
        return;
    }
    if (packet.terminated) {
        const auto place = inputs_.find(packet.universe);
        if (place != inputs_.end()) terminate(packet.universe, place->second, packet, now);
        return;
    }
    Input* const found = find_or_make_input(packet.universe);
    if (!found) return;
    Input& input = *found;
    LevelSource* source = find_or_add(input, packet, now);
    if (!source) return;
    input.heard = std::max(input.heard, now);
    if (!source->same_way(packet, now)) {
        ++counters_.other_way;
        return;
    }
    const std::optional<unsigned> missed = source->in_sequence(packet, now);
    if (!missed) {
        ++counters_.out_of_sequence;
        return;
    }
    counters_.missed += *missed;
    if (shows_preview(packet.universe)) pass_to_twin(input, packet, *missed);
    const bool hold = must_hold(input, *source, packet, now);
    if (hold) sync_.wait(packet.source, packet.sync_universe, packet.universe);
    source->keep(packet, hold, ++stamp_, now);
    counters_.held += hold ? 1 : 0;
    if (packet.start_code == 0) {
        input.arrival = std::max(input.arrival, now);
        input.interface_index = packet.interface_index;
        input.source = packet.source;
    }
    if (hold) return;
    mark(packet.universe, input);
    tell_rivals(input.sources, *source, now);
}

void Merge::feed(const SyncPacket& packet, std::chrono::nanoseconds now) {
    for (const std::uint16_t number : sync_.heard(packet, now)) {
        const auto place = inputs_.find(number);
        if (place == inputs_.end()) continue; // not kept
        Input& input = place->second;
        for (LevelSource& source : input.sources)
            if (sender_of(source.key()) == sender_of(packet.source) &&
                source.sync_universe() == packet.universe && source.release()) {
                mark(number, input);
                tell_rivals(input.sources, source, now);
            }
    }
}

template <class Which>
std::size_t Merge::remove_sources(Input& input, Which which) {
    const std::size_t gone = std::erase_if(input.sources, which);
    other_sources_ -= input.asked ? 0 : gone;
    return gone;
}

// Levels that wait for synchronisation that is lost.
bool Merge::release_unsynchronised(Input& input, std::chrono::nanoseconds now) {
    bool changed = false;
    for (LevelSource& source : input.sources)
        if (source.holding() && !sync_.holds(source.key(), source.sync_universe(), source.force_sync(), now))
            changed |= source.release();
    return changed;
}

bool Merge::let_newcomers_in(Input& input, std::chrono::nanoseconds now) {
    const bool beside_others =
        std::any_of(input.sources.begin(), input.sources.end(),
                    [](const auto& source) { return source.joined() && source.has_levels(); });
    if (beside_others)
        remove_sources(input,
                       [&](const LevelSource& source) { return !source.joined() && source.expired(now); });
    bool changed = false;
    for (LevelSource& source : input.sources) {
        const bool waits =
            beside_others && (now - source.first_heard() < options_.priority_wait || source.heard() < 2);
        if (source.joined() || waits) continue;
        source.join();
        changed = true;
    }
    return changed;
}

void Merge::keep_only(const std::vector<std::uint16_t>& universes) {
    forget([&](std::uint16_t number) {
        return !std::binary_search(universes.begin(), universes.end(), number);
    });
}

void Merge::ask_for(const std::vector<std::uint16_t>& universes) {
    options_.asked = universes;
    other_sources_ = 0;
    for (auto& [number, input] : inputs_) {
        input.asked = asked_for(number);
        other_sources_ += input.asked ? 0 : input.sources.size();
    }
}

void Merge::tick(std::chrono::nanoseconds now) {
    sync_.tick(now);
    std::erase_if(ignored_, [&](const auto& entry) { return now - entry.second.age > kIgnoredForgotten; });
    if (sampling_until_ && now >= *sampling_until_) sampling_until_.reset();
    for (auto& [number, input] : inputs_) {
        bool changed = release_unsynchronised(input, now);
        if (let_newcomers_in(input, now)) changed = true;
        if (loss_is_settled(input.sources, now)) {
            if (input.dirty || changed) rebuild(number, input); // the last look is the one to hold
            const std::size_t gone =
                remove_sources(input, [&](const LevelSource& source) { return source.expired(now); });
            counters_.sources_lost += gone;
            if (gone > 0 && !input.lost_since) input.ended = false;
            changed = true;
        }
        for (LevelSource& source : input.sources) {
            if (source.drop_old_priorities(now)) changed = true;
            source.measure_rate(now);
            counters_.lost += source.take_lost();
        }
        compare_rivals(input.sources, now);
        if (changed) mark(number, input);
        apply_loss_policy(number, input, now);
    }
    std::erase_if(sent_, [](const auto& entry) { return entry.second.expired(); });
    forget_silent();
}

void Merge::resume(std::chrono::nanoseconds pause, std::chrono::nanoseconds now) {
    sync_.resume(pause, now);
    for (auto& [number, input] : inputs_)
        for (LevelSource& source : input.sources) source.resume(pause, now);
}

void Merge::apply_loss_policy(std::uint16_t number, Input& input, std::chrono::nanoseconds now) {
    const bool live = std::any_of(input.sources.begin(), input.sources.end(),
                                  [](const LevelSource& source) { return source.has_levels(); });
    if (live || !input.seen) {
        input.lost_since.reset();
        input.black_due = false;
        return;
    }
    if (!input.lost_since) input.lost_since = now;
    const auto& black_after = options_.loss.black_after;
    if (!black_after || input.black_due || now - *input.lost_since < *black_after) return;
    input.black_due = true;
    mark(number, input);
}

void Merge::rebuild(std::uint16_t number, Input& input) {
    if (sampling_until_) return;
    const bool live = std::any_of(input.sources.begin(), input.sources.end(),
                                  [](const LevelSource& source) { return source.has_levels(); });
    // A universe appears with its first levels, not with a packet of priorities or a goodbye.
    input.seen |= live;
    if (!input.seen) return;
    Universe& universe = universes_.at(number);
    universe.arrival = input.arrival;
    universe.lost = !live;
    universe.black = !live && input.black_due;
    if (!live && !universe.black) return; // hold the last look
    if (live) universe.slot_count = slots_sent(input.sources, shows_preview(number));
    const Levels merged =
        live ? merge_levels(input.sources, shows_preview(number), options_.artnet_ltp) : Levels{};
    if (universe.revision != 0 && *universe.levels == merged) return;
    universe.levels = std::make_shared<const Levels>(merged);
    universe.revision = ++universes_.revision;
}

bool Merge::pending(std::uint16_t universe) const {
    const auto found = inputs_.find(universe);
    return !sampling_until_ && found != inputs_.end() && found->second.dirty;
}

bool Merge::all_heard_since(std::uint16_t universe, std::chrono::nanoseconds since) const {
    const auto found = inputs_.find(universe);
    return found == inputs_.end() ||
           std::all_of(found->second.sources.begin(), found->second.sources.end(),
                       [&](const LevelSource& source) { return source.last_levels() > since; });
}

bool Merge::has_source(std::uint16_t universe) const {
    const auto found = inputs_.find(universe);
    return found != inputs_.end() && !found->second.sources.empty();
}

std::size_t Merge::count(std::uint16_t universe, Protocol protocol) const {
    const auto found = inputs_.find(universe);
    if (found == inputs_.end()) return 0;
    const std::vector<LevelSource>& sources = found->second.sources;
    return static_cast<std::size_t>(
        std::count_if(sources.begin(), sources.end(),
                      [&](const LevelSource& source) { return source.key().protocol == protocol; }));
}

const Universes& Merge::universes() {
    if (sampling_until_) return universes_;
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
        const std::size_t first = result.size();
        for (const LevelSource& source : input.sources)
            result.push_back(source.status(number, options_.slot_status, now));
        const std::vector<std::size_t> held = slots_held(input.sources, shows_preview(number));
        for (std::size_t i = 0; i < held.size(); ++i) result[first + i].slots_held = held[i];
        const Universe* const shown = held.size() > 1 ? universes_.find(number) : nullptr;
        if (!shown) continue;
        // Of what is about to show, where that is newer: of a desk that is never still, too, it is told.
        const bool preview = shows_preview(number);
        const Levels merged =
            input.dirty ? merge_levels(input.sources, preview, options_.artnet_ltp) : *shown->levels;
        const auto overruled = slots_overruled(input.sources, preview, merged);
        const auto contested = slots_contested(input.sources, preview, merged);
        for (std::size_t i = 0; i < held.size(); ++i) {
            result[first + i].slots_overruled = overruled[i];
            result[first + i].slots_contested = contested[i];
        }
        for (std::size_t i = 1; i < held.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const Rivalry* const rivalry = input.sources[i].rivalry(input.sources[k]);
                if (!rivalry) continue;
                const std::size_t covered = rivalry->met(Rivalry::covers, now);
                for (SourceStatus* one : {&result[first + k], &result[first + i]}) {
                    one->slots_overruled = std::max(one->slots_overruled, covered);
                    one->slots_contested = std::max(one->slots_contested, covered);
                    one->slots_shared = std::max(one->slots_shared, rivalry->met(Rivalry::shares, now));
                }
            }
    }
    return result;
}

std::vector<IgnoredSource> Merge::ignored(std::chrono::nanoseconds now) const {
    std::vector<IgnoredSource> result;
    for (const auto& [key, entry] : ignored_) {
        result.push_back(entry);
        result.back().age = now - entry.age;
    }
    return result;
}

std::vector<LostUniverse> Merge::lost(std::chrono::nanoseconds now) const {
    std::vector<LostUniverse> result;
    for (const auto& [number, input] : inputs_)
        if (input.lost_since)
            result.push_back({number, input.black_due, now - *input.lost_since, input.ended,
                              now - input.arrival, input.interface_index, source_id(input.source)});
    return result;
}

std::vector<std::uint16_t> Merge::sync_universes() const {
    // By how many universes name each: those that are asked for, then all. Who forges sources can name as
    // many as there are numbers, but a desk names one with all of its universes.
    std::map<std::uint16_t, std::pair<std::size_t, std::size_t>> named;
    for (const auto& [number, input] : inputs_)
        for (const LevelSource& source : input.sources)
            if (source.key().protocol == Protocol::sacn && source.sync_universe() != 0) {
                auto& [asked, all] = named[source.sync_universe()];
                asked += input.asked ? 1 : 0;
                ++all;
            }
    std::vector<std::uint16_t> result;
    for (const auto& [universe, times] : named) result.push_back(universe);
    if (result.size() > kMaxSyncGroups) {
        std::stable_sort(result.begin(), result.end(),
                         [&](std::uint16_t a, std::uint16_t b) { return named[a] > named[b]; });
        result.resize(kMaxSyncGroups);
        std::sort(result.begin(), result.end());
    }
    return result;
}

} // namespace ghost::dmx
