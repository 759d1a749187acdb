// SPDX-License-Identifier: Apache-2.0
#include "cli/render/reference_render.h"

#include "base/interrupt.h"
#include "bounce/bounce_box.h"
#include "farm/farm_task.h"
#include "live/session/picture_writer.h"
#include "live/session/show_moment.h"
#include "reference/light_walk.h"
#include "reference/reference.h"

#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace ghost::app {
namespace {

// What light is in, and where it meets something.
struct LitStage {
    const bake::Tracer& tracer;
    const std::vector<shared::Light>& lights;
    const shared::Gobos& gobos;
    const shared::Haze& haze;
};

// Bounced light by particles, added to the picture.
Result<void> add_bounces(const ReferenceArguments& arguments, const LitStage& stage,
                         const scene::Camera& camera, Progress& progress, image::ImageF& picture) {
    const auto& [tracer, lights, gobos, haze] = stage;
    bake::WalkOptions walk;
    walk.particles = static_cast<std::int64_t>(arguments.particles_m * 1e6);
    walk.camera = &camera;
    walk.first_order = std::max(arguments.order, 1);
    walk.last_order = arguments.order > 0 ? arguments.order : arguments.bounces;
    const scene::BounceBox room = scene::bounce_box(tracer.stage(), lights);
    walk.air_low_m = room.low_m;
    walk.air_high_m = room.high_m;
    walk.stop = interrupted;
    walk.progress = [&](double share) { progress.update(share, steady_now_s(), "bounced light"); };
    TRY(const bake::Walk walked, bake::walk_light(tracer, lights, gobos, haze, walk));
    double sum = 0, error2 = 0;
    for (std::size_t i = 0; i < picture.samples.size(); ++i) {
        picture.samples[i] += walked.picture.samples[i];
        sum += static_cast<double>(walked.picture.samples[i]);
        error2 += std::pow(static_cast<double>(walked.error.samples[i]), 2);
    }
    if (sum > 0) {
        const auto count = static_cast<double>(picture.samples.size());
        char line[160];
        std::snprintf(line, sizeof line,
                      "bounced light by %.3g million particles: error of a pixel %.2g %% of the mean, of the "
                      "mean %.2g %%",
                      arguments.particles_m, 100 * std::sqrt(error2 / count) / (sum / count),
                      100 * std::sqrt(error2) / sum);
        log_info(line);
    }
    if (!arguments.error_out.empty())
        TRY_VOID(write_picture(arguments.error_out, walked.error, camera.ev100, image::Tone::linear));
    return {};
}

} // namespace

Result<void> render_reference(const SessionOptions& options, const ReferenceArguments& arguments,
                              const std::string& replay, double at_s, int fps, const std::string& out) {
    TRY(const OutputKind kind, output_kind(out));
    if (kind == OutputKind::film) return Error{"a reference is one picture: .png or .exr", out};
    if (!arguments.error_out.empty()) {
        TRY(const OutputKind error_kind, output_kind(arguments.error_out));
        if (error_kind != OutputKind::exr)
            return Error{"errors are cd/m^2 of each pixel: an .exr", arguments.error_out};
    }
    Report report;
    TRY(const auto moment, ShowMoment::open(options, replay, arguments.capture, report));
    const scene::Show& show = moment->show();
    TRY(const std::size_t view, show.find_camera(options.view));
    scene::Camera camera = options.eye.value_or(show.cameras[view]);
    if (options.width > 0) {
        camera.width = options.width;
        camera.height = options.height;
    }
    if (kind == OutputKind::png && camera.auto_exposure && !options.ev100)
        report.add(
            Severity::warning, show.file.string(),
            "camera '" + camera.name +
                "' measures its exposure; the reference is developed at its ev100, or name one with --ev");
    moment->step_to(at_s, fps, report);
    camera = scene::riding(camera, moment->rig());
    print_report(report);

    catch_interrupts();
    Progress progress("reference", options.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::ReferenceOptions reference;
    reference.air_samples = arguments.samples;
    reference.pixel_samples = arguments.pixel_samples;
    reference.lens_samples = arguments.lens_samples;
    reference.shadows = options.shadows && show.shadows;
    const Atmosphere atmosphere = atmosphere_of(show);
    const shared::Air air = atmosphere.field(at_s);
    reference.attenuation = air.attenuation;
    if (atmosphere.is_uneven()) {
        reference.density = [air](const glm::dvec3& place_m) {
            return static_cast<double>(shared::air_density(air, glm::vec3(place_m)));
        };
    }
    reference.stop = interrupted;
    reference.progress = [&](double share) { progress.update(share, steady_now_s(), out); };
    const bake::Tracer tracer(moment->stage());
    const double start_s = steady_now_s();
    const std::vector<shared::Light> lights = moment->lights();
    Result<image::ImageF> picture = image::ImageF(camera.width, camera.height, 3);
    if (arguments.order <= 0)
        picture = bake::reference_picture(&tracer, camera, lights, moment->gobos().images,
                                          atmosphere.medium(), show.ambient_lux, reference);
    if (picture.ok() && (arguments.order > 0 || (arguments.order < 0 && arguments.bounces > 0))) {
        const Result<void> added =
            add_bounces(arguments, {tracer, lights, moment->gobos().images, atmosphere.medium()}, camera,
                        progress, *picture);
        if (!added.ok()) picture = added.error();
    }
    progress.finish();
    if (interrupted()) return Error{"interrupted: nothing was written", out};
    if (!picture.ok()) return picture.error();
    TRY_VOID(write_picture(out, *picture, options.ev100.value_or(camera.ev100), options.tone));
    log_info(out + ": reference in " + clock_text(steady_now_s() - start_s));
    if (report.lost_anything()) return Error{kMadeButMissing, show.file.string()};
    return {};
}

} // namespace ghost::app
