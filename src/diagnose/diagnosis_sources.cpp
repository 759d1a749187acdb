// SPDX-License-Identifier: Apache-2.0
// What is wrong with sources that arrive: too many, for blind, of lower priority, two that fight, levels that
// wait, packets that get lost.
#include "base/print.h"
#include "diagnose/diagnosis_parts.h"
#include "dmx/wire/timecode.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace ghost::scene::diagnosed {
namespace {

using Sources = std::vector<const dmx::SourceStatus*>;

// Of two that have one name and address also what tells them apart.
std::string apart_text(const dmx::SourceStatus& source, const Sources& all) {
    const std::string text = source_text(source);
    const bool alone = std::none_of(all.begin(), all.end(), [&](const dmx::SourceStatus* other) {
        return other != &source && source_text(*other) == text;
    });
    if (alone) return text;
    if (source.protocol == dmx::Protocol::artnet) return source_text("", source.id, source.protocol);
    return source_text(source.name, dmx::place_text(source) + ", CID " + source.id, source.protocol);
}

// ". 10.0.0.2 sends by both protocols: ..", where one machine is several sources; else "".
std::string one_machine_text(const Sources& all) {
    const auto with = [&](const dmx::SourceStatus& one, bool same_protocol) {
        return std::any_of(all.begin(), all.end(), [&](const dmx::SourceStatus* other) {
            return other != &one && other->from == one.from && one.protocol == dmx::Protocol::artnet &&
                   (other->protocol == one.protocol) == same_protocol;
        });
    };
    for (const dmx::SourceStatus* one : all) {
        const std::string place = one_line(dmx::place_text(*one));
        if (with(*one, true))
            return ". " + place +
                   " names more than one Physical (input): it has several, or it changes what it names, and "
                   "each counts as a source";
        if (with(*one, false))
            return ". " + place + " sends by sACN and by Art-Net: if that is one desk, one of them will do";
    }
    return "";
}

// "; there 10.0.0.7 (silent for 4 s) and 10.0.0.8 have the places of Art-Net, .."; "" where fewer do.
std::string artnet_holders_text(const dmx::Statistics& statistics, int universe) {
    std::string text;
    std::size_t count = 0;
    Sources holders;
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (source.universe != universe || source.protocol != dmx::Protocol::artnet) continue;
        holders.push_back(&source);
        text += (count++ > 0 ? " and " : "") + one_line(source.id);
        if (source.age >= kSilent) text += " (silent for " + seconds_text(source.age) + ")";
    }
    if (count < dmx::kMaxArtnetSources) return "";
    return "; there " + text + " have the places of Art-Net, and one that is silent for " +
           seconds_text(dmx::kArtnetLoss) + " makes room" + one_machine_text(holders);
}

std::string joined(const std::set<std::string>& names) {
    constexpr std::size_t kMost = 4;
    std::string text;
    std::size_t count = 0;
    for (const std::string& name : names) {
        if (count == kMost) return text + " and " + std::to_string(names.size() - kMost) + " more";
        text += (count == 0 ? "" : count + 1 == names.size() ? " and " : ", ") + name;
        ++count;
    }
    return text;
}

void add_too_many(const dmx::Statistics& statistics, Sentences& out) {
    for (const auto protocol : {dmx::Protocol::artnet, dmx::Protocol::sacn}) {
        using Holders = std::string;
        std::map<std::pair<std::set<int>, Holders>, std::set<std::string>> by_universes;
        std::map<std::pair<std::string, Holders>, std::set<int>> by_source;
        for (const dmx::IgnoredSource& one : statistics.ignored)
            if (one.why == dmx::IgnoredSource::Why::too_many && one.protocol == protocol)
                by_source[{source_text(one.name, dmx::address_text(one.from), protocol),
                           protocol == dmx::Protocol::artnet ? artnet_holders_text(statistics, one.universe)
                                                             : ""}]
                    .insert(one.universe);
        for (const auto& [who, universes] : by_source)
            by_universes[{universes, who.second}].insert(who.first);
        for (const auto& [where, who] : by_universes) {
            const auto& [universes, holders] = where;
            const std::string is =
                who.size() == 1 ? " is one source too many on " : " are too many sources on ";
            const std::string rule =
                protocol == dmx::Protocol::artnet
                    ? " and ignored: Art-Net merges two" + holders
                    : " and ignored: " + std::to_string(dmx::kMaxSourcesPerUniverse) +
                          " are merged, those of the highest priority and of these the longest known";
            out.push_back(
                problem(Trouble::too_many, joined(who) + is + universes_text(universes) + rule, universes));
        }
    }
}

