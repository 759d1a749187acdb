// SPDX-License-Identifier: Apache-2.0
#include "bake/bake_show.h"

#include "bake/keys.h"
#include "bake/private/camera_bake.h"
#include "light/bodies.h"
#include "passes/passes_file.h"
#include "rays/tracer.h"
#include "show_folder/place_checks.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace ghost::bake {
namespace {

constexpr std::int64_t kMostPixels = 1 << 24; // fragments.exr counts them in floats

std::unique_ptr<tbb::global_control> thread_limit;

// The cameras that are meant, compared with the disk.
struct Jobs {
    std::vector<std::size_t> chosen;
    std::vector<std::unique_ptr<CameraBake>> jobs;
    std::vector<CameraWork> works; // as jobs
    scene::Stage stage;
    double work = 0;
};

Result<std::unique_ptr<Jobs>> compare(const scene::Show& show, const BakeOptions& options, Report& report) {
    auto result = std::make_unique<Jobs>();
    std::vector<std::size_t>& chosen = result->chosen;
    for (const std::string& view : options.views) {
        TRY(const std::size_t index, show.find_camera(view));
        if (std::find(chosen.begin(), chosen.end(), index) == chosen.end()) chosen.push_back(index);
    }
    if (options.views.empty())
        for (std::size_t k = 0; k < show.cameras.size(); ++k) chosen.push_back(k);
    for (const scene::PatchedFixture& fixture : show.fixtures)
        if (fixture.type == nullptr)
            report.add(Severity::warning, show.file.string(),
                       "fixture '" + fixture.name + "' has no readable type; no pass is baked for it");

    result->stage = scene::stage_with_bodies(show, report);
    const scene::Stage& stage = result->stage;
    const StageKeys keys = stage_keys(stage, show.fixtures.size());
    for (const std::size_t index : chosen) {
        const scene::Camera& camera = show.cameras[index];
        if (!camera.foreign_passes.empty()) {
            report.add(Severity::note, show.file.string(),
                       "camera '" + camera.name +
                           "' shows passes rendered elsewhere; nothing is baked for it");
            continue;
        }
        if (std::int64_t{camera.width} * camera.height > kMostPixels)
            return Error{"camera '" + camera.name + "': " + std::to_string(camera.width) + "x" +
                             std::to_string(camera.height) +
                             " is more than the 16.7 million pixels that passes can have; --live draws it",
                         show.file.string()};
        result->jobs.push_back(std::make_unique<CameraBake>(show, stage, keys, camera, options));
        const double work = result->jobs.back()->plan();
        if (result->jobs.back()->replaces_earlier_version())
            report.add(Severity::warning, scene::passes_folder(show, camera.name).string(),
                       "these passes are of an earlier version of Ghostlight; they are made again, once");
        result->works.push_back({camera.name, result->jobs.back()->light_count(), work == 0});
        result->work += work;
    }
    return result;
}

Result<BakeStats> bake_all(const scene::Show& show, const BakeOptions& options, Report& report) {
    const auto now_s = [&] { return options.now_s ? options.now_s() : 0.0; };
    const double begin_s = now_s();
    TRY(const std::unique_ptr<Jobs> compared, compare(show, options, report));
    const std::vector<std::size_t>& chosen = compared->chosen;
    const auto& jobs = compared->jobs;
    const scene::Stage& stage = compared->stage;
    const double work = compared->work;
    if (const auto& part = options.part; part && !part->surroundings && !jobs.empty())
        if (const std::size_t lights = jobs[0]->light_count(); part->first_light >= lights)
            return Error{"camera '" + options.views[0] + "' has " + std::to_string(lights) +
                             " lights, the first is 0",
                         ""};
    BakeStats stats;
    stats.cameras = static_cast<int>(jobs.size());
    // Building the ray tracer takes longer than finding out that nothing changed.
    std::optional<Tracer> tracer;
    if (work > 0) {
        tracer.emplace(stage);
        std::vector<scene::Camera> cameras;
        for (const std::size_t index : chosen) cameras.push_back(show.cameras[index]);
        scene::check_places(show, stage, cameras, report);
    }
    std::mutex mutex;
    double done = 0;
    std::string note;
    const auto on_samples = [&](double samples) {
        const std::lock_guard lock(mutex);
        done += samples;
        if (options.progress) options.progress(work > 0 ? done / work : 1.0, note);
    };
    std::size_t at = 0;
    for (const auto& job : jobs) {
        {
            const std::lock_guard lock(mutex);
            note = "camera " + std::to_string(++at) + " of " + std::to_string(jobs.size());
        }
        if (!tracer) {
            stats.kept += static_cast<int>(job->light_count());
            continue;
        }
        TRY_VOID(options.part ? job->run_part(*tracer, on_samples, stats)
                              : job->run(*tracer, on_samples, stats));
    }
    stats.interrupted = options.stop && options.stop();
    stats.seconds = now_s() - begin_s;
    return stats;
}

} // namespace

Result<BakeStats> bake_show(const scene::Show& show, const BakeOptions& options, Report& report) {
    if (options.spp < 1 || options.spp > kMaxSpp)
        return Error{"samples per pixel must be 1 to " + std::to_string(kMaxSpp), ""};
    if (options.bounces < 0 || options.bounces > kMaxBounces)
        return Error{"bounces must be 0 to " + std::to_string(kMaxBounces), ""};
    if (options.part && options.views.size() != 1) return Error{"a part is one of a single camera", ""};
    if (options.threads <= 0) return bake_all(show, options, report);
    tbb::task_arena arena(options.threads);
    std::optional<Result<BakeStats>> result;
    arena.execute([&] { result.emplace(bake_all(show, options, report)); });
    return std::move(*result);
}

Result<std::vector<CameraWork>> plan_bake(const scene::Show& show, const BakeOptions& options,
                                          Report& report) {
    TRY(const std::unique_ptr<Jobs> compared, compare(show, options, report));
    return compared->works;
}

void limit_threads(int threads) {
    thread_limit.reset();
    if (threads > 0)
        thread_limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                             static_cast<std::size_t>(threads));
}

} // namespace ghost::bake
