// SPDX-License-Identifier: Apache-2.0
// Tables of the relighter: cost of a sample, the paper's scene, the binary tree.
#include "base/interrupt.h"
#include "bench/bench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRelightWarmUp = 4;
constexpr int kComparedMoments = 4, kToNextMoment = 12; // frames

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// A light that fills the picture: every pixel takes every sample.
shared::Light filling_light(std::uint32_t wheels, std::uint32_t samples, double seconds) {
    shared::Light light = bench_light(0, wheels, 0);
    light.position_m = glm::vec3(0.0f, -30.0f, 4.0f);
    light.axis_w = glm::vec3(0, 1, 0);
    const auto turn = static_cast<float>(0.01 * seconds);
    light.axis_u = glm::vec3(std::cos(turn), 0, std::sin(turn));
    light.axis_v = glm::cross(light.axis_u, light.axis_w);
    light.tan_field = 1.5f;
    light.haze_samples = samples;
    return light;
}

// 16 bit pan and tilt, 8 bit others: every channel that makes a VL2500 do all it can, moving.
void set_spot(dmx::Levels& levels, int address, double seconds, int index) {
    const auto at = [&](int channel) -> std::uint8_t& {
        return levels[static_cast<std::size_t>(address + channel - 2)];
    };
    const auto swing = [&](double middle, double width, double speed) {
        return static_cast<int>(std::lround(middle + width * std::sin(seconds * speed + index)));
    };
    const int pan = swing(32768, 5000, 1.1);
    const int tilt = swing(index < 3 ? 28000 : 39000, 3000, 0.9);
    at(1) = 255;
    at(2) = static_cast<std::uint8_t>(pan >> 8);
    at(3) = static_cast<std::uint8_t>(pan & 255);
    at(4) = static_cast<std::uint8_t>(tilt >> 8);
    at(5) = static_cast<std::uint8_t>(tilt & 255);
    at(6) = static_cast<std::uint8_t>(swing(100, 90, 0.7));
    at(8) = static_cast<std::uint8_t>(swing(100, 90, 0.5));
    at(10) = 128;
    at(12) = static_cast<std::uint8_t>(swing(100, 40, 0.6));
    at(13) = 72;       // a fixed gobo
    at(14) = 128 + 18; // a rotating one, turning
    at(15) = 60;
    at(17) = 255;
    for (int channel = 18; channel <= 21; ++channel) at(channel) = 0;
}

void set_wash(dmx::Levels& levels, int address, double seconds, int index) {
    const auto at = [&](int channel) -> std::uint8_t& {
        return levels[static_cast<std::size_t>(address + channel - 2)];
    };
    const auto swing = [&](double middle, double width, double speed) {
        return static_cast<int>(std::lround(middle + width * std::sin(seconds * speed + index)));
    };
    const int pan = swing(32768, 4000, 0.8);
    const int tilt = swing(38000, 3000, 1.2);
    at(1) = 255;
    at(2) = static_cast<std::uint8_t>(pan >> 8);
    at(3) = static_cast<std::uint8_t>(pan & 255);
    at(4) = static_cast<std::uint8_t>(tilt >> 8);
    at(5) = static_cast<std::uint8_t>(tilt & 255);
    at(6) = static_cast<std::uint8_t>(swing(120, 100, 0.9));
    at(7) = static_cast<std::uint8_t>(swing(100, 90, 0.4));
    at(10) = static_cast<std::uint8_t>(swing(90, 40, 0.5));
}

dmx::Universes all_moving(const scene::Show& show, double seconds, const std::vector<bool>& moves) {
    auto levels = std::make_shared<dmx::Levels>();
    levels->fill(0);
    for (std::size_t i = 0; i < show.fixtures.size(); ++i) {
        const scene::PatchedFixture& fixture = show.fixtures[i];
        if (!fixture.type || fixture.universe != 1) continue;
        const bool spot = fixture.type->modes[static_cast<std::size_t>(fixture.mode)].channels.size() > 15;
        const double t = moves[i] ? seconds : 2.0;
        if (spot)
            set_spot(*levels, fixture.address, t, static_cast<int>(i));
        else
            set_wash(*levels, fixture.address, t, static_cast<int>(i));
    }
    dmx::Universes universes;
    dmx::Universe& universe = universes.at(1);
    universe.levels = std::move(levels);
    return universes;
}

} // namespace