// Of the slots that a source sends, how many another one ranks higher on.
std::size_t outranked_by(const dmx::SourceStatus& other, const dmx::SourceStatus& source) {
    if (!other.slots || !source.slots)
        return source.slots_held == 0 || other.highest_priority > source.highest_priority ? 1 : 0;
    std::size_t count = 0;
    for (std::size_t slot = 0; slot < source.slot_count; ++slot)
        count += other.slots->rank[slot] > source.slots->rank[slot] ? 1 : 0;
    return count;
}

// Of those that rank higher where it sends, the one that does on most slots, of equal ones the highest; null:
// none does.
const dmx::SourceStatus* winner_of(const std::vector<dmx::SourceStatus>& sources,
                                   const dmx::SourceStatus& loser) {
    const dmx::SourceStatus* best = nullptr;
    std::pair<std::size_t, int> most;
    for (const dmx::SourceStatus& one : sources) {
        if (one.universe != loser.universe || &one == &loser || one.slots_held == 0) continue;
        const std::pair<std::size_t, int> here(outranked_by(one, loser), one.highest_priority);
        if (here.first == 0 || (best && here <= most)) continue;
        best = &one;
        most = here;
    }
    return best;
}

std::string ranked_text(const dmx::SourceStatus& source) {
    if (!source.per_address_priority)
        return source_text(source) + " (priority " + std::to_string(source.priority) + ")";
    return source_text(source) + " (priority " + std::to_string(source.highest_priority) +
           " at most, one for each address)";
}

// Every dimmer that is patched on its universe, and that it does not give away, stays at 0, not all that it
// sends; a chase passes through 0.
bool dimmers_are_down(const dmx::SourceStatus& source, const PatchMap& patch) {
    if (!source.slots) return false;
    std::vector<int> dimmers = patch.dimmers(source.universe);
    std::erase_if(dimmers, [&](int address) {
        return source.per_address_priority && source.slots->rank[static_cast<std::size_t>(address - 1)] == 0;
    });
    return !dimmers.empty() && std::all_of(dimmers.begin(), dimmers.end(), [&](int address) {
        const auto slot = static_cast<std::size_t>(address - 1);
        return source.slots->levels[slot] == 0 && source.slots->stands[slot];
    });
}

// ", and sends 0 alone" where that hides a look; else "".
std::string hides_text(const dmx::SourceStatus& winner, const dmx::SourceStatus& loser,
                       const PatchMap& patch) {
    if (loser.is_dark) return "";
    if (winner.is_dark) return ", and sends 0 alone";
    return dimmers_are_down(winner, patch) && !dimmers_are_down(loser, patch) ? ", and has all dimmers at 0"
                                                                              : "";
}

void add_low_priority(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    std::map<std::tuple<std::string, std::string, std::string>, std::set<int>> low; // who, who wins and hides
    for (const dmx::SourceStatus& source : statistics.sources) {
        const std::string role = role_text(source, statistics.sources);
        const dmx::SourceStatus* const winner = winner_of(statistics.sources, source);
        const std::string hides = winner ? hides_text(*winner, source, patch) : "";
        const bool in_part = role == "in part" && !hides.empty();
        if (role != "lower priority" && !in_part) continue;
        low[{ranked_text(source) + (in_part ? " is shown only in part on " : " is not shown on "),
             winner ? ranked_text(*winner) : "", hides}]
            .insert(source.universe);
    }
    for (const auto& [who, universes] : low) {
        const auto& [loser, winner, hides] = who;
        out.push_back(note(
            Trouble::low_priority,
            loser + universes_text(universes) + ": " + winner + " has a higher priority" + hides, universes));
    }
}

