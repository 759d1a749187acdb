// SPDX-License-Identifier: Apache-2.0
#include "dmx/receive/intake.h"

#include "dmx/wire/build.h"

#include <algorithm>
#include <tuple>

namespace ghost::dmx {

namespace {

constexpr std::chrono::seconds kUnlistedForgotten{10};
constexpr std::chrono::seconds kTimecodeSilent{1};  // then another sender is followed
constexpr std::chrono::seconds kSenderForgotten{3}; // of one that others send, too

template <class T>
void remember(std::vector<T>& list, T entry) {
    entry.number = list.empty() ? 1 : list.back().number + 1;
    if (list.size() >= kMaxRemembered) list.erase(list.begin());
    list.push_back(std::move(entry));
}

} // namespace

Intake::Intake(const IntakeOptions& options) : options_(options), merge_(options.merge) {
    if (options.merge.asked.empty()) merge_.ask_for(options.universes);
}

bool Intake::accepts(std::uint16_t universe) const {
    const auto& wanted = options_.universes;
    return wanted.empty() || options_.accept_others ||
           std::binary_search(wanted.begin(), wanted.end(), universe);
}

void Intake::listen_to(std::vector<std::uint16_t> universes) {
    options_.universes = std::move(universes);
    if (!options_.universes.empty() && !options_.accept_others) merge_.keep_only(options_.universes);
    merge_.ask_for(options_.universes);
    std::erase_if(unlisted_, [&](const auto& entry) { return accepts(entry.first.first); });
}

void Intake::take_levels(Packet& packet, const Arrival& arrival) {
    if (!accepts(packet.universe)) {
        ++counted_.unlisted;
        merge_.pass_elsewhere(packet.source);
        const auto key = std::make_pair(packet.universe, packet.protocol);
        const auto place = unlisted_.find(key);
        if (place == unlisted_.end() && unlisted_.size() >= kMaxUnlisted) return;
        Unlisted& unlisted = place == unlisted_.end() ? unlisted_[key] : place->second;
        UnlistedUniverse& told = unlisted.told;
        const auto sender = std::tie(packet.source_name, packet.from);
        const auto named = std::tie(told.name, told.from);
        if (told.packets > 0 && sender != named) unlisted.other = arrival.time;
        if (told.packets == 0 || sender <= named || arrival.time - unlisted.named > kSenderForgotten) {
            told.name = packet.source_name;
            told.from = packet.from;
            unlisted.named = arrival.time;
        }
        told.universe = packet.universe;
        told.protocol = packet.protocol;
        told.has_others = unlisted.other && arrival.time - *unlisted.other <= kSenderForgotten;
        told.age = arrival.time;
        ++told.packets;
        return;
    }
    packet.from_port = arrival.from_port;
    packet.interface_index = arrival.interface_index;
    packet.wrong_group = packet.protocol == Protocol::sacn && arrival.to.is_multicast() &&
                         arrival.to != sacn_group_address(packet.universe, !arrival.to.is_ipv4());
    counted_.wrong_group += packet.wrong_group ? 1 : 0;
    counted_.wrong_length += packet.wrong_length ? 1 : 0;
    if (options_.before_levels) options_.before_levels(packet.universe);
    merge_.feed(packet, arrival.time);
}

void Intake::take_timecode(const TimeCodeStatus& now) {
    auto& [followed, other] = counted_.followed_timecodes;
    const bool is_same = followed && followed->from == now.from && followed->from_port == now.from_port;
    // Some open a socket for each packet: of one machine a port that spoke once is left for one that is new.
    const bool is_of_machine = followed && !is_same && followed->from == now.from;
    const bool is_back = is_of_machine && std::find(left_timecode_ports_.begin(), left_timecode_ports_.end(),
                                                    now.from_port) != left_timecode_ports_.end();
    const bool moves_on = is_of_machine && followed_in_a_row_ == 1 && !is_back;
    const bool is_silent = followed && now.arrival - followed->arrival > kTimecodeSilent;
    if (followed && !is_same && !moves_on && !is_silent) {
        other = now;
        return;
    }
    if (is_silent && !is_same) other.reset();
    if (moves_on) left_timecode_ports_[followed->packets % left_timecode_ports_.size()] = followed->from_port;
    followed_in_a_row_ = is_same ? followed_in_a_row_ + 1 : 1;
    followed = now;
    if (options_.on_timecode) options_.on_timecode(now.time, now.arrival);
}

std::optional<PollPacket> Intake::take(Bytes bytes, const Arrival& arrival) {
    const bool sacn = arrival.protocol == Protocol::sacn;
    Parsed parsed =
        sacn ? parse_sacn(bytes, arrival.from) : parse_artnet(bytes, arrival.from, options_.artnet_offset);
    const std::optional<Notice> notice = notice_of(parsed);
    if (arrival.own && notice == Notice::poll_reply) return std::nullopt;
    ++(sacn ? counted_.packets_sacn : counted_.packets_artnet);
    if (notice) ++counted_.notices[static_cast<std::size_t>(*notice)];
    const auto refuse = [&](Drop why) {
        ++counted_.drops[static_cast<std::size_t>(why)];
        if (sacn) ++counted_.drops_sacn[static_cast<std::size_t>(why)];
    };
    if (const Drop* drop = std::get_if<Drop>(&parsed)) {
        refuse(*drop);
    } else if (Packet* packet = std::get_if<Packet>(&parsed)) {
        take_levels(*packet, arrival);
    } else if (const auto* passing = std::get_if<Passing>(&parsed)) {
        merge_.pass(*passing);
    } else if (const auto* sync = std::get_if<SyncPacket>(&parsed)) {
        merge_.feed(*sync, arrival.time);
    } else if (const auto* discovery = std::get_if<DiscoveryPacket>(&parsed)) {
        (sacn ? discovery_ : nodes_).feed(*discovery, arrival.time);
    } else if (const auto* time = std::get_if<TimeCode>(&parsed)) {
        const std::uint64_t packets = counted_.timecode ? counted_.timecode->packets : 0;
        counted_.timecode = {*time, arrival.from, arrival.from_port, packets + 1, arrival.time};
        if (time->stream != 0) {
            if (options_.on_timecode) options_.on_timecode(*time, arrival.time);
            return std::nullopt;
        }
        take_timecode(*counted_.timecode);
    } else if (const auto* trigger = std::get_if<Trigger>(&parsed)) {
        remember(counted_.triggers, TriggerStatus{0, *trigger, arrival.from, arrival.time});
    } else if (const auto* poll = std::get_if<PollPacket>(&parsed)) {
        return *poll;
    }
    return std::nullopt;
}

void Intake::take_elsewhere(Bytes bytes, const Arrival& arrival) {
    const bool sacn = arrival.protocol == Protocol::sacn;
    const Parsed parsed =
        sacn ? parse_sacn(bytes, arrival.from) : parse_artnet(bytes, arrival.from, options_.artnet_offset);
    const Packet* const packet = std::get_if<Packet>(&parsed);
    if (!packet || packet->terminated) return;
    const auto key = std::make_tuple(arrival.interface_index, packet->universe, packet->protocol);
    const auto place = elsewhere_.find(key);
    if (place == elsewhere_.end() && elsewhere_.size() >= kMaxUnlisted) {
        // What somebody waits for finds a place.
        const auto is_wanted = [&](std::uint16_t universe) {
            return std::binary_search(options_.universes.begin(), options_.universes.end(), universe);
        };
        if (!is_wanted(packet->universe)) return;
        const auto other = std::find_if(elsewhere_.begin(), elsewhere_.end(),
                                        [&](const auto& entry) { return !is_wanted(entry.second.universe); });
        if (other == elsewhere_.end()) return;
        elsewhere_.erase(other);
    }
    ElsewhereUniverse& entry = elsewhere_[key];
    const std::uint64_t packets = entry.packets + 1;
    entry = {arrival.interface_index,
             packet->universe,
             packet->protocol,
             packet->source_name,
             packet->from,
             packets,
             arrival.time};
}

void Intake::tick(std::chrono::nanoseconds now) {
    merge_.tick(now);
    discovery_.tick(now);
    nodes_.tick(now);
    std::erase_if(unlisted_,
                  [&](const auto& entry) { return now - entry.second.told.age > kUnlistedForgotten; });
    std::erase_if(elsewhere_, [&](const auto& entry) { return now - entry.second.age > kUnlistedForgotten; });
}

void Intake::report(Statistics& statistics, std::chrono::nanoseconds now) const {
    statistics.packets_sacn = counted_.packets_sacn;
    statistics.packets_artnet = counted_.packets_artnet;
    statistics.unlisted = counted_.unlisted;
    statistics.wrong_group = counted_.wrong_group;
    statistics.wrong_length = counted_.wrong_length;
    statistics.notices = counted_.notices;
    statistics.drops = counted_.drops;
    statistics.drops_sacn = counted_.drops_sacn;
    statistics.timecode = counted_.timecode;
    statistics.followed_timecodes = counted_.followed_timecodes;
    statistics.triggers = counted_.triggers;
    statistics.time = now;
    statistics.sampling = merge_.sampling();
    statistics.merge = merge_.counters();
    statistics.sources = merge_.sources(now);
    statistics.ignored = merge_.ignored(now);
    statistics.lost = merge_.lost(now);
    statistics.sync = merge_.sync().list(now);
    statistics.discovered = discovery_.list(now);
    const std::vector<DiscoveredSource> nodes = nodes_.list(now);
    statistics.discovered.insert(statistics.discovered.end(), nodes.begin(), nodes.end());
    statistics.unlisted_universes.clear();
    for (const auto& [key, entry] : unlisted_) {
        statistics.unlisted_universes.push_back(entry.told);
        statistics.unlisted_universes.back().age = now - entry.told.age;
    }
    statistics.elsewhere_universes.clear();
    for (const auto& [key, entry] : elsewhere_) {
        statistics.elsewhere_universes.push_back(entry);
        statistics.elsewhere_universes.back().age = now - entry.age;
    }
}

} // namespace ghost::dmx
