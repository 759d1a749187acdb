#pragma once
// SPDX-License-Identifier: Apache-2.0
// FilmControls: what a remote control and trackers (live/engine/live_controls.h) do to a film of what happens
// now: light, exposure and tone, and a camera that flies where it is called, or turns to whom it follows. One
// session; its thread. Errors: of opening.

#include "live/engine/live_controls.h"
#include "live/session/session.h"
#include "show/camera.h"

#include <optional>
#include <string>

namespace ghost::app {

class FilmControls {
public:
    // interface: where trackers are heard, as ReceiverOptions has it. ev100: the exposure that the command
    // line wants of every camera.
    static Result<FilmControls> open(const LiveControlOptions& options, const scene::Show& show,
                                     const std::string& interface, std::optional<float> ev100);

    // Before the rig's step.
    void before_frame(Session& session, double now_s);
    // After it: a camera goes along with its mover, and turns to whom it follows.
    void aim(Session& session) const { turn(session, trackers_); }
    // The same with what was heard, for tests.
    void apply(Session& session, const RemoteRequest& request, double now_s);
    void apply(Session& session, const dmx::Trackers& trackers);

private:
    void take(Session& session, const RemoteNews& news, double now_s);
    void fly(Session& session, bool is_called, double now_s);
    void turn(Session& session, const dmx::Trackers* trackers) const;

    struct Flight {
        scene::Camera from, to;
        double start_s = 0;
        double length_s = 0;
    };
    LiveControls controls_;
    const dmx::Trackers* trackers_ = nullptr; // of controls_; null: they are not listened to
    std::optional<float> ev100_;
    std::optional<Flight> flight_;
    std::optional<scene::Camera> exposed_; // whose exposure holds and who rides; none: that of the start
    bool said_passes_ = false;
};

} // namespace ghost::app
