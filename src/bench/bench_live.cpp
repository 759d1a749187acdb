// SPDX-License-Identifier: Apache-2.0
// A film of the free camera by span, as it is drawn while things move; and how near that is to the same
// moments at rest.
#include "base/interrupt.h"
#include "bench/bench.h"
#include "bench/festival.h"
#include "dmx/record/recording_tasks.h"

#include "base/steady_time.h"
#include "gpu/pipelines.h"
#include "show/camera_moves.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <optional>
#include <set>

namespace ghost::app {
namespace {

constexpr double kFilmFps = 15;
// Of the demo: ten lights, half of them turning at a time.
constexpr double kFilmFrom_s = 20, kFilmTo_s = 22.5;
constexpr double kFade_s = 0.04; // a frame of the fade
constexpr int kFadeFrames = 25;
constexpr int kFadeWarmUp = 4, kFilmWarmUp = 10; // frames
constexpr int kCompareEvery = 12;                // frames

struct Film {
    const char* view;
    int width;
    int height;
    bool grid;           // haze as it is drawn while things move; else every ray, as at rest
    bool coarse;         // light at half the size
    int most_lights = 0; // that may turn from one frame to the next, 0: all
    const char* of = ""; // the show, for the table
    bool bounces = false;
};
constexpr Film kFilms[] = {{"close", 640, 360, true, false},   {"close", 640, 360, false, false},
                           {"house", 640, 360, true, false},   {"high", 640, 360, true, false},
                           {"close", 1280, 720, true, true},   {"house", 1280, 720, true, true},
                           {"high", 1280, 720, true, true},    {"close", 1280, 720, true, false},
                           {"close", 1280, 720, false, false}, {"close", 640, 360, true, false, 0, "", true}};

// At the fewest pixels of a window of 1280x760, as many lights as there is time for; likewise with as many
// pixels as points of light.
constexpr Film kFestivals[] = {{"wide", 350, 235, true, true, 8, "festival of "},
                               {"wide", 250, 168, true, false, 8, "festival of "}};

constexpr Film kFlights[] = {{"house", 320, 180, true, false}, {"house", 640, 360, true, true}};
constexpr const char* kFlightTo = "close";

class LiveBench {
public:
    static Result<LiveBench> open(const BenchOptions& options, const Film& film) {
        SessionOptions opening;
        opening.show = options.show;
        opening.device = options.device;
        opening.view = film.view;
        opening.width = film.width;
        opening.height = film.height;
        opening.live = true;
        opening.workers = true;
        opening.quiet = true;
        opening.beams.grid = true;
        opening.bounce = film.bounces ? scene::BounceDetail::normal : scene::BounceDetail::off;
        LiveBench bench;
        TRY(bench.session_, open_session(opening));
        TRY(dmx::Recording recording, dmx::open_recording(bench.session_->show->recording, {}, true));
        bench.player_.emplace(std::move(recording));
        return bench;
    }

