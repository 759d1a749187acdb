// SPDX-License-Identifier: Apache-2.0
// One frame of the engine: from request and levels to the picture that is published.
#include "live/engine/engine.h"

#include "gpu/pipelines.h"
#include "show/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kLongestStep_s = 0.5; // a slow frame must not make the recording jump
constexpr double kLongestFilm_s = 1e9; // of time code, which loops where the film does
constexpr float kFlashAtEv0_cd_m2 = 1; // of a body that identifies itself: white, whatever the exposure

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

// What differs by rounding alone, as at the end of a flight, stands where it was shown: to draw a stage from
// elsewhere takes a second.
scene::Camera steadied(scene::Camera camera, const scene::Camera& shown) {
    constexpr float kSame_m = 1e-4f, kSame_deg = 1e-3f;
    if (glm::distance(camera.position_m, shown.position_m) > kSame_m ||
        glm::distance(camera.target_m, shown.target_m) > kSame_m ||
        std::abs(camera.fov_y_deg - shown.fov_y_deg) > kSame_deg)
        return camera;
    camera.position_m = shown.position_m;
    camera.target_m = shown.target_m;
    camera.fov_y_deg = shown.fov_y_deg;
    return camera;
}

} // namespace

bool Engine::hear_remote(double now_s) {
    if (const auto cue = link_.cue.take()) controls_.be_in(*cue);
    for (const ui::Command& command : link_.commands.take()) {
        const Result<void> done = controls_.command(command);
        (void)link_.command_answers.put({command.number, done.ok() ? "" : done.error().what});
        link_.on_news();
    }
    const RemoteNews news = controls_.hear_remote(*session_, now_s);
    const RemoteRequest& asked = controls_.remote();
    if (news.camera) {
        link_.camera_call.put({session_->show->cameras[asked.camera->index], asked.camera->flight_s});
        link_.on_news();
    }
    if (news.look) {
        link_.look_call.put({asked.look.name, asked.look.seconds});
        link_.on_news();
    }
    if (news.cue) {
        link_.cue_call.put(asked.cue);
        link_.cue.put(asked.cue);
        link_.on_news();
    }
    if (news.jump) input_->jump(asked.at_s);
    return news.haze;
}

scene::Camera Engine::wanted_camera() {
    scene::Camera camera = request_.camera;
    if (const std::optional<float> ev100 = controls_.remote().ev100) {
        camera.ev100 = *ev100;
        camera.auto_exposure = false;
    }
    camera.mover = scene::kNoMover; // one that a hand has moved rides on nothing
    for (const scene::Camera& own : session_->show->cameras)
        if (own.position_m == camera.position_m && own.target_m == camera.target_m) camera.mover = own.mover;
    return camera;
}

bool Engine::is_moving(double now_s) const {
    return now_s - last_change_s_ < LivePicture::kRest_s ||
           (session_->atmosphere().is_uneven() && !request_.frozen);
}

// What is measured is the light of the show.
bool Engine::has_work_light() const {
    if (request_.false_colour.measure != ui::Measure::none) return false;
    if (request_.work_light != ui::WorkLight::automatic) return request_.work_light == ui::WorkLight::on;
    return !has_input();
}

bool Engine::has_input() const {
    return input_->recording_s() > 0 || !input_->desk().list.empty();
}

// Work light is there to see a stage that nobody lights. What heads do by their files alone, as tubes do that
// are bright until a desk is heard, would outshine it.
bool Engine::leaves_unasked_dark() const {
    return has_work_light() && !has_input() && request_.look.solo.empty();
}

render::FrameStatistics Engine::draw_live(const scene::Camera& asked, double begin_s) {
    const scene::Camera wanted = steadied(asked, shown_.camera);
    const LivePicture::Drawn drawn = live_.draw(*session_,
                                                {.camera = wanted,
                                                 .quality = request_.quality,
                                                 .has_work_light = has_work_light(),
                                                 .measure = request_.false_colour.measure,
                                                 .moves = is_moving(begin_s),
                                                 .air_s = air_s_},
                                                shown_.camera, begin_s, stop_of(begin_s));
    if (drawn.changed) last_change_s_ = begin_s;
    if (drawn.from) {
        shown_.camera = *drawn.from;
        shown_.framed = {request_.frame, scene::share_of_frame(wanted, request_.frame)};
    }
    return drawn.statistics;
}

