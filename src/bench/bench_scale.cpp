// SPDX-License-Identifier: Apache-2.0
// Table of many lights (bench/private/many_lights.h): every ray, and as pictures that move are drawn where
// there is not enough time.
#include "base/interrupt.h"
#include "bench/bench_views.h"
#include "bench/private/many_lights.h"
#include "render/haze/haze_pass.h"
#include "shared/push.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;
using glm::vec3;

constexpr int kFewestFrames = 2; // frames measured of a slow row

// What a picture that moves may do without.
struct Saving {
    const char* name;
    bool coarse;             // light at half the size
    std::uint32_t wide_step; // HazeQuality
};
constexpr Saving kAll{"", false, 1};
constexpr Saving kSavings[] = {{", every second ray", false, 2},
                               {", light at half", true, 1},
                               {", light at half, every second ray", true, 2}};
constexpr int kSavingFromWidth = 1920; // smaller pictures need none
constexpr std::array<std::size_t, 3> kSavingLights{60, 400, 1000};

struct Measured {
    double ms = 0;
    int frames = 0;
    double haze_tiles = 0, surface_tiles = 0;             // of the last frame
    double spans_ms = 0;                                  // all of them
    double dispatches = 0, barriers = 0, submissions = 0; // of the last frame
    double processor_ms = 0;
    image::ImageF picture; // of the first moment
    std::vector<std::pair<std::string, double>> passes;
};

// As many frames as fit into the time, two at least.
Measured measure_frames(const gpu::Device& device, render::Relighter& relighter,
                        const std::vector<Place>& places, std::size_t count, int frames, double seconds) {
    const std::vector<std::string> names{"cull",     "fan", "gate",    "visibility",
                                         "surfaces", "add", "develop", "read back"};
    std::vector<double> ms, processor_ms;
    std::vector<std::vector<double>> passes(names.size());
    std::vector<double> spans;
    double haze_tiles = 0, surface_tiles = 0;
    gpu::RecordedWork before;
    const Clock::time_point start = Clock::now();
    relighter.draw(festival_lights(places, count, 0));
    image::ImageF picture = relighter.frame();
    while (static_cast<int>(ms.size()) < frames) {
        const double spent = std::chrono::duration<double>(Clock::now() - start).count();
        if (static_cast<int>(ms.size()) >= kFewestFrames && spent > seconds) break;
        before = device.work();
        const std::vector<shared::Light> lights =
            festival_lights(places, count, 0.1 * static_cast<double>(ms.size() + 1));
        const std::clock_t begin = std::clock();
        const render::FrameStatistics drawn = relighter.draw(lights);
        processor_ms.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        ms.push_back(drawn.draw_ms);
        haze_tiles = drawn.haze_tiles;
        surface_tiles = drawn.surface_tiles;
        spans.push_back(0);
        for (const gpu::Span& span : drawn.spans) spans.back() += span.ms;
        // A frame of more passes than the device's clock has room for counts the rest as one.
        const bool whole = !drawn.spans.empty() && drawn.spans.back().name == "read back";
        for (std::size_t k = 0; k < names.size(); ++k) {
            double sum = span_ms(drawn, names[k]);
            if (names[k] == "gate") sum += span_ms(drawn, "lonely") + span_ms(drawn, "spread");
            if (names[k] == "add")
                sum += span_ms(drawn, "clear") + span_ms(drawn, "fold") + span_ms(drawn, "light spread");
            if (names[k] == "develop") sum += span_ms(drawn, "meter");
            passes[k].push_back(whole ? sum : std::numeric_limits<double>::quiet_NaN());
        }
    }
    const gpu::RecordedWork& work = device.work();
    Measured measured{median(ms),
                      static_cast<int>(ms.size()),
                      haze_tiles,
                      surface_tiles,
                      median(spans),
                      static_cast<double>(work.dispatches - before.dispatches),
                      static_cast<double>(work.barriers - before.barriers),
                      static_cast<double>(work.submissions - before.submissions),
                      median(processor_ms),
                      std::move(picture),
                      {}};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string key = names[k] == "read back" ? "read_back" : names[k];
        measured.passes.emplace_back(key + "_ms", median(passes[k]));
    }
    return measured;
}

Result<scene::DistanceMaps> trace_all(const scene::Stage& stage, const std::vector<Place>& places) {
    const bake::Tracer tracer(stage);
    scene::DistanceMaps maps;
    maps.size = scene::kDistanceMapSize;
    for (const Place& place : places) {
        if (interrupted()) return Error{"interrupted while making distance maps", ""};
        maps.maps.push_back(trace_distances(tracer, place.position_m, maps.size));
    }
    return maps;
}

std::unique_ptr<render::DistanceImages> upload(const gpu::Device& device, scene::DistanceMaps maps) {
    return std::make_unique<render::DistanceImages>(device, maps);
}

// What the fans of so many lights take, as the relighter makes them.
double fan_bytes(const gpu::Device& device, const render::Settings& settings, std::size_t count,
                 const render::DistanceImages& distances) {
    const std::uint32_t batch = device.is_cpu() ? 1 : shared::kLightsPerChunk;
    const render::HazePass haze(device, settings.beams, render::Fragments{}, batch,
                                static_cast<std::uint32_t>(count), &distances, render::FanDetail::fine);
    return static_cast<double>(haze.memory_bytes());
}

// A picture size, and what its rows share.
struct Views {
    const gpu::Device& device;
    const render::GBuffer& g_buffer;
    const render::DistanceImages& distances;
    const std::vector<Place>& places;
    const shared::Gobos& gobos;
    double map_bytes; // of a light
};