    Session& session() { return *session_; }
    // Steps the rig to this frame; frames come in order.
    void step_to(long frame) {
        for (; frame_ <= frame; ++frame_)
            session_->rig->step(player_->at(static_cast<double>(frame_) / kFilmFps), 1.0 / kFilmFps);
    }

private:
    std::unique_ptr<Session> session_;
    std::optional<dmx::Player> player_;
    long frame_ = 0;
};

// As things move, or as they rest.
void use(Session& session, const Film& film, bool moves) {
    render::HazeQuality quality;
    quality.grid = moves && film.grid;
    session.use_coarse_light(moves && film.coarse);
    session.relighter->set_quality(quality);
    session.relighter->set_most_lights(moves ? film.most_lights : 0);
}

// Means, for a film is as long as all its frames together.
class Means {
public:
    void add(const std::string& name, double value) { sums_[name] += value; }
    double of(const std::string& name) const {
        const auto found = sums_.find(name);
        return found == sums_.end() ? 0 : found->second / frames;
    }
    int frames = 0;

private:
    std::map<std::string, double> sums_;
};

Result<void> film_row(const BenchOptions& options, const Film& film, const BenchSink& sink) {
    TRY(LiveBench bench, LiveBench::open(options, film));
    Session& session = bench.session();
    use(session, film, true);
    const auto first = static_cast<long>(kFilmFrom_s * kFilmFps),
               last = static_cast<long>(kFilmTo_s * kFilmFps);
    Means means;
    std::set<std::string> spans;
    std::uint64_t waited_for = 0; // pipelines
    double db = 1e9;
    for (long frame = first - kFilmWarmUp; frame <= last; ++frame) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        bench.step_to(frame);
        const std::clock_t begin = std::clock();
        const render::FrameStatistics drawn = session.draw(static_cast<double>(frame) / kFilmFps);
        const double processor_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        if (frame < first) continue;
        if (means.frames++ == 0) waited_for = session.device->pipelines().waited_for();
        means.add("ms", drawn.draw_ms);
        if (session.bounce) means.add("solve_ms", session.bounce->solve_ms());
        means.add("processor_ms", processor_ms);
        means.add("lights_drawn", drawn.drawn);
        means.add("lights_mended", drawn.mended);
        const double units = std::max(1.0, static_cast<double>(drawn.surface_tiles));
        means.add("made_share", drawn.made_units / units);
        means.add("direct_share", drawn.direct_units / units);
        for (const gpu::Span& span : drawn.spans) {
            means.add(span.name, span.ms);
            spans.insert(span.name);
        }
        if (film.most_lights > 0 || (frame - first) % kCompareEvery != 0) continue;
        const image::ImageF moving = session.relighter->frame();
        use(session, film, false);
        session.relighter->draw_anew();
        (void)session.draw(static_cast<double>(frame) / kFilmFps);
        db = std::min(db, display_db(moving, session.relighter->frame()));
        use(session, film, true);
        session.relighter->draw_anew();
        (void)session.draw(static_cast<double>(frame) / kFilmFps);
    }
    BenchRow row{"live",
                 film.of +
                     (film.most_lights > 0 ? std::to_string(session.show->fixtures.size()) + ", " : "") +
                     film.view + " " + std::to_string(film.width) + "x" + std::to_string(film.height) +
                     (film.coarse ? ", light at half" : "") + (film.grid ? "" : ", every ray") +
                     (film.bounces ? ", light bounces" : ""),
                 {},
                 ""};
    row.figures = {
        {"ms", means.of("ms")},
        {"processor_ms", means.of("processor_ms")},
        {"lights_drawn", means.of("lights_drawn")},
        {"lights_mended", means.of("lights_mended")},
        {"pipelines_waited_for", static_cast<double>(session.device->pipelines().waited_for() - waited_for)}};
    if (film.bounces) row.figures.emplace_back("solve_ms", means.of("solve_ms"));
    for (const std::string& span : spans) row.figures.emplace_back(span + "_ms", means.of(span));
    for (const char* share : {"made_share", "direct_share"}) row.figures.emplace_back(share, means.of(share));
    row.note = "mean of " + std::to_string(means.frames) + " frames";
    if (film.bounces) row.note += "; with their solutions, which a window makes beside the pictures";
    if (film.most_lights == 0) {
        row.figures.emplace_back("least_db", db);
        row.note += "; dB against the same moments at rest";
    }
    sink(row);
    return {};
}

// The same while the camera flies, so that nothing that was seen from elsewhere can be kept.
Result<void> flight_row(const BenchOptions& options, const Film& film, const BenchSink& sink) {
    TRY(LiveBench bench, LiveBench::open(options, film));
    Session& session = bench.session();
    const std::vector<scene::Camera>& cameras = session.show->cameras;
    const auto to = std::find_if(cameras.begin(), cameras.end(),
                                 [](const scene::Camera& camera) { return camera.name == kFlightTo; });
    if (to == cameras.end()) return Error{"there is no such camera to fly to", kFlightTo};
    const scene::Camera from = session.live->camera();
    use(session, film, true);
    const auto first = static_cast<long>(kFilmFrom_s * kFilmFps),
               last = static_cast<long>(kFilmTo_s * kFilmFps);
    Means means;
    std::set<std::string> spans;
    double db = 1e9;
    for (long frame = first - 2; frame <= last; ++frame) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        bench.step_to(frame);
        const double begin_s = steady_now_s();
        const auto share = static_cast<float>(frame - first + 2) / static_cast<float>(last - first + 2);
        const scene::Camera here = scene::camera_between(from, *to, share);
        session.look_from(here, true);
        std::vector<gpu::Span> of_frame = session.live->g_buffer().spans();
        const double stage_ms = 1e3 * (steady_now_s() - begin_s);
        const render::FrameStatistics drawn = session.draw(static_cast<double>(frame) / kFilmFps);
        if (frame < first) continue;
        ++means.frames;
        means.add("ms", 1e3 * (steady_now_s() - begin_s));
        means.add("stage_ms", stage_ms);
        of_frame.insert(of_frame.end(), drawn.spans.begin(), drawn.spans.end());
        for (const gpu::Span& span : of_frame) {
            means.add(span.name, span.ms);
            spans.insert(span.name);
        }
        if ((frame - first) % kCompareEvery != 0) continue;
        const image::ImageF flying = session.relighter->frame();
        session.look_from(here);
        use(session, film, false);
        (void)session.draw(static_cast<double>(frame) / kFilmFps);
        db = std::min(db, display_db(flying, session.relighter->frame()));
        use(session, film, true);
    }
    BenchRow row{"live",
                 "flight " + std::to_string(film.width) + "x" + std::to_string(film.height) +
                     (film.coarse ? ", light at half" : ""),
                 {},
                 "mean of " + std::to_string(means.frames) +
                     " frames; stage: the picture without lights; dB against the same moments at rest"};
    row.figures = {{"ms", means.of("ms")}, {"stage_ms", means.of("stage_ms")}};
    for (const std::string& span : spans) row.figures.emplace_back(span + "_ms", means.of(span));
    row.figures.emplace_back("least_db", db);
    sink(row);
    return {};
}

