// SPDX-License-Identifier: Apache-2.0
// Tables of the integrators: the thesis's scene with its numbers of samples, and thirteen views for gate,
// cone and march at their defaults, at equal error and at equal time.
#include "base/interrupt.h"
#include "bench/bench_views.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;
using render::Beams;

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr int kAirSamples = 2048;    // of the reference
constexpr int kMapSide = 2048;       // of the distance maps: what is compared is the integrator
constexpr int kMostSteps = 4096;     // of the search for equal error
constexpr double kMostSeconds = 1.0; // of the draws of one figure
constexpr int kFewestDraws = 3;

Error stopped() {
    return Error{"interrupted; the rows above are whole", ""};
}

// How a light's haze is found.
struct Way {
    Beams beams = Beams::gate;
    int samples = 0;   // of march and cone; 0: what the light has
    bool grid = false; // of gate: as the window draws what moves (render/haze/grid_pass.h)

    auto operator<=>(const Way&) const = default;
};

render::Settings haze_settings(const Way& way, bool surfaces) {
    render::Settings settings = bench_settings();
    settings.beams.beams = way.beams;
    settings.beams.march_steps = way.samples;
    settings.beams.grid = way.grid;
    settings.surfaces = surfaces;
    settings.reuse = false; // a light that stands still is drawn all the same
    settings.image_memory_bytes = 0;
    return settings;
}

// Median time of so many draws, of fewer where they are slow.
double draw_time_ms(render::Relighter& relighter, const shared::Light& light, int frames) {
    std::vector<double> ms;
    relighter.draw({light});
    const Clock::time_point start = Clock::now();
    for (int frame = 0; frame < frames; ++frame) {
        if (frame >= kFewestDraws &&
            std::chrono::duration<double>(Clock::now() - start).count() > kMostSeconds)
            break;
        ms.push_back(relighter.draw({light}).draw_ms);
    }
    return median(ms);
}

// Relighters of the stages without surfaces, made as they are needed: one for every number of march steps.
class HazeDrawer {
public:
    HazeDrawer(const gpu::Device& device, const BenchStages& stages)
        : device_(device), stages_(stages), gobos_(bench_gobos()) {}

    image::ImageF picture(const Way& way, const shared::Light& light) {
        render::Relighter& relighter = relighter_of(way);
        relighter.draw({with_samples(light, way.samples)});
        return relighter.frame();
    }
    // A draw of haze less a draw of nothing: what haze adds to a frame, on any device's clock.
    double haze_time_ms(const Way& way, const shared::Light& light, int frames) {
        if (!nothing_) {
            render::Settings settings = haze_settings({Beams::gate, 1}, false);
            settings.air = false;
            nothing_ = std::make_unique<render::Relighter>(device_, stages_.g_buffer(), &stages_.distances(),
                                                           gobos_, 1, settings);
        }
        const double with_ms = draw_time_ms(relighter_of(way), with_samples(light, way.samples), frames);
        return std::max(with_ms - draw_time_ms(*nothing_, light, frames), 0.0);
    }

private:
    static shared::Light with_samples(shared::Light light, int samples) {
        if (samples > 0) light.haze_samples = static_cast<std::uint32_t>(samples);
        return light;
    }
    render::Relighter& relighter_of(const Way& way) {
        std::unique_ptr<render::Relighter>& one =
            made_[{way.beams, way.beams == Beams::march ? way.samples : 0, way.grid}];
        if (!one) {
            one = std::make_unique<render::Relighter>(device_, stages_.g_buffer(), &stages_.distances(),
                                                      gobos_, 1, haze_settings(way, false));
            render::HazeQuality quality;
            quality.grid = way.grid;
            one->set_quality(quality);
        }
        return *one;
    }

    const gpu::Device& device_;
    const BenchStages& stages_;
    const shared::Gobos gobos_;
    std::map<Way, std::unique_ptr<render::Relighter>> made_;
    std::unique_ptr<render::Relighter> nothing_;
};

