// SPDX-License-Identifier: Apache-2.0
// What arrives against what is patched: other universes than those of the show, by how they differ.
#include "base/print.h"
#include "base/text.h"
#include "diagnose/diagnosis_parts.h"

#include <algorithm>
#include <array>
#include <optional>

namespace ghost::scene::diagnosed {
namespace {

// Universes say nothing of whose they are.
constexpr const char* kOrAnother =
    ". If that is another system's (another hall, somebody's list), this show's desk is silent or does not "
    "get here: its output, the network, a firewall on UDP 5568 and 6454";

// Universes that the patch and the network have one beside the other.
struct Shift {
    int by = 0; // universes of the patch = those that arrive + this
    dmx::Protocol protocol = dmx::Protocol::artnet;
    std::set<int> arriving;
};

// What another protocol feeds is missing nothing: universes of somebody else lie beside it by chance.
std::optional<Shift> find_shift(dmx::Protocol protocol, const Arriving& all, const PatchMap& patch) {
    const std::set<int> arriving = all.announced(protocol);
    const auto is_fed = [&](int universe) {
        return std::any_of(all.by_protocol.begin(), all.by_protocol.end(), [&](const auto& one) {
            return one.first != protocol && one.second.contains(universe);
        });
    };
    const auto matches = [&](int by) {
        return std::count_if(arriving.begin(), arriving.end(),
                             [&](int u) { return patch.has(u + by) && (by == 0 || !is_fed(u + by)); });
    };
    const int by = matches(-1) > matches(1) ? -1 : 1;
    if (matches(by) <= matches(0)) return std::nullopt;
    return Shift{by, protocol, arriving};
}

std::string shift_text(const Shift& shift, const dmx::Statistics& statistics, const Arriving& arriving,
                       const PatchMap& patch) {
    std::string text = "off by one? " + std::string(dmx::protocol_name(shift.protocol)) +
                       (arriving.by(shift.protocol) ? " comes for " : " is announced for ") +
                       universes_text(shift.arriving);
    const int offset = statistics.listening.artnet_offset;
    if (shift.protocol == dmx::Protocol::artnet)
        text += " (from Port-Address " + port_address_text(*shift.arriving.begin(), offset) + " on)";
    if (const auto listed = arriving.listed.find(*shift.arriving.begin());
        !arriving.by(shift.protocol) && listed != arriving.listed.end())
        text += " by " + listed->second.who;
    text += ", fixtures are on " + universes_text(numbers_of(patch)) + ": ";
    if (shift.protocol == dmx::Protocol::artnet)
        text += "--artnet-offset " + std::to_string(offset + shift.by) + " brings them together";
    else
        text += "move the desk's output or the show's patch by one";
    return text + kOrAnother;
}

// Net, Sub-Net and Universe of a Port-Address.
std::array<int, 3> parts_of(int port_address) {
    return {port_address >> 8, (port_address >> 4) & 15, port_address & 15};
}

// Where one that arrives has the three numbers of one that is missing in another order.
std::string swapped_text(const std::set<int>& arriving, const std::set<int>& missing, int offset) {
    for (const int from : arriving)
        for (const int to : missing) {
            if (from < offset || to < offset || from == to) continue;
            std::array<int, 3> a = parts_of(from - offset), b = parts_of(to - offset);
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            if (a == b)
                return "; in Art-Net that is Net:Sub-Net:Universe " + port_address_text(from, offset) +
                       ", the show wants " + port_address_text(to, offset) +
                       ": the same numbers in another order";
        }
    return "";
}

// Where the number of one that arrives is that of one that is missing with its two bytes exchanged. Certain
// where its sender announces the right number.
std::string exchanged_text(const Arriving& arriving, const std::set<int>& sacn,
                           const std::set<int>& missing) {
    for (const int to : missing) {
        const int from = bytes_exchanged(to);
        if (from == to || !sacn.contains(from)) continue;
        const auto listed = arriving.listed.find(to);
        const bool certain =
            listed != arriving.listed.end() && listed->second.who == arriving.universes.at(from);
        return "; " + std::to_string(from) + " is " + std::to_string(to) + " with its two bytes exchanged: " +
               (certain ? std::string("the sender writes universe numbers in the wrong order of bytes")
                        : std::string("if that is meant, the sender writes them in the wrong order") +
                              kOrAnother);
    }
    return "";
}

// Marked as preview, it comes.
bool is_blind(const dmx::Statistics& statistics, int universe) {
    return std::any_of(statistics.ignored.begin(), statistics.ignored.end(),
                       [&](const dmx::IgnoredSource& one) {
                           return one.universe == universe && one.why == dmx::IgnoredSource::Why::preview;
                       });
}

// Desks that leave out what they have nothing at send as much as they have.
void add_short(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    struct Count {
        int now = 0, most = 0;
    };
    std::map<int, Count> slots; // by universe
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (source.state != dmx::SourceState::live || source.slot_count == 0) continue; // none: not_received
        Count& count = slots[source.universe];
        count.now = std::max<int>(count.now, source.slot_count);
        count.most = std::max<int>(count.most, source.most_slots);
    }
    for (const auto& [universe, count] : slots) {
        const std::vector<std::string> past = patch.readers_past(universe, count.now);
        if (past.empty()) continue;
        const std::string at_times =
            count.most > count.now ? " (" + std::to_string(count.most) + " in some packets)" : "";
        out.push_back(note(Trouble::short_universe,
                           "universe " + std::to_string(universe) + " comes with " +
                               count_text(static_cast<std::uint64_t>(count.now), "channel") + at_times +
                               ", and " + count_text(past.size(), "fixture") + " ('" +
                               one_line(past.front()) + "'" + (past.size() > 1 ? ", ...) are" : ") is") +
                               " patched past these: not patched on the desk?",
                           {universe}));
    }
}

} // namespace

