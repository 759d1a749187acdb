#pragma once
// SPDX-License-Identifier: Apache-2.0
// TrackerInput: PosiStageNet by multicast, read by the thread that draws, between two frames. Never sends.
// Bounded: what comes faster than it is read is dropped by the kernel.

#include "base/result.h"
#include "net/socket.h"
#include "psn_osc/psn.h"

#include <cstdint>
#include <memory>
#include <string>

namespace ghost::scene {
struct Show; // show/show.h
} // namespace ghost::scene

namespace ghost::app {

class TrackerInput {
public:
    // interface: name or address of one of ours; empty: all of them.
    static Result<std::unique_ptr<TrackerInput>> open(const std::string& interface,
                                                      std::uint16_t port = dmx::kPsnPort);

    // Trackers that the show names have their places, however many others there are.
    const dmx::Trackers& poll(const scene::Show& show);

private:
    explicit TrackerInput(std::unique_ptr<dmx::UdpSocket> socket) : socket_(std::move(socket)) {}

    std::unique_ptr<dmx::UdpSocket> socket_;
    dmx::Trackers trackers_;
    bool said_foreign_ = false;
};

} // namespace ghost::app
