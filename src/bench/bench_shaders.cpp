// SPDX-License-Identifier: Apache-2.0
// What a driver's compiler made of the shaders of a live picture. Another device than the one that draws may
// be asked, for some can compile and not draw: RADV_FORCE_FAMILY=navi21 makes Mesa's driver for AMD compile
// for hardware that is not there.
#include "bench/bench.h"

#include "dmx/record/player.h"
#include "dmx/record/recording_tasks.h"
#include "gpu/commands.h"
#include "gpu/pipelines.h"

namespace ghost::app {
namespace {

constexpr double kShaderStepFps = 15;
constexpr int kShaderWidth = 320, kShaderHeight = 180; // pixels: shaders are the same at any size

// Draws with the qualities of rest and of motion, with passes and with the free camera.
Result<std::vector<gpu::PipelineMade>> pipelines_drawn_with(const BenchOptions& options,
                                                            const std::string& device) {
    std::vector<gpu::PipelineMade> all;
    for (const bool live : {true, false}) {
        SessionOptions opening;
        opening.show = options.show;
        opening.device = device;
        opening.view = live ? "close" : "";
        if (live) opening.width = kShaderWidth, opening.height = kShaderHeight;
        opening.live = live;
        opening.quiet = true;
        opening.beams.grid = live;
        opening.beams.most_wide_step = live ? 2 : 1;
        opening.pipeline_statistics = true;
        opening.lights_per_dispatch = options.lights_per_dispatch;
        opening.pixels_on_processor = false; // all of them
        TRY(const std::unique_ptr<Session> session, open_session(opening));
        TRY(dmx::Recording recording, dmx::open_recording(session->show->recording, {}, true));
        dmx::Player player(std::move(recording));
        for (int frame = 0; frame < 12; ++frame) {
            session->rig->step(player.at(20 + frame / kShaderStepFps), 1 / kShaderStepFps);
            if (live) {
                render::HazeQuality quality;
                quality.grid = frame % 3 == 1;
                quality.wide_beam_step = frame % 3 == 2 ? 2 : 1;
                session->relighter->set_quality(quality);
                session->use_coarse_light(frame > 7);
            }
            (void)session->draw(frame / kShaderStepFps);
        }
        const std::vector<gpu::PipelineMade> made = session->device->pipelines().made();
        all.insert(all.end(), made.begin(), made.end());
    }
    return all;
}

} // namespace

Result<void> bench_shaders(const BenchOptions& options, const BenchSink& sink) {
    const bool other = !options.compile_for.empty();
    TRY(std::vector<gpu::PipelineMade> all, pipelines_drawn_with(options, options.device));
    if (other) {
        TRY(const std::unique_ptr<gpu::Device> device,
            gpu::Device::create({.name = options.compile_for, .pipeline_statistics = true}));
        for (const gpu::PipelineMade& one : all)
            if (!one.is_raster) (void)gpu::Program(*device, one.shader, one.constants);
        all = device->pipelines().made();
    }
    for (const gpu::PipelineMade& one : all) {
        std::string name(one.shader.name);
        for (const std::uint32_t constant : one.constants) name += ' ' + std::to_string(constant);
        BenchRow row{"shaders", name, {{"ms", one.ms}}, one.is_raster ? "vertex, then fragment" : ""};
        row.figures.insert(row.figures.end(), one.statistics.begin(), one.statistics.end());
        sink(row);
    }
    return {};
}

} // namespace ghost::app
