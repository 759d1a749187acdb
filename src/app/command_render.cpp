// SPDX-License-Identifier: Apache-2.0
#include "app/commands.h"
#include "app/governor.h"
#include "app/input_options.h"
#include "app/interrupt.h"
#include "app/number_option.h"
#include "app/picture_writer.h"
#include "app/reference_render.h"
#include "app/session.h"
#include "dmx/recording.h"

#include "base/log.h"
#include "base/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float kFarthest_m = 10000; // of what a show file may place

struct RenderArguments {
    SessionOptions session;
    InputOptions input;
    std::string out;
    std::string size;
    std::string beams = "gate";
    std::string replay;
    double at_s = -1;
    double from_s = -1;
    double to_s = -1;
    int fps = 30;
    bool live_input = false;
    double seconds = 10;
    int hold_fps = 0; // 0: quality stays
    bool no_caption = false;
    float ev100 = 0;
    bool has_ev100 = false;
    int image_memory_mb = 1024;
    std::vector<float> eye_m;
    std::vector<float> target_m;
    float fov_y_deg = 40;
    std::string travel;
    bool no_shadows = false;
    ReferenceArguments reference;
    bool json = false;
};

struct Tally {
    std::vector<double> draw_ms;
    std::vector<double> latency_ms; // packet to picture
    int late = 0;                   // film frames that repeat a picture because drawing took too long
    int additions = 0;
    int drawn = 0;
    int quality_changes = 0;
    std::size_t quality_level = 0; // 0 is the best

    void add(const render::FrameStatistics& frame) {
        draw_ms.push_back(frame.draw_ms);
        additions += frame.additions;
        drawn += frame.drawn;
    }
};

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void print_tally(const RenderArguments& arguments, const Session& session, const Tally& tally) {
    const double median = percentile(tally.draw_ms, 0.5);
    const double p99 = percentile(tally.draw_ms, 0.99);
    if (arguments.json) {
        nlohmann::json row{{"out", arguments.out},
                           {"device", session.device->name()},
                           {"width", session.relighter->width()},
                           {"height", session.relighter->height()},
                           {"frames", tally.draw_ms.size()},
                           {"draw_ms_median", median},
                           {"draw_ms_p99", p99},
                           {"lights_drawn", tally.drawn},
                           {"additions", tally.additions},
                           {"ev100", session.relighter->ev100_used()}};
        if (arguments.live_input) {
            row["late_frames"] = tally.late;
            row["packet_to_picture_ms_median"] = percentile(tally.latency_ms, 0.5);
            row["packet_to_picture_ms_p99"] = percentile(tally.latency_ms, 0.99);
            row["frames_with_new_packets"] = tally.latency_ms.size();
            row["quality_level"] = tally.quality_level;
            row["quality_changes"] = tally.quality_changes;
        }
        std::printf("%s\n", row.dump().c_str());
        return;
    }
    log_info(arguments.out + ": " + std::to_string(tally.draw_ms.size()) + " frames, " +
             std::to_string(median) + " ms a frame (median), " + std::to_string(p99) + " ms (99 %)");
    if (arguments.live_input && !tally.latency_ms.empty())
        log_info("packet to picture: " + std::to_string(percentile(tally.latency_ms, 0.5)) +
                 " ms (median); " + std::to_string(tally.late) +
                 " film frames repeat a picture because drawing took longer than a frame");
}

