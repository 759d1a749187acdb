// SPDX-License-Identifier: Apache-2.0
#include "app/engine.h"

#include "app/input_options.h"
#include "app/interrupt.h"
#include "app/take_patch.h"

#include "base/log.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

namespace ghost::app {
namespace {

using namespace std::chrono_literals;

constexpr double kListenAgain_s = 3;
constexpr int kLeastPixels = 16; // across
constexpr int kMostPixels = 8192;
constexpr double kLongestStep_s = 0.5; // a slow frame must not make the recording jump

bool same_view(const scene::Camera& a, const scene::Camera& b) {
    return a.position_m == b.position_m && a.target_m == b.target_m && a.fov_y_deg == b.fov_y_deg &&
           a.width == b.width && a.height == b.height;
}

bool same_lit(const scene::Lit& a, const scene::Lit& b) {
    const auto same = [](const shared::Light& x, const shared::Light& y) {
        return std::memcmp(&x, &y, sizeof x) == 0;
    };
    return std::equal(a.lights.begin(), a.lights.end(), b.lights.begin(), b.lights.end(), same) &&
           std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(),
                      [&](const scene::Face& x, const scene::Face& y) { return same(x.light, y.light); });
}

} // namespace

Engine::Engine(ui::Link& link, EngineOptions options)
    : link_(link), options_(std::move(options)), thread_([this] { run(); }) {}

Engine::~Engine() {
    stop_ = true;
    thread_.join();
    if (reopening_.valid()) reopening_.wait();
}

void Engine::run() {
    try {
        begin_inputs();
        while (!stop_ && !interrupted()) {
            listen();
            if (std::optional<ui::Wishes> newest = link_.wishes.take()) {
                wishes_ = std::move(*newest);
                if (wishes_.show != tried_) open(wishes_.show);
            }
            if (session_ && wishes_.text && wishes_.text != text_) take_edit();
            look_for_plots();
            const double begin_s = now_s();
            if (session_ && wishes_.camera.width > 0) frame();
            const double wait_s = 1.0 / std::clamp(wishes_.quality.fps, 5, 240) - (now_s() - begin_s);
            std::this_thread::sleep_for(std::chrono::duration<double>(std::clamp(wait_s, 0.0005, 0.04)));
        }
    } catch (const std::exception& problem) { // no memory, as a rule
        link_.failed.put({std::string("the picture stopped: ") + problem.what(), wishes_.show});
        link_.on_news();
    }
}

void Engine::begin_inputs() {
    if (options_.xchange) {
        auto xchange = Xchange::start(*options_.xchange);
        if (xchange.ok())
            xchange_ = std::move(*xchange);
        else
            add_news(scene::Severity::error, xchange.error().where, xchange.error().what);
    }
    if (options_.controls.psn) {
        auto trackers = TrackerInput::open(options_.receiver.interface);
        if (trackers.ok())
            trackers_ = std::move(*trackers);
        else
            add_news(scene::Severity::error, trackers.error().where, trackers.error().what);
    }
    if (auto timecode = open_timecode(options_.timecode); timecode.ok() && *timecode) {
        timecode_ = std::move(*timecode);
        timecode_->listen(options_.receiver);
    }
}

// A port that is taken may be free again when whoever has it is closed.
void Engine::listen() {
    if (!options_.listens || receiver_ || now_s() < listens_again_s_) return;
    listens_again_s_ = now_s() + kListenAgain_s;
    std::vector<scene::Message> said;
    auto receiver = dmx::Receiver::start(options_.receiver);
    if (receiver.ok()) {
        receiver_ = std::move(*receiver);
        if (!of_receiver_.empty()) log_info("the port is free: listening");
        for (const std::string& warning : receiver_->warnings())
            said.push_back({scene::Severity::warning, "network", warning});
        if (input_) input_->set_receiver(receiver_.get());
        listen_to_patch();
    } else {
        dmx::Statistics none;
        none.listening.problem = receiver.error().text();
        link_.network.put(std::move(none));
        link_.on_news();
        said.push_back({scene::Severity::error, receiver.error().where, receiver.error().what});
        if (of_receiver_.empty()) log_warning(receiver.error().text());
    }
    const auto same = [](const scene::Message& a, const scene::Message& b) {
        return a.where == b.where && a.what == b.what;
    };
    if (std::equal(said.begin(), said.end(), of_receiver_.begin(), of_receiver_.end(), same)) return;
    of_receiver_ = std::move(said);
    if (session_) publish_messages();
}

