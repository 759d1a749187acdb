// SPDX-License-Identifier: Apache-2.0
#include "live/engine/live_picture.h"

#include "base/steady_time.h"
#include "gpu/device_memory.h"
#include "live/session/picture_room.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace ghost::app {
namespace {

constexpr int kMostPixels = 8192;
constexpr double kPart_s = 0.01, kLandingPart_s = 0.04; // of a picture, for the next one's stage
constexpr float kWork_lux = 100;
constexpr float kWorkAtEv0_lux = 5; // stages are dark: makes what reflects a twelfth middle grey

bool same_view(const scene::Camera& a, const scene::Camera& b) {
    return a.position_m == b.position_m && a.target_m == b.target_m && a.fov_y_deg == b.fov_y_deg &&
           a.width == b.width && a.height == b.height;
}

// The same picture with more pixels.
bool is_larger(const scene::Camera& a, scene::Camera b) {
    constexpr float kSameShape = 0.02f;
    const auto shape = [](const scene::Camera& one) {
        return static_cast<float>(one.width) / static_cast<float>(std::max(one.height, 1));
    };
    if (a.width <= b.width || std::abs(shape(a) / shape(b) - 1) > kSameShape) return false;
    b.width = a.width;
    b.height = a.height;
    return same_view(a, b);
}

// As bright as the exposure asks for: it must neither be lost in the dark nor drown everything.
float work_lux_for(const scene::Camera& camera) {
    return camera.auto_exposure ? kWork_lux : kWorkAtEv0_lux * std::exp2(camera.ev100);
}

} // namespace

void LivePicture::begin() {
    from_ = {};
    work_lux_ = 0;
    flies_ = false;
    whole_for_ = {};
    haze_ = {};
}

LivePicture::Drawn LivePicture::draw(Session& session, const Wanted& wanted, const scene::Camera& shown,
                                     double now_s, const std::function<bool()>& stop) {
    Drawn drawn;
    drawn.changed = set_work_light(wanted, session);
    scene::Camera unsized = wanted.camera;
    unsized.width = shown.width;
    unsized.height = shown.height;
    if (!same_view(unsized, shown)) {
        flew_s_ = now_s;
        drawn.changed = true;
    }
    measure_ = wanted.measure;
    if (measure_ != ui::Measure::lux) session.lux_light.reset(); // it has as much memory as the picture
    const bool flew = std::exchange(flies_, now_s - flew_s_ < kRest_s);
    const bool moves = wanted.moves || drawn.changed;
    fit_into_memory(wanted.camera, session);
    scene::Camera camera = camera_for(wanted, moves);
    if (!moves && !session.prepare(camera, stop)) {
        flies_ = flew; // it has not landed yet
        drawn.statistics.stopped = true;
        return drawn;
    }
    // Luminances are those of all its light; beside lux nobody sees it.
    bool uses_coarse = moves && wanted.quality.percent == 0 && pace().level().coarse_light &&
                       measure_ != ui::Measure::luminance;
    // A better level, and what was left out of a flight, come when the stage is drawn, which takes a second:
    // a part in each picture, of which those after a flight are larger.
    const bool lands = flew && !flies_;
    const bool gains = moves && !flies_ && (lands || is_larger(camera, from_));
    was_prepared_ = was_prepared_ && gains;
    // Where a picture takes long, nobody wants to wait for many of them.
    const double part_s = lands ? std::max(kLandingPart_s, 1e-3 * drew_ms_) : kPart_s;
    const bool waits = gains && !prepare_part(camera, part_s, session);
    if (waits) {
        camera.width = from_.width;
        camera.height = from_.height;
        uses_coarse = session.relighter->is_coarse();
        flies_ = flew;
    }
    sees_else_ = sees_else_ || flies_ != flew;
    const bool is_other_size =
        camera.width != session.relighter->width() || camera.height != session.relighter->height();
    is_unusual_ = waits || flies_ != flew || is_other_size || uses_coarse != session.relighter->is_coarse();
    if (std::exchange(sees_else_, false) || !same_view(camera, from_)) {
        session.look_from(camera, flies_, uses_coarse);
        session.relighter->set_exposure(wanted.camera.ev100, wanted.camera.auto_exposure);
        from_ = camera;
    }
    drawn.from = camera;
    session.use_coarse_light(uses_coarse);
    session.relighter->set_quality(haze(moves));
    session.relighter->set_exposure(wanted.camera.ev100, wanted.camera.auto_exposure);
    session.relighter->set_tone(session.options.tone);
    session.relighter->set_most_lights(moves ? lights_in(1000.0 / wanted.quality.fps) : 0);
    drawn.statistics = session.draw(wanted.air_s, moves ? std::function<bool()>{} : stop);
    drew_ms_ = drawn.statistics.draw_ms;
    return drawn;
}