Result<void> bench_samples(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    const scene::Passes passes = bench_passes(kPaperPictureWidth, kPaperPictureHeight, 1);
    const shared::Gobos gobos = bench_gobos();
    const double pixels = kPaperPictureWidth * kPaperPictureHeight;
    double simple_surface_ns = 0;
    render::Settings settings = bench_settings();
    settings.beams.beams = render::Beams::cone; // the paper's, whose table this is
    for (const std::uint32_t wheels : {0u, 1u, 2u}) {
        render::Relighter relighter(*device, passes, gobos, 1, settings);
        // Two sample counts: their difference is the cost of samples alone, without what is paid once a
        // pixel.
        const std::uint32_t few = 4;
        const std::uint32_t many = 36;
        std::vector<double> surface, haze_few, haze_many, haze_paper;
        const std::uint32_t paper_samples = wheels == 0 ? 4 : 10;
        for (int frame = 0; frame < options.frames + kRelightWarmUp; ++frame) {
            for (const std::uint32_t samples : {few, many, paper_samples}) {
                const render::FrameStatistics drawn =
                    relighter.draw({filling_light(wheels, samples, frame * 3.0 + samples)});
                if (frame < kRelightWarmUp) continue;
                const double ms = span_ms(drawn, "haze");
                (samples == many ? haze_many : samples == few ? haze_few : haze_paper).push_back(ms);
                if (samples == paper_samples && wheels == 0 && samples == few) haze_paper.push_back(ms);
                surface.push_back(span_ms(drawn, "surfaces"));
            }
        }
        const double surface_ns = median(surface) * 1e6 / pixels;
        const double sample_ns = (median(haze_many) - median(haze_few)) * 1e6 / pixels / (many - few);
        if (wheels == 0) simple_surface_ns = surface_ns;
        const double haze_ns = median(haze_paper) * 1e6 / pixels;
        const char* names[] = {"simple light", "gobo light, one wheel", "gobo light, two wheels"};
        sink({"samples",
              names[wheels],
              {{"surface_ns", surface_ns},
               {"haze_sample_ns", sample_ns},
               {"march_steps", static_cast<double>(paper_samples)},
               {"haze_ns", haze_ns},
               {"total_ns", surface_ns + haze_ns},
               {"relative_total", (surface_ns + haze_ns) / simple_surface_ns},
               {"paper_relative_total", wheels == 0 ? 5.0 : 16.5}},
              "per pixel that the light fills"});
    }
    return {};
}

// cases: name, and how many of the fixtures change. as_window: as the window draws a baked camera while
// things move; then also how near that is to the same moments at rest.
Result<void> paper_rows(const BenchOptions& options, render::Beams beams, bool as_window,
                        const std::vector<std::pair<std::string, std::size_t>>& cases,
                        const BenchSink& sink) {
    SessionOptions opening;
    opening.show = options.show;
    opening.device = options.device;
    opening.quiet = true;
    opening.workers = true;
    opening.beams.beams = beams;
    opening.beams.grid = as_window;
    TRY(const std::unique_ptr<Session> session, open_session(opening));
    const render::HazeQuality at_rest;
    render::HazeQuality moving;
    moving.grid = as_window;
    session->relighter->set_quality(moving);
    const std::size_t fixtures = session->show->fixtures.size();
    for (const auto& [name, changing] : cases) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        std::vector<bool> moves(fixtures, false);
        std::fill_n(moves.begin(), std::min(changing, fixtures), true);
        std::vector<double> total, draw, haze, surfaces, add, develop;
        int drawn = 0;
        int additions = 0;
        // A gobo that turns is a change, too: in "none" and "one" the others stand still.
        const std::vector<shared::Light> still = [&] {
            session->rig->step(all_moving(*session->show, 2.0, moves), 0.02);
            return session->rig->lights(session->gobos, session->passes);
        }();
        const auto lights_of = [&](int frame) {
            session->rig->step(all_moving(*session->show, 2.0 + frame / 44.0, moves), 1.0 / 44.0);
            std::vector<shared::Light> lights = session->rig->lights(session->gobos, session->passes);
            for (std::size_t i = 0; i < lights.size(); ++i)
                if (i >= moves.size() || !moves[i]) lights[i] = still[i];
            return lights;
        };
        const int frames = options.frames + kRelightWarmUp;
        for (int frame = 0; frame < frames; ++frame) {
            const Clock::time_point start = Clock::now();
            const std::vector<shared::Light> lights = lights_of(frame);
            const render::FrameStatistics statistics = session->relighter->draw(lights);
            if (frame < kRelightWarmUp) continue;
            total.push_back(ms_since(start));
            draw.push_back(statistics.draw_ms);
            haze.push_back(haze_ms(statistics));
            surfaces.push_back(span_ms(statistics, "surfaces"));
            add.push_back(span_ms(statistics, "add") + span_ms(statistics, "clear"));
            develop.push_back(span_ms(statistics, "develop") + span_ms(statistics, "meter") +
                              span_ms(statistics, "read back"));
            drawn = std::max(drawn, statistics.drawn);
            additions = std::max(additions, statistics.additions);
        }
        BenchRow row{"paper",
                     name,
                     {{"lights", static_cast<double>(still.size())},
                      {"ms", median(total)},
                      {"best_ms", *std::min_element(total.begin(), total.end())},
                      {"draw_ms", median(draw)},
                      {"haze_ms", median(haze)},
                      {"surfaces_ms", median(surfaces)},
                      {"add_ms", median(add)},
                      {"develop_ms", median(develop)},
                      {"lights_drawn", static_cast<double>(drawn)},
                      {"additions", static_cast<double>(additions)}},
                     std::to_string(session->relighter->width()) + "x" +
                         std::to_string(session->relighter->height()) + ", DMX to image"};
        double db = std::numeric_limits<double>::infinity();
        for (int k = 1; as_window && k <= kComparedMoments; ++k) {
            const std::vector<shared::Light> lights = lights_of(frames + k * kToNextMoment);
            (void)session->relighter->draw(lights);
            const image::ImageF shown = session->relighter->frame();
            session->relighter->set_quality(at_rest);
            (void)session->relighter->draw(lights);
            db = std::min(db, display_db(shown, session->relighter->frame()));
            session->relighter->set_quality(moving);
        }
        if (as_window) row.figures.push_back({"least_db", db});
        sink(row);
    }
    return {};
}

