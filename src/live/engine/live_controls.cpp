// SPDX-License-Identifier: Apache-2.0
#include "live/engine/live_controls.h"

#include "show/camera_moves.h"

#include "base/log.h"

#include <algorithm>

namespace ghost::app {

Result<void> check_live_controls(const LiveControlOptions& options) {
    if (!options.osc.empty()) TRY_VOID(parse_port(options.osc, "--osc"));
    return {};
}

Result<LiveControls> LiveControls::open(const LiveControlOptions& options, const scene::Show& show,
                                        const std::string& interface, std::optional<float> ev100) {
    LiveControls controls;
    controls.ev100_ = ev100;
    if (options.psn) {
        if (show.tracking.uses.empty())
            return Error{"has no [[tracker]], expected one that says what follows",
                         show.file.string() + " --psn"};
        TRY(controls.trackers_, TrackerInput::open(interface));
    }
    if (options.osc.empty()) return controls;
    TRY(const PortOption port, parse_port(options.osc, "--osc"));
    std::vector<std::string> cameras;
    for (const scene::Camera& camera : show.cameras) cameras.push_back(camera.name);
    TRY(controls.remote_, RemoteInput::open(port, std::move(cameras), show.cues));
    log_info("listening to a remote control (OSC) at " + dmx::ipv4_text(port.ipv4) + ":" +
             std::to_string(port.port));
    return controls;
}

// A camera that was asked for, at once or on its way.
void LiveControls::fly(Session& session, const RemoteRequest& request, double now_s) {
    if (request.calls != calls_) {
        calls_ = request.calls;
        const scene::Camera& from = session.live->camera();
        scene::Camera to = session.show->cameras[request.camera->index];
        to.width = from.width; // the picture's size stays
        to.height = from.height;
        flight_ = Flight{from, to, now_s, static_cast<double>(request.camera->flight_s)};
    }
    if (!flight_) return;
    const double share = flight_->length_s > 0 ? (now_s - flight_->start_s) / flight_->length_s : 1.0;
    scene::Camera camera = flight_->to;
    if (share < 1) {
        camera = camera_between(flight_->from, flight_->to, static_cast<float>(share));
        camera.auto_exposure = flight_->to.auto_exposure;
    } else {
        flight_.reset();
    }
    exposed_ = camera;
    session.look_from(camera);
}

void LiveControls::before_frame(Session& session, double now_s) {
    if (remote_) apply(session, remote_->poll(now_s), now_s);
    if (trackers_) apply(session, trackers_->poll());
}

void LiveControls::apply(Session& session, const dmx::Trackers& trackers) {
    followers_.apply(session, trackers);
    if (!session.live || flight_) return;
    const scene::Camera camera = follow(session.live->camera(), *session.show, trackers);
    if (camera.target_m != session.live->camera().target_m) session.look_from(camera);
}

void LiveControls::apply(Session& session, const RemoteRequest& request, double now_s) {
    session.master = request.light();
    const bool moves = request.calls != calls_ || request.haze != haze_ || flight_;
    if (moves && session.live) {
        const bool denser = request.haze != haze_;
        session.haze_density = haze_ = request.haze;
        if (denser && !flight_ && request.calls == calls_) session.look_from(session.live->camera());
        fly(session, request, now_s);
    } else if (moves && !said_passes_) {
        log_warning("remote control: baked passes know one camera and one haze; --live draws any");
        said_passes_ = true;
    }
    const scene::Camera& camera = exposed_ ? *exposed_ : session.show->cameras[session.camera];
    const std::optional<float> fixed = request.ev100 ? request.ev100 : ev100_;
    session.relighter->set_exposure(fixed.value_or(camera.ev100), camera.auto_exposure && !fixed);
    session.relighter->set_tone(request.tone.value_or(session.options.tone));
}

} // namespace ghost::app
