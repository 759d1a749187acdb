// SPDX-License-Identifier: Apache-2.0
// Tables of what happens before the first frame: baking and how right it is, geometry, start-up.
#include "bench/bench.h"
#include "bench/private/temporary_folder.h"

#include "bake/bake_show.h"
#include "base/steady_time.h"
#include "dmx/record/player.h"
#include "image/colour.h"
#include "image/metrics.h"
#include "light/bodies.h"
#include "passes/passes_file.h"
#include "reference/trace_lit.h"
#include "show_folder/load_show.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// A bumpy floor of about so many triangles.
scene::Stage bumpy_floor(int triangles) {
    const int side = std::max(2, static_cast<int>(std::sqrt(triangles / 2.0)));
    scene::Mesh mesh;
    mesh.name = "floor";
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) {
            const float fx = static_cast<float>(x) / static_cast<float>(side);
            const float fy = static_cast<float>(y) / static_cast<float>(side);
            mesh.positions.emplace_back(fx * 40 - 20, fy * 24 - 10,
                                        1.0f + 0.4f * std::sin(fx * 60) * std::cos(fy * 40));
            mesh.normals.emplace_back(0, 0, 1);
        }
    const auto row = static_cast<std::uint32_t>(side + 1);
    for (std::uint32_t y = 0; y + 1 < row; ++y)
        for (std::uint32_t x = 0; x + 1 < row; ++x) {
            const std::uint32_t a = y * row + x;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + row, a + 1, a + row + 1, a + row});
        }
    scene::Stage stage;
    stage.materials.emplace_back();
    stage.meshes.push_back(std::move(mesh));
    scene::Instance instance;
    instance.name = "floor";
    stage.instances.push_back(instance);
    return stage;
}

// As a display shows it whose white is the brightest hundredth of the reference.
image::ToneCurve display_of(const image::ImageF& reference) {
    std::vector<float> sorted = reference.samples;
    const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 99 / 100);
    std::nth_element(sorted.begin(), place, sorted.end());
    return [scale = 1.0f / std::max(*place, 1e-9f)](const glm::vec3& value) {
        glm::vec3 shown;
        for (int c = 0; c < 3; ++c)
            shown[c] = image::linear_to_srgb(std::clamp(value[c] * scale, 0.0f, 1.0f));
        return shown;
    };
}

} // namespace

Result<void> bench_triangles(const BenchOptions& options, const BenchSink& sink) {
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    Report report;
    TRY(const scene::Show model, scene::load_show(options.show, false, report));
    const shared::Gobos gobos = bench_gobos();
    for (const int triangles : {10'000, 100'000, 1'000'000}) {
        const TemporaryFolder folder;
        TRY_VOID(folder.made());
        scene::Show show = model;
        show.folder = folder.path;
        show.stage = bumpy_floor(triangles);
        show.cameras.resize(1);
        bake::BakeOptions baking;
        baking.spp = 4;
        baking.now_s = steady_now_s;
        TRY(const bake::BakeStats stats, bake::bake_show(show, baking, report));
        TRY(const scene::Passes passes,
            scene::load_passes(scene::passes_folder(show, show.cameras[0].name), true, report));
        const int lights = static_cast<int>(passes.lights.size());
        render::Relighter relighter(*device, passes, gobos, lights, bench_settings());
        std::vector<double> ms;
        for (int frame = 0; frame < options.frames + 4; ++frame) {
            std::vector<shared::Light> moving;
            for (int i = 0; i < lights; ++i) {
                moving.push_back(bench_light(i, i < lights / 2 ? 2 : 0, frame / 44.0));
                moving.back().pass = static_cast<std::uint32_t>(i);
            }
            const render::FrameStatistics drawn = relighter.draw(moving);
            if (frame >= 4) ms.push_back(drawn.draw_ms);
        }
        sink({"triangles",
              std::to_string(show.stage.drawn_triangles()) + " triangles",
              {{"draw_ms", median(ms)},
               {"best_ms", *std::min_element(ms.begin(), ms.end())},
               {"bake_ms_per_pass", stats.trace_seconds * 1e3 / std::max(1, lights)}},
              "all lights changing"});
    }
    return {};
}

