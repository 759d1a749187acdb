// SPDX-License-Identifier: Apache-2.0
// What keeps levels away from a fixture: no patch, no packets, nobody who sends any more, somebody who sends
// with a higher priority.
#include "diagnose/explain_parts.h"

#include <algorithm>
#include <map>

namespace ghost::scene::explained {
namespace {

using fixture::Address;

// Numbers of universes: "1, 2 and 4".
std::string list_text(const std::vector<int>& universes) {
    constexpr std::size_t kMost = 8;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < universes.size() && i < kMost; ++i)
        names.push_back(std::to_string(universes[i]));
    if (universes.size() > kMost) names.push_back(std::to_string(universes.size() - kMost) + " more");
    return joined(names);
}

// Whether a sentence about everything says why a universe does not come.
bool tells_silence(Trouble trouble) {
    switch (trouble) {
    case Trouble::not_listening:
    case Trouble::no_interface:
    case Trouble::cable:
    case Trouble::nothing_arrives:
    case Trouble::port_shared:
    case Trouble::same_host:
        return true;
    default:
        return false;
    }
}

std::string never_text(const ExplainInput& input, const UniverseFacts& facts) {
    const std::string universe = "universe " + std::to_string(facts.universe);
    const Reception& reception = input.reception;
    std::vector<int> others;
    if (reception.kind == Reception::Kind::recording) {
        if (facts.first_frame_s >= 0)
            return universe + " begins in the recording at " + number(facts.first_frame_s, 2) +
                   " s, this is " + number(reception.at_s, 2) + " s";
        for (const auto& [number_of, first_s] : reception.first_frames_s) others.push_back(number_of);
        return universe + " is not in the recording, which has " + list_text(others);
    }
    std::string text = universe + " never arrived in " + number(reception.listened_s, 1) + " s";
    bool said = false;
    for (const Sentence& sentence : reception.diagnosis) {
        const bool ours = sentence.universes.contains(facts.universe);
        if (!sentence.is_problem ||
            !(ours || (sentence.universes.empty() && tells_silence(sentence.trouble))))
            continue;
        text += (said ? "; " : ": ") + sentence.text;
        said = true;
    }
    if (said) return text;
    for (const dmx::Universe& seen : input.universes.list) others.push_back(seen.number);
    if (!others.empty()) return text + "; what arrives is " + list_text(others);
    return text + (reception.packets == 0 ? ", nor did any packet" : "");
}

bool missing(const Explanation& explanation, const Reason* direct, int universe) {
    if (!direct) return false;
    for (const int index : direct->channels) {
        const ChannelFacts& channel = explanation.channels[static_cast<std::size_t>(index)];
        if (channel.reading.received) continue;
        for (const Address& place : channel.places)
            if (place.universe == universe) return true;
    }
    return false;
}

// Channels of a fixture that lie past those that its universe comes with.
struct Past {
    std::size_t count = 0;
    bool blocks = false; // one of these is to blame
};

Past channels_past(const Explanation& explanation, const Reason* direct, int universe, int slot_count) {
    Past past;
    for (std::size_t i = 0; i < explanation.channels.size(); ++i)
        for (const Address& place : explanation.channels[i].places) {
            if (place.universe != universe || place.channel <= slot_count) continue;
            ++past.count;
            past.blocks |= direct && std::find(direct->channels.begin(), direct->channels.end(),
                                               static_cast<int>(i)) != direct->channels.end();
        }
    return past;
}

bool uses(const Explanation& explanation, const Reason* direct, int universe) {
    if (!direct) return false;
    for (const int index : direct->channels)
        for (const Address& place : explanation.channels[static_cast<std::size_t>(index)].places)
            if (place.universe == universe) return true;
    return false;
}

// "22 channels (512 in some packets)"
std::string slots_text(const UniverseFacts& facts) {
    const std::string text =
        std::to_string(facts.slot_count) + (facts.slot_count == 1 ? " channel" : " channels");
    return facts.most_slots > facts.slot_count
               ? text + " (" + std::to_string(facts.most_slots) + " in some packets)"
               : text;
}

std::string so(const Reason* direct) {
    return direct ? ", and " + direct->text : "";
}

} // namespace
} // namespace ghost::scene::explained

namespace ghost::scene {

Reception reception_of(const dmx::Statistics& statistics, const PatchMap& patch, double listened_s) {
    Reception reception;
    reception.kind = Reception::Kind::desk;
    reception.listened_s = listened_s;
    reception.sources = statistics.sources;
    reception.packets = statistics.packets_sacn + statistics.packets_artnet;
    reception.preview = statistics.merge.preview;
    reception.unlisted = statistics.unlisted;
    reception.artnet_ltp = statistics.listening.artnet_ltp;
    for (const std::uint64_t count : statistics.drops) reception.not_understood += count;
    reception.diagnosis = diagnose(statistics, patch);
    return reception;
}

} // namespace ghost::scene

