// SPDX-License-Identifier: Apache-2.0
#include "base/interrupt.h"
#include "cli/options/input_options.h"
#include "cli/render/render_film.h"
#include "dmx/record/recording_tasks.h"
#include "live/engine/pace.h"
#include "live/session/picture_room.h"
#include "show/camera_moves.h"

#include "base/log.h"
#include "base/progress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace ghost::app {

namespace {

constexpr double kShort_s = 600; // up to here all that comes before is stepped through
constexpr double kLeadIn_s = 60; // further on this much: more than the slowest machine needs for any way

// The frame from which machines are moved, so that they stand right in `first`. Movers may take any time.
long begin_at(long first, double fps, bool has_movers) {
    if (has_movers || static_cast<double>(first) / fps <= kShort_s) return 0;
    return first - std::lround(kLeadIn_s * fps);
}

scene::Camera coarser(scene::Camera camera, double share) {
    const auto pixels = [&](int side) {
        return std::min(std::max(static_cast<int>(std::lround(share * side)), kLeastPixels), side);
    };
    camera.width = pixels(camera.width);
    camera.height = pixels(camera.height);
    return camera;
}

} // namespace

std::pair<long, long> film_frames(double from_s, double to_s, int fps) {
    return {std::lround(std::max(from_s, 0.0) * fps), std::lround(to_s * fps) - 1};
}

Result<void> render_recording(const RenderArguments& arguments, Session& session, PictureWriter& writer,
                              Tally& tally) {
    const std::filesystem::path file =
        arguments.replay.empty() ? session.show->recording : std::filesystem::path(arguments.replay);
    std::optional<dmx::Player> player;
    // A look needs no desk.
    if (!file.empty() || session.programmer.empty()) {
        TRY(dmx::Recording recording,
            open_recording(file, capture_options(arguments.input), arguments.session.quiet));
        player.emplace(std::move(recording));
    }
    const double end_s = player ? player->duration_s() : 0;

    const double fps = arguments.fps;
    const bool still = arguments.from_s < 0 && arguments.to_s < 0;
    const double at_s = arguments.at_s >= 0 ? arguments.at_s : 0.0;
    auto [first, last] =
        film_frames(arguments.from_s, arguments.to_s >= 0 ? arguments.to_s : end_s, arguments.fps);
    if (still) first = last = std::lround(at_s * fps);
    if (last < first) return Error{"the range is empty: --to must be later than --from", "--from/--to"};
    const bool is_part = arguments.first_frame >= 0;
    const long draws_from = is_part ? arguments.first_frame : first;
    const long draws_to = is_part ? arguments.last_frame : last;
    if (draws_from < first || draws_to > last)
        return Error{"the film has the frames " + std::to_string(first) + " to " + std::to_string(last),
                     "--frames"};

    if (player && static_cast<double>(first) / fps > end_s)
        log_warning("the recording ends at " + std::to_string(end_s) + " s; what is drawn is its last look");
    session.media_waits = true;
    const scene::Camera start = session.show->cameras[session.camera];
    catch_interrupts();
    const auto now_s = [] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    Progress progress(
        "rendering",
        arguments.session.quiet || still ? Progress::Style::silent : Progress::style_for_stderr(), now_s());
    std::optional<Pace> pace;
    if (arguments.hold_fps > 0) {
        pace.emplace(session.show->fixtures.size());
        session.relighter->set_quality({.grid = true});
    }
    for (long frame = begin_at(first, fps, !session.show->movers.empty()); frame <= draws_to; ++frame) {
        if (interrupted()) break;
        session.rig->set_time(static_cast<double>(frame) / fps);
        session.rig->step(player ? player->at(static_cast<double>(frame) / fps) : dmx::Universes{}, 1.0 / fps,
                          session.programmer);
        if (frame < draws_from) continue;
        // So that a film that is drawn in parts, which begin where a block does, has the bytes of the whole.
        if (!pace && frame % video::kFilmBlockFrames == 0) session.relighter->reset();
        scene::Camera camera = start;
        const bool rides = start.mover != scene::kNoMover && session.live;
        if (rides) camera = scene::riding(start, *session.rig);
        if (session.travel_to)
            camera = camera_between(camera, *session.travel_to,
                                    static_cast<float>(frame - first) /
                                        static_cast<float>(std::max(last - first, 1L)));
        if (pace) camera = coarser(camera, pace->level().sides);
        bool is_resized =
            camera.width != session.relighter->width() || camera.height != session.relighter->height();
        const double begin_s = now_s();
        if (session.travel_to || rides || is_resized)
            session.look_from(camera, pace && (session.travel_to || rides));
        if (pace && pace->level().coarse_light != session.relighter->is_coarse()) {
            session.use_coarse_light(pace->level().coarse_light);
            is_resized = true;
        }
        if (pace && is_resized) session.relighter->set_quality({.grid = true}); // it is another one
        tally.add(session.draw(static_cast<double>(frame) / fps));
        // Another size costs what no other frame does.
        if (pace && !is_resized && frame > first) pace->add(1e3 * (now_s() - begin_s), arguments.hold_fps);
        ++tally.sizes[{session.relighter->width(), session.relighter->height()}];
        TRY_VOID(writer.add(*session.relighter));
        progress.update(static_cast<double>(frame - draws_from + 1) /
                            static_cast<double>(draws_to - draws_from + 1),
                        now_s(), arguments.out);
    }
    progress.finish();
    if (player) log_damage(*player);
    return {};
}

} // namespace ghost::app