// Lists of priorities per address that give up what the source sends levels for.
void add_priorities(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    std::map<std::pair<std::string, int>, std::set<int>> above; // who, and for how many channels
    std::set<int> patched;                                      // universes of which one of them is read
    std::map<std::tuple<std::string, int, int>, std::set<int>> given_up; // who, levels, priorities
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (!source.per_address_priority || source.state != dmx::SourceState::live) continue;
        if (source.bad_priorities > 0) {
            above[{source_text(source), source.bad_priorities}].insert(source.universe);
            // Which ones is not known: more than nothing reads are read in part.
            int unread = 0;
            for (int address = 1; address <= static_cast<int>(dmx::kSlots); ++address)
                unread += patch.at(source.universe, address).empty() ? 1 : 0;
            if (source.bad_priorities > unread) patched.insert(source.universe);
        }
        const auto past = [&](int address) { return patch.readers_past(source.universe, address).size(); };
        if (source.priority_count < source.slot_count &&
            past(source.priority_count) > past(source.slot_count))
            given_up[{source_text(source), source.slot_count, source.priority_count}].insert(source.universe);
    }
    for (const auto& [who, universes] : above) {
        const bool is_read = std::any_of(universes.begin(), universes.end(),
                                         [&](int universe) { return patched.contains(universe); });
        const std::string said = who.first + " sends priorities per address above 200 on " +
                                 universes_text(universes) + " for " +
                                 count_text(static_cast<std::uint64_t>(who.second), "channel") +
                                 ": there is none above 200 (E1.31), and it does not hold these channels";
        out.push_back(is_read ? problem(Trouble::bad_priorities, said, universes)
                              : note(Trouble::bad_priorities, said, universes));
    }
    for (const auto& [who, universes] : given_up) {
        const auto& [name, levels, priorities] = who;
        out.push_back(note(Trouble::bad_priorities,
                           name + " sends " + count_text(static_cast<std::uint64_t>(levels), "level") +
                               " on " + universes_text(universes) + " and priorities per address for " +
                               std::to_string(priorities) +
                               " alone: it gives the others up, and fixtures are patched there",
                           universes));
    }
}

// Channels of the patch that a source gives away by a priority of 0, and that nobody else sends.
void add_given_away(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (!source.per_address_priority || source.bad_priorities > 0 || !source.slots ||
            source.state != dmx::SourceState::live)
            continue;
        // Most desks give nothing away, or only what nobody patched: then nobody else is asked.
        const int last = std::min<int>(source.slot_count, source.priority_count);
        std::vector<int> without; // a holder of their own, and patched
        for (int address = 1; address <= last; ++address)
            if (source.slots->rank[static_cast<std::size_t>(address - 1)] == 0 &&
                !patch.at(source.universe, address).empty())
                without.push_back(address);
        if (without.empty()) continue;
        Sources others;
        for (const dmx::SourceStatus& one : statistics.sources)
            if (one.universe == source.universe && &one != &source) others.push_back(&one);
        const auto given =
            static_cast<std::uint64_t>(std::count_if(without.begin(), without.end(), [&](int address) {
                return std::none_of(others.begin(), others.end(), [&](const dmx::SourceStatus* one) {
                    return !one->slots || one->slots->rank[static_cast<std::size_t>(address - 1)] > 0;
                });
            }));
        std::uint64_t patched = 0;
        for (int address = 1; given > 0 && address <= last; ++address)
            patched += patch.at(source.universe, address).empty() ? 0 : 1;
        if (given == 0) continue;
        const std::string text = source_text(source) + " gives " + std::to_string(given) + " of " +
                                 count_text(patched, "patched channel") + " on universe " +
                                 std::to_string(source.universe) +
                                 " away (priority per address 0), and nobody else sends them: their levels "
                                 "are not used. Are they patched on the desk?";
        out.push_back(given == patched ? problem(Trouble::bad_priorities, text, {source.universe})
                                       : note(Trouble::bad_priorities, text, {source.universe}));
    }
}

// "'A' (10.0.0.2) with 512 slots at 44 Hz"
std::string sends_text(const dmx::SourceStatus& source, const Sources& all) {
    return apart_text(source, all) + " with " + count_text(source.slot_count, "slot") + " at " +
           std::to_string(std::lround(source.rate_hz)) + " Hz";
}