void add_patch(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
               Sentences& out) {
    if (patch.universes().empty()) return;
    add_short(statistics, patch, out);
    std::set<int> explained_patch, explained_arriving;
    for (const auto protocol : {dmx::Protocol::artnet, dmx::Protocol::sacn}) {
        const auto shift = find_shift(protocol, arriving, patch);
        if (!shift) continue;
        std::set<int> wanted;
        for (const int universe : shift->arriving) {
            explained_arriving.insert(universe);
            wanted.insert(universe + shift->by);
        }
        explained_patch.insert(wanted.begin(), wanted.end());
        out.push_back(problem(Trouble::off_by_one, shift_text(*shift, statistics, arriving, patch), wanted));
    }
    for (const Sentence& sentence : out)
        if (sentence.trouble == Trouble::wrong_interface || sentence.trouble == Trouble::held_back)
            explained_patch.insert(sentence.universes.begin(), sentence.universes.end());
    const auto was_lost = [&](int universe) {
        return std::any_of(statistics.lost.begin(), statistics.lost.end(),
                           [&](const dmx::LostUniverse& one) { return one.universe == universe; });
    };
    std::set<int> missing, elsewhere;
    const std::string unreadable = unreadable_text(statistics);
    std::size_t fixtures = 0;
    std::string first, runs_on;
    for (const PatchedUniverse& one : patch.universes()) {
        if (arriving.has(one.universe) || explained_patch.contains(one.universe) || was_lost(one.universe))
            continue;
        missing.insert(one.universe);
        fixtures += one.fixtures;
        if (first.empty()) first = one.first;
        if (one.runs_on_from > 0 && runs_on.empty())
            runs_on = "; '" + one_line(one.first) + "' begins on universe " +
                      std::to_string(one.runs_on_from) +
                      " and runs past channel 512, where desks end a universe: is its address right?";
    }
    for (const auto& [universe, from] : arriving.universes)
        if (!patch.has(universe) && !explained_arriving.contains(universe)) elsewhere.insert(universe);
    // Where nothing at all arrives add_silence says so, unless it is clear what becomes of some.
    if (!missing.empty() && (!arriving.nothing() || !explained_patch.empty()))
        out.push_back(problem(
            Trouble::not_received,
            count_text(fixtures, "fixture") + " on " + universes_text(missing) + " ('" + one_line(first) +
                "'" + (fixtures > 1 ? ", ..." : "") + "), no levels arrive there" +
                port_addresses_hint(missing, statistics.listening) + runs_on +
                (unreadable.empty() ? "" : "; packets arrive that cannot be read (" + unreadable + ")") +
                empty_text(statistics, patch),
            missing));
    // What is only announced, where nothing else explains what is missing.
    std::set<int> only_announced;
    const bool is_announced = std::any_of(missing.begin(), missing.end(),
                                          [&](int universe) { return arriving.listed.contains(universe); });
    if (!missing.empty() && elsewhere.empty() && !is_announced)
        for (const auto& [universe, one] : arriving.listed)
            if (!patch.has(universe) && !explained_arriving.contains(universe))
                only_announced.insert(universe);
    // What came before it went elsewhere is wanted, too.
    std::set<int> wanted = missing;
    for (const PatchedUniverse& one : patch.universes())
        if (was_lost(one.universe) && !arriving.has(one.universe)) wanted.insert(one.universe);
    const std::string wants = wanted.empty() ? "" : "; the show wants " + universes_text(wanted);
    if (!only_announced.empty())
        out.push_back(problem(Trouble::not_patched,
                              arriving.announced_text(only_announced) + ", nothing is patched there" + wants +
                                  kOrAnother,
                              missing));
    if (elsewhere.empty()) return;
    std::string who = arriving.universes.at(*elsewhere.begin());
    if (std::any_of(elsewhere.begin(), elsewhere.end(),
                    [&](int universe) { return arriving.universes.at(universe) != who; }))
        who += " and others";
    std::string text = "packets for " + universes_text(elsewhere) + " arrive (" + who +
                       "), nothing is patched there" + wants;
    if (const auto artnet = arriving.by_protocol.find(dmx::Protocol::artnet);
        artnet != arriving.by_protocol.end())
        text += swapped_text(artnet->second, missing, statistics.listening.artnet_offset);
    std::string exchanged;
    if (const auto sacn = arriving.by_protocol.find(dmx::Protocol::sacn); sacn != arriving.by_protocol.end())
        exchanged = exchanged_text(arriving, sacn->second, missing);
    text += exchanged;
    if (!wanted.empty() && exchanged.empty()) text += kOrAnother;
    out.push_back(wanted.empty() ? note(Trouble::not_patched, text)
                                 : problem(Trouble::not_patched, text, wanted));
}

