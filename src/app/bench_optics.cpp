// SPDX-License-Identifier: Apache-2.0
// What each optic of a profile costs: ten moving beams of the fixture that has them all.
#include "app/bench.h"
#include "app/interrupt.h"
#include "fixture/gdtf.h"
#include "scene/lit.h"
#include "scene/prism.h"
#include "scene/show.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>

namespace ghost::app {
namespace {

constexpr int kWidth = 1024; // the paper's picture
constexpr int kHeight = 300;
constexpr int kWarmUp = 3;
constexpr int kBeams = 10;
constexpr double kFrame_s = 0.04;

int wheel_of(const fixture::Type& type, const std::string& name) {
    for (std::size_t k = 0; k < type.wheels.size(); ++k)
        if (type.wheels[k].name == name) return static_cast<int>(k);
    return -1;
}

struct Row {
    const char* name;
    std::function<void(fixture::Optics&)> set;
};

std::vector<Row> rows_of(const fixture::Type& type) {
    using fixture::Optics;
    const int gobos = wheel_of(type, "Static gobos"), turning = wheel_of(type, "Rotating gobos");
    const int disc = wheel_of(type, "Animation wheel"), prism = wheel_of(type, "Prism 1");
    const auto gobo = [=](Optics& o) {
        o.gobo_wheels.push_back({.wheel = gobos, .number = 1, .position = 1});
    };
    const auto second = [=](Optics& o) {
        o.gobo_wheels.push_back({.wheel = turning, .number = 2, .position = 1});
    };
    const auto iris = [](Optics& o) { o.iris = 0.7f; };
    const auto blades = [](Optics& o) {
        o.blades = {{0.3f, 0.2f}, {0.2f, 0.3f}, {0.2f, 0.2f}, {0.3f, 0.3f}};
    };
    const auto animation = [=](Optics& o) {
        o.animations = {{.number = 1, .wheel = disc, .slot = 0, .in = 1}};
    };
    const auto frost = [](Optics& o) {
        o.frost = 1;
        o.frost_full_deg = 3;
    };
    const auto split = [=](Optics& o) { o.prisms = {{.number = 1, .wheel = prism, .slot = 2, .in = 1}}; };
    const auto all = [=](Optics& o) {
        for (const auto& set : {std::function<void(Optics&)>(gobo), {second}, {iris}, {blades}, {animation}})
            set(o);
    };
    return {{"open", [](Optics&) {}},
            {"one gobo", gobo},
            {"two gobos in two planes", [=](Optics& o) { gobo(o), second(o); }},
            {"gobo and iris", [=](Optics& o) { gobo(o), iris(o); }},
            {"blades", blades},
            {"blades and gobo", [=](Optics& o) { blades(o), gobo(o); }},
            {"animation wheel", animation},
            {"frost", frost},
            {"gobos, iris, blades, animation wheel", all},
            {"prism of 8", split},
            {"prism of 8 and gobo", [=](Optics& o) { split(o), gobo(o); }}};
}

std::vector<shared::Light> lights_at(const fixture::Type& type, const fixture::BeamState& at_rest,
                                     const scene::GoboStack& gobos, double seconds) {
    std::vector<shared::Light> lights;
    scene::ProfileTable profiles;
    for (int k = 0; k < kBeams; ++k) {
        fixture::BeamState beam = at_rest;
        const auto turn = static_cast<float>(seconds * 40 + k * 30);
        for (fixture::WheelState& wheel : beam.optics.gobo_wheels)
            if (wheel.number == 2) wheel.gobo_deg = turn;
        for (fixture::Insert& disc : beam.optics.animations) disc.deg = turn;
        for (fixture::Insert& prism : beam.optics.prisms) prism.deg = turn;
        const shared::Light place = bench_light(k, 2, seconds);
        const glm::mat4 to_world(glm::vec4(place.axis_u, 0), glm::vec4(place.axis_v, 0),
                                 glm::vec4(-place.axis_w, 0), glm::vec4(place.position_m, 1));
        shared::Light light = scene::light_from(type, beam, to_world, gobos, profiles);
        light.pass = static_cast<std::uint32_t>(k);
        for (const scene::Copy& copy : scene::copies_of(type, beam.optics, scene::kMostCopies))
            lights.push_back(scene::copied(light, copy));
    }
    return lights;
}

} // namespace

Result<void> bench_optics(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    const std::filesystem::path file =
        std::filesystem::path(options.show) / "../fixtures/Ghostlight@Optics_Profile.gdtf";
    TRY(fixture::LoadedType loaded, fixture::load_gdtf(file));
    scene::Show show;
    scene::PatchedFixture fixture;
    fixture.type = std::make_shared<const fixture::Type>(std::move(loaded.type));
    show.fixtures.push_back(fixture);
    scene::Report report;
    const scene::GoboStack gobos = scene::build_gobos(show, report);
    const fixture::Type& type = *fixture.type;
    const scene::Passes passes = bench_passes(kWidth, kHeight, kBeams);
    fixture::BeamState open;
    for (std::size_t k = 0; k < type.geometries.size(); ++k)
        if (type.geometries[k].beam) open.geometry = static_cast<int>(k);
    open.optics.dimmer = 1;
    open.optics.zoom_deg = 20;
    double open_ms = 0;
    for (const Row& row : rows_of(type)) {
        if (interrupted()) return {};
        fixture::BeamState beam = open;
        row.set(beam.optics);
        const std::size_t count = lights_at(type, beam, gobos, 0).size();
        render::Relighter relighter(*device, passes, gobos.images, static_cast<int>(count), bench_settings());
        std::vector<double> frames, tables, rays, surfaces;
        std::clock_t begin = 0; // of the processor, all threads: what other programs do does not count
        for (int frame = 0; frame < options.frames + kWarmUp; ++frame) {
            if (frame == kWarmUp) begin = std::clock();
            const render::FrameStatistics drawn =
                relighter.draw(lights_at(type, beam, gobos, frame * kFrame_s));
            if (frame < kWarmUp) continue;
            frames.push_back(drawn.draw_ms);
            tables.push_back(span_ms(drawn, "fan"));
            rays.push_back(span_ms(drawn, "gate"));
            surfaces.push_back(span_ms(drawn, "surfaces"));
        }
        const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / options.frames;
        if (open_ms == 0) open_ms = ms;
        sink({"optics",
              row.name,
              {{"lights", static_cast<double>(count)},
               {"frame_ms", median(frames)},
               {"processor_ms", ms},
               {"tables_ms", median(tables)},
               {"rays_ms", median(rays)},
               {"surfaces_ms", median(surfaces)},
               {"times_open", ms / open_ms}},
              ""});
    }
    return {};
}

} // namespace ghost::app