// How many channels one whose dimmers are down raises of lamps that another lights.
std::size_t raised_by(const dmx::SourceStatus& down, const dmx::SourceStatus& lit, const PatchMap& patch) {
    if (!down.slots || !lit.slots) return 0;
    std::map<std::size_t, std::size_t> raised; // by fixture
    std::set<std::size_t> are_lit;
    for (int address = 1; address <= static_cast<int>(dmx::kSlots); ++address) {
        const auto slot = static_cast<std::size_t>(address - 1);
        const bool is_up = lit.slots->levels[slot] > 0;
        const bool raises = !is_up && down.slots->levels[slot] > 0 && down.slots->stands[slot];
        if (!is_up && !raises) continue;
        for (const PatchedSlot* one : patch.at(lit.universe, address)) {
            if (raises) ++raised[one->fixture];
            if (is_up && one->dims) are_lit.insert(one->fixture);
        }
    }
    std::size_t channels = 0;
    for (const std::size_t fixture : are_lit) channels += raised[fixture];
    return channels;
}

constexpr std::chrono::milliseconds kArtnetRests{4500}; // unchanged levels come every 4 s

// Two that have the same say. What they send may be the same (a backup), or not (two that fight).
void add_two_desks(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    std::map<int, Sources> by_universe;
    for (const dmx::SourceStatus& source : statistics.sources)
        if (source.state == dmx::SourceState::live && source.slots_held > 0)
            by_universe[source.universe].push_back(&source);
    struct Fight {
        std::string who; // as they are now
        std::set<int> universes;
        std::size_t channels = 0, shared = 0;
        bool contested = false; // channels that more than one sends above 0
        std::string merge;
        std::set<std::string> dark; // who sends nothing above 0
        std::set<std::string> down; // whose dimmers are at 0, and others' are not
        std::size_t raised = 0;     // by these, of lamps that others light
        std::string silent;         // who sends nothing any more, and counts yet
        std::string hint;
    };
    // By who, and who of them is dark or silent: rates flicker.
    std::map<std::array<std::set<std::string>, 4>, Fight> fights;
    for (const auto& [universe, sources] : by_universe) {
        std::size_t differ = 0, shared = 0, meet = 0;
        bool all_artnet = true, contested = false;
        std::string silent;
        std::set<std::string> who, names, dark, down;
        std::size_t all_down = 0, raised = 0;
        std::set<int> ranks; // of those that do not have their way: whom they meet has the same
        for (const dmx::SourceStatus* source : sources)
            if (source->slots_overruled + source->slots_shared > 0) ranks.insert(source->highest_priority);
        for (const dmx::SourceStatus* source : sources) {
            if (!source->per_address_priority && !ranks.contains(source->highest_priority)) continue;
            differ = std::max(differ, source->slots_overruled);
            shared = std::max(shared, source->slots_shared);
            contested |= source->slots_contested > 0;
            all_artnet &= source->protocol == dmx::Protocol::artnet;
            if (source->protocol == dmx::Protocol::artnet && source->age > kArtnetRests)
                silent = apart_text(*source, sources);
            who.insert(sends_text(*source, sources));
            names.insert(apart_text(*source, sources));
            if (source->is_dark)
                dark.insert(apart_text(*source, sources));
            else if (dimmers_are_down(*source, patch)) {
                down.insert(apart_text(*source, sources));
                for (const dmx::SourceStatus* other : sources)
                    raised = std::max(raised, raised_by(*source, *other, patch));
            }
            all_down += source->is_dark || dimmers_are_down(*source, patch) ? 1 : 0;
            ++meet;
        }
        if (differ + shared == 0 || meet < 2) continue;
        if (all_down == meet) down.clear();
        const std::set<std::string> of_silent = silent.empty() ? std::set<std::string>() : std::set{silent};
        Fight& fight = fights[{names, dark, down, of_silent}];
        if (fight.universes.empty()) fight.who = joined(who);
        fight.universes.insert(universe);
        fight.channels = std::max(fight.channels, differ);
        fight.shared = std::max(fight.shared, shared);
        fight.contested |= contested;
        fight.raised = std::max(fight.raised, raised);
        fight.dark = dark;
        fight.down = down;
        fight.silent = silent;
        fight.hint = one_machine_text(sources);
        fight.merge =
            all_artnet && statistics.listening.artnet_ltp
                ? "whoever changed a channel last has it (LTP, --artnet-merge)"
            : all_artnet ? "of each channel the higher level shows (HTP; Art-Net has no priorities, sACN has)"
                         : "of each channel the higher level shows (HTP)";
    }
    for (const auto& [key, fight] : fights) {
        const bool is_shared = fight.shared > 0 && !fight.contested;
        const std::string text =
            universes_text(fight.universes) + (fight.universes.size() == 1 ? " comes" : " come") +
            " from more than one source of equal priority, " + fight.who + ", and they " +
            (is_shared ? "have up to " + count_text(fight.shared, "channel") + " up at different times: "
                       : "differ on up to " + count_text(fight.channels, "channel") + ": ") +
            fight.merge +
            (is_shared ? ". If both play these lamps, all is well; if one is a backup, it is out of step: "
                         "give it a lower priority"
             : !fight.silent.empty() ? ". " + fight.silent + " is silent, and counts until " +
                                           seconds_text(dmx::kArtnetLoss) + " have gone by"
             : fight.contested ? ". Switch one off, or give one that is a backup a lower priority"
             : fight.raised > 0 && !fight.down.empty()
                 ? ". " + *fight.down.begin() + " has all dimmers at 0, and raises up to " +
                       count_text(fight.raised, "channel") +
                       " of lamps that others light: a closed shutter or a colour among these would take "
                       "the light away. If they are not meant to share, switch one off, or give one that "
                       "is a backup a lower priority"
             : !fight.down.empty() ? ". " + *fight.down.begin() +
                                         " has all dimmers at 0: if that is a black-out, the others hide it"
             : !fight.dark.empty()
                 ? ". " + *fight.dark.begin() + " sends 0 alone: if that is a black-out, the others hide it"
                 : ". None of these is now above 0 at two of them, so they may be meant to share") +
            fight.hint;
        out.push_back(fight.contested && fight.silent.empty()
                          ? problem(Trouble::two_desks, text, fight.universes)
                          : note(Trouble::two_desks, text, fight.universes));
    }
}

} // namespace