render::Settings settings_of(const Saving& saving) {
    render::Settings settings = bench_settings();
    settings.image_memory_bytes = 0; // every light changes in every frame: nothing to keep
    settings.coarse = saving.coarse;
    settings.beams.most_wide_step = saving.wide_step;
    return settings;
}

struct ScaleRow {
    BenchRow row;
    double ms = 0;
    double other_bytes = 0; // on the device, but for maps
    image::ImageF picture;
};

ScaleRow measure(const Views& views, const BenchOptions& options, const std::string& name, std::size_t count,
                 const Saving& saving) {
    const render::Settings settings = settings_of(saving);
    render::Relighter relighter(views.device, views.g_buffer, &views.distances, views.gobos,
                                static_cast<int>(count), settings);
    render::HazeQuality quality;
    quality.wide_beam_step = saving.wide_step;
    relighter.set_quality(quality);
    Measured measured = measure_frames(views.device, relighter, views.places, count,
                                       std::min(options.frames, 20), std::min(options.row_seconds, 3.0));
    const double lights = static_cast<double>(count);
    ScaleRow result{{"scale", name, {{"ms", measured.ms}}, std::to_string(measured.frames) + " frames"},
                    measured.ms,
                    // The table's lights share the maps of all 1000: a show of so many has as many maps.
                    static_cast<double>(relighter.memory_bytes()) -
                        views.map_bytes * static_cast<double>(views.places.size()),
                    std::move(measured.picture)};
    std::vector<std::pair<std::string, double>>& figures = result.row.figures;
    figures.insert(figures.end(), measured.passes.begin(), measured.passes.end());
    figures.insert(figures.end(), {{"device_ms", measured.spans_ms},
                                   {"processor_ms", measured.processor_ms},
                                   {"dispatches", measured.dispatches},
                                   {"barriers", measured.barriers},
                                   {"submissions", measured.submissions},
                                   {"million_rays", measured.haze_tiles * shared::kTilePixels / 1e6},
                                   {"million_points", measured.surface_tiles * shared::kTilePixels / 1e6},
                                   {"ms_per_light", measured.ms / lights},
                                   {"device_mb", (result.other_bytes + views.map_bytes * lights) / 1e6}});
    return result;
}

} // namespace

Result<void> bench_scale(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    TRY(const std::unique_ptr<gpu::Device> device,
        gpu::Device::create({.name = options.device, .shaders = options.shaders}));
    const scene::Stage stage = festival_stage();
    const std::vector<Place> places = festival_places();
    TRY(scene::DistanceMaps maps, trace_all(stage, places));
    const std::unique_ptr<render::DistanceImages> distances = upload(*device, std::move(maps));
    const double map_bytes = static_cast<double>(distances->bytes()) / static_cast<double>(places.size());
    Report report; // of a stage made in code: nothing to say
    const render::StageModel model(*device, stage, report);
    const shared::Gobos gobos = bench_gobos();
    scene::Camera camera;
    camera.position_m = {0, -34, 5};
    camera.target_m = {0, 6, 6};
    camera.fov_y_deg = 30;

    double light_ms = 0; // of one more light, by the rows above
    double last_pixels = 0;
    for (const auto& [width, height] : {std::pair{256, 256}, {1024, 300}, {1920, 1080}, {3840, 2160}}) {
        if (interrupted()) break;
        render::GBuffer g_buffer(*device, width, height);
        g_buffer.draw(model, {scene::camera_to_world(camera), camera.fov_y_deg, width, height},
                      {vec3(0), bench_settings().haze});
        const Views views{*device, g_buffer, *distances, places, gobos, map_bytes};
        // By the sizes above, until this one has rows of its own.
        const double pixels = static_cast<double>(width) * height;
        light_ms *= last_pixels > 0 ? pixels / last_pixels : 0;
        last_pixels = pixels;
        double first_ms = 0;
        double first_bytes = 0;
        for (const std::size_t count : {1u, 10u, 60u, 120u, 400u, 1000u}) {
            if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
            const std::string name = std::to_string(count) + (count == 1 ? " light, " : " lights, ") +
                                     std::to_string(width) + "x" + std::to_string(height);
            if (name.find(options.only) == std::string::npos) continue;
            const double expected_ms = first_ms + light_ms * static_cast<double>(count - 1);
            if (expected_ms * (1 + kFewestFrames) > options.row_seconds * 1000) {
                sink({"scale", name, {{"expected_ms", expected_ms}}, "skipped: longer than --row-seconds"});
                continue;
            }
            const double lights = static_cast<double>(count);
            ScaleRow all = measure(views, options, name, count, kAll);
            if (count == 1) first_ms = all.ms;
            if (count > 1) light_ms = std::max(all.ms - first_ms, 0.0) / (lights - 1);
            if (count == 1) first_bytes = all.other_bytes;
            const double fans = fan_bytes(*device, settings_of(kAll), count, *distances) / lights;
            all.row.figures.insert(
                all.row.figures.end(),
                {{"map_bytes_per_light", map_bytes},
                 {"fan_bytes_per_light", fans},
                 {"other_bytes_per_light", count > 1 ? (all.other_bytes - first_bytes) / (lights - 1)
                                                     : std::numeric_limits<double>::quiet_NaN()}});
            sink(all.row);
            const bool saves =
                width >= kSavingFromWidth &&
                std::find(kSavingLights.begin(), kSavingLights.end(), count) != kSavingLights.end();
            for (const Saving& saving : kSavings) {
                if (!saves) break;
                if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
                ScaleRow less = measure(views, options, name + saving.name, count, saving);
                less.row.figures.emplace_back("db", display_db(less.picture, all.picture));
                less.row.note += "; dB against every ray";
                sink(less.row);
            }
        }
    }
    return {};
}

} // namespace ghost::app