// Why the picture has to be drawn live whatever is baked; empty: it need not be.
std::string Engine::needs_live() const {
    const ui::Look& look = request_.look;
    if (!request_.takes_baked) return "baked pictures are turned off";
    if (session_->bounce_detail() != scene::BounceDetail::off) return "light bounces";
    if (has_work_light()) return "the work light is on";
    if (request_.quality.percent > 0) return "a share of the pixels is asked for";
    if (request_.false_colour.measure == ui::Measure::lux) return "lux are measured on surfaces";
    if (!look.shown.empty()) return "objects are hidden or shown by hand";
    if (!look.surfaces.empty()) return "surfaces are set by hand";
    if (!(look.scene == ui::SceneLook{})) return "air, even light or shadows are set by hand";
    if (controls_.remote().haze != 1.0f) return "a remote control sets the haze";
    if (session_->rig->movers().has_moved()) return "a mover is not where the model has it";
    if (rdm_.identifies()) return "a fixture identifies itself";
    if (controls_.has_trackers()) return "trackers may move what is on stage";
    return "";
}

render::FrameStatistics Engine::draw_baked(const scene::Camera& wanted, double begin_s) {
    const bool moves = is_moving(begin_s);
    return baked_.view().draw(wanted, air_s_, live_.haze(moves),
                              moves ? std::function<bool()>{} : stop_of(begin_s));
}

// Ends a picture of what rests as soon as something else is to be shown.
std::function<bool()> Engine::stop_of(double begin_s) {
    return [this, begin_s, plays = request_.transport.playing && !request_.frozen] {
        return link_.wake.is_raised() || stop_ || (plays && input_->plays_else_in(now_s() - begin_s));
    };
}

// Pictures from elsewhere, in what time the one of the request leaves.
void Engine::draw_beside(double begin_s) {
    const bool rests = settled_ == request_.number && !is_moving(begin_s);
    // Swirls never rest; lamps do.
    const bool lamps_rest = rests || (session_->atmosphere().is_uneven() && live_.is_whole(shown_.camera) &&
                                      begin_s - last_change_s_ >= LivePicture::kRest_s);
    const bool is_whole = shown_.is_baked || live_.is_whole(shown_.camera);
    // A show that plays would end each of them; who looks on from elsewhere waits for no rest.
    const std::function<bool()> stop = lamps_rest ? stop_of(begin_s) : [this] { return stop_.load(); };
    side_views_.draw(*session_, shown_.lights, {begin_s, last_change_s_, air_s_, lamps_rest, is_whole},
                     probe_, stop);
    const bool for_browsers = link_.wants_small_pictures;
    if ((rests && request_.wants_camera_pictures) || for_browsers)
        camera_pictures_.draw(*session_, shown_.lights, {begin_s, last_change_s_, air_s_, !lamps_rest}, stop);
    if (for_browsers && lamps_rest) look_pictures_.draw(*session_, begin_s, stop_of(begin_s));
}

