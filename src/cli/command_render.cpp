// SPDX-License-Identifier: Apache-2.0
#include "base/interrupt.h"
#include "cli/commands.h"
#include "cli/options/bounce_option.h"
#include "cli/options/input_options.h"
#include "cli/options/live_options.h"
#include "cli/options/number_option.h"
#include "cli/options/size_option.h"
#include "cli/options/tone_option.h"
#include "cli/render/render_film.h"
#include "dmx/record/recording_tasks.h"
#include "farm/farm_task.h"
#include "live/session/film_sound.h"
#include "show/show.h"

#include "bake/bake_show.h"
#include "base/log.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace ghost::app {
namespace {

// What the command line asks for, checked before anything is opened.
Result<bool> check_usage(RenderArguments& arguments) {
    if (!arguments.size.empty()) {
        TRY(const glm::ivec2 size, size_from(arguments.size, {16, 16}, 8192));
        arguments.session.width = size.x;
        arguments.session.height = size.y;
    }
    arguments.session.beams.beams = arguments.beams == "march"  ? render::Beams::march
                                    : arguments.beams == "cone" ? render::Beams::cone
                                                                : render::Beams::gate;
    arguments.session.image_memory_bytes = static_cast<std::uint64_t>(arguments.image_memory_mb) << 20;
    if (arguments.hold_fps > arguments.fps)
        return Error{"the film has only " + std::to_string(arguments.fps) + " frames a second (--fps)",
                     "--hold-fps"};
    if (arguments.hold_fps > 0 && arguments.session.beams.beams != render::Beams::gate)
        return Error{"only the haze of --beams gate can be lowered", "--hold-fps"};
    arguments.session.beams.most_wide_step = arguments.hold_fps > 0 ? 4 : 1;
    arguments.session.beams.grid = arguments.session.parks = arguments.hold_fps > 0 && !arguments.live_input;
    arguments.session.motion = fixture::motion_from(arguments.motion);
    if (arguments.has_ev100) arguments.session.ev100 = arguments.ev100;
    arguments.session.moving_maps = arguments.moving_maps == "device"      ? MovingMapsBy::device
                                    : arguments.moving_maps == "processor" ? MovingMapsBy::processor
                                                                           : MovingMapsBy::choice;
    arguments.session.shadows = !arguments.no_shadows;
    arguments.session.maps_in_background = arguments.live_input;
    arguments.session.repeatable = !arguments.live_input && arguments.hold_fps == 0;
    arguments.session.live =
        arguments.session.live || !arguments.eye_m.empty() || !arguments.session.travel.empty() ||
        arguments.session.bounce.value_or(scene::BounceDetail::off) != scene::BounceDetail::off;
    if (arguments.eye_m.empty() != arguments.target_m.empty())
        return Error{"a free camera needs both", "--eye/--target"};
    if (!arguments.eye_m.empty()) {
        scene::Camera& eye = arguments.session.eye.emplace();
        eye.name = "free";
        eye.position_m = {arguments.eye_m[0], arguments.eye_m[1], arguments.eye_m[2]};
        eye.target_m = {arguments.target_m[0], arguments.target_m[1], arguments.target_m[2]};
        eye.fov_y_deg = arguments.fov_y_deg;
        eye.auto_exposure = arguments.auto_exposure;
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(eye.position_m[axis]) <= scene::kMaxCoordinate_m &&
                  std::abs(eye.target_m[axis]) <= scene::kMaxCoordinate_m))
                return Error{"metres must be numbers up to 10 km", "--eye/--target"};
        if (glm::distance(eye.position_m, eye.target_m) < 1e-3f)
            return Error{"the camera stands at what it looks at", "--eye/--target"};
        if (!arguments.session.view.empty()) return Error{"two cameras; give one", "--view/--eye"};
    }
    arguments.input.ltc = arguments.timecode.ltc;
    if (arguments.live_input) TRY_VOID(receiver_options(arguments.input));
    TRY_VOID(open_timecode(arguments.timecode));
    if (arguments.live_input && !arguments.replay.empty() && arguments.timecode.begin.empty())
        return Error{"a desk's levels or a recording's; with --timecode a recording is played live",
                     "--replay"};
    TRY_VOID(check_live_controls(arguments.controls));
    arguments.session.plays_recording = (!arguments.live_input || !arguments.timecode.begin.empty()) &&
                                        arguments.replay.empty() && arguments.session.look.empty();
    if (!arguments.session.look.empty() && arguments.reference.wanted)
        return Error{"the reference draws what a recording does", "--look"};
    const bool film = arguments.live_input || arguments.from_s >= 0 || arguments.to_s >= 0;
    if (arguments.hold_fps > 0 && !arguments.live_input && !(arguments.session.live && film))
        return Error{"what is held is a film: --live-input, or --live (or --eye) with --from and --to",
                     "--hold-fps"};
    if (arguments.hold_fps > 0 && arguments.session.supersample > 1)
        return Error{"what is drawn larger takes longer", "--hold-fps/--supersample"};
    if (!arguments.session.travel.empty() && (arguments.live_input || !film))
        return Error{"only the camera of a film of a recording travels: --from and --to", "--travel"};
    if ((arguments.session.supersample > 1 || arguments.session.map_size > 0) && !arguments.session.live)
        return Error{"passes are as fine as they were baked; with --live or --eye",
                     arguments.session.map_size > 0 ? "--map-size" : "--supersample"};
    if (const int size = arguments.session.map_size; (size & (size - 1)) != 0)
        return Error{std::to_string(size) + " is not a power of two", "--map-size"};
    if (arguments.no_shadows && !arguments.session.live && !arguments.reference.wanted)
        return Error{"baked pictures have their shadows; with --live or --eye", "--no-shadows"};
    if (arguments.has_steps && arguments.beams != "march")
        return Error{"only --beams march takes steps", "--steps"};
    if (arguments.reference.wanted && (arguments.session.supersample > 1 || arguments.session.map_size > 0))
        return Error{"the reference takes --pixel-samples, and rays instead of maps",
                     "--supersample/--map-size"};
    if (!arguments.session.travel.empty() && arguments.session.travel == arguments.session.view)
        return Error{"the camera is there already", "--travel"};
    TRY(const OutputKind kind, output_kind(arguments.out));
    if (!arguments.frames.empty()) {
        char end = 0;
        if (std::sscanf(arguments.frames.c_str(), "%9ld-%9ld%c", &arguments.first_frame,
                        &arguments.last_frame, &end) != 2 ||
            arguments.first_frame < 0 || arguments.last_frame < arguments.first_frame)
            return Error{"'" + arguments.frames + "' is not FIRST-LAST, two numbers of frames", "--frames"};
        if (!film || arguments.live_input || arguments.hold_fps > 0)
            return Error{"a part of a film of a recording: --from and --to, in full quality", "--frames"};
    }
    if (arguments.reference.wanted && (film || kind == OutputKind::film || !arguments.session.travel.empty()))
        return Error{"a reference is one picture: .png or .exr, with --at", "--reference"};
    if (kind == OutputKind::film && !film)
        return Error{"a film needs a range: --from and --to in seconds, or --live-input", arguments.out};
    if (!arguments.farm.engine.empty() && (!film || arguments.live_input || arguments.to_s < 0 ||
                                           arguments.hold_fps > 0 || !arguments.frames.empty()))
        return Error{
            "a farm draws a film of a recording whose end is given, in full quality: --from and --to",
            "--farm"};
    if (arguments.to_s >= 0 && arguments.to_s <= std::max(arguments.from_s, 0.0))
        return Error{"the range is empty: --to must be later than --from", "--from/--to"};
    return film;
}

