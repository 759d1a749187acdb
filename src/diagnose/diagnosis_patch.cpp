// SPDX-License-Identifier: Apache-2.0
// What arrives against what is patched: other universes than those of the show, by how they differ.
#include "base/print.h"
#include "base/text.h"
#include "diagnose/diagnosis_parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace ghost::scene::diagnosed {
namespace {

// Universes say nothing of whose they are.
constexpr const char* kOrAnother =
    ". If that is another system's (another hall, somebody's list), this show's desk is silent or does not "
    "get here: its output, the network, a firewall on UDP 5568 and 6454";

constexpr std::size_t kMostCompared = 32; // universes that are missing, with all that arrive

// Universes that the patch and the network have one beside the other.
struct Shift {
    int by = 0; // universes of the patch = those that arrive + this
    dmx::Protocol protocol = dmx::Protocol::artnet;
    std::set<int> arriving; // all of the protocol
    std::set<int> missing;  // of the patch, that would be there
    std::set<int> right;    // of the patch, that are there as it is, though not all would match so well
};

bool was_lost(const dmx::Statistics& statistics, int universe) {
    return std::any_of(statistics.lost.begin(), statistics.lost.end(),
                       [&](const dmx::LostUniverse& one) { return one.universe == universe; });
}

// What another protocol feeds is missing nothing: universes of somebody else lie beside it by chance. What
// came until now is no shift, and neither is what lies further away as well.
std::optional<Shift> find_shift(dmx::Protocol protocol, const dmx::Statistics& statistics,
                                const Arriving& all, const PatchMap& patch) {
    const std::set<int> arriving = all.announced(protocol);
    std::set<int> wanted, missing, right;
    for (const PatchedUniverse& one : patch.universes()) {
        if (was_lost(statistics, one.universe)) return std::nullopt;
        const bool is_fed = std::any_of(all.by_protocol.begin(), all.by_protocol.end(), [&](const auto& by) {
            return by.first != protocol && by.second.contains(one.universe);
        });
        if (is_fed) continue;
        wanted.insert(one.universe);
        (arriving.contains(one.universe) ? right : missing).insert(one.universe);
    }
    std::map<int, std::size_t> found; // by shift, of what is missing
    std::size_t compared = 0;
    for (const int to : missing) {
        if (++compared > kMostCompared) break;
        for (const int from : arriving) ++found[to - from];
    }
    const int by = found[-1] > found[1] ? -1 : 1;
    std::size_t most = 0;
    for (const auto& [shift, count] : found) most = std::max(most, count);
    if (found[by] == 0 || found[by] < most) return std::nullopt;
    Shift shift{by, protocol, arriving, {}, {}};
    std::size_t matches = 0, beside = 0;
    for (const int universe : arriving) {
        matches += wanted.contains(universe + by) ? 1 : 0;
        beside += wanted.contains(universe + by) ? 0 : 1;
        if (missing.contains(universe + by)) shift.missing.insert(universe + by);
    }
    if (matches <= right.size() || 2 * matches < wanted.size()) return std::nullopt;
    if (matches < wanted.size() || beside > 0) shift.right = right;
    return shift;
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
    if (!shift.right.empty())
        text += "either nothing is sent for " + universes_text(shift.missing) +
                " or it does not get here, or all of them are one off: then ";
    if (shift.protocol == dmx::Protocol::artnet)
        text += "--artnet-offset " + std::to_string(offset + shift.by) + " brings them together";
    else
        text += "move the desk's output or the show's patch by one";
    return shift.right.empty() ? text + kOrAnother : text;
}

// Net, Sub-Net and Universe of a Port-Address.
std::array<int, 3> parts_of(int port_address) {
    return {port_address >> 8, (port_address >> 4) & 15, port_address & 15};
}

// Where what arrives has the three numbers of all that is missing in another order, or another Net or
// Sub-Net.
std::string swapped_text(const std::set<int>& arriving, const std::set<int>& missing, int offset) {
    const auto all_come = [&](const auto& sent) { // for what is missing: at another number, each of them
        return std::all_of(missing.begin(), missing.end(), [&](int to) {
            const int from = sent(to);
            return to >= offset && from != to && arriving.contains(from);
        });
    };
    const auto text = [&](int from, const char* how) {
        return "; in Art-Net that is Net:Sub-Net:Universe " + port_address_text(from, offset) +
               ", the show wants " + port_address_text(*missing.begin(), offset) + ": " + how;
    };
    if (missing.empty()) return "";
    std::array<std::size_t, 3> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
        const auto sent = [&](int to) {
            const std::array<int, 3> parts = parts_of(to - offset);
            const int net = parts[order[0]], sub_net = parts[order[1]], universe = parts[order[2]];
            return sub_net > 15 || universe > 15 ? to : (net << 8 | sub_net << 4 | universe) + offset;
        };
        if (all_come(sent)) return text(sent(*missing.begin()), "the same numbers in another order");
    }
    for (const int from : arriving) {
        if (from < offset) continue;
        const int by = from - *missing.begin();
        const std::array<int, 3> a = parts_of(from - offset), b = parts_of(*missing.begin() - offset);
        const char* const how = a[2] != b[2]   ? nullptr
                                : a[1] == b[1] ? "another Net"
                                : a[0] == b[0] ? "another Sub-Net"
                                               : nullptr;
        if (how && all_come([&](int to) { return to + by; })) return text(from, how);
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
        const auto shift = find_shift(protocol, statistics, arriving, patch);
        if (!shift) continue;
        for (const int universe : shift->arriving)
            if (patch.has(universe + shift->by)) explained_arriving.insert(universe);
        if (shift->right.empty()) explained_patch.insert(shift->missing.begin(), shift->missing.end());
        out.push_back(
            problem(Trouble::off_by_one, shift_text(*shift, statistics, arriving, patch), shift->missing));
    }
    for (const Sentence& sentence : out)
        if (sentence.trouble == Trouble::wrong_interface || sentence.trouble == Trouble::held_back)
            explained_patch.insert(sentence.universes.begin(), sentence.universes.end());
    std::set<int> missing, elsewhere;
    const std::string unreadable = unreadable_text(statistics);
    std::size_t fixtures = 0;
    std::string first, runs_on;
    for (const PatchedUniverse& one : patch.universes()) {
        if (arriving.has(one.universe) || explained_patch.contains(one.universe) ||
            was_lost(statistics, one.universe))
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
        if (was_lost(statistics, one.universe) && !arriving.has(one.universe)) wanted.insert(one.universe);
    const std::string wants = wanted.empty() ? "" : "; the show wants " + universes_text(wanted);
    if (!only_announced.empty())
        out.push_back(problem(Trouble::not_patched,
                              arriving.announced_text(only_announced) + ", nothing is patched there" + wants +
                                  kOrAnother,
                              missing));
    if (elsewhere.empty()) return;
    std::string who = arriving.universes.at(*elsewhere.begin());
    if (std::any_of(elsewhere.begin(), elsewhere.end(), [&](int universe) {
            return arriving.universes.at(universe) != who || arriving.shared.contains(universe);
        }))
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

constexpr std::chrono::seconds kTogether{2}; // universes that were lost at one time

// ". net0: cable pulled 4 s ago, ..", of what happened to our card after the last levels came; else "".
std::string links_text(const dmx::Statistics& statistics, const dmx::LostUniverse& lost) {
    std::string text;
    for (const dmx::LinkChange& change : statistics.link_changes)
        if (const std::chrono::nanoseconds age = statistics.time - change.time;
            change.is_loss && change.interface_index == lost.interface_index && age <= lost.silent &&
            lost.silent - age <= dmx::kArtnetLoss)
            text = ". " + one_line(change.text) + " " + seconds_text(age) + " ago, which may be why";
    return text;
}

// ". 'FOH' (10.0.0.7) is heard all the while, with universes 4, 9: ..", where who sent it sends others; else
// "".
std::string heard_text(const dmx::Statistics& statistics, const dmx::LostUniverse& lost) {
    std::set<int> universes;
    std::string who;
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (source.state != dmx::SourceState::live || lost.source.empty() || source.id != lost.source)
            continue;
        universes.insert(source.universe);
        who = source_text(source);
    }
    if (universes.empty()) return "";
    return ". " + who + " is heard all the while, with " + universes_text(universes) +
           ": its output was switched off or goes elsewhere, or something holds back these packets alone, a "
           "firewall or a switch that prunes multicast (IGMP snooping without a querier)";
}

std::string why_lost(const dmx::Statistics& statistics, const PatchMap& patch,
                     const dmx::LostUniverse& lost) {
    if (is_without_levels(statistics, lost.universe))
        return ". Packets still come, without levels" + empty_text(statistics, patch);
    if (lost.ended)
        return ". Its desk said that it ends this stream: its output was switched off, or its program closed";
    if (const std::string links = links_text(statistics, lost); !links.empty()) return links;
    if (const std::string heard = heard_text(statistics, lost); !heard.empty()) return heard;
    if (const std::string unreadable = unreadable_text(statistics); !unreadable.empty())
        return ". Packets arrive that cannot be read (" + unreadable +
               "): if they are its desk's, that has to be mended";
    return ". Its desk has stopped, sends elsewhere now (another universe or machine) or less often than "
           "every 2.5 s (sACN) or 10 s (Art-Net), or something on the way lets nothing through any more: a "
           "cable, a firewall, or a switch that prunes multicast after minutes (IGMP snooping without a "
           "querier)";
}

} // namespace