void Engine::frame() {
    const double begin_s = now_s();
    const double dt_s = request_.frozen ? 0.0 : std::clamp(begin_s - last_step_s_, 0.0, kLongestStep_s);
    last_step_s_ = begin_s;
    const bool thicker = hear_remote(begin_s);
    const dmx::Trackers* const trackers = controls_.hear_trackers(*session_);
    input_->step(request_.input, request_.transport, dt_s);
    // Motors, too, would wait for ever where time stands still.
    session_->show->motion =
        request_.frozen ? fixture::Motion::as_commanded : request_.motion.value_or(motion_);
    // Films and keys of movers run with the recording, where it is shown, else with the network's time code,
    // once it is heard.
    if (input_->recording_s() > 0 && !input_->shows_desk())
        session_->media_s = input_->at_s();
    else if (!request_.frozen)
        session_->media_s = desk_.timecode() ? desk_.timecode()->at_s(kLongestFilm_s) : std::nullopt;
    const ui::Look& look = look_of_drawn();
    session_->rig->movers().drive(look.movers);
    session_->rig->set_time(session_->media_s);
    session_->rig->leave_unasked_dark(leaves_unasked_dark());
    session_->rig->step(input_->universes(), dt_s, look.fixtures);
    scene::Camera wanted = scene::riding(wanted_camera(), *session_->rig);
    if (trackers) wanted = follow(wanted, *session_->show, *trackers); // trackers do not ride
    wanted = scene::with_frame(wanted, request_.frame);
    if (arrival_.count() == 0) arrival_ = input_->arrival();
    session_->master =
        request_.black_out ? 0.0f : std::clamp(request_.master, 0.0f, 1.0f) * controls_.remote().light();
    session_->stop_bounce(request_.stops_bounce);
    const bool sees_else = look_->apply(look, *session_) || thicker;
    if (sees_else) live_.look_anew();
    session_->relighter->set_exposure(wanted.ev100, wanted.auto_exposure);
    session_->options.tone =
        controls_.remote().tone.value_or(request_.tone); // of pictures that are made anew
    session_->relighter->set_tone(session_->options.tone);
    const int samples = std::clamp(look.haze_samples.value_or(ui::kHazeSamples), 1, 256);
    if (live_.set_haze_samples(samples, *session_)) last_change_s_ = begin_s;

    if (session_->media_s)
        sound_.follow(*session_->media_s,
                      start_.time_since_epoch() + std::chrono::round<std::chrono::nanoseconds>(
                                                      std::chrono::duration<double>(begin_s)));
    for (const std::string& sentence : sound_.take_messages())
        messages_.add(Severity::warning, session_->show->sound.where, sentence);
    session_->show_media(air_s_ + dt_s);
    rdm_.step(request_, (!request_.text || request_.text == text_) && !opening_.is_running(), *session_->show,
              session_->rig->states(), begin_s);
    if (const auto shining = rdm_.flash(begin_s)) {
        session_->live->light_bodies(*shining, kFlashAtEv0_cd_m2 * std::exp2(relighter().ev100_used()));
        last_change_s_ = begin_s;
    }
    const bool baked =
        baked_.choose(*session_, {wanted, request_.camera.fov_y_deg, text_, needs_live()}, begin_s);
    const bool switched = baked != std::exchange(shown_.is_baked, baked);
    if (switched) probe_.forget_frame();
    scene::FrameLights lit = session_->lit();
    std::vector<glm::mat4> moved;
    for (std::size_t k = 0; k < session_->show->movers.size(); ++k)
        moved.push_back(session_->rig->movers().moved(k));
    const bool moves = moved != shown_.moved;
    shown_.moved = std::move(moved);
    if (switched || sees_else || moves || !same_lit(lit, shown_.lights)) last_change_s_ = begin_s;
    shown_.lights = std::move(lit);
    air_s_ += dt_s;
    if (switched && baked) baked_.view().relighter().forget(); // it may rest
    relighter().set_reads_back(!leaves_on_device(begin_s));
    const render::FrameStatistics statistics =
        baked ? draw_baked(wanted, begin_s) : draw_live(wanted, begin_s);
    if (baked) {
        shown_.camera = baked_.view().camera();
        shown_.framed = {};
    }
    const double draw_ms = 1e3 * (now_s() - begin_s);
    // Spans: of what the device did; a picture that is the same does nothing.
    const bool drew = !statistics.spans.empty() && !statistics.stopped;
    // The map of a lamp that is dark changes no picture, and is one less to come all the same.
    const bool has_more_maps = !statistics.stopped && session_->live->missing_maps() != missing_maps_sent_;
    const bool is_other_measure = request_.false_colour != false_colour_;
    const bool rests_unread = is_image_older_ && !is_moving(begin_s);
    present((drew || is_other_measure) && request_.false_colour.measure == ui::Measure::none, draw_ms);
    if (drew || is_other_measure || baked_.words() != supply_sent_ || has_more_maps || rests_unread)
        publish_picture(statistics, draw_ms);
    if (drew) {
        // Beside luminances and lux the picture itself takes no time.
        const bool is_measured = request_.false_colour.measure != ui::Measure::none;
        const double all_ms = is_measured ? 1e3 * (now_s() - begin_s) : draw_ms;
        if (!baked && last_change_s_ == begin_s) live_.learn(statistics, all_ms, request_.quality.fps);
    } else if (!statistics.stopped) {
        arrival_ = std::chrono::nanoseconds{0}; // they changed nothing that is seen
    }
    if (drew) {
        bounce_ms_ = statistics.bounce_ms();
        session_->device->make_late_pipelines(); // a gobo that is first used must not be late
    }
    bounce_news_.publish(*session_, bounce_ms_, begin_s);
    rig_news_.publish(*session_, *input_, controls_.remote(), shown_.lights, recorder_.seconds(), begin_s);
    rig_news_.explain(
        {fixture_of_drawn(request_.explained), fixture_of_drawn(request_.hovered), request_.explains_all},
        *session_, *input_, patch_, [&]() -> const bake::Tracer& { return probe_.tracer(*session_); },
        begin_s);
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
    if (!statistics.stopped) tell_unseen(begin_s);
    draw_beside(begin_s);
}

} // namespace ghost::app