// What would only come out after a bake of minutes.
Result<void> check_output(const RenderArguments& arguments) {
    std::error_code code;
    const std::filesystem::path folder = std::filesystem::path(arguments.out).parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, code))
        return Error{"no such folder", folder.string()};
    if (std::filesystem::is_directory(arguments.out, code))
        return Error{"is a folder, expected the name of a picture or film", arguments.out};
    return {};
}

Result<void> run(RenderArguments& arguments, bool film) {
    TRY_VOID(check_output(arguments));
    if (!arguments.replay.empty())
        TRY_VOID(check_recording(arguments.replay, capture_options(arguments.input)));
    arguments.reference.capture = capture_options(arguments.input);
    if (arguments.reference.wanted)
        return render_reference(arguments.session, arguments.reference, arguments.replay, arguments.at_s,
                                arguments.fps, arguments.out);
    TRY(const std::unique_ptr<Session> session, open_session(arguments.session));
    video::FilmSound sound;
    const bool is_part = arguments.first_frame >= 0;
    long first_frame = is_part ? arguments.first_frame : 0;
    if (output_kind(arguments.out).value() == OutputKind::film && !arguments.live_input && !is_part) {
        first_frame = film_frames(arguments.from_s, arguments.to_s, arguments.fps).first;
        auto found = film_sound(*session->show, static_cast<double>(first_frame) / arguments.fps);
        if (found.ok()) {
            sound = std::move(*found);
        } else {
            log_error(found.error().text() + "; the film is silent");
            session->report.add(Severity::error, found.error().where, found.error().what);
        }
    }
    TRY(const std::unique_ptr<PictureWriter> writer,
        PictureWriter::create(arguments.out, session->relighter->width() / arguments.session.supersample,
                              session->relighter->height() / arguments.session.supersample, arguments.fps,
                              film, arguments.session.supersample, std::move(sound), first_frame));
    Tally tally;
    TRY_VOID(arguments.live_input ? render_live(arguments, *session, *writer, tally)
                                  : render_recording(arguments, *session, *writer, tally));
    // A desk's film may end when its user says so; half a film of a recording replaces no whole one.
    if (interrupted() && !arguments.live_input)
        return Error{"interrupted: nothing is written but the pictures that were finished", arguments.out};
    TRY_VOID(writer->finish());
    if (const std::string problem = writer->sound_problem(); !problem.empty())
        log_warning(session->show->sound.file.string() + ": " + problem);
    if (interrupted()) return Error{"interrupted: it ends early", arguments.out};
    print_tally(arguments, *session, *writer, tally);
    if (session->report.lost_anything()) return Error{kMadeButMissing, session->show->file.string()};
    return {};
}

