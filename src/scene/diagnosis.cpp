// SPDX-License-Identifier: Apache-2.0
#include "scene/diagnosis.h"

#include "scene/diagnosis_parts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace ghost::scene {
namespace {

using namespace diagnosed;
using namespace std::chrono_literals;

constexpr auto kSilent = 1s;   // too long for a desk whose levels move
constexpr auto kPatience = 5s; // unchanged levels come every second (sACN) or every four (Art-Net)

Sentence problem(Trouble trouble, std::string text) {
    return {trouble, true, std::move(text)};
}
Sentence note(Trouble trouble, std::string text) {
    return {trouble, false, std::move(text)};
}

void add_links(const dmx::Statistics& statistics, bool any_arrives, std::vector<Sentence>& out) {
    const std::string& chosen = statistics.listening.interface;
    const auto is_ours = [&](const dmx::NetInterface& one) {
        if (!chosen.empty())
            return one.name == chosen || (one.address != 0 && dmx::ipv4_text(one.address) == chosen);
        return !one.loopback;
    };
    const auto ours = std::find_if(statistics.interfaces.begin(), statistics.interfaces.end(), is_ours);
    const bool found = ours != statistics.interfaces.end();
    if (!chosen.empty() && !found && !chosen.starts_with("127."))
        out.push_back(
            problem(Trouble::no_interface,
                    "the interface " + chosen + " is down or gone: nothing is heard until it is back"));
    else if (chosen.empty() && !found && !any_arrives)
        out.push_back(problem(Trouble::no_interface,
                              "no network interface is up: only a desk on this machine, "
                              "by unicast to 127.0.0.1, can be heard"));
    const bool plugged =
        std::any_of(statistics.interfaces.begin(), statistics.interfaces.end(),
                    [&](const dmx::NetInterface& one) { return is_ours(one) && one.running; });
    if (found && !plugged && !any_arrives)
        out.push_back(
            problem(Trouble::cable, ours->name + " has no cable, or what is at its other end is off"));
}

// "260 too short, 3 not ours"; "" where none was refused.
std::string refused_text(const dmx::Statistics& statistics) {
    std::string text;
    for (std::size_t i = 0; i < statistics.drops.size(); ++i)
        if (statistics.drops[i] > 0)
            text += (text.empty() ? "" : ", ") + std::to_string(statistics.drops[i]) + " " +
                    dmx::drop_name(static_cast<dmx::Drop>(i));
    return text;
}

void add_silence(const dmx::Statistics& statistics, const Arriving& arriving, bool all_fed,
                 std::vector<Sentence>& out) {
    const dmx::Listening& listening = statistics.listening;
    const std::string refused = refused_text(statistics);
    if (arriving.nothing() && statistics.lost.empty() && !refused.empty()) {
        out.push_back(problem(Trouble::nothing_arrives,
                              "packets arrive, and none of them can be read as levels: " + refused +
                                  ". Whoever sends them has to be mended"));
    } else if (arriving.nothing() && statistics.lost.empty() && (listening.sacn || listening.artnet)) {
        std::string text =
            "nothing arrives: is the desk's output on, is it in this network, and is no firewall "
            "on UDP 5568 and 6454 in the way? We listen on " +
            addresses_text(statistics);
        if (listening.artnet && !has_artnet_address(statistics))
            text += "; Art-Net desks often stand in 2.x.x.x or 10.x.x.x with the mask 255.0.0.0";
        out.push_back(problem(Trouble::nothing_arrives, text));
    }
    for (const dmx::PortUser& user : statistics.port_users) {
        const auto sockets = std::find_if(statistics.sockets.begin(), statistics.sockets.end(),
                                          [&](const dmx::SocketStatus& s) { return s.port == user.port; });
        if (sockets == statistics.sockets.end()) continue;
        const bool sacn = sockets->protocol == dmx::Protocol::sacn;
        if (all_fed || arriving.by(sockets->protocol)) continue;
        const std::string who = dmx::program_text(user);
        out.push_back(problem(Trouble::port_shared,
                              "the port " + std::to_string(user.port) + " of " +
                                  dmx::protocol_name(sockets->protocol) + " is taken by " + who +
                                  ", too: of two programs only the one started last gets a desk's unicast. "
                                  "Close the other one, or start again with --interface and an address of "
                                  "this machine"));
        if (sacn)
            out.push_back(problem(Trouble::same_host,
                                  who +
                                      " runs on this machine: if it is the desk, its multicast does not come "
                                      "back here (QLC+ and OLA switch that off): have it send unicast to "
                                      "127.0.0.1"));
    }
}

// Universes that the patch and the network have one beside the other.
struct Shift {
    int by = 0; // universes of the patch = those that arrive + this
    dmx::Protocol protocol = dmx::Protocol::artnet;
    std::set<int> arriving;
};

std::optional<Shift> find_shift(dmx::Protocol protocol, const std::set<int>& arriving,
                                const PatchMap& patch) {
    const auto matches = [&](int by) {
        return std::count_if(arriving.begin(), arriving.end(), [&](int u) { return patch.has(u + by); });
    };
    const int by = matches(-1) > matches(1) ? -1 : 1;
    if (matches(by) <= matches(0)) return std::nullopt;
    return Shift{by, protocol, arriving};
}

std::string shift_text(const Shift& shift, const dmx::Statistics& statistics, const PatchMap& patch) {
    std::set<int> patched;
    for (const PatchedUniverse& one : patch.universes()) patched.insert(one.universe);
    std::string text = "off by one? " + std::string(dmx::protocol_name(shift.protocol)) + " comes for " +
                       universes_text(shift.arriving);
    const int offset = statistics.listening.artnet_offset;
    if (shift.protocol == dmx::Protocol::artnet)
        text += " (from Port-Address " + port_address_text(*shift.arriving.begin(), offset) + " on)";
    text += ", fixtures are on " + universes_text(patched) + ": ";
    if (shift.protocol == dmx::Protocol::artnet)
        return text + "--artnet-offset " + std::to_string(offset + shift.by) + " brings them together";
    return text + "move the desk's output or the show's patch by one";
}

void add_patch(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
               std::vector<Sentence>& out) {
    if (patch.universes().empty()) return;
    std::set<int> explained_patch, explained_arriving;
    for (const auto protocol : {dmx::Protocol::artnet, dmx::Protocol::sacn}) {
        const auto shift = find_shift(protocol, arriving.announced(protocol), patch);
        if (!shift) continue;
        out.push_back(problem(Trouble::off_by_one, shift_text(*shift, statistics, patch)));
        for (const int universe : shift->arriving) {
            explained_arriving.insert(universe);
            explained_patch.insert(universe + shift->by);
        }
    }
    const auto was_lost = [&](int universe) {
        return std::any_of(statistics.lost.begin(), statistics.lost.end(),
                           [&](const dmx::LostUniverse& one) { return one.universe == universe; });
    };
    std::set<int> missing, elsewhere;
    std::size_t fixtures = 0;
    std::string first;
    for (const PatchedUniverse& one : patch.universes()) {
        if (arriving.has(one.universe) || explained_patch.contains(one.universe) || was_lost(one.universe))
            continue;
        missing.insert(one.universe);
        fixtures += one.fixtures;
        if (first.empty()) first = one.first;
    }
    for (const auto& [universe, from] : arriving.universes)
        if (!patch.has(universe) && !explained_arriving.contains(universe)) elsewhere.insert(universe);
    if (!missing.empty() && !arriving.nothing())
        out.push_back(problem(Trouble::not_received, count_text(fixtures, "fixture") + " on " +
                                                         universes_text(missing) + " ('" + printable(first) +
                                                         "'" + (fixtures > 1 ? ", ..." : "") +
                                                         "), nothing arrives there" +
                                                         port_addresses_hint(missing, statistics.listening)));
    if (elsewhere.empty()) return;
    const std::string text = "packets for " + universes_text(elsewhere) + " arrive (" +
                             arriving.universes.at(*elsewhere.begin()) + "), nothing is patched there";
    out.push_back(missing.empty() ? note(Trouble::not_patched, text) : problem(Trouble::not_patched, text));
}

void add_lost(const dmx::Statistics& statistics, const PatchMap& patch, std::vector<Sentence>& out) {
    for (const bool black : {false, true}) {
        std::set<int> universes;
        std::chrono::nanoseconds longest{0};
        for (const dmx::LostUniverse& one : statistics.lost) {
            if (one.black != black || (!patch.universes().empty() && !patch.has(one.universe))) continue;
            universes.insert(one.universe);
            longest = std::max(longest, one.since);
        }
        if (universes.empty()) continue;
        out.push_back(problem(Trouble::lost, "nobody sends " + universes_text(universes) +
                                                 " any more, since " + seconds_text(longest) + ": " +
                                                 (black ? "black (--on-loss)" : "the last look is held")));
    }
}

// "; there 10.0.0.7 (silent for 4 s) and 10.0.0.8 have the places of Art-Net, .."; "" where fewer do.
std::string artnet_holders_text(const dmx::Statistics& statistics, int universe) {
    std::string text;
    std::size_t count = 0;
    for (const dmx::SourceStatus& source : statistics.sources) {
        if (source.universe != universe || source.protocol != dmx::Protocol::artnet) continue;
        text += (count++ > 0 ? " and " : "") + printable(source.id);
        if (source.age >= kSilent) text += " (silent for " + seconds_text(source.age) + ")";
    }
    if (count < dmx::kMaxArtnetSources) return "";
    return "; there " + text + " have the places of Art-Net, and one that is silent for " +
           seconds_text(dmx::kArtnetLoss) + " makes room";
}

void add_ignored(const dmx::Statistics& statistics, std::vector<Sentence>& out) {
    std::map<std::pair<dmx::IgnoredSource::Why, std::string>, std::set<int>> ignored; // by who
    for (const dmx::IgnoredSource& one : statistics.ignored)
        ignored[{one.why, source_text(one.name, dmx::address_text(one.from), one.protocol)}].insert(
            one.universe);
    for (const auto& [key, universes] : ignored) {
        const auto& [why, who] = key;
        if (why == dmx::IgnoredSource::Why::preview)
            out.push_back(problem(Trouble::preview,
                                  who + " marks " + universes_text(universes) +
                                      " as preview (blind), which is not shown: leave blind on the desk, or "
                                      "start with --show-preview"));
        else
            out.push_back(
                problem(Trouble::too_many, who + " is one source too many on " + universes_text(universes) +
                                               " and ignored: Art-Net merges two, all together 16" +
                                               artnet_holders_text(statistics, *universes.begin())));
    }
    if (statistics.recent.too_many_universes > 0)
        out.push_back(problem(
            Trouble::too_many_universes,
            "more universes arrive than the " + std::to_string(dmx::kMaxUniverses) +
                " that are shown at once; those of the show and of --universes are always among them"));
    std::map<std::string, std::set<int>> low;
    for (const dmx::SourceStatus& source : statistics.sources)
        if (role_text(source, statistics.sources) == "lower priority")
            low[source_text(source.name, dmx::place_text(source), source.protocol) + " (priority " +
                std::to_string(source.priority) + ")"]
                .insert(source.universe);
    for (const auto& [who, universes] : low)
        out.push_back(note(Trouble::low_priority, who + " is not shown on " + universes_text(universes) +
                                                      ": another source has a higher priority"));
}

void add_sources(const dmx::Statistics& statistics, std::vector<Sentence>& out) {
    std::map<std::string, std::set<int>> waiting, foreign, astray, cut;
    for (const dmx::SourceStatus& source : statistics.sources) {
        const std::string who = source_text(source.name, dmx::place_text(source), source.protocol);
        if (source.held && synchronisation_is_late(source, statistics.sync))
            waiting[who].insert(source.universe);
        if (source.protocol == dmx::Protocol::artnet && is_foreign(source.from, statistics))
            foreign[who].insert(source.universe);
        if (source.wrong_group) astray[who].insert(source.universe);
        if (source.wrong_length) cut[who].insert(source.universe);
    }
    for (const auto& [who, universes] : waiting)
        out.push_back(problem(Trouble::waits_for_sync,
                              "levels of " + who + " on " + universes_text(universes) +
                                  " wait for a synchronisation packet that does not come; after 10 s at most "
                                  "they show without"));
    for (const auto& [who, universes] : foreign)
        out.push_back(
            note(Trouble::other_network,
                 who + " sends Art-Net from another network than ours (" + addresses_text(statistics) +
                     "): its broadcasts arrive, unicast and our answers may not; give this machine an "
                     "address in its network"));
    for (const auto& [who, universes] : astray)
        out.push_back(
            note(Trouble::wrong_group, who + " sends " + universes_text(universes) +
                                           " to the multicast group of another universe; the levels "
                                           "are used"));
    for (const auto& [who, universes] : cut)
        out.push_back(note(Trouble::wrong_length, who + " declares more levels on " +
                                                      universes_text(universes) +
                                                      " than its packets hold; those that come are used"));
    if (statistics.recent.overflow > 0)
        out.push_back(
            problem(Trouble::packets_lost,
                    "this machine dropped " + count_text(statistics.recent.overflow, "packet") +
                        " in the last seconds: it is too busy, or the sockets' buffers are too small "
                        "(as root: sysctl -w net.core.rmem_max=4194304)"));
    if (statistics.recent.missed > statistics.recent.overflow)
        out.push_back(problem(Trouble::packets_lost,
                              count_text(statistics.recent.missed - statistics.recent.overflow, "packet") +
                                  " got lost on the way in the last seconds: cable, switch or Wi-Fi"));
}

} // namespace

