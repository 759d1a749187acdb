// SPDX-License-Identifier: Apache-2.0
#include "diagnose/diagnosis_parts.h"

#include "base/print.h"

#include <algorithm>
#include <bit>

namespace ghost::scene {

namespace diagnosed {

namespace {

using namespace std::chrono_literals;

constexpr auto kSyncIsLate = dmx::kSacnSyncLoss; // frames may come a second and more apart
constexpr std::size_t kMostRanges = 8;

bool is_ours(const dmx::NetInterface& one, const dmx::Listening& listening) {
    if (one.address == 0) return false;
    if (listening.interface.empty()) return !one.loopback;
    return one.name == listening.interface || dmx::ipv4_text(one.address) == listening.interface;
}

bool has_levels(const dmx::SourceStatus& source) {
    return source.slot_count > 0 || source.most_slots > 0; // or it waits to be synchronised
}

} // namespace

Arriving::Arriving(const dmx::Statistics& statistics) {
    const auto add = [&](int universe, dmx::Protocol protocol, const std::string& from) {
        std::string& first = universes.emplace(universe, from).first->second;
        if (first != from) shared.insert(universe);
        first = std::min(first, from);
        by_protocol[protocol].insert(universe);
    };
    for (const dmx::SourceStatus& source : statistics.sources)
        if (source.state != dmx::SourceState::silent && has_levels(source))
            add(source.universe, source.protocol,
                source_text(source.name, dmx::place_text(source), source.protocol));
    for (const dmx::UnlistedUniverse& one : statistics.unlisted_universes) {
        add(one.universe, one.protocol, source_text(one.name, dmx::address_text(one.from), one.protocol));
        if (one.has_others) shared.insert(one.universe);
    }
    for (const dmx::IgnoredSource& one : statistics.ignored)
        add(one.universe, one.protocol, source_text(one.name, dmx::address_text(one.from), one.protocol));
    for (const dmx::DiscoveredSource& one : statistics.discovered) {
        if (one.protocol == dmx::Protocol::artnet && !nothing()) continue;
        const Listed entry{source_text(one.name, dmx::address_text(one.from), one.protocol), one.protocol,
                           one.age};
        for (const int universe : *one.universes) listed.emplace(universe, entry);
    }
}

std::set<int> Arriving::announced(dmx::Protocol protocol) const {
    const auto found = by_protocol.find(protocol);
    std::set<int> result = found == by_protocol.end() ? std::set<int>() : found->second;
    for (const auto& [universe, one] : listed)
        if (one.protocol == protocol) result.insert(universe);
    return result;
}

std::string Arriving::announced_text(const std::set<int>& of) const {
    std::map<std::string, std::set<int>> by_who;
    for (const int universe : of) by_who[listed.at(universe).who].insert(universe);
    std::string text;
    for (const auto& [who, numbers] : by_who)
        text += (text.empty() ? "" : ", ") + who + " announces " + universes_text(numbers);
    return text;
}

std::string count_text(std::uint64_t count, const std::string& word) {
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

std::string universes_text(const std::set<int>& universes) {
    std::vector<std::pair<int, int>> ranges;
    for (const int universe : universes)
        if (!ranges.empty() && ranges.back().second == universe - 1)
            ranges.back().second = universe;
        else
            ranges.emplace_back(universe, universe);
    std::string text = universes.size() == 1 ? "universe " : "universes ";
    for (std::size_t i = 0; i < std::min(ranges.size(), kMostRanges); ++i) {
        const auto& [first, last] = ranges[i];
        text += (i > 0 ? ", " : "") + std::to_string(first);
        if (last > first) text += "-" + std::to_string(last);
    }
    return ranges.size() > kMostRanges ? text + ", ..." : text;
}

std::set<int> numbers_of(const PatchMap& patch) {
    std::set<int> numbers;
    for (const PatchedUniverse& one : patch.universes()) numbers.insert(one.universe);
    return numbers;
}

std::string seconds_text(std::chrono::nanoseconds time) {
    return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

std::string source_text(const std::string& name, const std::string& place, dmx::Protocol protocol) {
    if (!name.empty()) return "'" + one_line(name) + "' (" + one_line(place) + ")";
    return one_line(place) + " (" + dmx::protocol_name(protocol) + ")";
}

bool is_without_levels(const dmx::Statistics& statistics, int universe) {
    return std::any_of(
        statistics.sources.begin(), statistics.sources.end(),
        [&](const dmx::SourceStatus& one) { return one.universe == universe && !has_levels(one); });
}

std::string empty_text(const dmx::Statistics& statistics, const PatchMap& patch) {
    std::set<std::string> bare, priorities;
    for (const dmx::SourceStatus& source : statistics.sources)
        if (!has_levels(source) && (patch.universes().empty() || patch.has(source.universe)))
            (source.packets > 0 ? bare : priorities)
                .insert(source_text(source) + " on universe " + std::to_string(source.universe));
    std::string text;
    const auto add = [&](const std::set<std::string>& who, const std::string& what) {
        if (!who.empty()) text += "; " + *who.begin() + (who.size() > 1 ? " and others" : "") + what;
    };
    add(bare, ": packets without a single level");
    add(priorities, ": only priorities per address (start code 0xDD), no levels");
    return text;
}

std::string source_text(const dmx::SourceStatus& source) {
    return source_text(source.name, dmx::place_text(source), source.protocol);
}

std::string addresses_text(const dmx::Statistics& statistics) {
    std::string text;
    for (const dmx::NetInterface& one : statistics.interfaces)
        if (is_ours(one, statistics.listening))
            text += (text.empty() ? "" : ", ") + one.name + " (" + dmx::ipv4_text(one.address) + "/" +
                    std::to_string(std::popcount(one.netmask)) + (one.running ? ")" : ", no cable)");
    if (!text.empty()) return text;
    return statistics.listening.interface.empty() ? "no network but this machine's own"
                                                  : statistics.listening.interface;
}

std::string unaddressed_text(const dmx::Statistics& statistics) {
    constexpr std::uint32_t kLinkLocal = 0xA9FE0000, kLinkLocalMask = 0xFFFF0000; // RFC 3927
    const std::string& chosen = statistics.listening.interface;
    std::string text;
    for (const dmx::NetInterface& one : statistics.interfaces) {
        if (one.loopback || one.bridged || !one.running ||
            (!chosen.empty() && !is_ours(one, statistics.listening) && one.name != chosen))
            continue;
        if (one.address == 0)
            text += ". " + one.name +
                    " has a cable and no IPv4 address (no DHCP server answers, perhaps): for Art-Net, and "
                    "for sACN by IPv4, it needs one in the desk's network";
        else if ((one.address & kLinkLocalMask) == kLinkLocal)
            text += ". " + one.name + " gave itself " + dmx::ipv4_text(one.address) +
                    ", as a machine does that no DHCP server answers: for Art-Net the "
                    "desk has to be in 169.254.x.x, too";
    }
    return text;
}

std::string broadcasts_text(const dmx::Statistics& statistics) {
    struct Usual {
        std::uint32_t broadcast;
        const char* text;
        const char* network;
    };
    static constexpr Usual kUsual[] = {{0x02FFFFFF, "2.255.255.255", "2.x.x.x"},
                                       {0x0AFFFFFF, "10.255.255.255", "10.x.x.x"}};
    std::string deaf, networks, taken;
    for (const Usual& usual : kUsual) {
        const bool arrives = std::any_of(
            statistics.interfaces.begin(), statistics.interfaces.end(), [&](const dmx::NetInterface& one) {
                return is_ours(one, statistics.listening) && (one.address | ~one.netmask) == usual.broadcast;
            });
        if (arrives) continue;
        deaf += (deaf.empty() ? "" : " and ") + std::string(usual.text);
        networks += (networks.empty() ? "" : " or ") + std::string(usual.network);
    }
    if (deaf.empty()) return "";
    for (const dmx::NetInterface& one : statistics.interfaces)
        if (is_ours(one, statistics.listening))
            taken += (taken.empty() ? "" : ", ") + dmx::ipv4_text(one.address | ~one.netmask);
    return "Art-Net that a desk broadcasts to " + deaf + " (one in " + networks +
           " with the mask 255.0.0.0) does not arrive at our address and mask" +
           (taken.empty() ? std::string() : ", which take " + taken + " and 255.255.255.255") +
           ": give both machines one network and one mask";
}

bool is_foreign(const dmx::IpAddress& address, const dmx::Statistics& statistics) {
    if (!address.is_ipv4() || address.is_loopback()) return false;
    return std::none_of(statistics.interfaces.begin(), statistics.interfaces.end(),
                        [&](const dmx::NetInterface& one) {
                            return one.address != 0 && ((one.address ^ address.ipv4()) & one.netmask) == 0;
                        });
}

bool synchronisation_is_late(const dmx::SourceStatus& source) {
    return source.held && source.held_for > kSyncIsLate;
}

std::string port_addresses_hint(const std::set<int>& universes, const dmx::Listening& listening) {
    const std::string text = universes.size() == 1
                                 ? port_address_text(*universes.begin(), listening.artnet_offset)
                                 : std::string();
    return text.empty() || !listening.artnet ? "" : " (in Art-Net: Port-Address " + text + ")";
}

Sentence problem(Trouble trouble, std::string text, std::set<int> universes) {
    return {trouble, true, std::move(text), std::move(universes)};
}

Sentence note(Trouble trouble, std::string text, std::set<int> universes) {
    return {trouble, false, std::move(text), std::move(universes)};
}

} // namespace diagnosed

std::string role_text(const dmx::SourceStatus& source, const std::vector<dmx::SourceStatus>& all) {
    if (source.state != dmx::SourceState::live) return dmx::source_state_name(source.state);
    const auto beside = [&](auto&& which) {
        return std::any_of(all.begin(), all.end(), [&](const dmx::SourceStatus& other) {
            return &other != &source && other.universe == source.universe && which(other);
        });
    };
    if (source.slot_count == 0) return "no levels";
    if (source.slots_held == 0) {
        if (beside([&](const auto& other) { return other.preview && !source.preview; }))
            return "behind preview";
        if (beside([](const auto& other) { return other.slots_held > 0; })) return "lower priority";
        return "holds no slot";
    }
    if (source.slots_held < source.slot_count) return "in part";
    return beside([](const auto& other) { return other.slots_held > 0; }) ? "merged" : "shown";
}

std::string port_address_text(int universe, int artnet_offset) {
    const int address = universe - artnet_offset;
    if (address < 0 || address > 0x7FFF) return "";
    return std::to_string(address >> 8) + ":" + std::to_string((address >> 4) & 15) + ":" +
           std::to_string(address & 15);
}

} // namespace ghost::scene
