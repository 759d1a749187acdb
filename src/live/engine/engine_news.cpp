// SPDX-License-Identifier: Apache-2.0
// What the engine says to the window: each piece of news whole, as often as it changes or as a person can
// read it.
#include "live/engine/engine.h"

#include "beam_groups/light_places.h"
#include "live/lux/unseen_stage.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace ghost::app {
namespace {

// Of those that shine.
std::size_t without_shadow(const std::vector<shared::Light>& lights) {
    return static_cast<std::size_t>(
        std::count_if(lights.begin(), lights.end(), [](const shared::Light& light) {
            return light.map == 0 && light.intensity_cd != glm::vec3(0);
        }));
}

} // namespace

void Engine::publish_opened(Opening::Kind kind) {
    ui::Opened news = opened_from(*session_);
    news.recording_s = input_->recording_s();
    news.opens = opens_;
    news.again = kind == Opening::Kind::newer_plot;
    news.is_edit = kind == Opening::Kind::edit;
    news.text = text_;
    link_.opened.put(std::move(news));
    messages_.show_anew(session_->report);
}

void Engine::publish_rest(double now_s, bool drew) {
    const bool has_text = !request_.text || request_.text == text_;
    const bool rests = !drew && has_text && !opening_.is_running() &&
                       now_s - last_change_s_ >= LivePicture::kRest_s && !session_->live->is_making_maps() &&
                       session_->is_bounce_settled() && !baked_.is_reading();
    if (!rests || settled_ == request_.number) return;
    settled_ = request_.number;
    link_.settled.put(settled_);
    link_.on_news();
}

void Engine::tell_unseen(double now_s) {
    const auto is_same = [](const scene::Camera& a, const scene::Camera& b) {
        return a.position_m == b.position_m && a.target_m == b.target_m && a.fov_y_deg == b.fov_y_deg;
    };
    const bool is_as_before =
        unseen_.is_known && is_same(unseen_.camera, shown_.camera) && unseen_.is_black == shown_.is_black;
    const bool rests = !is_moving(now_s);
    if (is_as_before || (!rests && !unseen_.is_known)) return;
    const bool is_asked_dark = session_->master == 0 || request_.false_colour.measure != ui::Measure::none;
    const bool may_be_unseen =
        rests && !is_asked_dark && !shown_.is_baked && (shown_.is_black || live_.has_work_light());
    const bake::Tracer* const tracer = may_be_unseen ? probe_.tracer_if_made(*session_) : nullptr;
    if (may_be_unseen && !tracer) return; // a later frame finds it
    ui::UnseenStage news;
    unseen_.is_known = rests;
    unseen_.camera = shown_.camera;
    unseen_.is_black = shown_.is_black;
    if (tracer) {
        std::vector<glm::vec3> heads_m;
        for (std::size_t i = 0; i < session_->show->fixtures.size(); ++i)
            heads_m.push_back(session_->rig->moved(i) *
                              glm::vec4(scene::light_position_m(session_->show->fixtures[i], 0), 1.0f));
        const bake::DenormalsOff mode;
        if (auto body =
                unseen_stage(shown_.camera, heads_m, *tracer, shown_.is_black, live_.has_work_light()))
            news = {true, std::move(*body)};
    }
    if (news == unseen_.news) return;
    unseen_.news = news;
    link_.unseen_stage.put(std::move(news));
    link_.on_news();
}

bool Engine::leaves_on_device(double now_s) const {
    return presentation_.is_by_device() && is_moving(now_s) && image_ && !link_.picture.is_for_second();
}

std::shared_ptr<const image::Image8> Engine::window_image() {
    is_image_older_ = leaves_on_device(now_s());
    if (is_image_older_) return image_;
    const double begin_s = now_s();
    const std::shared_ptr<image::Image8> image = pictures_.take(relighter().width(), relighter().height(), 4);
    relighter().copy_picture(*image);
    presentation_.note_read_ms(1e3 * (now_s() - begin_s));
    return image_ = image;
}

void Engine::present(bool is_new, double draw_ms) {
    constexpr double kQuick_ms = 150;
    presentation_.offer(image_ && (draw_ms < kQuick_ms || settled_ == request_.number));
    presentation_.listen();
    const bool again = presentation_.wants_again() && settled_ == request_.number;
    if (is_new || again) presentation_.take(relighter(), shown_.framed);
    presentation_.show();
}

void Engine::publish_picture(const render::FrameStatistics& statistics, double draw_ms) {
    ui::Picture picture;
    if (request_.false_colour.measure == ui::Measure::none) {
        picture.image = window_image();
    } else {
        picture.image = image_ = probe_.false_colours(request_.false_colour, shown(), !is_moving(now_s()));
        is_image_older_ = false;
        presentation_.take(*picture.image, shown_.framed);
        presentation_.show();
    }
    if (!is_image_older_) shown_.is_black = picture.image && is_black(*picture.image);
    picture.false_colour = false_colour_ = request_.false_colour;
    picture.camera = shown_.camera;
    picture.framed = shown_.framed;
    picture.ev100 = relighter().ev100_used();
    picture.draw_ms = draw_ms;
    picture.lights_drawn = statistics.drawn;
    picture.device_bytes = session_->device->memory().used_bytes();
    picture.is_baked = shown_.is_baked;
    picture.supply = supply_sent_ = baked_.words();
    picture.is_coarse = !shown_.is_baked && request_.quality.percent == 0 && !live_.is_whole(shown_.camera);
    picture.missing_maps = missing_maps_sent_ = session_->live->missing_maps();
    if (picture.missing_maps > 0 && session_->shadows)
        picture.missing_shadows = without_shadow(shown_.lights.lights);
    picture.left_dark = session_->rig->left_dark();
    picture.has_work_light = !shown_.is_baked && live_.has_work_light();
    picture.arrival = std::exchange(arrival_, std::chrono::nanoseconds{0});
    link_.picture.put(std::move(picture), [](const ui::Picture& unread, ui::Picture& next) {
        if (unread.arrival.count() > 0) next.arrival = unread.arrival;
    });
    link_.on_news();
}

} // namespace ghost::app
