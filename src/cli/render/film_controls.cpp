// SPDX-License-Identifier: Apache-2.0
#include "cli/render/private/film_controls.h"

#include "show/camera_moves.h"

#include "base/log.h"

#include <algorithm>

namespace ghost::app {

Result<FilmControls> FilmControls::open(const LiveControlOptions& options, const scene::Show& show,
                                        const std::string& interface, std::optional<float> ev100) {
    FilmControls film;
    film.ev100_ = ev100;
    if (options.psn) {
        const bool tracks_mover = std::any_of(show.movers.begin(), show.movers.end(),
                                              [](const scene::Mover& mover) { return mover.has_tracker(); });
        if (show.tracking.uses.empty() && !tracks_mover)
            return Error{"has no [[tracker]] and no [[mover]] with one, expected what follows",
                         show.file.string() + " --psn"};
        TRY_VOID(film.controls_.open_trackers(interface));
    }
    if (options.osc.empty()) return film;
    TRY_VOID(film.controls_.open_remote(options.osc, show));
    TRY(const PortOption port, parse_port(options.osc, "--osc"));
    log_info("listening to a remote control (OSC) at " + dmx::ipv4_text(port.ipv4) + ":" +
             std::to_string(port.port));
    return film;
}

void FilmControls::before_frame(Session& session, double now_s) {
    if (controls_.has_remote()) take(session, controls_.hear_remote(session, now_s), now_s);
    trackers_ = controls_.hear_trackers(session);
}

void FilmControls::apply(Session& session, const RemoteRequest& request, double now_s) {
    take(session, controls_.take(request, session), now_s);
}

void FilmControls::apply(Session& session, const dmx::Trackers& trackers) {
    controls_.take(trackers, session);
    turn(session, &trackers);
}

void FilmControls::take(Session& session, const RemoteNews& news, double now_s) {
    const RemoteRequest& remote = controls_.remote();
    session.master = remote.light();
    if (news.look) log_warning("remote control: a film has the look of --look alone");
    const bool moves = news.camera || news.haze || flight_;
    if (moves && session.live) {
        if (news.haze && !flight_ && !news.camera) session.look_from(session.live->camera());
        fly(session, news.camera, now_s);
    } else if (moves && !said_passes_) {
        log_warning("remote control: baked passes know one camera and one haze; --live draws any");
        said_passes_ = true;
    }
    const scene::Camera& camera = exposed_ ? *exposed_ : session.show->cameras[session.camera];
    const std::optional<float> fixed = remote.ev100 ? remote.ev100 : ev100_;
    session.relighter->set_exposure(fixed.value_or(camera.ev100), camera.auto_exposure && !fixed);
    session.relighter->set_tone(remote.tone.value_or(session.options.tone));
}

// A camera that was asked for, at once or on its way.
void FilmControls::fly(Session& session, bool is_called, double now_s) {
    if (is_called) {
        const RemoteCamera& call = *controls_.remote().camera;
        const scene::Camera& from = session.live->camera();
        scene::Camera to = session.show->cameras[call.index];
        to.width = from.width; // the picture's size stays
        to.height = from.height;
        flight_ = Flight{from, to, now_s, static_cast<double>(call.flight_s)};
    }
    if (!flight_) return;
    const double share = flight_->length_s > 0 ? (now_s - flight_->start_s) / flight_->length_s : 1.0;
    const scene::Camera to = scene::riding(flight_->to, *session.rig);
    scene::Camera camera = to;
    if (share < 1) {
        camera = camera_between(flight_->from, to, static_cast<float>(share));
        camera.auto_exposure = to.auto_exposure;
        exposed_ = camera;
    } else {
        exposed_ = flight_->to;
        flight_.reset();
    }
    session.look_from(camera);
}

void FilmControls::turn(Session& session, const dmx::Trackers* trackers) const {
    if (!session.live || flight_) return;
    const scene::Camera& shown = session.live->camera();
    scene::Camera camera = shown;
    const scene::Camera& home = exposed_ ? *exposed_ : session.show->cameras[session.camera];
    if (home.mover != scene::kNoMover) {
        const scene::Camera rides = scene::riding(home, *session.rig);
        camera.position_m = rides.position_m;
        camera.target_m = rides.target_m;
    }
    if (trackers) camera = follow(camera, *session.show, *trackers);
    if (camera.position_m != shown.position_m || camera.target_m != shown.target_m) session.look_from(camera);
}

} // namespace ghost::app