void Engine::listen_to_patch() {
    if (receiver_ && session_)
        receiver_->listen_to(joined_universes(options_.receiver.universes, scene::PatchMap(*session_->show)));
}

void Engine::open(const std::string& path) {
    tried_ = path;
    text_ = wishes_.text;
    link_.activity.put("opening " + path);
    link_.on_news();
    auto opened = open_session(session_options(path));
    link_.activity.put("");
    if (!opened.ok()) {
        link_.failed.put(opened.error());
        link_.on_news();
        return;
    }
    adopt(std::move(*opened), Opening::another);
}

SessionOptions Engine::session_options(const std::string& path) const {
    SessionOptions options = options_.session;
    options.show = path;
    options.text = text_;
    options.live = true;
    options.maps_in_background = true;
    options.keep_hidden = true;
    options.bake = false;
    options.width = 320; // until the window says how large it is
    options.height = 180;
    return options;
}

void Engine::adopt(std::unique_ptr<Session> session, Opening opening) {
    tracer_.reset(); // they refer to the session before
    look_.reset();
    const std::unique_ptr<Session> session_before = std::exchange(session_, std::move(session));
    if (opening != Opening::another && session_before)
        session_->rig->go_on_from(*session_before->rig,
                                  same_fixtures(*session_before->show, *session_->show));
    followers_ = {};
    begin_controls();
    const std::unique_ptr<LiveInput> before = std::move(input_);
    look_ = std::make_unique<AppliedLook>(*session_);
    motion_ = session_->show->motion;
    input_ = std::make_unique<LiveInput>(receiver_.get(), timecode_.get());
    listen_to_patch();
    if (auto loaded = input_->load_recording(session_->show->recording, session_->report); !loaded.ok())
        session_->report.add(scene::Severity::warning, loaded.error().where, loaded.error().what);
    if (opening != Opening::another && before) input_->go_on_from(*before);
    drawn_from_ = {};
    drawn_ = {};
    pace_ = {};
    haze_ = {};
    last_step_s_ = now_s();
    messages_sent_ = 0;
    if (opening != Opening::edit) { // those of the show before are none of this one
        wishes_.look = {};
        wishes_.explained.reset();
    }
    if (opening == Opening::another) wishes_.camera.width = 0;
    publish_opened(opening);
}

void Engine::begin_controls() {
    if (options_.controls.osc.empty()) return;
    std::vector<std::string> cameras;
    for (const scene::Camera& camera : session_->show->cameras) cameras.push_back(camera.name);
    if (remote_) { // its faders stay where they are
        remote_->know(std::move(cameras), session_->show->cues);
        session_->live->set_haze(remote_wishes_.haze);
        return;
    }
    const auto port = parse_port(options_.controls.osc, "--osc");
    if (!port.ok()) return; // checked before
    auto remote = RemoteInput::open(*port, std::move(cameras), session_->show->cues);
    if (remote.ok())
        remote_ = std::move(*remote);
    else
        session_->report.add(scene::Severity::error, remote.error().where, remote.error().what);
}

bool Engine::apply_controls(double now_s) {
    wanted_camera_ = wishes_.camera;
    bool sees_else = false;
    if (remote_) {
        const RemoteWishes& wishes = remote_->poll(now_s);
        if (wishes.calls != remote_wishes_.calls) {
            link_.camera_call.put({session_->show->cameras[wishes.camera->index], wishes.camera->flight_s});
            link_.on_news();
        }
        if (wishes.jumps != remote_wishes_.jumps) input_->jump(wishes.at_s);
        sees_else = wishes.haze != remote_wishes_.haze;
        if (sees_else) session_->live->set_haze(wishes.haze);
        remote_wishes_ = wishes;
    }
    if (remote_wishes_.ev100) {
        wanted_camera_.ev100 = *remote_wishes_.ev100;
        wanted_camera_.auto_exposure = false;
    }
    if (!trackers_) return sees_else;
    const dmx::Trackers& trackers = trackers_->poll();
    followers_.apply(*session_, trackers);
    wanted_camera_ = follow(wanted_camera_, *session_->show, trackers);
    return sees_else;
}

