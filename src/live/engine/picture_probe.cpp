// SPDX-License-Identifier: Apache-2.0
#include "live/engine/picture_probe.h"

#include "live/session/picture_writer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ghost::app {
namespace {

constexpr double kProbeEvery_s = 0.05;

// (0, 0) is the top left corner.
float at_place(const image::ImageF& picture, const glm::vec2& place) {
    const glm::vec2 within = glm::clamp(place, 0.0f, 1.0f);
    const auto pixel = [](float share, int count) {
        return std::clamp(static_cast<int>(std::floor(share * static_cast<float>(count))), 0, count - 1);
    };
    return *picture.at(pixel(within.x, picture.width), pixel(within.y, picture.height));
}

} // namespace

void PictureProbe::forget() {
    coming_tracer_ = {};
    tracer_.reset();
    frame_ = {};
}

std::shared_ptr<const image::Image8> PictureProbe::false_colours(const ui::FalseColour& wanted,
                                                                 const ShownPicture& shown, bool rests) {
    image::ImageF values;
    if (wanted.measure == ui::Measure::luminance) {
        values = luminance_of(shown.relighter.frame());
    } else {
        values = lux_picture(shown.session, shown.lights, rests);
    }
    return std::make_shared<const image::Image8>(image::false_coloured(values, wanted.scale));
}

void PictureProbe::begin_tracer(const Session& session) {
    const bool has_one = tracer_ || coming_tracer_.valid();
    if (has_one && traced_changes_ == session.live->shown_changes()) return;
    coming_tracer_ = {};
    tracer_.reset();
    traced_changes_ = session.live->shown_changes();
    const bool is_as_opened = traced_changes_ == 0;
    traced_stage_ = is_as_opened ? scene::Stage{} : session.live->solid_now();
    const scene::Stage& stage = is_as_opened ? session.live->solid() : traced_stage_;
    coming_tracer_ =
        std::async(std::launch::async, [&stage] { return std::make_unique<bake::Tracer>(stage); });
}

const bake::Tracer& PictureProbe::tracer(const Session& session) {
    begin_tracer(session);
    if (coming_tracer_.valid()) tracer_ = coming_tracer_.get();
    return *tracer_;
}

const bake::Tracer* PictureProbe::tracer_if_made(const Session& session) {
    begin_tracer(session);
    const bool has_come = coming_tracer_.valid() &&
                          coming_tracer_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (has_come) tracer_ = coming_tracer_.get();
    return tracer_.get();
}

ui::SideMeasure PictureProbe::measure(const glm::vec2& wanted, const image::ImageF& luminance,
                                      const scene::Camera& camera, const Session& session,
                                      const scene::FrameLights& lit) {
    ui::SideMeasure measure;
    measure.place = wanted;
    measure.cd_m2 = at_place(luminance, wanted);
    const bake::DenormalsOff mode;
    const bake::Tracer& rays = tracer(session);
    const bake::Surface surface = surface_at(camera, glm::clamp(wanted, 0.0f, 1.0f), rays);
    if (surface.instance < 0) return measure;
    measure.hit = true;
    measure.lux = lux_at(surface, lit, session, rays).all;
    measure.distance_m = surface.distance_m;
    measure.object = rays.stage().instances[static_cast<std::size_t>(surface.instance)].name;
    return measure;
}

void PictureProbe::probe(const std::optional<glm::vec2>& wanted, const ShownPicture& shown, double now_s,
                         bool drew) {
    if (drew) frame_ = {};
    if (!wanted) {
        probed_place_.reset();
        return;
    }
    if ((!drew && wanted == probed_place_) || now_s - probed_s_ < kProbeEvery_s) return;
    probed_place_ = wanted;
    probed_s_ = now_s;
    if (frame_.empty()) frame_ = luminance_of(shown.relighter.frame());
    const glm::vec2 place = glm::clamp(*wanted, 0.0f, 1.0f);
    ui::Probed probed;
    probed.place = *wanted;
    probed.cd_m2 = at_place(frame_, *wanted);
    const bake::DenormalsOff mode;
    const bake::Tracer& rays = tracer(shown.session);
    const bake::Surface surface = surface_at(shown.camera, place, rays);
    if (surface.instance >= 0) {
        probed.hit = true;
        const Lux lux = lux_at(surface, shown.lights, shown.session, rays);
        probed.lux = lux.all;
        if (shown.session.bounced) probed.bounced_lux = lux.bounced;
        probed.at_m = surface.position;
        probed.distance_m = surface.distance_m;
        probed.object = rays.stage().instances[static_cast<std::size_t>(surface.instance)].name;
    }
    link_.probed.put(std::move(probed));
    link_.on_news();
}

void PictureProbe::pick(const ui::Pick& pick, const Session& session) {
    if (pick.number == picked_) return;
    picked_ = pick.number;
    ui::Picked picked;
    picked.number = pick.number;
    const bake::DenormalsOff mode;
    const bake::Tracer& rays = tracer(session);
    const bake::Surface surface = surface_near(pick.from_m, pick.way, pick.beside, rays);
    if (surface.instance >= 0) {
        const scene::Instance& instance = rays.stage().instances[static_cast<std::size_t>(surface.instance)];
        picked.hit = true;
        picked.at_m = surface.position;
        picked.object = instance.name;
        if (instance.fixture >= 0) picked.fixture = static_cast<std::size_t>(instance.fixture);
    }
    link_.picked.put(std::move(picked));
    link_.on_news();
}

void PictureProbe::save(const ui::SaveFrame& wanted, const ShownPicture& shown) {
    if (wanted.number == saved_) return;
    saved_ = wanted.number;
    const Result<void> written = write_picture(wanted.file, shown.relighter.frame(),
                                               shown.relighter.ev100_used(), shown.relighter.tone());
    link_.saved.put({saved_, written.ok() ? std::nullopt : std::optional(written.error())});
    link_.on_news();
}

} // namespace ghost::app