Result<void> bench_bake(const BenchOptions& options, const BenchSink& sink) {
    Report report;
    TRY(scene::Show show, scene::load_show(options.show, true, report));
    const TemporaryFolder folder;
    TRY_VOID(folder.made());
    show.folder = folder.path;
    show.cameras.resize(1);
    for (const int spp : {1, 4, 16}) {
        std::error_code ignored;
        fs::remove_all(show.cache_folder(), ignored);
        bake::BakeOptions baking;
        baking.spp = spp;
        baking.now_s = steady_now_s;
        TRY(const bake::BakeStats stats, bake::bake_show(show, baking, report));
        const double passes = std::max<double>(1, static_cast<double>(stats.passes.size()));
        sink({"bake",
              std::to_string(spp) + " samples a pixel",
              {{"passes", passes},
               {"ms_per_pass", stats.trace_seconds * 1e3 / passes},
               {"total_s", stats.seconds},
               {"mrays_per_s", static_cast<double>(stats.rays) / std::max(stats.trace_seconds, 1e-9) * 1e-6}},
              show.cameras[0].name + " " + std::to_string(show.cameras[0].width) + "x" +
                  std::to_string(show.cameras[0].height)});
    }
    return {};
}

Result<void> bench_quality(const BenchOptions& options, const BenchSink& sink) {
    constexpr int kSpp = 16;
    constexpr double kFrameRate = 30;
    TRY(const std::unique_ptr<gpu::Device> device, gpu::Device::create({options.device, false}));
    Report report;
    TRY(scene::Show show, scene::load_show(options.show, true, report));
    const TemporaryFolder folder;
    TRY_VOID(folder.made());
    show.folder = folder.path;
    show.cameras.resize(1);
    const scene::Camera& camera = show.cameras[0];
    bake::BakeOptions baking;
    baking.spp = kSpp;
    TRY_VOID(bake::bake_show(show, baking, report));
    TRY(scene::Passes passes, scene::load_passes(scene::passes_folder(show, camera.name), true, report));
    passes.emission.clear(); // direct tracing has none
    const scene::GoboStack gobos = scene::build_gobos(show, report);
    const scene::Stage stage = scene::stage_with_bodies(show, report);
    TRY(dmx::Recording recording, dmx::read_recording(show.recording));
    dmx::Player player(std::move(recording));
    scene::Rig rig(show);
    render::Settings settings = bench_settings();
    settings.air = false;
    int frame = 0;
    for (const int at_s : {8, 36, 50, 70, 82}) {
        for (; frame <= at_s * static_cast<int>(kFrameRate); ++frame)
            rig.step(player.at(frame / kFrameRate), 1 / kFrameRate);
        const std::vector<shared::Light> lights = rig.lights(gobos, passes);
        const Clock::time_point start = Clock::now();
        const image::ImageF direct =
            bake::trace_lit(stage, camera, lights, gobos.images, kSpp, settings.haze);
        const double trace_s = std::chrono::duration<double>(Clock::now() - start).count();
        const image::ImageF other =
            bake::trace_lit(stage, camera, lights, gobos.images, kSpp, settings.haze, 7);
        render::Relighter relighter(*device, passes, gobos.images, static_cast<int>(lights.size()), settings);
        relighter.draw(lights);
        const image::ToneCurve display = display_of(direct);
        TRY(const image::PicturePair relit, image::pair_up(relighter.frame(), direct, {}));
        TRY(const image::PicturePair noise, image::pair_up(other, direct, {}));
        sink({"quality",
              "at " + std::to_string(at_s) + " s",
              {{"psnr_db", image::psnr_db(relit, display)},
               {"bias_percent", 100 * image::relative_errors(relit).bias},
               {"other_samples_psnr_db", image::psnr_db(noise, display)},
               {"direct_s", trace_s}},
              camera.name + " " + std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                  ", 16 samples a pixel"});
    }
    return {};
}

Result<void> bench_start(const BenchOptions& options, const BenchSink& sink) {
    const TemporaryFolder folder;
    TRY_VOID(folder.made());
    const std::string out = (folder.path / "first.png").string();
    std::vector<double> seconds;
    double peak_mb = 0;
    for (int run = 0; run < 4; ++run) { // the first one bakes what is missing
        const Clock::time_point start = Clock::now();
        const pid_t child = ::fork();
        if (child < 0) return Error{"cannot start a process", options.program};
        if (child == 0) {
            ::execl(options.program.c_str(), "ghostlight", "render", options.show.c_str(), "-o", out.c_str(),
                    "--at", "0", "--quiet", static_cast<char*>(nullptr));
            ::_exit(127);
        }
        int status = 0;
        rusage usage{};
        if (::wait4(child, &status, 0, &usage) < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
            return Error{"the render that should be timed failed", options.program};
        if (run > 0) seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
        peak_mb = std::max(peak_mb, static_cast<double>(usage.ru_maxrss) / 1024.0);
    }
    sink({"start",
          "program to first picture",
          {{"seconds", median(seconds)}, {"peak_memory_mb", peak_mb}},
          "passes baked"});
    return {};
}

} // namespace ghost::app
