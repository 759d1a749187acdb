// SPDX-License-Identifier: Apache-2.0
// How stations find each other: mDNS over IPv4 on every interface.
#include "xchange/private/xchange_loop.h"

#include <algorithm>
#include <cctype>

namespace ghost::app {

namespace {

constexpr std::size_t kMostKnown = 256;
constexpr std::size_t kMostSpokenOf = 1000;
constexpr double kInterfacesEvery_s = 5;
constexpr double kForgotten_s = 150; // a station lives 120 s, and is asked for every 30
constexpr double kAnswerEvery_s = 1; // RFC 6762, 6
constexpr double kQuestionEvery_s = 30;
constexpr double kMoved_s = 1;
constexpr double kFirstQuestions_s[] = {1, 3};
constexpr int kMostBatches = 8; // of 64 packets

bool same_text(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace

// The loopback interface only where it was asked for, or nothing else is up: others cannot reach it.
void Xchange::Loop::check_interfaces() {
    next_interfaces_s_ = now_s() + kInterfacesEvery_s;
    std::vector<dmx::NetInterface> now;
    if (!options_.interface.empty()) {
        if (auto one = dmx::find_interface(options_.interface); one.ok()) now.push_back(std::move(*one));
    } else {
        now = dmx::list_interfaces();
        const auto loopback = [](const dmx::NetInterface& interface) { return interface.loopback; };
        if (!std::all_of(now.begin(), now.end(), loopback)) std::erase_if(now, loopback);
    }
    std::erase_if(now, [](const dmx::NetInterface& interface) { return interface.address == 0; });
    if (now == interfaces_) return;
    for (const dmx::NetInterface& interface : now)
        if (const auto joined = mdns_->join(dmx::kMdnsGroup, interface); !joined.ok())
            tell(XchangeEvent::Kind::trouble, "", joined.error().text());
    interfaces_ = std::move(now);
    questions_ = 0;
    next_question_s_ = now_s();
}

scene::XchangeStation Xchange::Loop::us_at(const dmx::NetInterface& interface) const {
    return {options_.station, uuid_, options_.group, interface.address, listener_->port(), false};
}

void Xchange::Loop::send_by(const dmx::NetInterface& interface, const dmx::DnsPacket& packet) {
    // An interface without a network says so; the next one may have one.
    if (mdns_->send_multicast_through(interface).ok())
        (void)mdns_->send(dmx::build_dns(packet), dmx::kMdnsGroup, options_.mdns_port);
}

void Xchange::Loop::ask_and_announce(bool leaving) {
    for (const dmx::NetInterface& interface : interfaces_) {
        scene::XchangeStation us = us_at(interface);
        us.gone = leaving;
        send_by(interface, scene::xchange_announcement(us));
        if (!leaving) send_by(interface, scene::xchange_question(options_.group));
    }
    const auto index = static_cast<std::size_t>(questions_++);
    next_question_s_ =
        now_s() + (index < std::size(kFirstQuestions_s) ? kFirstQuestions_s[index] : kQuestionEvery_s);
    std::erase_if(known_, [&](const auto& entry) {
        const bool gone = !entry.second.fixed && now_s() - entry.second.seen_s > kForgotten_s;
        if (gone)
            tell(XchangeEvent::Kind::left, entry.second.station.name, "was not heard of for some minutes");
        return gone;
    });
}

void Xchange::Loop::hear() {
    for (int batch = 0; batch < kMostBatches; ++batch) {
        const auto datagrams = mdns_->receive();
        if (datagrams.empty()) return;
        for (const dmx::Datagram& datagram : datagrams) {
            const auto packet = dmx::parse_dns(datagram.bytes);
            if (!packet || !is_neighbour(datagram)) continue;
            for (const scene::XchangeStation& station : scene::xchange_stations(*packet, datagram.from))
                meet(station, datagram);
            if (now_s() - answered_s_ < kAnswerEvery_s) continue;
            const auto interface =
                std::find_if(interfaces_.begin(), interfaces_.end(), [&](const dmx::NetInterface& one) {
                    return one.index == datagram.interface_index;
                });
            if (interface == interfaces_.end()) continue;
            const auto answer = scene::xchange_answer(*packet, us_at(*interface));
            if (!answer) continue;
            send_by(*interface, *answer);
            answered_s_ = now_s();
        }
    }
}

bool Xchange::Loop::is_neighbour(const dmx::Datagram& datagram) const {
    return std::any_of(interfaces_.begin(), interfaces_.end(), [&](const dmx::NetInterface& one) {
        return one.index == datagram.interface_index && dmx::is_on_link(one, datagram.from);
    });
}

void Xchange::Loop::meet(const scene::XchangeStation& station, const dmx::Datagram& datagram) {
    const auto once = [&](const std::string& what) {
        return spoken_of_.size() < kMostSpokenOf && spoken_of_.insert(what).second;
    };
    if (station.uuid == uuid_) {
        if (station.port != listener_->port() && !station.gone && once("our name"))
            tell(XchangeEvent::Kind::trouble, station.name,
                 "another station has our name on this machine; give one of them another (--station)");
        return;
    }
    const std::string key = station.uuid.empty()
                                ? dmx::address_text(station.address) + ":" + std::to_string(station.port)
                                : station.uuid;
    const auto place = known_.find(key);
    if (station.gone) {
        // Anyone can say it in the name of another, so it counts from where the station was found only.
        if (place == known_.end() || place->second.fixed || place->second.station.address != datagram.from)
            return;
        tell(XchangeEvent::Kind::left, place->second.station.name, "left the network");
        known_.erase(place);
        return;
    }
    if (!same_text(station.group, options_.group)) {
        if (once("other group " + key))
            tell(XchangeEvent::Kind::found, station.name,
                 "is in group '" + station.group + "'; we are in '" + options_.group + "'");
        return;
    }
    if (place != known_.end()) {
        Known& known = place->second;
        if (known.fixed) return; // its address is what the user wrote
        known.seen_s = now_s();
        // Started again, or the address that we took is one that we cannot reach. One with two network cards
        // is heard by two addresses, and stays at the first that works.
        const bool moved = known.station.address != station.address;
        if (known.station.port != station.port || (moved && known.tries > 0)) {
            known.station = station;
            known.joined = false;
            known.next_join_s = now_s() + kMoved_s;
        }
        return;
    }
    if (known_.size() >= kMostKnown) {
        if (once("full"))
            tell(XchangeEvent::Kind::trouble, "",
                 "more than " + std::to_string(kMostKnown) + " stations: others are left out");
        return;
    }
    Known known;
    known.station = station;
    known.interface_index = datagram.interface_index;
    known.seen_s = known.next_join_s = now_s();
    known_[key] = known;
    tell(XchangeEvent::Kind::found, station.name,
         "at " + dmx::address_text(station.address) + ":" + std::to_string(station.port));
}

} // namespace ghost::app