bool LivePicture::prepare_part(const scene::Camera& camera, double part_s, Session& session) {
    const double begin_s = steady_now_s();
    const bool is_done = session.prepare(camera, [&] { return steady_now_s() - begin_s > part_s; });
    // The last part takes long enough for one picture.
    return std::exchange(was_prepared_, is_done) && is_done;
}

bool LivePicture::set_work_light(const Wanted& wanted, const Session& session) {
    const float lux = wanted.has_work_light ? work_lux_for(wanted.camera) : 0;
    if (lux == std::exchange(work_lux_, lux)) return false;
    session.live->set_work_light(lux);
    sees_else_ = true;
    return true;
}

void LivePicture::fit_into_memory(const scene::Camera& wanted, Session& session) {
    const glm::ivec2 pixels(wanted.width, wanted.height);
    if (pixels == whole_for_) return;
    whole_for_ = pixels;
    session.drop_parked();
    // What there is now goes before the next one is made.
    const std::uint64_t room = session.device->memory().left_bytes() + session.relighter->picture_bytes();
    scene::Camera most = wanted;
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
    messages_.add(Severity::warning, session.device->name(),
                  "memory is short for a picture of " + text(most) + " (" + std::to_string(needed >> 20) +
                      " MB, there are " + std::to_string(room >> 20) + "): it is drawn with " + text(whole));
}

scene::Camera LivePicture::camera_for(const Wanted& wanted, bool moves) const {
    scene::Camera camera = wanted.camera;
    const double share = wanted.quality.percent > 0 ? std::sqrt(wanted.quality.percent / 100.0)
                         : moves                    ? pace().level().sides
                                                    : 1.0;
    const auto pixels = [&](int whole) {
        return std::clamp(static_cast<int>(std::lround(whole * share)), kLeastPixels, kMostPixels);
    };
    camera.height = pixels(whole_.y);
    // Of the same height in the window as the whole one, and never narrower.
    camera.width = share == 1.0 ? whole_.x
                                : std::clamp((camera.height * whole_.x + whole_.y - 1) / whole_.y,
                                             kLeastPixels, kMostPixels);
    return camera;
}

// How many lights that turn there is time for; 0: all of them.
int LivePicture::lights_in(double frame_ms) const {
    constexpr int kLeast = 8;
    return light_ms_ > 0 ? std::max(static_cast<int>(frame_ms / light_ms_), kLeast) : 0;
}

void LivePicture::learn(const render::FrameStatistics& statistics, double draw_ms, int frames_per_s) {
    constexpr int kMany = 16; // below, the time is that of the picture and not of its lights
    constexpr double kOfNew = 0.3;
    if (is_unusual_) return; // the first one costs what no other does
    // A fade draws no light: what it takes says nothing of the lights that turn next.
    if (statistics.drawn == 0 && statistics.mended == 0 && draw_ms <= 1000.0 / frames_per_s) return;
    paces_[kind()].add(draw_ms, frames_per_s);
    if (statistics.drawn < kMany) return;
    const double ms = draw_ms / statistics.drawn;
    light_ms_ = light_ms_ == 0 ? ms : light_ms_ + kOfNew * (ms - light_ms_);
}

void LivePicture::take_air(Session& session) {
    session.relighter->set_quality(haze_);
    session.lux_light.reset(); // it knows one air
    look_anew();
}

bool LivePicture::set_haze_samples(int samples, const Session& session) {
    if (samples == std::exchange(haze_.most_segments, samples)) return false;
    session.relighter->set_quality(haze_);
    session.relighter->draw_anew();
    return true;
}

const render::HazeQuality& LivePicture::haze(bool moves) {
    haze_.grid = moves;
    return haze_;
}

} // namespace ghost::app