Result<void> bench_paper(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    constexpr std::size_t kAll = 1u << 20;
    TRY_VOID(paper_rows(options, render::Beams::gate, false,
                        {{"all changing", kAll}, {"one changing", 1}, {"none changing", 0}}, sink));
    TRY_VOID(paper_rows(options, render::Beams::gate, true,
                        {{"all changing, as in the window", kAll}, {"one changing, as in the window", 1}},
                        sink));
    return paper_rows(options, render::Beams::cone, false, {{"all changing, cone", kAll}}, sink);
}

Result<void> bench_tree(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    constexpr int kPasses = 8; // shared by the lights: memory of the passes is not what is measured
    const scene::Passes passes = bench_passes(kPaperPictureWidth, kPaperPictureHeight, kPasses);
    const shared::Gobos gobos = bench_gobos();
    for (const int count : {1, 2, 8, 32, 128, 512}) {
        render::Relighter relighter(*device, passes, gobos, count, bench_settings());
        std::vector<shared::Light> lights;
        for (int i = 0; i < count; ++i) {
            lights.push_back(bench_light(i, 0, i));
            lights.back().pass = static_cast<std::uint32_t>(i % kPasses);
        }
        const render::FrameStatistics first = relighter.draw(lights);
        int most_additions = 0;
        std::vector<double> same, other, other_additions;
        const int frames = std::min(options.frames, 12);
        for (int frame = 0; frame < frames; ++frame) { // the same light again and again
            lights[0] = bench_light(0, 0, 0.1 * (frame + 1));
            const render::FrameStatistics drawn = relighter.draw(lights);
            if (frame >= kRelightWarmUp) same.push_back(drawn.draw_ms);
            if (frame == 0) most_additions = drawn.additions;
        }
        for (int frame = 0; frame < frames; ++frame) { // every time another one
            const auto i = static_cast<std::size_t>((frame * 37 + 1) % count);
            const std::uint32_t pass = lights[i].pass;
            lights[i] = bench_light(static_cast<int>(i), 0, 50.0 + frame);
            lights[i].pass = pass;
            const render::FrameStatistics drawn = relighter.draw(lights);
            other.push_back(drawn.draw_ms);
            other_additions.push_back(drawn.additions);
        }
        sink({"tree",
              std::to_string(count) + " lights",
              {{"first_frame_ms", first.draw_ms},
               {"additions_first_change", static_cast<double>(most_additions)},
               {"ceil_log2", std::ceil(std::log2(static_cast<double>(count)))},
               {"same_light_ms", median(same)},
               {"other_light_ms", median(other)},
               {"other_light_additions", median(other_additions)},
               {"image_memory_mb", static_cast<double>(relighter.memory_bytes()) / 1e6}},
              "one light changing"});
    }
    return {};
}

} // namespace ghost::app
