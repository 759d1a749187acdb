// SPDX-License-Identifier: Apache-2.0
#include "rdm/node.h"

#include <algorithm>
#include <utility>

namespace ghost::rdm {

namespace {

constexpr int kPortAddressBits = 15;

} // namespace

void Node::update(std::vector<Device> devices) {
    if (devices.size() > kMaxDevices) devices.resize(kMaxDevices);
    const std::map<int, std::set<Uid>> before = by_universe_;
    for (auto& [universe, uids] : by_universe_) uids.clear();
    for (const Device& device : devices)
        if (device.universe > 0) by_universe_[device.universe].insert(device.uid);
    std::set<Uid> there;
    for (const Device& device : devices) there.insert(device.uid);
    const auto is_gone = [&](const auto& one) { return !there.contains(one.first); };
    std::erase_if(responders_, is_gone);
    std::erase_if(heard_, is_gone);
    for (Device& device : devices) {
        const auto known = responders_.find(device.uid);
        if (known != responders_.end())
            known->second.update(std::move(device));
        else
            responders_.emplace(device.uid, Responder(std::move(device)));
    }
    note_changes(before);
}

void Node::note_changes(const std::map<int, std::set<Uid>>& before) {
    for (const auto& [universe, uids] : by_universe_) {
        const int port_address = universe - artnet_offset_;
        const auto was = before.find(universe);
        if (port_address < 0 || port_address >> kPortAddressBits != 0) continue;
        if (was == before.end() || was->second != uids)
            askers_.changed(static_cast<std::uint16_t>(port_address));
    }
}

const Device* Node::find(const Uid& uid) const {
    const auto found = responders_.find(uid);
    return found == responders_.end() ? nullptr : &found->second.device();
}

void Node::feel(const Uid& uid, std::span<const std::int16_t> values) {
    if (const auto found = responders_.find(uid); found != responders_.end()) found->second.feel(values);
}

Node::Heard Node::heard(const Uid& uid) const {
    const auto found = heard_.find(uid);
    return found == heard_.end() ? Heard{} : found->second;
}

void Node::put_table(std::uint16_t port_address, const Port& port, Packets& out) {
    const auto found = by_universe_.find(universe_of(port_address));
    std::vector<Uid> all;
    if (found != by_universe_.end()) all.assign(found->second.begin(), found->second.end());
    std::size_t first = 0;
    do { // of nobody there is a packet, too: a controller forgets by it whom it knew
        TodData data;
        data.port_address = port_address;
        data.port = port;
        data.total = static_cast<std::uint16_t>(all.size());
        data.block = static_cast<std::uint8_t>(first / kMaxUidsPerPacket);
        const std::size_t count = std::min(kMaxUidsPerPacket, all.size() - first);
        data.uids.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                         all.begin() + static_cast<std::ptrdiff_t>(first + count));
        out.push_back(build_tod_data(data));
        first += count;
    } while (first < all.size());
    for (const Uid& uid : all) heard_[uid].is_found = true;
}

void Node::answer_table(std::uint16_t port_address, const Sender& from, const PortOf& port_of, Packets& out) {
    const std::optional<Port> port = port_of(port_address);
    if (!port && !by_universe_.contains(universe_of(port_address))) return;
    askers_.asked(from.ipv4, port_address, from.now);
    put_table(port_address, port.value_or(Port{}), out);
}

void Node::answer(const ArtRdm& rdm, const Sender& from, const Responder::Wants& wants, Packets& out) {
    const Message* const message = std::get_if<Message>(&rdm.message);
    if (!message) {
        ++faults_;
        return;
    }
    const auto there = by_universe_.find(universe_of(rdm.port_address));
    if (there == by_universe_.end() || message->is_response) return;
    ++messages_;
    for (const Uid& uid : there->second) {
        if (!message->to.means(uid)) continue;
        ++heard_[uid].messages;
        const Responder::Reply reply = responders_.at(uid).take(*message, wants, from.now);
        if (reply.message) out.push_back(build_art_rdm(rdm.port_address, *reply.message));
    }
}

Node::Packets Node::take(Bytes packet, const Sender& from, const Responder::Wants& wants,
                         const PortOf& port_of) {
    Packets out;
    const ArtPacket parsed = parse_artnet(packet);
    if (!std::holds_alternative<std::monostate>(parsed)) askers_.heard(from.ipv4, from.now);
    if (const auto* request = std::get_if<TodRequest>(&parsed)) {
        for (const std::uint16_t address : request->port_addresses) answer_table(address, from, port_of, out);
    } else if (const auto* control = std::get_if<TodControl>(&parsed)) {
        answer_table(control->port_address, from, port_of, out);
    } else if (const auto* rdm = std::get_if<ArtRdm>(&parsed)) {
        answer(*rdm, from, wants, out);
    }
    return out;
}

std::optional<Node::News> Node::news(std::chrono::nanoseconds now, const PortOf& port_of) {
    const std::optional<Askers::Due> due = askers_.next(now);
    if (!due) return std::nullopt;
    News news;
    news.to_ipv4 = due->ipv4;
    put_table(due->port_address, port_of(due->port_address).value_or(Port{}), news.packets);
    return news;
}

} // namespace ghost::rdm