// The rig is run from the start of the recording, because wheels and gobos turn: a frame is the same wherever
// it is asked from.
Result<void> render_recording(const RenderArguments& arguments, Session& session, PictureWriter& writer,
                              Tally& tally) {
    const std::filesystem::path file =
        arguments.replay.empty() ? session.show->recording : std::filesystem::path(arguments.replay);
    if (arguments.replay.empty() && session.show->recording.empty())
        return Error{"has no recording; name one with --replay FILE, or listen to a desk with --live-input",
                     session.show->file.string()};
    TRY(dmx::Recording recording, dmx::read_recording(file));
    for (const Error& problem : recording.problems) log_warning(problem.text());
    const dmx::Player player(std::move(recording));

    const double fps = arguments.fps;
    const bool still = arguments.from_s < 0 && arguments.to_s < 0;
    const double at_s = arguments.at_s >= 0 ? arguments.at_s : 0.0;
    const auto first = static_cast<long>(std::lround((still ? at_s : std::max(arguments.from_s, 0.0)) * fps));
    const long last =
        still ? first : std::lround((arguments.to_s >= 0 ? arguments.to_s : player.duration_s()) * fps) - 1;
    if (last < first) return Error{"the range is empty: --to must be later than --from", "--from/--to"};

    if (static_cast<double>(first) / fps > player.duration_s())
        log_warning("the recording ends at " + std::to_string(player.duration_s()) +
                    " s; what is drawn is its last look");
    const scene::Camera start = session.show->cameras[session.camera];
    std::optional<scene::Camera> travel_to;
    if (!arguments.travel.empty()) {
        TRY(const std::size_t camera, session.show->find_camera(arguments.travel));
        travel_to = session.show->cameras[camera];
    }
    catch_interrupts();
    const auto now_s = [] { return std::chrono::duration<double>(Clock::now().time_since_epoch()).count(); };
    Progress progress(
        "rendering",
        arguments.session.quiet || still ? Progress::Style::silent : Progress::style_for_stderr(), now_s());
    for (long frame = 0; frame <= last; ++frame) {
        if (interrupted()) break;
        session.rig->step(player.at(static_cast<double>(frame) / fps), 1.0 / fps);
        if (frame < first) continue;
        if (travel_to)
            session.look_from(camera_between(start, *travel_to,
                                             static_cast<float>(frame - first) /
                                                 static_cast<float>(std::max(last - first, 1L))));
        tally.add(session.draw(static_cast<double>(frame) / fps));
        TRY_VOID(writer.add(*session.relighter));
        progress.update(static_cast<double>(frame - first + 1) / static_cast<double>(last - first + 1),
                        now_s(), arguments.out);
    }
    progress.finish();
    return {};
}

// Tells the governor what a frame took; what it lowers holds from the next frame on.
void govern(Governor& governor, double frame_ms, Session& session, Tally& tally) {
    if (!governor.add(frame_ms)) return;
    session.relighter->set_quality(governor.quality());
    // Lights that rest show what they were drawn with.
    if (governor.level() < tally.quality_level) session.relighter->forget();
    tally.quality_changes += governor.level() != tally.quality_level ? 1 : 0;
    tally.quality_level = governor.level();
    const std::string note = governor.note();
    if (governor.holds())
        log_info(note.empty() ? "haze: full quality again" : note);
    else
        log_warning(note);
}

// A rig that rests can be drawn as well as it goes: one more frame, at full quality. When it moves again,
// what the governor chose holds again.
class Rest {
public:
    explicit Rest(const render::HazeQuality& full) : full_(full) {}

    // After each frame; true: this one was drawn for the rest, and tells nothing about frames that move.
    bool look(const Governor& governor, int drawn, double now_s, render::Relighter& relighter) {
        if (drawn > 0) {
            const bool ours = state_ == State::settling;
            if (state_ == State::settled) relighter.set_quality(governor.quality());
            state_ = ours ? State::settled : State::moving;
            last_drawn_s_ = now_s;
            return ours;
        }
        if (state_ == State::moving && governor.level() > 0 && now_s - last_drawn_s_ > kCalm_s) {
            relighter.set_quality(full_);
            relighter.forget();
            state_ = State::settling;
        }
        return false;
    }
    bool settled() const { return state_ != State::moving; }

private:
    static constexpr double kCalm_s = 0.5;
    enum class State { moving, settling, settled };

    render::HazeQuality full_;
    State state_ = State::moving;
    double last_drawn_s_ = 0;
};

