// SPDX-License-Identifier: Apache-2.0
#include "live/engine/live_controls.h"

#include <utility>
#include <vector>

namespace ghost::app {
namespace {

std::vector<std::string> camera_names(const scene::Show& show) {
    std::vector<std::string> names;
    for (const scene::Camera& camera : show.cameras) names.push_back(camera.name);
    return names;
}

} // namespace

Result<void> check_live_controls(const LiveControlOptions& options) {
    if (!options.osc.empty()) TRY_VOID(parse_port(options.osc, "--osc"));
    return {};
}

Result<void> LiveControls::open_remote(const std::string& osc, const scene::Show& show) {
    TRY(const PortOption port, parse_port(osc, "--osc"));
    TRY(remote_input_, RemoteInput::open(port));
    remote_.know(camera_names(show), show.cues);
    return {};
}

Result<void> LiveControls::command(const ui::Command& command) {
    std::vector<dmx::OscArgument> arguments;
    for (const auto& argument : command.arguments)
        std::visit([&](const auto& value) { arguments.emplace_back(value); }, argument);
    was_commanded_ = true;
    return remote_.apply(command.what, arguments, command.what);
}

Result<void> LiveControls::open_trackers(const std::string& interface) {
    TRY(trackers_, TrackerInput::open(interface));
    return {};
}

void LiveControls::begin(Session& session, Of of) {
    followers_ = {};
    if (of == Of::another_show) {
        remote_.begin(camera_names(*session.show), session.show->cues);
        request_ = remote_.request(); // what was asked for of the show before is no news of this one
    }
    know(session);
}

void LiveControls::know(Session& session) {
    remote_.know(camera_names(*session.show), session.show->cues);
    if (!is_heard()) return;
    session.haze_density = request_.haze;
}

RemoteNews LiveControls::hear_remote(Session& session, double now_s) {
    if (remote_input_) remote_input_->poll(remote_, now_s);
    return is_heard() ? take(remote_.request(), session) : RemoteNews{};
}

const dmx::Trackers* LiveControls::hear_trackers(Session& session) {
    if (!trackers_) return nullptr;
    const dmx::Trackers& heard = trackers_->poll(*session.show);
    take(heard, session);
    return &heard;
}

RemoteNews LiveControls::take(const RemoteRequest& request, Session& session) {
    const RemoteRequest before = std::exchange(request_, request);
    if (session.live) session.haze_density = request.haze; // baked passes know one haze
    return {.camera = request.calls != before.calls,
            .jump = request.jumps != before.jumps,
            .haze = request.haze != before.haze,
            .look = request.recalls != before.recalls,
            .cue = request.cues != before.cues};
}

} // namespace ghost::app
