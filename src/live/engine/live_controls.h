#pragma once
// SPDX-License-Identifier: Apache-2.0
// LiveControls: what moves a live picture besides DMX: a remote control (OSC) and trackers (PosiStageNet).
// Applied to a session before each frame, by the thread that draws.

#include "live/engine/followers.h"
#include "live/inputs/remote_input.h"
#include "live/inputs/tracker_input.h"
#include "live/session/session.h"

#include <memory>
#include <optional>
#include <string>

namespace ghost::app {

struct LiveControlOptions {
    std::string osc;  // "9000", "0.0.0.0:9000"; empty: none
    bool psn = false; // what the show's [[tracker]] entries follow
};

Result<void> check_live_controls(const LiveControlOptions& options);

class LiveControls {
public:
    // interface: where trackers are heard, as ReceiverOptions has it. ev100: the exposure that the command
    // line wants of every camera.
    static Result<LiveControls> open(const LiveControlOptions& options, const scene::Show& show,
                                     const std::string& interface, std::optional<float> ev100);

    // Before the rig's step.
    void before_frame(Session& session, double now_s);
    // The same with what was heard, for tests.
    void apply(Session& session, const RemoteRequest& request, double now_s);
    void apply(Session& session, const dmx::Trackers& trackers);

private:
    void fly(Session& session, const RemoteRequest& request, double now_s);

    struct Flight {
        scene::Camera from, to;
        double start_s = 0;
        double length_s = 0;
    };
    std::unique_ptr<RemoteInput> remote_;    // or null
    std::unique_ptr<TrackerInput> trackers_; // or null
    Followers followers_;
    std::optional<float> ev100_;
    std::optional<Flight> flight_;
    std::optional<scene::Camera> exposed_; // whose exposure holds; none: that of the start
    std::size_t calls_ = 0;
    float haze_ = 1;
    bool said_passes_ = false;
};

} // namespace ghost::app