void add_ignored(const dmx::Statistics& statistics, Sentences& out) {
    std::map<std::string, std::set<int>> preview; // by who
    for (const dmx::IgnoredSource& one : statistics.ignored)
        if (one.why == dmx::IgnoredSource::Why::preview)
            preview[source_text(one.name, dmx::address_text(one.from), one.protocol)].insert(one.universe);
    for (const auto& entry : preview) {
        const std::string& who = entry.first;
        const std::set<int>& universes = entry.second;
        // Beside a live look, of the same desk or of another one's operator, it is only said.
        const auto is_live = [&](const auto& who_may) {
            return std::all_of(universes.begin(), universes.end(), [&](int universe) {
                return std::any_of(statistics.sources.begin(), statistics.sources.end(),
                                   [&](const dmx::SourceStatus& source) {
                                       return source.universe == universe && !source.preview &&
                                              source.slots_held > 0 && who_may(source);
                                   });
            });
        };
        const bool live = is_live([](const dmx::SourceStatus&) { return true; });
        const bool itself =
            is_live([&](const dmx::SourceStatus& source) { return source_text(source) == who; });
        const std::string text = who + " marks " + (itself ? "some of " : "") + universes_text(universes) +
                                 " as preview (blind), which is not shown: leave blind on the desk, or "
                                 "start with --show-preview";
        out.push_back(live ? note(Trouble::preview, text, universes)
                           : problem(Trouble::preview, text, universes));
    }
    add_too_many(statistics, out);
    if (statistics.recent.too_many_universes > 0)
        out.push_back(problem(
            Trouble::too_many_universes,
            "more universes arrive than the " + std::to_string(dmx::kMaxUniverses) +
                " that are shown at once; those of the show and of --universes are always among them"));
}

void add_ranks(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    add_low_priority(statistics, patch, out);
    add_priorities(statistics, patch, out);
    add_given_away(statistics, patch, out);
    add_two_desks(statistics, patch, out);
}

