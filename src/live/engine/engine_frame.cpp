// SPDX-License-Identifier: Apache-2.0
// One frame of the engine: from request and levels to the picture that is published.
#include "live/engine/engine.h"
#include "live/session/picture_room.h"
#include "show/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace ghost::app {
namespace {

constexpr int kLeastPixels = 16; // across
constexpr int kMostPixels = 8192;
constexpr double kLongestStep_s = 0.5; // a slow frame must not make the recording jump
constexpr float kWork_lux = 100;
constexpr float kWorkAtEv0_lux = 5;    // stages are dark: makes what reflects a twelfth middle grey
constexpr double kLongestFilm_s = 1e9; // of time code, which loops where the film does

bool same_view(const scene::Camera& a, const scene::Camera& b) {
    return a.position_m == b.position_m && a.target_m == b.target_m && a.fov_y_deg == b.fov_y_deg &&
           a.width == b.width && a.height == b.height;
}

bool same_lit(const scene::FrameLights& a, const scene::FrameLights& b) {
    const auto same = [](const shared::Light& x, const shared::Light& y) {
        return std::memcmp(&x, &y, sizeof x) == 0;
    };
    return std::equal(a.lights.begin(), a.lights.end(), b.lights.begin(), b.lights.end(), same) &&
           std::equal(
               a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(),
               [&](const scene::LensFace& x, const scene::LensFace& y) { return same(x.light, y.light); }) &&
           std::equal(a.walls.begin(), a.walls.end(), b.walls.begin(), b.walls.end(),
                      [](const shared::LedWall& x, const shared::LedWall& y) {
                          return std::memcmp(&x, &y, sizeof x) == 0;
                      });
}

} // namespace

bool Engine::apply_controls(double now_s) {
    wanted_camera_ = request_.camera;
    bool sees_else = false;
    if (remote_) {
        const RemoteRequest& request = remote_->poll(now_s);
        if (request.calls != remote_request_.calls) {
            link_.camera_call.put({session_->show->cameras[request.camera->index], request.camera->flight_s});
            link_.on_news();
        }
        if (request.jumps != remote_request_.jumps) input_->jump(request.at_s);
        sees_else = request.haze != remote_request_.haze;
        session_->haze_density = request.haze;
        remote_request_ = request;
    }
    if (remote_request_.ev100) {
        wanted_camera_.ev100 = *remote_request_.ev100;
        wanted_camera_.auto_exposure = false;
    }
    if (trackers_) {
        const dmx::Trackers& trackers = trackers_->poll();
        followers_.apply(*session_, trackers);
        wanted_camera_ = follow(wanted_camera_, *session_->show, trackers);
    }
    wanted_camera_ = scene::with_frame(wanted_camera_, request_.frame);
    return sees_else;
}

void Engine::fit_into_memory() {
    const glm::ivec2 wanted(wanted_camera_.width, wanted_camera_.height);
    if (wanted == whole_for_) return;
    whole_for_ = wanted;
    session_->drop_parked();
    // What there is now goes before the next one is made.
    const std::uint64_t room = session_->device->memory_left_bytes() + session_->relighter->picture_bytes();
    scene::Camera most = wanted_camera_;
    most.width = std::min(most.width, kMostPixels);
    most.height = std::min(most.height, kMostPixels);
    const scene::Camera whole = fitted(most, room);
    whole_ = {whole.width, whole.height};
    if (whole.width == most.width) return;
    const auto text = [](const scene::Camera& camera) {
        return std::to_string(camera.width) + "x" + std::to_string(camera.height);
    };
    const std::uint64_t needed = kPictureBytesPerPixel * static_cast<std::uint64_t>(most.width) *
                                 static_cast<std::uint64_t>(most.height);
    messages_.add(Severity::warning, session_->device->name(),
                  "memory is short for a picture of " + text(most) + " (" + std::to_string(needed >> 20) +
                      " MB, there are " + std::to_string(room >> 20) + "): it is drawn with " + text(whole));
}

bool Engine::is_moving(double now_s) const {
    return now_s - last_change_s_ < kRest_s || (session_->atmosphere().is_uneven() && !request_.frozen);
}

scene::Camera Engine::camera_for(double now_s) {
    fit_into_memory();
    scene::Camera camera = wanted_camera_;
    const double share = request_.quality.percent > 0 ? std::sqrt(request_.quality.percent / 100.0)
                         : is_moving(now_s)           ? pace_.level().sides
                                                      : 1.0;
    const auto pixels = [&](int wanted) {
        return std::clamp(static_cast<int>(std::lround(wanted * share)), kLeastPixels, kMostPixels);
    };
    camera.height = pixels(whole_.y);
    // Of the same height in the window as the whole one, and never narrower.
    camera.width = share == 1.0 ? whole_.x
                                : std::clamp((camera.height * whole_.x + whole_.y - 1) / whole_.y,
                                             kLeastPixels, kMostPixels);
    return camera;
}

