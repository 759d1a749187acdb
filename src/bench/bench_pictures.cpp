// SPDX-License-Identifier: Apache-2.0
// Stills of the show on this device: how long one takes and how near it is to what another device drew.
#include "base/interrupt.h"
#include "bench/bench.h"

#include "dmx/record/recording_tasks.h"
#include "image/exr.h"
#include "image/ldr.h"
#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace ghost::app {
namespace {

constexpr double kStepFps = 30;
constexpr float kMostHalf = 65504;
constexpr double kAlike_db = 120; // or more

struct Still {
    const char* view;
    double at_s;
    int width;
    int height;
    bool live;
};
// The golden ones of tests/golden, and what a free camera shows.
constexpr Still kStills[] = {{"house", 8, 256, 75, false},    {"house", 50, 256, 75, false},
                             {"close", 70, 160, 90, false},   {"close", 36, 1280, 720, true},
                             {"house", 82, 1280, 720, true},  {"high", 18, 1280, 720, true},
                             {"house", 20, 1024, 300, false}, {"close", 21, 1920, 1080, true}};

std::string name_of(const Still& still) {
    return std::string(still.view) + "_" + std::to_string(static_cast<int>(still.at_s)) + "s_" +
           std::to_string(still.width) + "x" + std::to_string(still.height) + (still.live ? "_live" : "");
}

} // namespace

Result<void> bench_pictures(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    namespace fs = std::filesystem;
    for (const Still& still : kStills) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        SessionOptions opening;
        opening.show = options.show;
        opening.device = options.device;
        opening.view = still.view;
        opening.width = still.width;
        opening.height = still.height;
        opening.live = still.live;
        opening.quiet = true;
        TRY(const std::unique_ptr<Session> session, open_session(opening));
        TRY(dmx::Recording recording, dmx::open_recording(session->show->recording, {}, true));
        dmx::Player player(std::move(recording));
        for (int frame = 0; frame <= std::lround(still.at_s * kStepFps); ++frame)
            session->rig->step(player.at(frame / kStepFps), 1 / kStepFps);
        const render::FrameStatistics drawn = session->draw(still.at_s);
        session->relighter->draw_anew();
        const render::FrameStatistics again = session->draw(still.at_s);
        image::ImageF frame = session->relighter->frame();
        for (float& value : frame.samples) value = std::min(value, kMostHalf); // as files have it
        const std::string name = name_of(still);
        double db = std::numeric_limits<double>::quiet_NaN(), bias = db;
        if (!options.against.empty()) {
            TRY(image::ExrFile reference, image::read_exr(fs::path(options.against) / (name + ".exr")));
            TRY(const image::PicturePair pair, image::pair_up(frame, std::move(reference.pixels), {}));
            db = std::min(image::psnr_db(pair, image::p75_curve(pair)), kAlike_db);
            bias = 100 * image::relative_errors(pair).bias;
        }
        if (!options.pictures.empty()) {
            const fs::path folder = options.pictures;
            TRY_VOID(image::write_png(folder / (name + ".png"), session->relighter->picture()));
            const image::ExrFile file{frame, {"R", "G", "B"}, image::kRec2020, {{"unit", "cd/m^2"}}};
            TRY_VOID(image::write_exr(folder / (name + ".exr"), file, image::ExrSample::half));
        }
        sink({"pictures",
              name,
              {{"first_ms", drawn.draw_ms},
               {"again_ms", again.draw_ms},
               {"psnr_db", db},
               {"bias_percent", bias}},
              options.against.empty() ? "" : "against " + options.against});
    }
    return {};
}

} // namespace ghost::app
