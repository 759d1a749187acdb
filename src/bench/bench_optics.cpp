// SPDX-License-Identifier: Apache-2.0
// What each optic of a profile costs: ten moving beams of the fixture that has them all; ten lasers and an
// LED wall beside them; and 400 beams with nothing, a gobo and everything in the gate.
#include "base/interrupt.h"
#include "base/text.h"
#include "beam_groups/prism.h"
#include "bench/bench.h"
#include "fixture_files/common/laser_type.h"
#include "fixture_files/common/wall_type.h"
#include "fixture_files/gdtf/gdtf.h"
#include "light/frame_lights.h"
#include "light/laser_rays.h"
#include "light/led_wall_light.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace ghost::app {
namespace {

constexpr int kOpticsWarmUp = 3;
constexpr int kBeams = 10;
constexpr double kFrame_s = 0.04;
constexpr const char* kEverything = "gobos, iris, blades, animation wheel";
constexpr int kManyBeams = 400;
constexpr int kManySide = 256; // pixels of their picture
constexpr int kManyFrames = 5;

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
            {kEverything, all},
            {"prism of 8", split},
            {"prism of 8 and gobo", [=](Optics& o) { split(o), gobo(o); }}};
}

glm::mat4 place_of(int index, double seconds) {
    const shared::Light place = bench_light(index, 2, seconds);
    return {glm::vec4(place.axis_u, 0), glm::vec4(place.axis_v, 0), glm::vec4(-place.axis_w, 0),
            glm::vec4(place.position_m, 1)};
}

std::vector<shared::Light> lights_at(const fixture::Type& type, const fixture::BeamState& at_rest,
                                     const scene::GoboStack& gobos, int beams, double seconds) {
    std::vector<shared::Light> lights;
    scene::ProfileTable profiles;
    for (int k = 0; k < beams; ++k) {
        fixture::BeamState beam = at_rest;
        const auto turn = static_cast<float>(seconds * 40 + k * 30);
        for (fixture::WheelState& wheel : beam.optics.gobo_wheels)
            if (wheel.number == 2) wheel.gobo_deg = turn;
        for (fixture::Insert& disc : beam.optics.animations) disc.deg = turn;
        for (fixture::Insert& prism : beam.optics.prisms) prism.deg = turn;
        shared::Light light = scene::light_from(type, beam, place_of(k, seconds), gobos, profiles);
        light.pass = static_cast<std::uint32_t>(k);
        for (const scene::Copy& copy : scene::copies_of(type, beam.optics, scene::kMostCopies))
            lights.push_back(scene::copied(light, copy));
    }
    return lights;
}

int first_beam(const fixture::Type& type) {
    for (std::size_t k = 0; k < type.geometries.size(); ++k)
        if (type.geometries[k].beam) return static_cast<int>(k);
    return 0;
}

std::vector<shared::Light> lasers_at(const fixture::LaserCurve& figure, double seconds) {
    const std::shared_ptr<const fixture::Type> type = fixture::show_laser_type();
    fixture::BeamState beam;
    beam.geometry = first_beam(*type);
    beam.optics.dimmer = 1;
    beam.optics.zoom_deg = type->geometries[static_cast<std::size_t>(beam.geometry)].beam->field_angle_deg;
    std::vector<shared::Light> lights;
    scene::ProfileTable profiles;
    for (int k = 0; k < kBeams; ++k) {
        fixture::LaserCurve turned = figure;
        turned.deg = static_cast<float>(seconds * 40 + k * 30);
        shared::Light light = scene::light_from(*type, beam, place_of(k, seconds), {}, profiles);
        light.pass = static_cast<std::uint32_t>(k);
        if (fixture::is_swept(figure.kind)) {
            lights.push_back(scene::swept(light, turned));
            continue;
        }
        for (const scene::Copy& ray : scene::rays_of(turned, light.tan_field))
            lights.push_back(scene::copied(light, ray));
    }
    return lights;
}

// At the back of the stage, towards the house; all its cells change in every frame.
std::vector<shared::Light> wall_at(double seconds) {
    scene::LedWall wall;
    wall.size_m = {8, 4.5f};
    const glm::ivec2 cells = scene::cells_of(wall);
    const std::shared_ptr<const fixture::Type> type = fixture::led_wall_type(wall.size_m, cells, wall.nits);
    const glm::mat4 to_world(glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0), glm::vec4(0, 0, 1, 0),
                             glm::vec4(0, 8, 4, 1));
    std::vector<shared::Light> lights;
    scene::ProfileTable profiles;
    const fixture::State state = fixture::make_state({.name = "wall", .type = type.get(), .addresses = {}});
    for (std::size_t k = 0; k < state.beams.size(); ++k) {
        fixture::BeamState beam = state.beams[k];
        beam.optics.dimmer = 1;
        shared::Light light = scene::light_from(*type, beam, to_world * beam.to_fixture, {}, profiles);
        light.pass = static_cast<std::uint32_t>(k % kBeams);
        const auto share = static_cast<float>(0.5 + 0.4 * std::sin(seconds * 3 + static_cast<double>(k)));
        scene::light_cell(wall, glm::vec3(share, 0.5f, 1.0f - share), light);
        lights.push_back(light);
    }
    return lights;
}