// What is measured is the light of the show.
bool Engine::has_work_light() const {
    if (request_.false_colour.measure != ui::Measure::none) return false;
    if (request_.work_light != ui::WorkLight::automatic) return request_.work_light == ui::WorkLight::on;
    return input_->recording_s() == 0 && input_->desk().list.empty();
}

// As bright as the exposure asks for: it must neither be lost in the dark nor drown everything.
float Engine::wanted_work_lux() const {
    if (!has_work_light()) return 0;
    return wanted_camera_.auto_exposure ? kWork_lux : kWorkAtEv0_lux * std::exp2(wanted_camera_.ev100);
}

render::FrameStatistics Engine::draw_live(double begin_s, double air_s) {
    if (const float lux = wanted_work_lux(); lux != std::exchange(work_lux_, lux)) {
        session_->live->set_work_light(lux);
        sees_else_ = true;
        last_change_s_ = begin_s;
    }
    scene::Camera unsized = wanted_camera_;
    unsized.width = drawn_from_.width;
    unsized.height = drawn_from_.height;
    if (!same_view(unsized, drawn_from_)) last_change_s_ = flew_s_ = begin_s;
    // What was left out goes into the picture when the camera has come to rest.
    const bool flies = begin_s - flew_s_ < kRest_s;
    sees_else_ = sees_else_ || flies != std::exchange(flies_, flies);
    const scene::Camera camera = camera_for(begin_s);
    const bool moves = is_moving(begin_s);
    if (!moves && !session_->prepare(camera, stop_of(begin_s))) {
        render::FrameStatistics nothing;
        nothing.stopped = true;
        return nothing;
    }
    const bool uses_coarse = moves && request_.quality.percent == 0 && pace_.level().coarse_light &&
                             request_.false_colour.measure == ui::Measure::none;
    const bool is_other_size =
        camera.width != session_->relighter->width() || camera.height != session_->relighter->height();
    was_resized_ = is_other_size || uses_coarse != session_->relighter->is_coarse();
    if (std::exchange(sees_else_, false) || !same_view(camera, live_from_)) {
        if (is_other_size) probe_.forget_meter();
        session_->look_from(camera, flies, uses_coarse);
        session_->relighter->set_exposure(wanted_camera_.ev100, wanted_camera_.auto_exposure);
        live_from_ = camera;
    }
    drawn_from_ = camera;
    framed_ = {request_.frame, scene::share_of_frame(wanted_camera_, request_.frame)};
    haze_.grid = moves;
    session_->use_coarse_light(uses_coarse);
    session_->relighter->set_quality(haze_);
    session_->relighter->set_exposure(wanted_camera_.ev100, wanted_camera_.auto_exposure);
    session_->relighter->set_tone(session_->options.tone);
    session_->relighter->set_most_lights(moves ? lights_in(1000.0 / request_.quality.fps) : 0);
    return session_->draw(air_s, moves ? std::function<bool()>{} : stop_of(begin_s));
}

// Why the picture has to be drawn live whatever is baked; empty: it need not be.
std::string Engine::needs_live() const {
    const ui::Look& look = request_.look;
    if (!request_.takes_baked) return "baked pictures are turned off";
    if (has_work_light()) return "the work light is on";
    if (request_.quality.percent > 0) return "a share of the pixels is asked for";
    if (request_.false_colour.measure == ui::Measure::lux) return "lux are measured on surfaces";
    if (!look.shown.empty()) return "objects are hidden or shown by hand";
    if (!look.surfaces.empty()) return "surfaces are set by hand";
    if (!(look.scene == ui::SceneLook{})) return "air, even light or shadows are set by hand";
    if (remote_request_.haze != 1.0f) return "a remote control sets the haze";
    if (trackers_) return "trackers may move what is on stage";
    return "";
}

render::FrameStatistics Engine::draw_baked(double begin_s, double air_s) {
    haze_.grid = is_moving(begin_s);
    return baked_.view().draw(wanted_camera_, air_s, haze_,
                              haze_.grid ? std::function<bool()>{} : stop_of(begin_s));
}

// Ends a picture of what rests as soon as something else is to be shown.
std::function<bool()> Engine::stop_of(double begin_s) {
    return [this, begin_s, plays = request_.transport.playing && !request_.frozen] {
        return link_.wake.is_raised() || stop_ || (plays && input_->plays_else_in(now_s() - begin_s));
    };
}

// How many lights that turn there is time for; 0: all of them.
int Engine::lights_in(double frame_ms) const {
    constexpr int kLeast = 8;
    return light_ms_ > 0 ? std::max(static_cast<int>(frame_ms / light_ms_), kLeast) : 0;
}

