// SPDX-License-Identifier: Apache-2.0
// Lights one by one, as on a processor, and 128 at once, as on a GPU, are the same picture; and how much is
// recorded for 400 of them does not hang on how many they are.
#include "bench/bench.h"
#include "dmx/record/player.h"
#include "image/metrics.h"
#include "shared/push.h"
#include "support/demo_copy.h"
#include "support/likeness.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

constexpr double kLeast_db = 70;

struct Moment {
    const char* view;
    double t_s;
    bool live;
};

image::ImageF picture_of(const Moment& moment, std::uint32_t lights_per_dispatch,
                         const gpu::LoweredLimits& lowered = {}) {
    SessionOptions options;
    options.show = DemoCopy::show().string();
    options.view = moment.view;
    options.width = 160;
    options.height = 90;
    options.live = moment.live;
    options.validation = true;
    options.quiet = true;
    options.lights_per_dispatch = lights_per_dispatch;
    options.lowered_limits = lowered;
    const auto session = must(open_session(options));
    dmx::Player player(must(dmx::read_recording(session->show->recording)));
    for (int frame = 0; frame <= std::lround(moment.t_s * 30); ++frame)
        session->rig->step(player.at(frame / 30.0), 1.0 / 30);
    (void)session->draw(moment.t_s);
    EXPECT_EQ(session->device->validation_errors(), 0u);
    return session->relighter->frame();
}

TEST(Batches, OneByOneAndAllAtOnceAreTheSamePicture) {
    for (const Moment& moment : {Moment{"close", 36, true}, Moment{"high", 18, true},
                                 Moment{"house", 82, true}, Moment{"close", 70, false}}) {
        const image::PicturePair pair =
            pair_of(picture_of(moment, shared::kLightsPerChunk), picture_of(moment, 1));
        const double db = image::psnr_db(pair, image::p75_curve(pair));
        std::printf("%s at %.0f s: %.1f dB\n", moment.view, moment.t_s, db);
        EXPECT_GE(db, kLeast_db) << moment.view;
    }
}

// What is made use of, and not asked for, alone as low as it may be.
TEST(Batches, ADeviceThatHasJustEnoughDrawsTheSamePicture) {
    const Moment moment{"close", 36, true};
    const image::ImageF usual = picture_of(moment, shared::kLightsPerChunk);
    for (const auto& [name, value] : gpu::LoweredLimits{{"maxComputeWorkGroupInvocations", 256},
                                                        {"maxImageArrayLayers", 256},
                                                        {"maxMemoryAllocationCount", 64},
                                                        {"timestampComputeAndGraphics", 0}}) {
        const image::ImageF lowered = picture_of(moment, shared::kLightsPerChunk, {{name, value}});
        const image::PicturePair pair = pair_of(lowered, usual);
        EXPECT_GE(image::psnr_db(pair, image::p75_curve(pair)), kLeast_db) << name;
    }
}

// A device may not begin as many workgroups as a list has tiles; then each draws several.
TEST(Batches, FewWorkgroupsDrawEverything) {
    SessionOptions options;
    options.show = DemoCopy::show().string();
    options.view = "close";
    options.width = 160;
    options.height = 90;
    options.live = true;
    options.validation = true;
    options.quiet = true;
    const auto session = must(open_session(options));
    dmx::Player player(must(dmx::read_recording(session->show->recording)));
    session->rig->step(player.at(36), 3600);
    const scene::FrameLights lit = session->lit();
    const auto drawn = [&](std::uint32_t batch, std::uint32_t most_groups,
                           const render::HazeQuality& quality) {
        render::Settings settings;
        settings.lights_per_dispatch = batch;
        settings.most_groups = most_groups;
        settings.beams.most_wide_step = 2;
        render::Relighter relighter(*session->device, session->live->g_buffer(), session->live->distances(),
                                    session->gobos.images, static_cast<int>(lit.lights.size()), settings);
        relighter.set_quality(quality);
        for (int frame = 0; frame < 3; ++frame) { // visibility is made, and read
            relighter.draw_anew();
            EXPECT_GT(relighter.draw(lit).surface_tiles, 100);
        }
        return relighter.frame().samples;
    };
    for (const render::HazeQuality& quality :
         {render::HazeQuality{}, render::HazeQuality{.wide_beam_step = 2}})
        EXPECT_EQ(drawn(shared::kLightsPerChunk, 5, quality), drawn(shared::kLightsPerChunk, 0, quality))
            << "step " << quality.wide_beam_step;
    EXPECT_EQ(session->device->validation_errors(), 0u);
}

// What a steady frame may take of a device's front end, whatever the number of lights.
TEST(Batches, FourHundredLightsAreOneSubmissionOfFewDispatches) {
    constexpr int kLights = 400;
    constexpr double kMost = 120;
    const auto device = must(gpu::Device::create({.validation = true}));
    const scene::Passes passes = bench_passes(64, 36, 8);
    render::Settings settings = bench_settings();
    settings.lights_per_dispatch = shared::kLightsPerChunk;
    settings.image_memory_bytes = 0;
    settings.pixels_on_processor = false; // as on a GPU
    render::Relighter relighter(*device, passes, bench_gobos(), kLights, settings);
    gpu::RecordedWork before;
    for (const double seconds : {0.0, 0.1}) {
        std::vector<shared::Light> lights;
        for (int i = 0; i < kLights; ++i) {
            lights.push_back(bench_light(i, static_cast<std::uint32_t>(i % 3), i + seconds));
            lights.back().pass = static_cast<std::uint32_t>(i % 8);
        }
        before = device->work();
        EXPECT_EQ(relighter.draw(lights).drawn, kLights);
    }
    const gpu::RecordedWork& work = device->work();
    std::printf("%llu dispatches, %llu barriers\n",
                static_cast<unsigned long long>(work.dispatches - before.dispatches),
                static_cast<unsigned long long>(work.barriers - before.barriers));
    EXPECT_LT(static_cast<double>(work.dispatches - before.dispatches), kMost);
    EXPECT_LT(static_cast<double>(work.barriers - before.barriers), kMost);
    EXPECT_EQ(work.submissions - before.submissions, 1u);
    EXPECT_EQ(device->validation_errors(), 0u);
}

} // namespace
} // namespace ghost::app