// Film time is wall time: a picture that takes longer than a frame is shown for several.
Result<void> render_live(const RenderArguments& arguments, Session& session, PictureWriter& writer,
                         Tally& tally) {
    TRY(const dmx::ReceiverOptions options, receiver_options(arguments.input));
    TRY(const std::unique_ptr<dmx::Receiver> receiver, dmx::Receiver::start(options));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    catch_interrupts();
    char length[32];
    std::snprintf(length, sizeof length, "listening for %g s", arguments.seconds);
    log_info(length);

    dmx::Universes universes;
    const Clock::time_point start = Clock::now();
    Clock::time_point last_step = start;
    const auto frame_time = std::chrono::duration<double>(1.0 / arguments.fps);
    const long frames = std::max(1L, std::lround(arguments.seconds * arguments.fps));
    long written = 0;
    std::optional<Governor> governor;
    if (arguments.hold_fps > 0) governor.emplace(arguments.hold_fps, quality_levels(arguments.session.beams));
    Rest rest(quality_levels(arguments.session.beams).front());
    while (written < frames && !interrupted()) {
        std::this_thread::sleep_until(
            start + std::chrono::duration_cast<Clock::duration>(frame_time * static_cast<double>(written)));
        bool fresh = false;
        if (std::optional<dmx::Universes> newest = receiver->take()) {
            fresh = newest->revision != universes.revision;
            universes = std::move(*newest);
        }
        const Clock::time_point now = Clock::now();
        session.rig->step(universes, std::chrono::duration<double>(now - last_step).count());
        last_step = now;
        const render::FrameStatistics frame =
            session.draw(std::chrono::duration<double>(now - start).count());
        tally.add(frame);
        if (fresh) {
            std::chrono::nanoseconds arrival{0};
            for (const dmx::Universe& universe : universes.list)
                arrival = std::max(arrival, universe.arrival);
            tally.latency_ms.push_back(
                std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch() - arrival).count());
        }
        const auto due = static_cast<long>(std::chrono::duration<double>(Clock::now() - start) / frame_time);
        const long repeat = std::clamp(due - written, 1L, frames - written);
        tally.late += static_cast<int>(repeat - 1);
        const bool for_rest =
            governor && rest.look(*governor, frame.drawn, std::chrono::duration<double>(now - start).count(),
                                  *session.relighter);
        const std::string caption =
            governor && !arguments.no_caption && !rest.settled() ? governor->note() : std::string();
        for (long i = 0; i < repeat; ++i, ++written) {
            TRY_VOID(writer.add(*session.relighter, caption));
            // The pictures that repeat it would not be there had it been in time.
            if (i > 0 || !governor || frame.drawn == 0 || for_rest) continue;
            govern(*governor, std::chrono::duration<double, std::milli>(Clock::now() - now).count(), session,
                   tally);
        }
    }
    if (tally.latency_ms.empty())
        log_warning(
            "no packet arrived: the rig stayed at its defaults; 'ghostlight monitor' shows who sends what");
    return {};
}

// What the command line asks for, checked before anything is opened.
Result<bool> check_usage(RenderArguments& arguments) {
    if (!arguments.size.empty()) {
        char end = 0;
        if (std::sscanf(arguments.size.c_str(), "%dx%d%c", &arguments.session.width,
                        &arguments.session.height, &end) != 2 ||
            arguments.session.width < 16 || arguments.session.height < 16 || arguments.session.width > 8192 ||
            arguments.session.height > 8192)
            return Error{"'" + arguments.size + "' is not WIDTHxHEIGHT between 16x16 and 8192x8192",
                         "--size"};
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
    if (arguments.has_ev100) arguments.session.ev100 = arguments.ev100;
    arguments.session.shadows = !arguments.no_shadows;
    arguments.session.maps_in_background = arguments.live_input;
    arguments.session.live = arguments.session.live || !arguments.eye_m.empty() || !arguments.travel.empty();
    if (arguments.eye_m.empty() != arguments.target_m.empty())
        return Error{"a free camera needs both", "--eye/--target"};
    if (!arguments.eye_m.empty()) {
        scene::Camera& eye = arguments.session.eye.emplace();
        eye.name = "free";
        eye.position_m = {arguments.eye_m[0], arguments.eye_m[1], arguments.eye_m[2]};
        eye.target_m = {arguments.target_m[0], arguments.target_m[1], arguments.target_m[2]};
        eye.fov_y_deg = arguments.fov_y_deg;
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(eye.position_m[axis]) <= kFarthest_m &&
                  std::abs(eye.target_m[axis]) <= kFarthest_m))
                return Error{"metres must be numbers up to 10 km", "--eye/--target"};
        if (glm::distance(eye.position_m, eye.target_m) < 1e-3f)
            return Error{"the camera stands at what it looks at", "--eye/--target"};
        if (!arguments.session.view.empty()) return Error{"two cameras; give one", "--view/--eye"};
    }
    const bool film = arguments.live_input || arguments.from_s >= 0 || arguments.to_s >= 0;
    if (!arguments.travel.empty() && (arguments.live_input || !film))
        return Error{"only the camera of a film of a recording travels: --from and --to", "--travel"};
    if (arguments.no_shadows && !arguments.session.live)
        return Error{"baked pictures have their shadows; with --live or --eye", "--no-shadows"};
    TRY(const OutputKind kind, output_kind(arguments.out));
    if (arguments.reference.wanted && (film || kind == OutputKind::film || !arguments.travel.empty()))
        return Error{"a reference is one picture: .png or .exr, with --at", "--reference"};
    if (kind == OutputKind::film && !film)
        return Error{"a film needs a range: --from and --to in seconds, or --live-input", arguments.out};
    if (arguments.to_s >= 0 && arguments.to_s <= std::max(arguments.from_s, 0.0))
        return Error{"the range is empty: --to must be later than --from", "--from/--to"};
    return film;
}