void Engine::learn_light_ms(const render::FrameStatistics& statistics, double draw_ms) {
    constexpr int kMany = 16; // below, the time is that of the picture and not of its lights
    constexpr double kOfNew = 0.3;
    if (statistics.drawn < kMany) return;
    const double ms = draw_ms / statistics.drawn;
    light_ms_ = light_ms_ == 0 ? ms : light_ms_ + kOfNew * (ms - light_ms_);
}

void Engine::frame() {
    const double begin_s = now_s();
    const double dt_s = request_.frozen ? 0.0 : std::clamp(begin_s - last_step_s_, 0.0, kLongestStep_s);
    last_step_s_ = begin_s;
    const bool thicker = apply_controls(begin_s);
    input_->step(request_.input, request_.transport, dt_s);
    // Motors, too, would wait for ever where time stands still.
    session_->show->motion = request_.frozen ? fixture::Motion::as_commanded : motion_;
    session_->rig->step(input_->universes(), dt_s, request_.look.fixtures);
    if (arrival_.count() == 0) arrival_ = input_->arrival();
    session_->master =
        request_.black_out ? 0.0f : std::clamp(request_.master, 0.0f, 1.0f) * remote_request_.light();
    const bool sees_else = look_->apply(request_.look, *session_) || thicker;
    sees_else_ = sees_else_ || sees_else;
    session_->relighter->set_exposure(wanted_camera_.ev100, wanted_camera_.auto_exposure);
    session_->options.tone = remote_request_.tone.value_or(request_.tone); // of pictures that are made anew
    session_->relighter->set_tone(session_->options.tone);
    if (const int segments = std::clamp(request_.look.haze_samples.value_or(ui::kHazeSamples), 1, 256);
        segments != std::exchange(haze_.most_segments, segments)) {
        session_->relighter->set_quality(haze_);
        session_->relighter->draw_anew();
        last_change_s_ = begin_s;
    }

    // Films run with the recording, where it is shown, else with the network's time code, once it is heard.
    if (input_->recording_s() > 0 && !input_->shows_desk())
        session_->media_s = input_->at_s();
    else if (!request_.frozen)
        session_->media_s = timecode_ ? timecode_->at_s(kLongestFilm_s) : std::nullopt;
    if (session_->media_s)
        sound_.follow(*session_->media_s,
                      start_.time_since_epoch() + std::chrono::round<std::chrono::nanoseconds>(
                                                      std::chrono::duration<double>(begin_s)));
    for (const std::string& sentence : sound_.take_messages())
        messages_.add(Severity::warning, session_->show->sound.where, sentence);
    session_->show_media(air_s_ + dt_s);
    const bool baked =
        baked_.choose(*session_, {wanted_camera_, request_.camera.fov_y_deg, text_, needs_live()}, begin_s);
    const bool switched = baked != std::exchange(shows_baked_, baked);
    if (switched) probe_.forget_frame();
    scene::FrameLights lit = session_->lit();
    if (switched || sees_else || !same_lit(lit, drawn_)) last_change_s_ = begin_s;
    drawn_ = std::move(lit);
    air_s_ += dt_s;
    was_resized_ = false;
    if (switched && baked) baked_.view().relighter().forget(); // it may rest
    const render::FrameStatistics statistics =
        baked ? draw_baked(begin_s, air_s_) : draw_live(begin_s, air_s_);
    if (baked) {
        drawn_from_ = baked_.view().camera();
        framed_ = {};
    }
    const double draw_ms = 1e3 * (now_s() - begin_s);
    // Spans: of what the device did; a picture that is the same does nothing.
    const bool drew = !statistics.spans.empty() && !statistics.stopped;
    if (drew || request_.false_colour != false_colour_ || baked_.words() != supply_sent_)
        publish_picture(statistics, draw_ms);
    if (drew) {
        // A new size costs what no other frame does.
        const bool counts = !was_resized_ && last_change_s_ == begin_s;
        if (counts && !baked) {
            pace_.add(draw_ms, request_.quality.fps);
            learn_light_ms(statistics, draw_ms);
        }
    } else if (!statistics.stopped) {
        arrival_ = std::chrono::nanoseconds{0}; // they changed nothing that is seen
    }
    rig_news_.publish(*session_, *input_, drawn_, recorder_.seconds(), begin_s);
    rig_news_.explain(
        {request_.explained, request_.explains_all}, *session_, *input_, patch_,
        [&]() -> const bake::Tracer& { return probe_.tracer(*session_); }, begin_s);
    probe_.pick(request_.pick, *session_);
    if (!statistics.stopped) {
        probe_.probe(request_.probe, shown(), begin_s, drew);
        probe_.save(request_.save_frame, shown());
    }
    messages_.show(session_->report);
    if (std::optional<dmx::Statistics> network = input_->take_statistics()) {
        link_.network.put(std::move(*network));
        link_.on_news();
    }
    if (std::optional<std::vector<float>> activity = input_->take_activity()) {
        link_.activity_of_recording.put(std::move(*activity));
        link_.on_news();
    }
    publish_rest(begin_s, drew);
}

} // namespace ghost::app
