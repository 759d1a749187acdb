// SPDX-License-Identifier: Apache-2.0
// Table of many lights: up to 1000 moving heads over a stage hung as tools/make_festival.py hangs it, the
// geometry reduced to boxes.
#include "base/interrupt.h"
#include "bench/bench_views.h"
#include "render/haze/haze_pass.h"
#include "shared/push.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;
using glm::vec3;

constexpr std::size_t kMostLights = 1000;
constexpr int kFewestFrames = 2; // frames measured of a slow row

struct Place {
    vec3 position_m{0};
    bool stands = false; // on the floor, light goes up
};

void add_line(std::vector<Place>& places, const vec3& from_m, const vec3& to_m, int count, bool stands) {
    for (int i = 0; i < count; ++i)
        places.push_back(
            {glm::mix(from_m, to_m, static_cast<float>(i) / static_cast<float>(count - 1)), stands});
}

// Ten trusses in double rows, floor rows, ladders, wings, delay towers, a grid beside the wall: 1000 places,
// after tools/festival/layout.py.
std::vector<Place> festival_places() {
    std::vector<Place> places;
    for (int line = 0; line < 10; ++line) {
        const float share = static_cast<float>(line) / 9;
        const float z = 11.0f - 2.9f * share;
        for (const float side : {-0.22f, 0.22f}) {
            const float y = 0.5f + 10.9f * share + side;
            add_line(places, {-11.6f, y, z}, {11.6f, y, z}, 30, false);
        }
    }
    for (const float y : {11.9f, 12.3f}) add_line(places, {-11.3f, y, 2}, {11.3f, y, 2}, 40, true);
    add_line(places, {-13, -1.1f, 0.2f}, {13, -1.1f, 0.2f}, 50, true);
    add_line(places, {-7, 12.5f, 8.1f}, {7, 12.5f, 8.1f}, 26, false);
    for (const float side : {-1.0f, 1.0f}) {
        for (const float y : {3.0f, 10.0f})
            add_line(places, {side * 12.55f, y, 3.4f}, {side * 12.55f, y, 9.4f}, 12, false);
        for (const float y : {0.4f, 0.8f})
            add_line(places, {side * 14.6f, y, 9.3f}, {side * 20.4f, y, 9.3f}, 11, false);
        add_line(places, {side * 5.4f, 0.6f, 2}, {side * 11.5f, 0.6f, 2}, 12, true);
        add_line(places, {side * 6.8f, 8.6f, 2}, {side * 11.4f, 8.6f, 2}, 9, true);
        for (const float z : {5.8f, 7.3f})
            add_line(places, {side * 16, -43.1f, z}, {side * 16, -44.9f, z}, 4, false);
        for (const float x : {7.9f, 9.2f, 10.5f})
            add_line(places, {side * x, 12.4f, 2.9f}, {side * x, 12.4f, 8.2f}, 9, false);
    }
    while (places.size() < kMostLights) // what is left hangs over the apron
        places.push_back({{-11.0f + 0.55f * static_cast<float>(places.size() % 41), -0.6f, 11.2f}, false});
    places.resize(kMostLights);
    return places;
}

scene::Stage festival_stage() {
    scene::Stage stage = empty_stage();
    add_box(stage, {-60, -70, -0.2f}, {60, 40, 0});                // ground
    add_box(stage, {-12, 0, 0}, {12, 14, 1.8f});                   // deck
    add_box(stage, {-7, 12.9f, 2.6f}, {7, 13.2f, 7.6f});           // LED wall
    add_box(stage, {-13, 14, 1.8f}, {13, 14.1f, 13});              // cloth
    add_box(stage, {-13.6f, -0.5f, 13.4f}, {13.6f, 14.5f, 13.6f}); // roof
    for (int line = 0; line < 10; ++line) {
        const float share = static_cast<float>(line) / 9;
        const float y = 0.5f + 10.9f * share, z = 11.3f - 2.9f * share;
        for (const float low : {0.0f, 0.3f})
            for (const float side : {-0.15f, 0.15f})
                add_box(stage, {-12, y + side - 0.03f, z + low}, {12, y + side + 0.03f, z + low + 0.06f});
    }
    for (const float side : {-1.0f, 1.0f}) {
        for (const float y : {0.0f, 14.0f})
            add_box(stage, {side * 13.4f - 0.3f, y - 0.3f, 0}, {side * 13.4f + 0.3f, y + 0.3f, 13.4f});
        add_box(stage, {side * 17.5f - 0.7f, -0.2f, 4}, {side * 17.5f + 0.7f, 1.4f, 9}); // line array
        add_box(stage, {side * 16 - 0.3f, -44.3f, 0}, {side * 16 + 0.3f, -43.7f, 9});    // delay tower
    }
    for (int k = 0; k < 24; ++k) { // band, risers and wedges
        const float x = -9.0f + 3.6f * static_cast<float>(k % 6);
        const float y = 1.5f + 2.6f * static_cast<float>(k / 6);
        add_box(stage, {x - 0.4f, y - 0.3f, 1.8f},
                {x + 0.4f, y + 0.3f, 2.3f + 0.3f * static_cast<float>(k % 4)});
        add_ball(stage, {x, y, 3.6f}, 0.2f);
    }
    for (int k = 0; k < 400; ++k) { // crowd
        const float x = -14.0f + 0.72f * static_cast<float>(k % 40) + 0.3f * static_cast<float>(k / 40 % 2);
        const float y = -3.0f - 1.4f * static_cast<float>(k / 40);
        add_box(stage, {x - 0.2f, y - 0.15f, 0},
                {x + 0.2f, y + 0.15f, 1.5f + 0.05f * static_cast<float>(k % 7)});
    }
    return stage;
}

