// SPDX-License-Identifier: Apache-2.0
// What the window measures: false colours instead of the picture, and the probe under the mouse.
#include "live/engine/engine.h"

#include "live/session/light_meter.h"
#include "live/session/picture_writer.h"

#include <algorithm>
#include <cmath>

namespace ghost::app {
namespace {

constexpr double kProbeEvery_s = 0.05;

} // namespace

std::shared_ptr<const image::Image8> Engine::false_colours() {
    const ui::FalseColour& wanted = request_.false_colour;
    image::ImageF values;
    if (wanted.measure == ui::Measure::luminance) {
        values = luminance_of(relighter().frame());
    } else {
        if (!meter_) meter_ = std::make_unique<LightMeter>(*session_);
        values = meter_->lux_picture(drawn_);
    }
    return std::make_shared<const image::Image8>(image::false_coloured(values, wanted.scale));
}

const bake::Tracer& Engine::tracer() {
    if (!tracer_ || traced_changes_ != session_->live->shown_changes()) {
        tracer_.reset();
        traced_changes_ = session_->live->shown_changes();
        const bool is_as_opened = traced_changes_ == 0;
        traced_stage_ = is_as_opened ? scene::Stage{} : session_->live->solid_now();
        tracer_ = std::make_unique<bake::Tracer>(is_as_opened ? session_->live->solid() : traced_stage_);
    }
    return *tracer_;
}

void Engine::publish_probe(double now_s, bool drew) {
    if (drew) frame_ = {};
    if (!request_.probe) {
        probed_place_.reset();
        return;
    }
    if ((!drew && request_.probe == probed_place_) || now_s - probed_s_ < kProbeEvery_s) return;
    probed_place_ = request_.probe;
    probed_s_ = now_s;
    if (frame_.empty()) frame_ = luminance_of(relighter().frame());
    const glm::vec2 place = glm::clamp(*request_.probe, 0.0f, 1.0f);
    const auto pixel = [](float share, int count) {
        return std::clamp(static_cast<int>(std::floor(share * static_cast<float>(count))), 0, count - 1);
    };
    ui::Probed probed;
    probed.place = *request_.probe;
    probed.cd_m2 = *frame_.at(pixel(place.x, frame_.width), pixel(place.y, frame_.height));
    const bake::DenormalsOff mode;
    const bake::Surface surface = surface_at(drawn_from_, place, tracer());
    if (surface.instance >= 0) {
        probed.hit = true;
        probed.lux = lux_at(surface, drawn_, *session_, tracer());
        probed.at_m = surface.position;
        probed.distance_m = surface.distance_m;
        probed.object = tracer().stage().instances[static_cast<std::size_t>(surface.instance)].name;
    }
    link_.probed.put(std::move(probed));
    link_.on_news();
}

void Engine::publish_picked() {
    const ui::Pick& pick = request_.pick;
    if (pick.number == picked_) return;
    picked_ = pick.number;
    ui::Picked picked;
    picked.number = pick.number;
    const bake::DenormalsOff mode;
    const bake::Surface surface = surface_on(pick.from_m, pick.way, tracer());
    if (surface.instance >= 0) {
        const scene::Instance& instance =
            tracer().stage().instances[static_cast<std::size_t>(surface.instance)];
        picked.hit = true;
        picked.at_m = surface.position;
        picked.object = instance.name;
        if (instance.fixture >= 0) picked.fixture = static_cast<std::size_t>(instance.fixture);
    }
    link_.picked.put(std::move(picked));
    link_.on_news();
}

void Engine::save_frame() {
    if (request_.save_frame.number == saved_frame_) return;
    saved_frame_ = request_.save_frame.number;
    const Result<void> written = write_picture(request_.save_frame.file, relighter().frame(),
                                               relighter().ev100_used(), relighter().tone());
    link_.saved.put({saved_frame_, written.ok() ? std::nullopt : std::optional(written.error())});
    link_.on_news();
}

} // namespace ghost::app
