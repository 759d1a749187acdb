// SPDX-License-Identifier: Apache-2.0
#include "app/reference_render.h"

#include "app/interrupt.h"
#include "app/media_player.h"
#include "app/picture_writer.h"
#include "app/recordings.h"
#include "bake/reference.h"
#include "scene/bodies.h"
#include "scene/prism.h"

#include "base/log.h"
#include "base/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ghost::app {
namespace {

double steady_now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What the rig does at a moment of a recording, stepped as a film is, because wheels and gobos turn.
Result<void> step_to(scene::Rig& rig, const scene::Show& show, const std::string& replay, double at_s,
                     int fps, const dmx::CaptureOptions& capture, bool quiet) {
    const std::filesystem::path file = replay.empty() ? show.recording : std::filesystem::path(replay);
    if (file.empty()) return Error{"has no recording; name one with --replay FILE", show.file.string()};
    TRY(dmx::Recording recording, open_recording(file, capture, quiet));
    const dmx::Player player(std::move(recording));
    if (at_s > player.duration_s())
        log_warning("the recording ends at " + std::to_string(player.duration_s()) +
                    " s; what is drawn is its last look");
    const double rate = fps;
    const long last = std::lround(std::max(at_s, 0.0) * rate);
    for (long frame = 0; frame <= last; ++frame)
        rig.step(player.at(static_cast<double>(frame) / rate), 1.0 / rate);
    log_damage(player);
    return {};
}

} // namespace

Result<void> render_reference(const SessionOptions& options, const ReferenceArguments& arguments,
                              const std::string& replay, double at_s, int fps, const std::string& out) {
    TRY(const OutputKind kind, output_kind(out));
    if (kind == OutputKind::film) return Error{"a reference is one picture: .png or .exr", out};
    scene::Report report;
    TRY(scene::Show show, open_show(options.show, false, options.quiet, report));
    show.motion = options.motion.value_or(show.motion);
    load_stage(show, report);
    TRY(const std::size_t view, show.find_camera(options.view));
    scene::Camera camera = options.eye.value_or(show.cameras[view]);
    if (options.width > 0) {
        camera.width = options.width;
        camera.height = options.height;
    }
    if (kind == OutputKind::png && camera.auto_exposure && !options.ev100)
        report.add(
            scene::Severity::warning, show.file.string(),
            "camera '" + camera.name +
                "' measures its exposure; the reference is developed at its ev100, or name one with --ev");
    scene::GoboStack gobos = scene::build_gobos(show, report);
    scene::check_prisms(show, report);
    if (!show.media.empty()) MediaPlayer(show, gobos).show(std::max(at_s, 0.0), true, gobos, report);
    scene::Stage stage = scene::stage_with_bodies(show, report);
    print_report(report);
    scene::Rig rig(show);
    TRY_VOID(step_to(rig, show, replay, at_s, fps, arguments.capture, options.quiet));
    scene::pose_bodies(show, rig, stage);

    catch_interrupts();
    Progress progress("reference", options.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::ReferenceOptions reference;
    reference.air_samples = arguments.samples;
    reference.pixel_samples = arguments.pixel_samples;
    reference.lens_samples = arguments.lens_samples;
    reference.shadows = options.shadows && show.shadows;
    reference.attenuation = {show.attenuation.constant, show.attenuation.linear, show.attenuation.quadratic};
    if (is_uneven(show)) {
        const shared::Air air = air_of(show, at_s);
        reference.density = [air](const glm::dvec3& place_m) {
            return static_cast<double>(shared::air_density(air, glm::vec3(place_m)));
        };
    }
    reference.stop = interrupted;
    reference.progress = [&](double share) { progress.update(share, steady_now_s(), out); };
    const bake::Tracer tracer(stage);
    const double start_s = steady_now_s();
    const Result<image::ImageF> picture = bake::reference_picture(
        &tracer, camera, rig.lit(gobos, scene::DistanceMaps{}, scene::Cells::apart).lights, gobos.images,
        haze_of(show), show.ambient_lux, reference);
    progress.finish();
    if (interrupted()) return Error{"interrupted: nothing was written", out};
    if (!picture.ok()) return picture.error();
    TRY_VOID(write_picture(out, *picture, options.ev100.value_or(camera.ev100), options.tone));
    log_info(out + ": reference in " + clock_text(steady_now_s() - start_s));
    if (report.lost_anything())
        return Error{"drawn, but something that the show asks for is missing (see above)",
                     show.file.string()};
    return {};
}

} // namespace ghost::app