// Cut at the frames at which nothing is kept. Before all others one frame is drawn, which bakes or makes
// maps.
Result<int> run_on_farm(const RenderArguments& arguments) {
    TRY_VOID(check_output(arguments));
    Report report;
    TRY(const scene::Show show, open_show(arguments.session.show, true, arguments.session.quiet, report));
    TRY(const std::size_t camera, show.find_camera(arguments.session.view));
    namespace fs = std::filesystem;
    std::error_code code;
    FarmPlan plan;
    TRY(plan.build, farm_build());
    plan.from = fs::current_path(code);
    plan.show = fs::absolute(arguments.session.show, code);
    plan.out = fs::absolute(arguments.out, code);
    if (!arguments.session.live && show.cameras[camera].foreign_passes.empty())
        plan.camera = show.cameras[camera].name;
    plan.fps = arguments.fps;
    const fs::path recording = arguments.replay.empty() ? show.recording : fs::path(arguments.replay);
    if (arguments.session.plays_recording && recording.empty())
        return Error{"has no recording; name one with --replay FILE", show.file.string()};
    if (!recording.empty() && !fs::exists(recording, code)) return Error{"no such file", recording.string()};
    for (const fs::path& file : {recording, fs::path(arguments.session.looks_file)})
        if (!file.empty()) plan.also.push_back(fs::absolute(file, code));
    if (plan.out.extension() == ".mp4") TRY_VOID(film_sound(show, 0)); // else it comes out at the end
    plan.inputs = farm_inputs(show, plan.also);
    plan.words = words_without({{"-o", 1}, {"--out", 1}, {"--json", 0}, {"--quiet", 0}});
    plan.words.push_back("--quiet");
    const auto [first, last] = film_frames(arguments.from_s, arguments.to_s, arguments.fps);
    if (last < first) return Error{"the range is empty: --to must be later than --from", "--from/--to"};
    const auto words = [](long from, long to) {
        return std::vector<std::string>{"--frames", std::to_string(from) + "-" + std::to_string(to)};
    };
    plan.tasks.push_back({"the first frame, with what all need", 0, words(first, first)});
    for (long from = first; from <= last;) {
        const long to = std::min((from / video::kFilmBlockFrames + 1) * video::kFilmBlockFrames - 1, last);
        plan.tasks.push_back(
            {"frames " + std::to_string(from) + " to " + std::to_string(to), 1, words(from, to), from, to});
        from = to + 1;
    }
    return start_farm(std::move(plan), show, arguments.farm, arguments.session.quiet);
}

} // namespace