void add_lost(const dmx::Statistics& statistics, const PatchMap& patch, Sentences& out) {
    struct Lost {
        std::chrono::nanoseconds since;
        std::set<int> universes;
    };
    std::vector<dmx::LostUniverse> lost = statistics.lost;
    // From its last levels on, as all counts that are shown do, not from when it passed for lost.
    for (dmx::LostUniverse& one : lost) one.since = std::max(one.since, one.silent);
    std::stable_sort(lost.begin(), lost.end(),
                     [](const auto& a, const auto& b) { return a.since > b.since; });
    std::map<std::pair<bool, std::string>, std::vector<Lost>> alike; // black, and why
    for (const dmx::LostUniverse& one : lost) {
        if (!patch.universes().empty() && !patch.has(one.universe)) continue;
        if (is_blind(statistics, one.universe)) continue; // add_ignored says so
        std::vector<Lost>& times = alike[{one.black, why_lost(statistics, patch, one)}];
        if (times.empty() || times.back().since - one.since > kTogether) times.push_back({one.since, {}});
        times.back().universes.insert(one.universe);
    }
    for (const auto& [how, times] : alike)
        for (const Lost& one : times)
            out.push_back(problem(Trouble::lost,
                                  "nothing comes for " + universes_text(one.universes) + " any more, since " +
                                      seconds_text(one.since) + ": " +
                                      (how.first ? "black (--on-loss)" : "the last look is held") +
                                      how.second,
                                  one.universes));
}

} // namespace ghost::scene::diagnosed
