// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/tracker_input.h"

#include "base/log.h"
#include "show/show.h"

#include <chrono>
#include <set>
#include <string>
#include <utility>

namespace ghost::app {

namespace {

constexpr int kReceiveBufferBytes = 256 << 10;
constexpr int kMostBatchesPerPoll = 4; // of 64 packets; a system sends 60 to 120 a second

void expect_named(dmx::Trackers& trackers, const scene::Show& show) {
    std::set<std::uint16_t> ids;
    std::set<std::string> names;
    const auto add = [&](int id, const std::string& name) {
        if (id >= 0)
            ids.insert(static_cast<std::uint16_t>(id));
        else if (!name.empty())
            names.insert(name);
    };
    for (const scene::TrackerUse& use : show.tracking.uses) add(use.id, use.name);
    for (const scene::Mover& mover : show.movers) add(mover.tracker_id, mover.tracker);
    trackers.expect(std::move(ids), std::move(names));
}

} // namespace

Result<std::unique_ptr<TrackerInput>> TrackerInput::open(const std::string& interface, std::uint16_t port) {
    std::vector<dmx::NetInterface> interfaces;
    if (interface.empty()) {
        interfaces = dmx::list_interfaces();
    } else {
        TRY(dmx::NetInterface found, dmx::find_interface(interface));
        interfaces.push_back(std::move(found));
    }
    TRY(auto socket, dmx::UdpSocket::open(0, port, kReceiveBufferBytes));
    int joined = 0;
    for (const dmx::NetInterface& one : interfaces) {
        if (one.address == 0) continue; // IPv6 only
        const Result<void> done = socket->join(dmx::kPsnGroup, one);
        if (done.ok())
            ++joined;
        else
            log_warning("trackers: " + done.error().text());
    }
    if (joined == 0) return Error{"no interface takes the group " + dmx::ipv4_text(dmx::kPsnGroup), "--psn"};
    return std::unique_ptr<TrackerInput>(new TrackerInput(std::move(socket)));
}

const dmx::Trackers& TrackerInput::poll(const scene::Show& show) {
    expect_named(trackers_, show);
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    for (int batch = 0; batch < kMostBatchesPerPoll; ++batch) {
        const auto datagrams = socket_->receive();
        if (datagrams.empty()) break;
        for (const dmx::Datagram& datagram : datagrams) {
            if (const auto packet = dmx::parse_psn(datagram.bytes)) {
                trackers_.feed(*packet, now);
            } else if (!said_foreign_) {
                log_warning("trackers: a packet of " + dmx::address_text(datagram.from) +
                            " is no PosiStageNet");
                said_foreign_ = true;
            }
        }
    }
    return trackers_;
}

} // namespace ghost::app