struct EqualError {
    double samples = kNever;
    double ms = kNever;
};

// The fewest samples, a power of two, that come as near to the reference as gate does.
Result<EqualError> equal_error(HazeDrawer& drawer, Beams beams, const shared::Light& light,
                               const References& references, double psnr_db, int frames) {
    for (int samples = 1; samples <= kMostSteps; samples *= 2) {
        if (interrupted()) return stopped();
        TRY(const Accuracy quality,
            accuracy_of(drawer.picture({beams, samples}, light), references.samples, references.counts));
        if (quality.psnr_db >= psnr_db)
            return EqualError{static_cast<double>(samples),
                              drawer.haze_time_ms({beams, samples}, light, frames)};
    }
    return EqualError{};
}

struct EqualTime {
    double samples = kNever;
    double ms = kNever;
    double psnr_db = kNever;
};

// As many samples as fit into the time, by a line through two measured times.
Result<EqualTime> equal_time(HazeDrawer& drawer, Beams beams, const shared::Light& light,
                             const References& references, double ms, int frames) {
    constexpr int kFew = 4, kMany = 64;
    const double few_ms = drawer.haze_time_ms({beams, kFew}, light, frames);
    const double many_ms = drawer.haze_time_ms({beams, kMany}, light, frames);
    const double sample_ms = std::max((many_ms - few_ms) / (kMany - kFew), 1e-6);
    const double samples = std::floor(kFew + (ms - few_ms) / sample_ms);
    if (samples < 1) return EqualTime{}; // not even one fits
    const int count = static_cast<int>(std::min(samples, double{kMostSteps}));
    TRY(const Accuracy quality,
        accuracy_of(drawer.picture({beams, count}, light), references.samples, references.counts));
    return EqualTime{static_cast<double>(count), drawer.haze_time_ms({beams, count}, light, frames),
                     quality.psnr_db};
}

Result<void> integrators_of_view(BenchStages& stages, std::size_t index, HazeDrawer& drawer, int frames,
                                 const BenchSink& sink) {
    const BenchView& view = stages.views()[index];
    TRY(const References references, reference_haze(view, stages.tracer(index), kAirSamples));
    stages.look(index); // every draw draws its light anew (Settings::reuse)
    const std::string note = "256x144, haze only, no shadows in the air";

    const auto gate_row = [&](bool grid) -> Result<std::pair<Accuracy, double>> {
        const Way way{Beams::gate, 0, grid};
        const double ms = drawer.haze_time_ms(way, view.light, frames);
        TRY(const Accuracy accuracy,
            accuracy_of(drawer.picture(way, view.light), references.gate, references.counts));
        sink({"integrators",
              view.name + (grid ? ": gate, as it moves" : ": gate"),
              {{"samples", kNever},
               {"ms", ms},
               {"psnr_db", accuracy.psnr_db},
               {"bias_percent", accuracy.bias_percent},
               {"compared_percent", accuracy.compared_percent}},
              "256x144, haze only, with shadows in the air, maps of 2048 texels"});
        return std::pair(accuracy, ms);
    };
    TRY(const auto gate_and_ms, gate_row(false));
    const auto& [gate, gate_ms] = gate_and_ms;
    TRY_VOID(gate_row(true));

    for (const Beams beams : {Beams::cone, Beams::march}) {
        if (interrupted()) return stopped();
        const int samples = beams == Beams::cone ? static_cast<int>(view.light.haze_samples)
                                                 : render::HazeIntegrator{}.march_steps;
        const double ms = drawer.haze_time_ms({beams, samples}, view.light, frames);
        TRY(const Accuracy quality,
            accuracy_of(drawer.picture({beams, samples}, view.light), references.samples, references.counts));
        TRY(const EqualError error, equal_error(drawer, beams, view.light, references, gate.psnr_db, frames));
        TRY(const EqualTime time, equal_time(drawer, beams, view.light, references, gate_ms, frames));
        sink({"integrators",
              view.name + (beams == Beams::cone ? ": cone" : ": march"),
              {{"samples", static_cast<double>(samples)},
               {"ms", ms},
               {"psnr_db", quality.psnr_db},
               {"bias_percent", quality.bias_percent},
               {"compared_percent", quality.compared_percent},
               {"equal_error_samples", error.samples},
               {"equal_error_ms", error.ms},
               {"equal_time_samples", time.samples},
               {"equal_time_ms", time.ms},
               {"equal_time_psnr_db", time.psnr_db}},
              note});
    }
    return {};
}