void add_render(CLI::App& app, int& exit_code) {
    CLI::App* command =
        app.add_subcommand("render", "draw a show without a window: a picture (.png, .exr) or a film (.mp4)");
    const auto a = std::make_shared<RenderArguments>();
    command->add_option("SHOW", a->session.show, "folder with show.toml, or an .mvr")->required();
    command->add_option("-o,--out", a->out, ".png, .exr or .mp4; with a range, .png and .exr are numbered")
        ->required();
    command->add_option("--view", a->session.view, "camera (default: the first)")->type_name("NAME");
    command->add_option("--size", a->size, "WIDTHxHEIGHT instead of the camera's; bakes passes of that size")
        ->type_name("WxH");
    command->add_flag("--live", a->session.live,
                      "draw the stage itself instead of baked passes; distance maps are made where missing");
    command->add_option("--eye", a->eye_m, "free camera: X Y Z in metres; implies --live")
        ->expected(3)
        ->type_name("X Y Z");
    command->add_option("--target", a->target_m, "what it looks at")->expected(3)->type_name("X Y Z");
    command->add_option("--fov", a->fov_y_deg, "its vertical field of view in degrees")
        ->check(number_in(0.1, 170.0)) // as a camera of show.toml
        ->needs("--eye")
        ->capture_default_str();
    command
        ->add_option("--travel", a->session.travel,
                     "fly to this camera in the course of a film; implies --live")
        ->type_name("NAME");
    command
        ->add_option("--supersample", a->session.supersample,
                     "draw it so many times as large and average: finer edges; with --live")
        ->check(CLI::Range(1, 8))
        ->capture_default_str();
    command
        ->add_option("--map-size", a->session.map_size,
                     "texels across a distance map, a power of two: finer shadows; with --live")
        ->check(CLI::Range(scene::kMinDistanceMapSize, scene::kMaxDistanceMapSize));
    command
        ->add_option("--moving-maps", a->moving_maps,
                     "who makes the distance maps of a show with movers: processor or device, as in "
                     "--moving-maps processor (default: the device where it is a graphics card)")
        ->check(CLI::IsMember({"processor", "device"}));
    command
        ->add_option("--glare", a->session.glare,
                     "share of the light that the camera scatters; 0: neither glare nor shining lenses")
        ->check(number_in(0.0, 1.0))
        ->capture_default_str();
    CLI::Option* const bounce = add_bounce_option(*command, a->session.bounce);
    command->add_flag("--no-shadows", a->no_shadows, "light passes through everything; with --live");
    CLI::Option* reference =
        command->add_flag("--reference", a->reference.wanted,
                          "draw by brute force on the processor, in minutes, to compare with");
    command->add_option("--samples", a->reference.samples, "of --reference: along each ray and light")
        ->check(CLI::Range(1, 1048576))
        ->needs(reference)
        ->capture_default_str();
    command
        ->add_option("--pixel-samples", a->reference.pixel_samples, "of --reference: across and down a pixel")
        ->check(CLI::Range(1, 64))
        ->needs(reference)
        ->capture_default_str();
    command
        ->add_option("--lens-samples", a->reference.lens_samples,
                     "of --reference: across a lens; 1: hard shadows")
        ->check(CLI::Range(1, 4096))
        ->needs(reference)
        ->capture_default_str();
    CLI::Option* const bounces =
        command
            ->add_option("--bounces", a->reference.bounces,
                         "of --reference: light that bounces so often is added, by particles")
            ->check(CLI::Range(0, 31))
            ->needs(reference);
    command
        ->add_option("--order", a->reference.order,
                     "of --reference: only the light that bounced so often; 0: direct light")
        ->check(CLI::Range(0, 31))
        ->needs(reference);
    command->add_option("--particles", a->reference.particles_m, "of --bounces and --order: millions")
        ->check(number_in(0.001, 1e6))
        ->needs(reference)
        ->capture_default_str();
    command
        ->add_option("--error-out", a->reference.error_out,
                     "of --bounces: standard deviation of its pixels, an .exr")
        ->type_name("FILE")
        ->needs(bounces);
    command
        ->add_option(
            "--motion", a->motion,
            "machine: fixtures take the time that they need; commanded: at once (default: the show's)")
        ->check(CLI::IsMember({"commanded", "machine"}));
    command->add_option("--replay", a->replay, "DMX recording (default: the show's own)")->type_name("FILE");
    command->add_option("--at", a->at_s, "second of the recording")->check(number_in(0.0, kLongest_s));
    command->add_option("--from", a->from_s, "first second of a film")
        ->check(number_in(0.0, kLongest_s))
        ->excludes("--at");
    command->add_option("--to", a->to_s, "last second of a film")
        ->check(number_in(0.0, kLongest_s))
        ->excludes("--at");
    command->add_option("--fps", a->fps, "frames a second")->check(CLI::Range(1, 240))->capture_default_str();
    command
        ->add_option("--frames", a->frames,
                     "only these pictures of the film, without its sound, numbered as they are from second 0 "
                     "on; drawn "
                     "in parts that "
                     "begin at multiples of " +
                         std::to_string(video::kFilmBlockFrames) + " it has the bytes of the whole")
        ->type_name("FIRST-LAST");
    command->add_option("--threads", a->threads, "processor threads (0: one per core)")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command->add_flag("--live-input", a->live_input, "draw what a desk sends now, by sACN or Art-Net")
        ->excludes("--at");
    CLI::Option* look =
        command->add_option("--look", a->session.look, "a look stored in the window, on top of the recording")
            ->type_name("NAME")
            ->check([](const std::string& name) {
                return name.empty() ? std::string("expected the name of a look") : std::string();
            })
            ->excludes("--live-input");
    command->add_option("--looks", a->session.looks_file, "the file that it is in (default: the show's)")
        ->type_name("FILE")
        ->needs(look);
    add_timecode_options(*command, a->timecode, a->input.midi)->needs("--live-input");
    command->add_option("--seconds", a->seconds, "length of --live-input")
        ->check(number_in(0.1, 86400.0))
        ->needs("--live-input")
        ->capture_default_str();
    command
        ->add_option(
            "--hold-fps", a->hold_fps,
            "lower what would be slower on this machine: of --live-input the quality of haze, and the "
            "picture says so; of a film with --live the pixels that are drawn, and the end says so")
        ->check(CLI::Range(1, 240));
    command
        ->add_flag("--no-caption", a->no_caption,
                   "the picture says neither that nor which universes are lost")
        ->needs("--live-input");
    command->add_option("--beams", a->beams, "gate (ours), cone (the paper) or march (the thesis)")
        ->check(CLI::IsMember({"gate", "cone", "march"}))
        ->capture_default_str();
    CLI::Option* steps = command->add_option("--steps", a->session.beams.march_steps, "steps of march")
                             ->check(CLI::Range(1, 4096))
                             ->capture_default_str();
    CLI::Option* ev = command->add_option("--ev", a->ev100, "exposure EV100 instead of the camera's")
                          ->check(number_in(-10.0, 20.0));
    command
        ->add_flag("--auto-exposure", a->auto_exposure,
                   "a free camera measures its exposure, as one of the show with auto_exposure does")
        ->needs("--eye")
        ->excludes(ev);
    add_tone_option(*command, a->session.tone);
    command->add_option("--device", a->session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_option("--image-memory", a->image_memory_mb, "megabytes for kept images of resting lights")
        ->check(CLI::Range(0, 65536))
        ->capture_default_str();
    add_farm_options(*command, a->farm);
    command->add_flag("--validation", a->session.validation, "check our use of Vulkan");
    command->add_flag("--quiet", a->session.quiet, "print warnings and errors only");
    command->add_flag("--json", a->json, "print the figures as JSON");
    add_input_options(*command, a->input);
    add_live_control_options(*command, a->controls);
    for (const char* name : {"--osc", "--psn"}) command->get_option(name)->needs("--live-input");
    // What it draws with: it would do nothing.
    for (const char* name :
         {"--beams", "--steps", "--glare", "--device", "--image-memory", "--validation", "--json"})
        reference->excludes(command->get_option(name));
    reference->excludes(bounce);
    command->footer(
        "Example: ghostlight render assets/demo -o demo.mp4 --from 10 --to 20\n"
        "         ghostlight render assets/demo -o now.mp4 --live-input --seconds 20\n"
        "         ghostlight render assets/demo -o fly.mp4 --view house --travel close --from 20 --to 30");
    command->callback([a, ev, steps, &exit_code] {
        a->has_ev100 = ev->count() > 0;
        a->has_steps = steps->count() > 0;
        if (a->session.quiet) set_log_level(LogLevel::warning);
        const Result<bool> film = check_usage(*a);
        if (!film.ok()) {
            log_error(film.error().text());
            exit_code = 2;
            return;
        }
        if (a->threads > 0) { // for lavapipe, too
            bake::limit_threads(a->threads);
            ::setenv("LP_NUM_THREADS", std::to_string(a->threads).c_str(), 1);
        }
        if (!a->farm.engine.empty()) {
            const Result<int> done = run_on_farm(*a);
            if (!done.ok()) log_error(done.error().text());
            exit_code = done.ok() ? *done : 1;
            return;
        }
        const Result<void> done = run(*a, *film);
        if (done.ok()) return;
        log_error(done.error().text());
        exit_code = 1;
    });
}

} // namespace ghost::app