Result<void> run(RenderArguments& arguments, bool film) {
    if (arguments.reference.wanted)
        return render_reference(arguments.session, arguments.reference, arguments.replay, arguments.at_s,
                                arguments.fps, arguments.out);
    TRY(const std::unique_ptr<Session> session, open_session(arguments.session));
    TRY(const std::unique_ptr<PictureWriter> writer,
        PictureWriter::create(arguments.out, session->relighter->width(), session->relighter->height(),
                              arguments.fps, film));
    Tally tally;
    TRY_VOID(arguments.live_input ? render_live(arguments, *session, *writer, tally)
                                  : render_recording(arguments, *session, *writer, tally));
    TRY_VOID(writer->finish());
    if (interrupted()) return Error{"interrupted: it ends early", arguments.out};
    print_tally(arguments, *session, tally);
    if (session->report.lost_anything())
        return Error{"drawn, but something that the show asks for is missing (see above)",
                     session->show->file.string()};
    return {};
}

} // namespace

void add_render(CLI::App& app, int& exit_code) {
    CLI::App* command =
        app.add_subcommand("render", "draw a show without a window: a picture (.png, .exr) or a film (.mp4)");
    const auto a = std::make_shared<RenderArguments>();
    command->add_option("SHOW", a->session.show, "folder with show.toml")->required();
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
        ->check(number_in(1.0, 150.0))
        ->needs("--eye")
        ->capture_default_str();
    command->add_option("--travel", a->travel, "fly to this camera in the course of a film; implies --live")
        ->type_name("NAME");
    command
        ->add_option("--glare", a->session.glare,
                     "share of the light that the camera scatters; 0: neither glare nor shining lenses")
        ->check(number_in(0.0, 1.0))
        ->capture_default_str();
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
    command->add_option("--replay", a->replay, "DMX recording (default: the show's own)")->type_name("FILE");
    command->add_option("--at", a->at_s, "second of the recording")->check(number_in(0.0, 86400.0));
    command->add_option("--from", a->from_s, "first second of a film")
        ->check(number_in(0.0, 86400.0))
        ->excludes("--at");
    command->add_option("--to", a->to_s, "last second of a film")
        ->check(number_in(0.0, 86400.0))
        ->excludes("--at");
    command->add_option("--fps", a->fps, "frames a second")->check(CLI::Range(1, 240))->capture_default_str();
    command->add_flag("--live-input", a->live_input, "draw what a desk sends now, by sACN or Art-Net")
        ->excludes("--replay")
        ->excludes("--at");
    command->add_option("--seconds", a->seconds, "length of --live-input")
        ->check(number_in(0.1, 86400.0))
        ->needs("--live-input")
        ->capture_default_str();
    CLI::Option* hold =
        command
            ->add_option("--hold-fps", a->hold_fps,
                         "lower the quality of haze where --live-input would be slower; the picture says so")
            ->check(CLI::Range(1, 240))
            ->needs("--live-input");
    command->add_flag("--no-caption", a->no_caption, "the picture does not say it")->needs(hold);
    command->add_option("--beams", a->beams, "gate (ours), cone (the paper) or march (the thesis)")
        ->check(CLI::IsMember({"gate", "cone", "march"}))
        ->capture_default_str();
    command->add_option("--steps", a->session.beams.march_steps, "steps of march")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    CLI::Option* ev = command->add_option("--ev", a->ev100, "exposure EV100 instead of the camera's")
                          ->check(number_in(-10.0, 20.0));
    command->add_option("--device", a->session.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_option("--image-memory", a->image_memory_mb, "megabytes for kept images of resting lights")
        ->check(CLI::Range(0, 65536))
        ->capture_default_str();
    command->add_flag("--validation", a->session.validation, "check our use of Vulkan");
    command->add_flag("--quiet", a->session.quiet, "print warnings and errors only");
    command->add_flag("--json", a->json, "print the figures as JSON");
    add_input_options(*command, a->input);
    command->footer(
        "Example: ghostlight render assets/demo -o demo.mp4 --from 10 --to 20\n"
        "         ghostlight render assets/demo -o now.mp4 --live-input --seconds 20\n"
        "         ghostlight render assets/demo -o fly.mp4 --view house --travel close --from 20 --to 30");
    command->callback([a, ev, &exit_code] {
        a->has_ev100 = ev->count() > 0;
        if (a->session.quiet) set_log_level(LogLevel::warning);
        const Result<bool> film = check_usage(*a);
        if (!film.ok()) {
            log_error(film.error().text());
            exit_code = 2;
            return;
        }
        const Result<void> done = run(*a, *film);
        if (done.ok()) return;
        log_error(done.error().text());
        exit_code = 1;
    });
}

} // namespace ghost::app