// Three spots to one wash; every other spot has a gobo. All heads turn.
shared::Light festival_light(std::size_t index, const Place& place, double seconds) {
    const auto phase = static_cast<float>(seconds * 0.9 + 0.37 * static_cast<double>(index));
    const float up = place.stands ? 1.0f : -1.0f;
    const vec3 way(0.7f * std::sin(phase), -0.45f + 0.5f * std::cos(0.7f * phase), up);
    const bool wash = index % 4 == 3;
    shared::Light light = aimed_light(place.position_m, place.position_m + way, wash ? 28.0f : 11.0f, !wash);
    light.intensity_cd *= 0.5f + 0.5f * vec3(std::sin(phase), std::sin(phase + 2), std::sin(phase + 4));
    if (!wash && index % 2 == 0) {
        light.wheel[light.wheel_count++] = {1, 0, 0.0f, std::cos(2 * phase), std::sin(2 * phase), 0.0f};
        light.haze_samples = 10;
    }
    light.map = static_cast<std::uint32_t>(index + 1);
    return light;
}

// Of the 1000 places evenly so many.
std::vector<shared::Light> festival_lights(const std::vector<Place>& places, std::size_t count,
                                           double seconds) {
    std::vector<shared::Light> lights;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = count == 1 ? 15 : i * places.size() / count;
        lights.push_back(festival_light(index, places[index], seconds));
    }
    return lights;
}

struct Measured {
    double ms = 0;
    int frames = 0;
    double haze_tiles = 0, surface_tiles = 0;             // of the last frame
    double spans_ms = 0;                                  // all of them
    double dispatches = 0, barriers = 0, submissions = 0; // of the last frame
    std::vector<std::pair<std::string, double>> passes;
};

// As many frames as fit into the time, two at least.
Measured measure_frames(const gpu::Device& device, render::Relighter& relighter,
                        const std::vector<Place>& places, std::size_t count, int frames, double seconds) {
    const std::vector<std::string> names{"cull",     "fan", "gate",    "visibility",
                                         "surfaces", "add", "develop", "read back"};
    std::vector<double> ms;
    std::vector<std::vector<double>> passes(names.size());
    std::vector<double> spans;
    double haze_tiles = 0, surface_tiles = 0;
    gpu::RecordedWork before;
    const Clock::time_point start = Clock::now();
    relighter.draw(festival_lights(places, count, 0));
    while (static_cast<int>(ms.size()) < frames) {
        const double spent = std::chrono::duration<double>(Clock::now() - start).count();
        if (static_cast<int>(ms.size()) >= kFewestFrames && spent > seconds) break;
        before = device.work();
        const render::FrameStatistics drawn =
            relighter.draw(festival_lights(places, count, 0.1 * static_cast<double>(ms.size() + 1)));
        ms.push_back(drawn.draw_ms);
        haze_tiles = drawn.haze_tiles;
        surface_tiles = drawn.surface_tiles;
        spans.push_back(0);
        for (const gpu::Span& span : drawn.spans) spans.back() += span.ms;
        // A frame of more passes than the device's clock has room for counts the rest as one.
        const bool whole = !drawn.spans.empty() && drawn.spans.back().name == "read back";
        for (std::size_t k = 0; k < names.size(); ++k) {
            double sum = span_ms(drawn, names[k]);
            if (names[k] == "add") sum += span_ms(drawn, "clear") + span_ms(drawn, "fold");
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
    render::Settings settings = bench_settings();
    settings.image_memory_bytes = 0; // every light changes in every frame: nothing to keep
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
                      {vec3(0), settings.haze});
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
            render::Relighter relighter(*device, g_buffer, distances.get(), gobos, static_cast<int>(count),
                                        settings);
            const Measured measured =
                measure_frames(*device, relighter, places, count, std::min(options.frames, 20),
                               std::min(options.row_seconds, 3.0));
            const double lights = static_cast<double>(count);
            if (count == 1) first_ms = measured.ms;
            if (count > 1) light_ms = std::max(measured.ms - first_ms, 0.0) / (lights - 1);
            // The table's lights share the maps of all 1000: a show of so many has as many maps.
            const double other_bytes = static_cast<double>(relighter.memory_bytes()) -
                                       map_bytes * static_cast<double>(places.size());
            if (count == 1) first_bytes = other_bytes;
            const double fans = fan_bytes(*device, settings, count, *distances) / lights;
            BenchRow row{"scale", name, {{"ms", measured.ms}}, std::to_string(measured.frames) + " frames"};
            row.figures.insert(row.figures.end(), measured.passes.begin(), measured.passes.end());
            row.figures.insert(
                row.figures.end(),
                {{"device_ms", measured.spans_ms},
                 {"dispatches", measured.dispatches},
                 {"barriers", measured.barriers},
                 {"submissions", measured.submissions},
                 {"million_rays", measured.haze_tiles * shared::kTilePixels / 1e6},
                 {"million_points", measured.surface_tiles * shared::kTilePixels / 1e6},
                 {"ms_per_light", measured.ms / lights},
                 {"device_mb", (other_bytes + map_bytes * lights) / 1e6},
                 {"map_bytes_per_light", map_bytes},
                 {"fan_bytes_per_light", fans},
                 {"other_bytes_per_light", count > 1 ? (other_bytes - first_bytes) / (lights - 1)
                                                     : std::numeric_limits<double>::quiet_NaN()}});
            sink(row);
        }
    }
    return {};
}

} // namespace ghost::app