scene::Camera Engine::camera_for(double now_s) const {
    scene::Camera camera = wanted_camera_;
    const bool moves = now_s - last_change_s_ < kRest_s || (is_uneven(*session_->show) && !wishes_.frozen);
    const double share = wishes_.quality.percent > 0 ? std::sqrt(wishes_.quality.percent / 100.0)
                         : moves                     ? pace_.share()
                                                     : 1.0;
    const auto pixels = [&](int wanted) {
        return std::clamp(static_cast<int>(std::lround(wanted * share)), kLeastPixels, kMostPixels);
    };
    camera.width = pixels(camera.width);
    camera.height = pixels(camera.height);
    return camera;
}

void Engine::frame() {
    const double begin_s = now_s();
    const double dt_s = wishes_.frozen ? 0.0 : std::clamp(begin_s - last_step_s_, 0.0, kLongestStep_s);
    last_step_s_ = begin_s;
    const bool thicker = apply_controls(begin_s);
    input_->step(wishes_.input, wishes_.transport, dt_s);
    // Motors, too, would wait for ever where time stands still.
    session_->show->motion = wishes_.frozen ? fixture::Motion::as_commanded : motion_;
    session_->rig->step(input_->universes(), dt_s, wishes_.look.fixtures);
    if (arrival_.count() == 0) arrival_ = input_->arrival();
    session_->master =
        wishes_.black_out ? 0.0f : std::clamp(wishes_.master, 0.0f, 1.0f) * remote_wishes_.light();
    const bool sees_else = look_->apply(wishes_.look, *session_) || thicker;
    session_->relighter->set_exposure(wanted_camera_.ev100, wanted_camera_.auto_exposure);
    if (const int segments = std::clamp(wishes_.quality.most_segments, 1, 256);
        segments != std::exchange(haze_.most_segments, segments)) {
        session_->relighter->set_quality(haze_);
        session_->relighter->forget(); // what rests was drawn with others
        last_change_s_ = begin_s;
    }

    scene::Camera unsized = wanted_camera_;
    unsized.width = drawn_from_.width;
    unsized.height = drawn_from_.height;
    scene::Lit lit = session_->lit();
    if (sees_else || !same_view(unsized, drawn_from_) || !same_lit(lit, drawn_)) last_change_s_ = begin_s;
    drawn_ = std::move(lit);
    const scene::Camera camera = camera_for(begin_s);
    const bool resized =
        camera.width != session_->relighter->width() || camera.height != session_->relighter->height();
    if (sees_else || !same_view(camera, drawn_from_)) {
        session_->look_from(camera);
        drawn_from_ = camera;
    }
    if (resized) session_->relighter->set_quality(haze_);
    air_s_ += dt_s;
    const render::FrameStatistics statistics = session_->draw(air_s_);
    const double draw_ms = 1e3 * (now_s() - begin_s);
    // Spans: of what the device did; a picture that is the same does nothing.
    if (!statistics.spans.empty()) {
        publish_picture(statistics, draw_ms);
        // A new size costs what no other frame does.
        if (last_change_s_ == begin_s && !resized) pace_.add(draw_ms, wishes_.quality.fps);
    } else {
        arrival_ = std::chrono::nanoseconds{0}; // they changed nothing that is seen
    }
    publish_rig(begin_s);
    publish_explanation(begin_s);
    if (session_->report.messages.size() != messages_sent_) publish_messages();
    if (std::optional<dmx::Statistics> network = input_->take_statistics()) {
        link_.network.put(std::move(*network));
        link_.on_news();
    }
    publish_rest(begin_s, !statistics.spans.empty());
}

} // namespace ghost::app