namespace ghost::scene::explained {

std::vector<UniverseFacts> universe_facts(const ExplainInput& input,
                                          const std::vector<ChannelFacts>& channels) {
    std::map<int, std::vector<std::size_t>> slots;
    for (const ChannelFacts& channel : channels)
        for (const fixture::Address& place : channel.places)
            slots[place.universe].push_back(static_cast<std::size_t>(place.channel - 1));
    std::vector<UniverseFacts> result;
    for (const auto& [number_of, own] : slots) {
        UniverseFacts facts;
        facts.universe = number_of;
        facts.first_frame_s = -1;
        for (const auto& [recorded, first_s] : input.reception.first_frames_s)
            if (recorded == number_of) facts.first_frame_s = first_s;
        if (const dmx::Universe* found = number_of <= dmx::kMaxUniverse
                                             ? input.universes.find(static_cast<std::uint16_t>(number_of))
                                             : nullptr) {
            facts.received = true;
            facts.lost = found->lost;
            facts.black = found->black;
            facts.slot_count = facts.most_slots = found->slot_count;
            facts.age_s = input.now_s - std::chrono::duration<double>(found->arrival).count();
        }
        for (const dmx::SourceStatus& source : input.reception.sources) {
            if (source.universe != number_of) continue;
            UniverseFacts::Sender sender;
            facts.most_slots = std::max<int>(facts.most_slots, source.most_slots);
            sender.protocol = dmx::protocol_name(source.protocol);
            sender.name = source.protocol == dmx::Protocol::artnet ? source.id : source.name;
            sender.from = dmx::place_text(source);
            sender.priority = source.priority;
            sender.per_address_priority = source.per_address_priority;
            sender.rate_hz = source.rate_hz;
            sender.age_s = std::chrono::duration<double>(source.age).count();
            for (const std::size_t slot : own) {
                sender.channels += slot < source.slot_count ? 1 : 0;
                int best = 0;
                for (const dmx::SourceStatus& other : input.reception.sources)
                    if (other.universe == number_of && other.slots)
                        best = std::max<int>(best, other.slots->rank[slot]);
                sender.channels_held += source.slots && best > 0 && source.slots->rank[slot] == best ? 1 : 0;
            }
            facts.senders.push_back(std::move(sender));
        }
        result.push_back(std::move(facts));
    }
    return result;
}

std::vector<Reason> causes_in_network(const ExplainInput& input, const fixture::Patch& patch,
                                      const Explanation& explanation, const fixture::State& state,
                                      const Reason* direct) {
    std::vector<Reason> findings;
    for (std::size_t b = 0; b < explanation.footprint.size(); ++b) {
        if (explanation.footprint[b] == 0) continue;
        if (b < explanation.addresses.size() && explanation.addresses[b].channel > 0) continue;
        const bool blocks =
            direct && std::any_of(direct->channels.begin(), direct->channels.end(), [&](int index) {
                const ChannelFacts& channel = explanation.channels[static_cast<std::size_t>(index)];
                return channel.dmx_break == static_cast<int>(b) + 1 && channel.number > 0;
            });
        const bool is_known = explanation.is_address_known;
        findings.push_back({is_known ? Cause::not_patched : Cause::no_address,
                            blocks,
                            (is_known ? "it is not patched" : "its address cannot be read") +
                                (explanation.footprint.size() > 1 ? " (break " + std::to_string(b + 1) + ")"
                                                                  : std::string()) +
                                ": without an address its channels keep their defaults" +
                                (blocks ? so(direct) : ""),
                            is_known ? "they are not patched" : "their address cannot be read",
                            {}});
    }
    for (const UniverseFacts& facts : explanation.universes) {
        const std::string name = "their universe " + std::to_string(facts.universe);
        if (!facts.received) {
            const bool blocks = missing(explanation, direct, facts.universe);
            const bool no_input = input.reception.kind == Reception::Kind::none;
            const std::string text =
                no_input ? "there is no DMX: " +
                               (input.reception.recording.empty() ? std::string("the show has no recording")
                                                                  : input.reception.recording) +
                               " and no desk is listened to; all channels keep their defaults"
                         : never_text(input, facts) + "; its channels keep their defaults";
            findings.push_back({no_input ? Cause::no_input : Cause::never_received,
                                blocks,
                                text + (blocks ? so(direct) : ""),
                                no_input ? "there is no DMX" : name + " never arrived",
                                {}});
        } else if (facts.lost) {
            const bool blocks = uses(explanation, direct, facts.universe);
            findings.push_back({Cause::lost,
                                blocks,
                                "universe " + std::to_string(facts.universe) +
                                    " is lost: its last packet came " + number(facts.age_s, 1) +
                                    " s ago and " +
                                    (facts.black ? "it went black (--on-loss)" : "its last look is held") +
                                    (blocks ? so(direct) : ""),
                                name + " is lost",
                                {}});
        } else if (const Past past = channels_past(explanation, direct, facts.universe, facts.slot_count);
                   past.count > 0) {
            findings.push_back({Cause::not_sent,
                                past.blocks,
                                "universe " + std::to_string(facts.universe) + " comes with " +
                                    slots_text(facts) + ", and " + std::to_string(past.count) +
                                    " of the fixture lie past these (is it patched on the desk?)" +
                                    (past.blocks ? so(direct) : ""),
                                name + " comes with fewer channels",
                                {}});
        }
    }
    add_overrides(input, patch, explanation, state, direct, findings);
    add_two_desks(input, patch, explanation, state, direct, findings);
    return findings;
}

} // namespace ghost::scene::explained