namespace {

// ". net0: cable pulled 4 s ago, ..", of what happened to our cards after the last levels came; else "".
std::string links_text(const dmx::Statistics& statistics, std::chrono::nanoseconds silent,
                       const std::set<unsigned>& interfaces) {
    std::string text;
    for (const dmx::LinkChange& change : statistics.link_changes)
        if (const std::chrono::nanoseconds age = statistics.time - change.time;
            change.is_loss && interfaces.contains(change.interface_index) && age <= silent &&
            silent - age <= dmx::kArtnetLoss)
            text = ". " + one_line(change.text) + " " + seconds_text(age) + " ago, which may be why";
    return text;
}

// "'FOH' (10.0.0.1) is heard all the while, with universes 4, 9: ..", where each that sent what is lost sends
// others; else "".
std::string heard_text(const dmx::Statistics& statistics, const std::set<dmx::IpAddress>& senders) {
    if (senders.contains(dmx::IpAddress{})) return ""; // widgets have none
    std::set<dmx::IpAddress> heard;
    std::set<int> universes;
    std::string who;
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (source.state != dmx::SourceState::live || !senders.contains(source.from)) continue;
        heard.insert(source.from);
        universes.insert(source.universe);
        if (who.empty()) who = source_text(source);
    }
    if (universes.empty() || heard.size() < senders.size()) return "";
    return ". " + who + (heard.size() > 1 ? " and others are" : " is") + " heard all the while, with " +
           universes_text(universes) +
           ": its output was switched off or goes elsewhere, or something holds back these packets alone, a "
           "firewall or a switch that prunes multicast (IGMP snooping without a querier)";
}

} // namespace

void add_lost(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    const std::string unreadable = unreadable_text(statistics);
    constexpr std::pair<bool, bool> kKinds[] = {{false, false}, {true, false}, {false, true}, {true, true}};
    for (const auto& [black, ended] : kKinds) {
        std::set<int> universes;
        std::set<unsigned> interfaces; // that these came by
        std::set<dmx::IpAddress> senders;
        std::chrono::nanoseconds longest{0}, silent{0};
        for (const dmx::LostUniverse& one : statistics.lost) {
            if (one.black != black || one.ended != ended ||
                (!patch.universes().empty() && !patch.has(one.universe)))
                continue;
            if (is_blind(statistics, one.universe)) continue; // add_ignored says so
            universes.insert(one.universe);
            longest = std::max(longest, one.since);
            silent = std::max(silent, one.silent);
            interfaces.insert(one.interface_index);
            senders.insert(one.from);
        }
        if (universes.empty()) continue;
        const std::string links = links_text(statistics, silent, interfaces);
        const std::string heard = heard_text(statistics, senders);
        const bool bare = std::any_of(universes.begin(), universes.end(),
                                      [&](int universe) { return is_without_levels(statistics, universe); });
        out.push_back(problem(
            Trouble::lost,
            "nothing comes for " + universes_text(universes) + " any more, since " + seconds_text(longest) +
                ": " + (black ? "black (--on-loss)" : "the last look is held") +
                (bare                 ? ". Packets still come, without levels" + empty_text(statistics, patch)
                 : ended              ? ". Its desk said that it ends this stream: its output was switched "
                                        "off, or its program closed"
                 : !links.empty()     ? links
                 : !heard.empty()     ? heard
                 : unreadable.empty() ? ". Its desk has stopped, sends elsewhere now (another universe or "
                                        "machine) or less often than every 2.5 s (sACN) or 10 s (Art-Net), "
                                        "or something on the way lets nothing through any more: a cable, a "
                                        "firewall, or a switch that prunes multicast after minutes (IGMP "
                                        "snooping without a querier)"
                                      : ". Packets arrive that cannot be read (" + unreadable +
                                            "): if they are its desk's, that has to be mended"),
            universes));
    }
}

} // namespace ghost::scene::diagnosed
