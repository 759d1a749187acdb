// SPDX-License-Identifier: Apache-2.0
// Why nothing arrives: links, ports, networks, and what comes somewhere else instead. Where several causes
// are possible they are listed with what tells them apart.
#include "diagnose/diagnosis_parts.h"

#include <algorithm>
#include <numeric>

namespace ghost::scene::diagnosed {

void add_links(const dmx::Statistics& statistics, bool any_arrives, Sentences& out) {
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

namespace {

// Fewer of late that cannot be read may be anybody's.
constexpr std::uint64_t kManyRefused = 20;
constexpr std::chrono::seconds kListedAfter{1}; // the last levels: who announces then is still there

std::uint64_t sum(const dmx::Refused& refused) {
    return std::accumulate(refused.begin(), refused.end(), std::uint64_t{0});
}

bool is_unreadable(const dmx::Statistics& statistics) {
    return sum(statistics.recent.refused) >= kManyRefused;
}

// "260 too short, 3 not ours"; "" where none was refused.
std::string refused_text(const dmx::Statistics& statistics) {
    std::string text;
    const dmx::Refused& refused = statistics.recent.refused;
    for (std::size_t i = 0; i < refused.size(); ++i)
        if (refused[i] > 0)
            text += (text.empty() ? "" : ", ") + std::to_string(refused[i]) + " " +
                    dmx::drop_name(static_cast<dmx::Drop>(i));
    return text;
}

// "though 12 other packets did (3 poll, 9 discovery)"; "" where none did.
std::string others_text(const dmx::Statistics& statistics) {
    std::string text;
    std::uint64_t count_of_all = 0;
    for (std::size_t i = 0; i < statistics.notices.size(); ++i)
        if (const std::uint64_t count = statistics.notices[i]; count > 0) {
            count_of_all += count;
            text += (text.empty() ? "" : ", ") + std::to_string(count) + " " +
                    dmx::notice_name(static_cast<dmx::Notice>(i));
        }
    if (const std::string refused = refused_text(statistics); !refused.empty()) {
        count_of_all += sum(statistics.recent.refused);
        text += (text.empty() ? "" : ", ") + refused;
    }
    // Goodbyes, and priorities per address without levels.
    if (const std::uint64_t all = statistics.packets_sacn + statistics.packets_artnet;
        text.empty() && all > 0) {
        count_of_all = all;
        text = "without levels";
    }
    return count_of_all == 0 ? ""
                             : ", though " + count_text(count_of_all, "other packet") + " did (" + text + ")";
}

// "eth1 (10.0.0.3/24)" of an interface.
std::string interface_text(const dmx::Statistics& statistics, unsigned index) {
    for (const dmx::NetInterface& one : statistics.interfaces)
        if (one.index == index) return one.name;
    return "interface " + std::to_string(index);
}

void add_wrong_interface(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
                         Sentences& out) {
    const auto is_missed = [&](const dmx::ElsewhereUniverse& one) {
        return !arriving.has(one.universe) && (patch.universes().empty() || patch.has(one.universe));
    };
    // Another universe of our desk is told of where nothing else is known.
    const bool any =
        arriving.nothing() && statistics.lost.empty() &&
        std::none_of(statistics.elsewhere_universes.begin(), statistics.elsewhere_universes.end(), is_missed);
    std::map<std::pair<unsigned, std::string>, std::set<int>> elsewhere; // by interface and who
    for (const dmx::ElsewhereUniverse& one : statistics.elsewhere_universes)
        if (any || is_missed(one))
            elsewhere[{one.interface_index, source_text(one.name, dmx::address_text(one.from), one.protocol)}]
                .insert(one.universe);
    for (const auto& [key, universes] : elsewhere) {
        const std::string name = interface_text(statistics, key.first);
        out.push_back(problem(Trouble::wrong_interface,
                              key.second + " sends " + universes_text(universes) + ", but it comes in on " +
                                  name + ", and we listen on " + addresses_text(statistics) +
                                  " only: start with --interface " + name + ", or without --interface",
                              any ? numbers_of(patch) : universes));
    }
}

// Announced by sACN's lists, which come by multicast, too, and yet no level of it.
void add_held_back(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
                   Sentences& out) {
    if (sum(statistics.recent.refused_sacn) >= kManyRefused) return; // it comes, and cannot be read
    std::map<std::string, std::set<int>> held;
    // What came until now is lost, and add_lost says why; lists outlive their sender by 25 s.
    const auto is_old = [&](int universe, const Arriving::Listed& one) {
        const auto lost =
            std::find_if(statistics.lost.begin(), statistics.lost.end(),
                         [&](const dmx::LostUniverse& other) { return other.universe == universe; });
        const bool is_silent = std::any_of(
            statistics.sources.begin(), statistics.sources.end(), [&](const dmx::SourceStatus& source) {
                return source.universe == universe && source.state == dmx::SourceState::silent;
            });
        return is_silent || (lost != statistics.lost.end() && one.age + kListedAfter > lost->silent);
    };
    const auto is_exchanged = [&](int universe, const std::string& who) { // add_patch says so
        const auto found = arriving.universes.find(bytes_exchanged(universe));
        return found != arriving.universes.end() && found->second == who;
    };
    for (const auto& [universe, one] : arriving.listed)
        if (one.protocol == dmx::Protocol::sacn && patch.has(universe) && !arriving.has(universe) &&
            !is_without_levels(statistics, universe) && !is_exchanged(universe, one.who) &&
            !is_old(universe, one))
            held[one.who].insert(universe);
    for (const auto& [who, universes] : held)
        out.push_back(problem(
            Trouble::held_back,
            who + " announces " + universes_text(universes) +
                ", and none of it arrives here: either it sends them by unicast to other addresses than ours "
                "(its output page says so), or a switch holds this multicast back (IGMP snooping without a "
                "querier): unicast to " +
                addresses_text(statistics) +
                " gets past both; or it announces what it does not send (its output is off)",
            universes));
}

// "udp port 5568 or udp port 6454" of "5568 and 6454".
std::string tcpdump_text(std::string ports) {
    const std::string_view both = " and ";
    if (const std::size_t place = ports.find(both); place != std::string::npos)
        ports.replace(place, both.size(), " or udp port ");
    return "udp port " + ports;
}

// That we listen on, where `wanted`: "5568 and 6454".
std::string joined_ports(const dmx::Statistics& statistics, bool sacn, bool artnet) {
    std::string text;
    for (const auto& [protocol, wanted] :
         {std::pair(dmx::Protocol::sacn, sacn), std::pair(dmx::Protocol::artnet, artnet)}) {
        const auto socket =
            std::find_if(statistics.sockets.begin(), statistics.sockets.end(),
                         [by = protocol](const dmx::SocketStatus& one) { return one.protocol == by; });
        if (wanted && socket != statistics.sockets.end())
            text += (text.empty() ? "" : " and ") + std::to_string(socket->port);
    }
    return text;
}

// Who sends Art-Net to those alone that answer its polls, and gets no answer.
std::string polls_text(const dmx::Statistics& statistics) {
    const dmx::RecentLoss& recent = statistics.recent;
    if (!statistics.listening.artnet || recent.polls == 0) return "";
    if (!statistics.listening.answers_polls)
        return ". Somebody asks who wants Art-Net (ArtPoll) and gets no answer (--no-poll-reply): OLA and "
               "some "
               "desks send to those alone that answer";
    return recent.polls_refused < recent.polls
               ? ". Somebody asks who wants Art-Net (ArtPoll) and is answered: where that is the desk, a "
                 "firewall of its machine on UDP 6454 may keep our answer from it, or it has no output for "
                 "our universes"
               : ". Somebody asks who wants Art-Net (ArtPoll) and gets no answer, for it asks from another "
                 "network, too often or with too many others: OLA and some desks send to those alone that "
                 "answer";
}

std::string reverse_path_text(const dmx::Statistics& statistics) {
    if (statistics.recent.reverse_path == 0) return "";
    return ". The reverse path filter of this machine dropped " +
           count_text(statistics.recent.reverse_path, "packet") +
           " in the last seconds, of senders that it would not answer by the card that they came by: if they "
           "are the desk's, give that card an address in the desk's network (or, as root: sysctl -w "
           "net.ipv4.conf.all.rp_filter=2, and the same for the card)";
}

void add_nothing(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
                 Sentences& out) {
    const dmx::Listening& listening = statistics.listening;
    if (is_unreadable(statistics)) {
        const auto bad_universe = static_cast<std::size_t>(dmx::Drop::bad_universe);
        const bool has_bad_universe =
            statistics.recent.refused[bad_universe] > statistics.recent.refused_sacn[bad_universe];
        const bool of_sacn = statistics.recent.refused_sacn[bad_universe] > 0;
        out.push_back(problem(
            Trouble::nothing_arrives,
            "packets arrive, and none of them can be read as levels: " + refused_text(statistics) +
                (has_bad_universe && listening.artnet && listening.artnet_offset < 1
                     ? ". With --artnet-offset " + std::to_string(listening.artnet_offset) +
                           " the first Port-Addresses have no universe"
                     : "") +
                (of_sacn ? ". sACN has universes 1 to 63999: a desk that counts from 0 has to count from 1"
                         : "") +
                ". If they are the desk's, it has to be mended; if not: is its output on, and is it in this "
                "network? We listen on " +
                addresses_text(statistics)));
        return;
    }
    const std::string others = others_text(statistics);
    // A port that packets come by is closed by no firewall.
    const std::string ports = joined_ports(statistics, listening.sacn && statistics.packets_sacn == 0,
                                           listening.artnet && statistics.packets_artnet == 0);
    std::string text = (others.empty() ? "nothing arrives" : "no levels arrive" + others) +
                       ": is the desk's output on, is it in this network, " +
                       (ports.empty() ? "does it send to a universe of ours"
                                      : "and is no firewall on UDP " + ports + " in the way") +
                       "? We listen on " + addresses_text(statistics) + empty_text(statistics, patch);
    if (listening.wider > 0) text += ", also for " + count_text(listening.wider, "universe") + " around";
    text += polls_text(statistics);
    if (!listening.sacn || !listening.artnet)
        text +=
            ". " + std::string(listening.sacn ? "Art-Net" : "sACN") + " is not listened for (--protocols)";
    if (const auto chosen = std::find_if(statistics.interfaces.begin(), statistics.interfaces.end(),
                                         [&](const dmx::NetInterface& one) {
                                             return one.loopback && (one.name == listening.interface ||
                                                                     listening.interface.starts_with("127."));
                                         });
        chosen != statistics.interfaces.end())
        text += ". By " + chosen->name + " only programs of this machine are heard (--interface)";
    text += unaddressed_text(statistics);
    text += reverse_path_text(statistics);
    if (const std::string broadcasts = listening.artnet ? broadcasts_text(statistics) : "";
        !broadcasts.empty())
        text += ". " + broadcasts;
    std::set<int> listed;
    for (const auto& [universe, one] : arriving.listed) listed.insert(universe);
    if (!listed.empty())
        text += "; " + arriving.announced_text(listed) +
                (patch.universes().empty() ? ", which --universes can name" : "");
    if (others.empty())
        text += ". A desk on this very machine has to send unicast to 127.0.0.1: multicast of QLC+ does not "
                "come back here";
    if (!ports.empty()) // else packets get through
        text +=
            ". To tell them apart: where 'tcpdump -ni any " + tcpdump_text(ports) +
            "' shows packets to an address of ours, to its broadcast or to the group of a universe of ours "
            "(239.255.0.1, ff18::.. for 1), a firewall or the "
            "reverse path filter of this machine drops them, or their sender has an address of ours; to "
            "another broadcast, the masks differ; to another group, it is another universe; where "
            "it "
            "shows none at all, they do not get here: a cable, another VLAN, a switch that holds multicast "
            "back (IGMP snooping without a querier), a desk that sends to other addresses alone (unicast), "
            "or one that is silent";
    out.push_back(problem(Trouble::nothing_arrives, text));
}

} // namespace

std::string unreadable_text(const dmx::Statistics& statistics) {
    return is_unreadable(statistics) ? refused_text(statistics) : "";
}

void add_silence(const dmx::Statistics& statistics, const Arriving& arriving, const PatchMap& patch,
                 bool all_fed, Sentences& out) {
    const dmx::Listening& listening = statistics.listening;
    const std::size_t before = out.size();
    add_wrong_interface(statistics, arriving, patch, out);
    add_held_back(statistics, arriving, patch, out);
    // Who sends sACN's lists sends levels, too: add_patch says where. A port of Art-Net may be idle.
    const auto is_elsewhere = [&](const auto& one) {
        return one.second.protocol == dmx::Protocol::sacn && !patch.has(one.first);
    };
    const bool elsewhere = !patch.universes().empty() &&
                           std::any_of(arriving.listed.begin(), arriving.listed.end(), is_elsewhere);
    const bool just_lost =
        std::any_of(statistics.sources.begin(), statistics.sources.end(),
                    [](const dmx::SourceStatus& source) { return source.state == dmx::SourceState::silent; });
    if (out.size() == before && (!elsewhere || is_unreadable(statistics)) && arriving.nothing() &&
        statistics.lost.empty() && !just_lost && (listening.sacn || listening.artnet))
        add_nothing(statistics, arriving, patch, out);
    for (const dmx::PortUser& user : statistics.port_users) {
        const auto sockets = std::find_if(statistics.sockets.begin(), statistics.sockets.end(),
                                          [&](const dmx::SocketStatus& s) { return s.port == user.port; });
        if (sockets == statistics.sockets.end()) continue;
        const bool sacn = sockets->protocol == dmx::Protocol::sacn;
        if (all_fed || arriving.by(sockets->protocol)) continue;
        const std::string who = dmx::program_text(user);
        const bool other_is_ours = user.program == "ghostlight"; // a monitor beside explain, mostly
        out.push_back((other_is_ours ? note : problem)(
            Trouble::port_shared,
            "the port " + std::to_string(user.port) + " of " + dmx::protocol_name(sockets->protocol) +
                " is taken by " + who +
                ", too: of two programs only the one started last gets a desk's unicast. "
                "Close the other one, or start again with --interface and an address of "
                "this machine",
            {}));
        if (sacn && !other_is_ours)
            out.push_back(problem(Trouble::same_host,
                                  who +
                                      " runs on this machine: if it is the desk, its multicast does not come "
                                      "back here (QLC+ switches that off): have it send unicast to "
                                      "127.0.0.1"));
    }
}

} // namespace ghost::scene::diagnosed