const char* trouble_name(Trouble trouble) {
    switch (trouble) {
    case Trouble::not_listening:
        return "not_listening";
    case Trouble::no_interface:
        return "no_interface";
    case Trouble::cable:
        return "cable";
    case Trouble::nothing_arrives:
        return "nothing_arrives";
    case Trouble::port_shared:
        return "port_shared";
    case Trouble::same_host:
        return "same_host";
    case Trouble::off_by_one:
        return "off_by_one";
    case Trouble::not_received:
        return "not_received";
    case Trouble::not_patched:
        return "not_patched";
    case Trouble::lost:
        return "lost";
    case Trouble::preview:
        return "preview";
    case Trouble::low_priority:
        return "low_priority";
    case Trouble::too_many:
        return "too_many";
    case Trouble::too_many_universes:
        return "too_many_universes";
    case Trouble::waits_for_sync:
        return "waits_for_sync";
    case Trouble::other_network:
        return "other_network";
    case Trouble::wrong_group:
        return "wrong_group";
    case Trouble::wrong_length:
        return "wrong_length";
    case Trouble::packets_lost:
        return "packets_lost";
    }
    return "?";
}

std::vector<Sentence> diagnose(const dmx::Statistics& statistics, const PatchMap& patch) {
    std::vector<Sentence> out;
    if (!statistics.listening.problem.empty())
        return {problem(Trouble::not_listening, statistics.listening.problem)};
    const Arriving arriving(statistics);
    const bool patient = statistics.time - statistics.listening.since >= kPatience;
    add_links(statistics, !arriving.nothing(), out);
    // Without a patch whatever arrives will do.
    const bool all_fed =
        patch.universes().empty()
            ? !arriving.nothing()
            : std::all_of(patch.universes().begin(), patch.universes().end(),
                          [&](const PatchedUniverse& one) { return arriving.has(one.universe); });
    if (patient && out.empty()) add_silence(statistics, arriving, all_fed, out);
    if (patient) add_patch(statistics, arriving, patch, out);
    add_lost(statistics, patch, out);
    add_ignored(statistics, out);
    add_sources(statistics, out);
    return out;
}

} // namespace ghost::scene
