// SPDX-License-Identifier: Apache-2.0
// Desks that share a fixture: one that a higher priority keeps out, and two of equal priority, of which
// each has its way on some channels and which together make no light.
#include "diagnose/explain_parts.h"

#include <algorithm>

namespace ghost::scene::explained {
namespace {

using fixture::Address;

std::string sender_text(const dmx::SourceStatus& source) {
    const std::string from = dmx::place_text(source);
    return (source.name.empty() ? from : "'" + source.name + "'") + " (" +
           dmx::protocol_name(source.protocol) + (source.name.empty() ? "" : ", " + from) + ", priority ";
}

std::string ranked_text(const dmx::SourceStatus& source, std::size_t slot) {
    return sender_text(source) + std::to_string(source.slots->rank[slot] - 1) +
           (source.per_address_priority ? " for this address" : "") + ")";
}

// Whether both take part in the merge: what is marked preview is shown instead of the live look, not with it.
bool meet(const dmx::SourceStatus& one, const dmx::SourceStatus& other) {
    return one.universe == other.universe && one.preview == other.preview && one.slots && other.slots;
}

// A slot of the fixture where a source does not have its way.
struct Beaten {
    std::size_t slot = 0;
    const dmx::SourceStatus* holder = nullptr; // who has; null: nobody, by per-address priority 0
    const ChannelFacts* channel = nullptr;
};

std::vector<Beaten> slots_lost(const ExplainInput& input, const Explanation& explanation,
                               const dmx::SourceStatus& loser) {
    std::vector<Beaten> lost;
    for (const ChannelFacts& channel : explanation.channels)
        for (const Address& place : channel.places) {
            if (place.universe != loser.universe) continue;
            const auto slot = static_cast<std::size_t>(place.channel - 1);
            const dmx::SourceStatus* holder = nullptr;
            for (const dmx::SourceStatus& other : input.reception.sources)
                if (meet(loser, other) && (!holder || other.slots->rank[slot] > holder->slots->rank[slot]))
                    holder = &other;
            if (slot >= loser.slot_count || !holder) continue;
            const int best = holder->slots->rank[slot];
            if (best == 0 && loser.slots->levels[slot] > 0) // nobody has it
                lost.push_back({slot, nullptr, &channel});
            if (best > loser.slots->rank[slot] && holder->slots->levels[slot] != loser.slots->levels[slot])
                lost.push_back({slot, holder, &channel});
        }
    return lost;
}

// Why a source with priorities per address does not hold a slot.
std::string given_up_text(const dmx::SourceStatus& source, std::size_t slot) {
    if (slot >= source.priority_count) return "its list of priorities per address ends before that channel";
    if (source.bad_priorities > 0) return "its priority per address there is 0, or above 200, which is none";
    return "says by its priority per address that the channel is not its own";
}

// Whether the fixture would shine had this source its way.
bool would_shine(const ExplainInput& input, const fixture::Patch& patch, const fixture::State& state,
                 const dmx::SourceStatus& loser, const std::vector<Beaten>& lost) {
    fixture::Levels levels;
    dmx::Levels own{};
    for (const dmx::Universe& universe : input.universes.list) {
        levels.set(universe.number, *universe.levels);
        if (universe.number == loser.universe) own = *universe.levels;
    }
    for (const Beaten& beaten : lost) own[beaten.slot] = loser.slots->levels[beaten.slot];
    levels.set(loser.universe, own);
    const fixture::Targets targets = fixture::decode(patch, levels);
    for (std::size_t b = 0; b < state.beams.size() && b < targets.beams.size(); ++b) {
        fixture::BeamState beam = state.beams[b];
        beam.optics = targets.beams[b];
        beam.optics.shutter = beam.optics.shutter_position;
        if (fraction_of(*patch.type, beam, input.gobos) > kNearlyDark) return true;
    }
    return false;
}

} // namespace

void add_overrides(const ExplainInput& input, const fixture::Patch& patch, const Explanation& explanation,
                   const fixture::State& state, const Reason* direct, std::vector<Reason>& findings) {
    for (const dmx::SourceStatus& loser : input.reception.sources) {
        if (!loser.slots) continue;
        const std::vector<Beaten> lost = slots_lost(input, explanation, loser);
        if (lost.empty()) continue;
        // The channel that is to blame, if it is one of these.
        const Beaten* shown = &lost.front();
        for (const Beaten& beaten : lost)
            for (const int index : direct ? direct->channels : std::vector<int>{})
                if (shown == &lost.front() &&
                    beaten.channel == &explanation.channels[static_cast<std::size_t>(index)])
                    shown = &beaten;
        const bool blocks = direct && would_shine(input, patch, state, loser, lost);
        const auto level = [&](const dmx::SourceStatus& source) {
            return std::to_string(source.slots->levels[shown->slot]);
        };
        const std::string rank = loser.slots->rank[shown->slot] > 0
                                     ? ranked_text(loser, shown->slot)
                                     : sender_text(loser) + "none for this address)";
        if (!shown->holder) {
            findings.push_back({Cause::overridden,
                                blocks,
                                sender_text(loser) + "none for this address) sends " + level(loser) + " on " +
                                    place_text(*shown->channel) + " but " +
                                    given_up_text(loser, shown->slot) + "; nobody holds it",
                                "nobody holds their channels",
                                {}});
            continue;
        }
        findings.push_back({Cause::overridden,
                            blocks,
                            ranked_text(*shown->holder, shown->slot) + " overrides " + rank +
                                (blocks ? ", which would light it" : "") + ": on " +
                                place_text(*shown->channel) + " it sends " + level(*shown->holder) +
                                " instead of " + level(loser),
                            "a source of higher priority overrides another",
                            {}});
    }
}

// Of two sources that rank alike on channels of the fixture and differ there: whether one of them alone would
// light it.
void add_two_desks(const ExplainInput& input, const fixture::Patch& patch, const Explanation& explanation,
                   const fixture::State& state, const Reason* direct, std::vector<Reason>& findings) {
    for (const dmx::SourceStatus& one : input.reception.sources) {
        if (!one.slots) continue;
        std::vector<Beaten> lost; // slots that it holds, where another of its rank shows
        for (const ChannelFacts& channel : explanation.channels)
            for (const Address& place : channel.places) {
                if (place.universe != one.universe) continue;
                const auto slot = static_cast<std::size_t>(place.channel - 1);
                const int rank = one.slots->rank[slot];
                for (const dmx::SourceStatus& other : input.reception.sources)
                    if (&other != &one && meet(one, other) && rank > 0 && other.slots->rank[slot] == rank &&
                        other.slots->levels[slot] != one.slots->levels[slot] &&
                        other.slots->levels[slot] == input.universes.level(one.universe, place.channel)) {
                        lost.push_back({slot, &other, &channel});
                        break;
                    }
            }
        if (lost.empty()) continue;
        const bool blocks = direct && would_shine(input, patch, state, one, lost);
        const Beaten* shown = &lost.front();
        for (const Beaten& beaten : lost)
            for (const int index : direct ? direct->channels : std::vector<int>{})
                if (beaten.channel == &explanation.channels[static_cast<std::size_t>(index)]) shown = &beaten;
        const auto level = [&](const dmx::SourceStatus& source) {
            return std::to_string(source.slots->levels[shown->slot]);
        };
        const bool is_latest = input.reception.artnet_ltp && one.protocol == dmx::Protocol::artnet &&
                               shown->holder->protocol == dmx::Protocol::artnet;
        findings.push_back({Cause::two_desks,
                            blocks,
                            ranked_text(one, shown->slot) + " and " +
                                ranked_text(*shown->holder, shown->slot) + " have the same say: on " +
                                place_text(*shown->channel) + " they send " + level(one) + " and " +
                                level(*shown->holder) + ", and " + level(*shown->holder) + " shows" +
                                (is_latest ? ", for it changed last (LTP)" : "") +
                                (blocks ? "; the first alone would light it" : ""),
                            "two sources of equal priority send different things",
                            {}});
    }
}

} // namespace ghost::scene::explained
