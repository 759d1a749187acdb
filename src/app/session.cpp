// SPDX-License-Identifier: Apache-2.0
#include "app/session.h"

#include "app/interrupt.h"
#include "bake/bake_show.h"
#include "scene/passes_file.h"

#include "base/log.h"
#include "base/progress.h"

#include <chrono>
#include <set>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

double steady_now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Whether any file that the passes depend on is newer than they are. The bake itself compares contents; this
// only says whether it has to be asked.
bool is_stale(const scene::Show& show, const fs::path& manifest) {
    std::error_code code;
    const fs::file_time_type made = fs::last_write_time(manifest, code);
    if (code) return true;
    std::set<fs::path> sources{show.file, show.stage_file};
    for (const scene::PatchedFixture& fixture : show.fixtures) sources.insert(show.folder / fixture.gdtf);
    for (const fs::path& source : sources) {
        const fs::file_time_type changed = fs::last_write_time(source, code);
        if (!code && changed > made) return true;
    }
    return false;
}

Result<void> bake_view(scene::Show& show, const std::string& view, bool quiet, scene::Report& report) {
    if (show.stage.instances.empty()) {
        TRY(show.stage, scene::load_stage_file(show.stage_file, report));
    }
    catch_interrupts();
    Progress progress("baking", quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::BakeOptions options;
    options.views = {view};
    options.stop = interrupted;
    options.progress = [&](double share, const std::string& note) {
        progress.update(share, steady_now_s(), note);
    };
    const Result<bake::BakeStats> stats = bake::bake_show(show, options, report);
    progress.finish();
    if (!stats.ok()) return stats.error();
    if (stats->interrupted)
        return Error{
            "interrupted while baking; finished passes are kept, the same command goes on from there", ""};
    return {};
}

Result<scene::Passes> get_passes(scene::Show& show, const scene::Camera& camera,
                                 const SessionOptions& options, scene::Report& report) {
    if (!camera.foreign_passes.empty()) return scene::load_foreign_passes(camera.foreign_passes, report);
    const fs::path folder = scene::passes_folder(show, camera.name);
    const fs::path manifest = folder / "manifest.json";
    if (options.bake && is_stale(show, manifest)) {
        TRY_VOID(bake_view(show, camera.name, options.quiet, report));
        std::error_code ignored;
        fs::last_write_time(manifest, fs::file_time_type::clock::now(), ignored);
    }
    return scene::load_passes(folder, true, report);
}

} // namespace

void print_report(const scene::Report& report, std::size_t skip) {
    for (std::size_t i = skip; i < report.messages.size(); ++i) {
        const scene::Message& message = report.messages[i];
        const std::string line = message.where.empty() ? message.what : message.where + ": " + message.what;
        if (message.severity == scene::Severity::note)
            log_debug(line);
        else if (message.severity == scene::Severity::warning)
            log_warning(line);
        else
            log_error(line);
    }
}

render::Settings draw_settings(const scene::Show& show, const scene::Camera& camera,
                               const SessionOptions& options) {
    render::Settings settings;
    settings.haze.extinction_per_m = show.haze.extinction_per_m;
    settings.haze.scattering_per_m = show.haze.extinction_per_m * show.haze.albedo;
    settings.haze.forward_g = show.haze.forward_g;
    settings.haze.back_g = show.haze.back_g;
    settings.haze.back_weight = show.haze.back_weight;
    settings.ambient_lux = show.ambient_lux;
    settings.beams = options.beams;
    settings.march_steps = options.march_steps;
    settings.ev100 = options.ev100.value_or(camera.ev100);
    settings.auto_exposure = camera.auto_exposure && !options.ev100;
    settings.image_memory_bytes = options.image_memory_bytes;
    return settings;
}

Result<std::unique_ptr<Session>> open_session(const SessionOptions& options) {
    auto session = std::make_unique<Session>();
    scene::Report& report = session->report;
    TRY(scene::Show show, scene::load_show(options.show, false, report));
    session->show = std::make_unique<scene::Show>(std::move(show));
    print_report(report);
    std::size_t printed = report.messages.size();

    TRY(session->camera, session->show->find_camera(options.view));
    if (options.width > 0) {
        scene::Camera sized = session->show->cameras[session->camera];
        sized.width = options.width;
        sized.height = options.height;
        sized.name += "@" + std::to_string(options.width) + "x" + std::to_string(options.height);
        session->camera = session->show->cameras.size();
        session->show->cameras.push_back(std::move(sized));
    }
    const scene::Camera camera = session->show->cameras[session->camera];

    TRY(session->passes, get_passes(*session->show, camera, options, report));
    session->gobos = scene::build_gobos(*session->show, report);
    print_report(report, printed);

    TRY(session->device, gpu::Device::create({options.device, options.validation}));
    log_info("drawing on " + session->device->name());
    session->rig = std::make_unique<scene::Rig>(*session->show);
    const auto light_count = static_cast<int>(session->rig->lights(session->gobos, session->passes).size());
    session->relighter =
        std::make_unique<render::Relighter>(*session->device, session->passes, session->gobos.images,
                                            light_count, draw_settings(*session->show, camera, options));
    for (scene::LightPass& pass : session->passes.lights) {
        pass.radiance = {};
        pass.indirect = {};
    }
    return session;
}

} // namespace ghost::app