// The thesis, chapter 10.2; 35 to 40 with 110.
double thesis_fps(int steps) {
    switch (steps) {
    case 20:
        return 80;
    case 40:
        return 61;
    case 60:
        return 50;
    case 80:
        return 46;
    case 100:
        return 35;
    case 110:
        return 37.5;
    case 120:
        return 32;
    default:
        return kNever;
    }
}

} // namespace

Result<void> bench_thesis(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    BenchStages stages(*device, {thesis_view()}, kMapSide);
    const BenchView& view = stages.views()[0];
    TRY(const References references, reference_haze(view, stages.tracer(0), kAirSamples));
    const shared::Gobos gobos = bench_gobos();
    HazeDrawer drawer(*device, stages);
    struct Row {
        Beams beams;
        int steps;
    };
    for (const Row& row : {Row{Beams::march, 20}, Row{Beams::march, 40}, Row{Beams::march, 60},
                           Row{Beams::march, 80}, Row{Beams::march, 100}, Row{Beams::march, 110},
                           Row{Beams::march, 120}, Row{Beams::cone, 0}, Row{Beams::gate, 0}}) {
        if (interrupted()) return stopped();
        stages.look(0);
        render::Relighter relighter(*device, stages.g_buffer(), &stages.distances(), gobos, 1,
                                    haze_settings({row.beams, row.steps}, true));
        const double ms = draw_time_ms(relighter, view.light, options.frames);
        std::vector<double> moving; // the stage is drawn again in every frame, too
        for (int frame = 0; frame < std::min(options.frames, 10); ++frame) {
            const Clock::time_point start = Clock::now();
            stages.look(0, 0.001f * static_cast<float>(frame + 1));
            relighter.forget();
            relighter.draw({view.light});
            moving.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
        }
        const int samples = row.beams == Beams::gate   ? 0
                            : row.beams == Beams::cone ? static_cast<int>(view.light.haze_samples)
                                                       : row.steps;
        const double haze_ms = drawer.haze_time_ms({row.beams, samples}, view.light, options.frames);
        const bool gate = row.beams == Beams::gate;
        TRY(const Accuracy quality,
            accuracy_of(drawer.picture({row.beams, samples}, view.light),
                        gate ? references.gate : references.samples, references.counts));
        sink({"thesis",
              gate                       ? "gate"
              : row.beams == Beams::cone ? "cone, " + std::to_string(samples) + " samples"
                                         : "march, " + std::to_string(samples) + " steps",
              {{"ms", ms},
               {"fps", 1000 / ms},
               {"thesis_fps", row.beams == Beams::march ? thesis_fps(row.steps) : kNever},
               {"haze_ms", haze_ms},
               {"moving_camera_ms", median(moving)},
               {"haze_psnr_db", quality.psnr_db},
               {"haze_bias_percent", quality.bias_percent}},
              gate ? "256x256, one light, shadows in the air, map of 2048 texels"
                   : "256x256, one light, no shadows in the air"});
    }
    return {};
}

Result<void> bench_integrators(const BenchOptions& options, const BenchSink& sink) {
    catch_interrupts();
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    BenchStages stages(*device, bench_views(), kMapSide);
    HazeDrawer drawer(*device, stages);
    for (std::size_t view = 0; view < stages.views().size(); ++view) {
        if (interrupted()) return stopped();
        TRY_VOID(integrators_of_view(stages, view, drawer, std::min(options.frames, 12), sink));
    }
    return {};
}

} // namespace ghost::app