namespace {

void add_timecodes(const dmx::Statistics& statistics, Sentences& out) {
    constexpr double kSame_s = 1; // two cards of one sender, two machines that follow one clock
    const auto& [followed, other] = statistics.followed_timecodes;
    const auto runs = [&](const std::optional<dmx::TimeCodeStatus>& one) {
        return one && statistics.time - one->arrival < kSilent;
    };
    if (!runs(followed) || !runs(other)) return;
    const double apart_s = std::chrono::duration<double>(followed->arrival - other->arrival).count();
    if (std::abs(dmx::timecode_seconds(followed->time) - dmx::timecode_seconds(other->time) - apart_s) <=
        kSame_s)
        return;
    // By which came first in the alphabet, so that the sentence stands still.
    const bool one_machine = followed->from == other->from;
    std::set<std::string> both;
    for (const auto& one : {followed, other})
        both.insert(dmx::address_text(one->from) + (one_machine ? ":" + std::to_string(one->from_port) : ""));
    out.push_back(
        note(Trouble::two_timecodes, "two Art-Net time codes run, of " + joined(both) +
                                         ": the one that came first is followed until it is silent"));
}

} // namespace

void add_sources(const dmx::Statistics& statistics, Sentences& out) {
    std::map<std::pair<std::string, dmx::Protocol>, std::set<int>> waiting;
    std::map<std::string, std::set<int>> foreign, astray, cut;
    for (const dmx::SourceStatus& source : statistics.sources) {
        const std::string who = source_text(source);
        if (synchronisation_is_late(source)) waiting[{who, source.protocol}].insert(source.universe);
        if (source.protocol == dmx::Protocol::artnet && is_foreign(source.from, statistics))
            foreign[who].insert(source.universe);
        if (source.wrong_group) astray[who].insert(source.universe);
        if (source.wrong_length) cut[who].insert(source.universe);
    }
    for (const auto& [who, universes] : waiting)
        out.push_back(problem(Trouble::waits_for_sync,
                              "levels of " + who.first + " on " + universes_text(universes) +
                                  " wait for a synchronisation packet that does not come, or seldom; after " +
                                  seconds_text(who.second == dmx::Protocol::artnet ? dmx::kArtnetSyncLoss
                                                                                   : dmx::kSacnSyncHold) +
                                  " at most they show without",
                              universes));
    for (const auto& [who, universes] : foreign)
        out.push_back(
            note(Trouble::other_network,
                 who + " sends Art-Net from another network than ours (" + addresses_text(statistics) +
                     "), by a router or because the addresses do not fit: without a router its unicast and "
                     "our answers do not arrive, and this machine needs an address in its network",
                 universes));
    for (const auto& [who, universes] : astray)
        out.push_back(note(Trouble::wrong_group,
                           who + " sends " + universes_text(universes) +
                               " to the multicast group of another universe; the levels are used as those "
                               "of " +
                               universes_text(universes),
                           universes));
    for (const auto& [who, universes] : cut)
        out.push_back(note(Trouble::wrong_length,
                           who + " declares more levels on " + universes_text(universes) +
                               " than its packets hold, or than 512; those that come are used",
                           universes));
    add_timecodes(statistics, out);
    if (statistics.recent.overflow > 0)
        out.push_back(
            problem(Trouble::packets_lost,
                    "this machine dropped " + count_text(statistics.recent.overflow, "packet") +
                        " in the last seconds: it is too busy, the sockets' buffers are too small (as "
                        "root: sysctl -w net.core.rmem_max=4194304), or somebody's packets have wrong "
                        "checksums"));
    if (statistics.recent.lost > statistics.recent.overflow)
        out.push_back(
            problem(Trouble::packets_lost,
                    "in the numbers of the last seconds " +
                        count_text(statistics.recent.lost - statistics.recent.overflow, "packet") +
                        (statistics.recent.lost == statistics.recent.overflow + 1 ? " is" : " are") +
                        " missing: lost by a cable, a switch, Wi-Fi or a firewall that lets only some "
                        "through, or left out by a sender that skips numbers"));
}

} // namespace ghost::scene::diagnosed