// Ten lights fade, in dimmer and colour, and nothing turns.
Result<void> fade_row(const BenchOptions& options, const BenchSink& sink) {
    TRY(LiveBench bench, LiveBench::open(options, kFilms[0]));
    Session& session = bench.session();
    bench.step_to(static_cast<long>(kFilmFrom_s * kFilmFps));
    std::vector<double> total;
    std::map<std::string, std::vector<double>> spans;
    int redrawn = 0;
    const scene::FrameLights lit = session.lit();
    for (int frame = 0; frame < kFadeFrames + kFadeWarmUp; ++frame) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        scene::FrameLights faded = lit;
        for (std::size_t k = 0; k < faded.lights.size(); ++k) {
            const double phase = 2 * kFade_s * frame + static_cast<double>(k);
            const glm::vec3 share(0.6 + 0.4 * std::sin(phase), 0.6 + 0.4 * std::sin(1.3 * phase),
                                  0.6 + 0.4 * std::cos(phase));
            faded.lights[k].intensity_cd *= share;
        }
        const render::FrameStatistics drawn = session.relighter->draw(faded);
        if (frame < kFadeWarmUp) continue;
        total.push_back(drawn.draw_ms);
        for (const gpu::Span& span : drawn.spans) spans[span.name].push_back(span.ms);
        redrawn = std::max(redrawn, drawn.drawn);
    }
    BenchRow row{"live", "fade of all lights, 640x360", {}, "colour and dimmer only"};
    row.figures = {{"ms", median(total)}, {"lights_drawn", static_cast<double>(redrawn)}};
    for (const auto& [name, times] : spans) row.figures.emplace_back(name + "_ms", median(times));
    sink(row);
    return {};
}

} // namespace

Result<void> bench_live(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    for (const Film& film : kFlights) TRY_VOID(flight_row(options, film, sink));
    for (const Film& film : kFilms) TRY_VOID(film_row(options, film, sink));
    TRY_VOID(fade_row(options, sink));
    for (const int fixtures : {60, 400}) {
        TRY(const Festival festival, Festival::make(fixtures));
        BenchOptions there = options;
        there.show = festival.folder();
        for (const Film& film : kFestivals) TRY_VOID(film_row(there, film, sink));
    }
    return {};
}

} // namespace ghost::app
