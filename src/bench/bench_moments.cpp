// SPDX-License-Identifier: Apache-2.0
// Ten moments of the demo (with light at half the size, and in full) and ten of a festival, as they are drawn
// while all moves and as they are drawn at rest: how near they are, and, with --pictures, both beside each
// other with what differs, to be looked at.
#include "base/interrupt.h"
#include "bench/bench.h"
#include "bench/festival.h"
#include "dmx/record/recording_tasks.h"

#include "image/flip.h"
#include "image/ldr.h"
#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kMomentFps = 15;
constexpr int kMovingFrames = 6; // drawn before each moment, so that what is kept is as old as in the window
constexpr int kTimes = 4;        // of a difference, as it is shown
constexpr int kFestivalFixtures = 60; // of its lights a quarter turns from one frame to the next
constexpr int kFestivalLights = 15;

struct ShownMoment {
    const char* view;
    double at_s;
};
constexpr ShownMoment kOfDemo[] = {{"house", 8},  {"high", 18}, {"close", 21}, {"close", 36}, {"house", 38},
                                   {"house", 50}, {"high", 61}, {"close", 70}, {"house", 82}, {"close", 92}};
constexpr ShownMoment kOfFestival[] = {{"wide", 2},  {"wide", 5},  {"wide", 8},  {"wide", 11}, {"wide", 14},
                                       {"wide", 17}, {"wide", 20}, {"wide", 23}, {"wide", 26}, {"wide", 29}};

// How the window draws what moves (live/engine/live_picture.h).
struct Motion {
    const char* words; // behind the moment's name
    int width, height;
    bool coarse_light;
    int most_lights; // 0: all
};
constexpr Motion kHalfLight{"", 1280, 720, true, 0}, kFullLight{", light in full", 640, 360, false, 0},
    kManyLights{"", 1280, 720, true, kFestivalLights};

void draw_as(Session& session, bool moves, const Motion& motion) {
    render::HazeQuality quality;
    quality.grid = moves;
    session.use_coarse_light(moves && motion.coarse_light);
    session.relighter->set_quality(quality);
    session.relighter->set_most_lights(moves ? motion.most_lights : 0);
}

struct MovingAndResting {
    image::Image8 moving, resting;
    double db = 0, flip = 0;
};

Result<MovingAndResting> pair_at(Session& session, double at_s, const Motion& motion) {
    TRY(dmx::Recording recording, dmx::open_recording(session.show->recording, {}, true));
    dmx::Player player(std::move(recording));
    const auto last = std::lround(at_s * kMomentFps);
    draw_as(session, true, motion);
    session.relighter->draw_anew();
    for (long frame = 0; frame <= last; ++frame) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        const double now_s = static_cast<double>(frame) / kMomentFps;
        session.rig->step(player.at(now_s), 1 / kMomentFps);
        if (last - frame < kMovingFrames) (void)session.draw(now_s);
    }
    MovingAndResting pair;
    pair.moving = session.relighter->picture();
    image::ImageF moving = session.relighter->frame();
    draw_as(session, false, motion);
    session.relighter->draw_anew();
    (void)session.draw(static_cast<double>(last) / kMomentFps);
    pair.resting = session.relighter->picture();
    TRY(const image::PicturePair both, image::pair_up(std::move(moving), session.relighter->frame(), {}));
    pair.db = image::psnr_db(both, image::p75_curve(both));
    pair.flip = image::hdr_flip(both, image::kFlipPixelsPerDegree).mean;
    return pair;
}

// Moving, resting, and what differs, kTimes as bright.
image::Image8 beside(const MovingAndResting& pair) {
    const int width = pair.moving.width, height = pair.moving.height;
    image::Image8 all(3 * width, height, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t *a = pair.moving.at(x, y), *b = pair.resting.at(x, y);
            std::copy_n(a, 4, all.at(x, y));
            std::copy_n(b, 4, all.at(width + x, y));
            std::uint8_t* difference = all.at(2 * width + x, y);
            for (int c = 0; c < 3; ++c)
                difference[c] = static_cast<std::uint8_t>(std::min(kTimes * std::abs(a[c] - b[c]), 255));
            difference[3] = 255;
        }
    return all;
}

std::string at_text(double at_s) {
    char text[16];
    std::snprintf(text, sizeof text, "%02.0f", at_s);
    return text;
}

Result<void> moments_of(const BenchOptions& options, const std::string& what,
                        std::span<const ShownMoment> moments, const Motion& motion, const BenchSink& sink) {
    std::unique_ptr<Session> session;
    std::string view;
    for (const ShownMoment& moment : moments) {
        if (view != moment.view) {
            SessionOptions opening;
            opening.show = options.show;
            opening.device = options.device;
            opening.view = view = moment.view;
            opening.width = motion.width;
            opening.height = motion.height;
            opening.live = true;
            opening.workers = true;
            opening.quiet = true;
            opening.beams.grid = true;
            session.reset();
            TRY(session, open_session(opening));
        }
        TRY(const MovingAndResting pair, pair_at(*session, moment.at_s, motion));
        const std::string name = what + "_" + moment.view + "_" + at_text(moment.at_s) + "s" + motion.words;
        if (!options.pictures.empty())
            TRY_VOID(
                image::write_png(std::filesystem::path(options.pictures) / (name + ".png"), beside(pair)));
        sink({"moments", name, {{"db", pair.db}, {"flip_mean", pair.flip}}, ""});
    }
    return {};
}

} // namespace

Result<void> bench_moments(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    TRY_VOID(moments_of(options, "demo", kOfDemo, kHalfLight, sink));
    TRY_VOID(moments_of(options, "demo", kOfDemo, kFullLight, sink));
    TRY(const Festival festival, Festival::make(kFestivalFixtures));
    BenchOptions there = options;
    there.show = festival.folder();
    return moments_of(there, "festival", kOfFestival, kManyLights, sink);
}

} // namespace ghost::app