struct OpticsMeasuring {
    const gpu::Device& device;
    const scene::Passes& passes;
    const shared::Gobos& gobos;
    int frames;
    const BenchSink& sink;
    double open_ms = 0; // of the first row
};

using LightsAt = std::function<std::vector<shared::Light>(double seconds)>;

void measure(const std::string& name, const LightsAt& lights_at, OpticsMeasuring& measured) {
    const std::size_t count = lights_at(0).size();
    render::Relighter relighter(measured.device, measured.passes, measured.gobos, static_cast<int>(count),
                                bench_settings());
    std::vector<double> frames, tables, rays, surfaces;
    std::clock_t begin = 0; // of the processor, all threads: what other programs do does not count
    for (int frame = 0; frame < measured.frames + kOpticsWarmUp; ++frame) {
        if (frame == kOpticsWarmUp) begin = std::clock();
        const render::FrameStatistics drawn = relighter.draw(lights_at(frame * kFrame_s));
        if (frame < kOpticsWarmUp) continue;
        frames.push_back(drawn.draw_ms);
        tables.push_back(span_ms(drawn, "fan"));
        rays.push_back(span_ms(drawn, "gate"));
        surfaces.push_back(span_ms(drawn, "surfaces"));
    }
    const double ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / measured.frames;
    if (measured.open_ms == 0) measured.open_ms = ms;
    measured.sink({"optics",
                   name,
                   {{"lights", static_cast<double>(count)},
                    {"frame_ms", median(frames)},
                    {"processor_ms", ms},
                    {"tables_ms", median(tables)},
                    {"rays_ms", median(rays)},
                    {"surfaces_ms", median(surfaces)},
                    {"times_open", ms / measured.open_ms}},
                   ""});
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
    Report report;
    const scene::GoboStack gobos = scene::build_gobos(show, report);
    const fixture::Type& type = *fixture.type;
    const scene::Passes passes = bench_passes(kPaperPictureWidth, kPaperPictureHeight, kBeams);
    fixture::BeamState open;
    open.geometry = first_beam(type);
    open.optics.dimmer = 1;
    open.optics.zoom_deg = 20;
    const auto beams_with = [&](const std::function<void(fixture::Optics&)>& set, int beams) -> LightsAt {
        fixture::BeamState beam = open;
        set(beam.optics);
        return [&type, &gobos, beam, beams](double seconds) {
            return lights_at(type, beam, gobos, beams, seconds);
        };
    };
    const std::vector<Row> rows = rows_of(type);
    OpticsMeasuring few{*device, passes, gobos.images, options.frames, sink};
    for (const Row& row : rows) {
        if (interrupted()) return {};
        measure(row.name, beams_with(row.set, kBeams), few);
    }
    using enum fixture::LaserCurveKind;
    const std::pair<const char*, fixture::LaserCurve> figures[] = {
        {"laser: beam", {.kind = beam}},
        {"laser: fan of 12", {.kind = fan, .count = 12, .size_deg = {60, 0}}},
        {"laser: line", {.kind = line, .size_deg = {60, 0}}},
        {"laser: circle", {.kind = circle, .size_deg = {20, 20}}},
        {"laser: wave", {.kind = wave, .count = 3, .size_deg = {40, 10}}}};
    for (const auto& [name, figure] : figures) {
        if (interrupted()) return {};
        measure(
            name, [&figure = figure](double seconds) { return lasers_at(figure, seconds); }, few);
    }
    measure("one LED wall of 8 x 4.5 m", wall_at, few);

    // How many: that of all optics beside plain beams.
    const scene::Passes many_passes = bench_passes(kManySide, kManySide, kManyBeams);
    OpticsMeasuring many{*device, many_passes, gobos.images, std::min(options.frames, kManyFrames), sink};
    for (const Row& row : rows) {
        const std::string name = row.name;
        if (interrupted()) return {};
        if (name == "open" || name == "one gobo" || name == kEverything)
            measure("400 beams: " + name, beams_with(row.set, kManyBeams), many);
    }
    return {};
}

} // namespace ghost::app
