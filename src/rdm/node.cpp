// SPDX-License-Identifier: Apache-2.0
#include "rdm/node.h"

#include <algorithm>
#include <utility>

namespace ghost::rdm {

bool Node::update(std::vector<Device> devices) {
    if (devices.size() > kMaxDevices) devices.resize(kMaxDevices);
    std::map<int, std::set<Uid>> by_universe;
    for (const Device& device : devices)
        if (device.universe > 0) by_universe[device.universe].insert(device.uid);
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
    return std::exchange(by_universe_, by_universe) != by_universe;
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

void Node::answer_table(std::uint16_t port_address, const Port& port, Packets& out) {
    const auto found = by_universe_.find(universe_of(port_address));
    if (found == by_universe_.end()) return;
    const std::vector<Uid> all(found->second.begin(), found->second.end());
    for (std::size_t first = 0, block = 0; first < all.size(); first += kMaxUidsPerPacket, ++block) {
        TodData data;
        data.port_address = port_address;
        data.port = port;
        data.total = static_cast<std::uint16_t>(all.size());
        data.block = static_cast<std::uint8_t>(block);
        const std::size_t count = std::min(kMaxUidsPerPacket, all.size() - first);
        data.uids.assign(all.begin() + static_cast<std::ptrdiff_t>(first),
                         all.begin() + static_cast<std::ptrdiff_t>(first + count));
        out.push_back(build_tod_data(data));
    }
    for (const Uid& uid : all) heard_[uid].is_found = true;
}

Node::Packets Node::take(Bytes packet, const Responder::Wants& wants, const PortOf& port_of) {
    Packets out;
    const ArtPacket parsed = parse_artnet(packet);
    if (const auto* request = std::get_if<TodRequest>(&parsed)) {
        for (const std::uint16_t address : request->port_addresses)
            answer_table(address, port_of(address), out);
    } else if (const auto* control = std::get_if<TodControl>(&parsed)) {
        answer_table(control->port_address, port_of(control->port_address), out);
    } else if (const auto* rdm = std::get_if<ArtRdm>(&parsed)) {
        const Message* const message = std::get_if<Message>(&rdm->message);
        if (!message) {
            ++faults_;
            return out;
        }
        const auto there = by_universe_.find(universe_of(rdm->port_address));
        if (there == by_universe_.end() || message->is_response) return out;
        ++messages_;
        for (const Uid& uid : there->second) {
            if (!message->to.means(uid)) continue;
            ++heard_[uid].messages;
            const Responder::Reply reply = responders_.at(uid).take(*message, wants);
            if (reply.message) out.push_back(build_art_rdm(rdm->port_address, *reply.message));
        }
    }
    return out;
}

} // namespace ghost::rdm
