// SPDX-License-Identifier: Apache-2.0
#include "base/interrupt.h"
#include "cli/options/input_options.h"
#include "cli/render/private/film_controls.h"
#include "cli/render/render_film.h"
#include "dmx/record/recording_tasks.h"
#include "live/engine/governor.h"
#include "live/inputs/joined_universes.h"
#include "live/inputs/loss_note.h"

#include "base/log.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <thread>

namespace ghost::app {
namespace {

using Clock = std::chrono::steady_clock;

// Tells the governor what a frame took; what it lowers holds from the next frame on.
void govern(Governor& governor, double frame_ms, double haze_ms, Session& session, Tally& tally) {
    if (!governor.add(frame_ms, haze_ms)) return;
    session.relighter->set_quality(governor.quality());
    // Lights that rest show what they were drawn with.
    if (governor.level() < tally.quality_level) session.relighter->draw_anew();
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
            relighter.draw_anew();
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

} // namespace

Result<void> render_live(const RenderArguments& arguments, Session& session, PictureWriter& writer,
                         Tally& tally) {
    TRY(dmx::ReceiverOptions options, receiver_options(arguments.input));
    options.universes = joined_universes(options.universes, scene::PatchMap(*session.show));
    options.listen_wider = true;
    TRY(const std::unique_ptr<TimeCodeInput> timecode, open_timecode(arguments.timecode));
    std::optional<dmx::Player> player;
    if (timecode) {
        timecode->listen(options);
        const std::filesystem::path file =
            arguments.replay.empty() ? session.show->recording : std::filesystem::path(arguments.replay);
        TRY(dmx::Recording recording,
            open_recording(file, capture_options(arguments.input), arguments.session.quiet));
        player.emplace(std::move(recording));
    }
    TRY(const std::unique_ptr<dmx::Receiver> receiver, dmx::Receiver::start(options));
    for (const std::string& warning : receiver->warnings()) log_warning(warning);
    TRY(FilmControls controls, FilmControls::open(arguments.controls, *session.show,
                                                  arguments.input.interface, arguments.session.ev100));
    catch_interrupts();
    wait_for_sources(*receiver);
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
    LossNote loss;
    Rest rest(quality_levels(arguments.session.beams).front());
    while (written < frames && !interrupted()) {
        std::this_thread::sleep_until(
            start + std::chrono::duration_cast<Clock::duration>(frame_time * static_cast<double>(written)));
        bool fresh = false;
        if (std::optional<dmx::Universes> newest = receiver->take()) {
            fresh = newest->revision != universes.revision;
            universes = std::move(*newest);
        }
        if (player) {
            const auto at_s = timecode->at_s(player->duration_s());
            if (at_s) {
                universes = player->at(*at_s);
                session.media_s = at_s;
                session.rig->set_time(at_s);
            }
            fresh = false; // of a recording nothing arrives
        }
        const Clock::time_point now = Clock::now();
        controls.before_frame(session, std::chrono::duration<double>(now - start).count());
        session.rig->step(universes, std::chrono::duration<double>(now - last_step).count());
        last_step = now;
        controls.aim(session);
        const render::FrameStatistics frame =
            session.draw(std::chrono::duration<double>(now - start).count());
        tally.add(frame);
        if (fresh) {
            std::chrono::nanoseconds arrival{0};
            for (const dmx::Universe& universe : universes.list)
                arrival = std::max(arrival, universe.arrival);
            tally.latency.add(Clock::now().time_since_epoch() - arrival);
        }
        const auto due = static_cast<long>(std::chrono::duration<double>(Clock::now() - start) / frame_time);
        const long repeat = std::clamp(due - written, 1L, frames - written);
        tally.late += static_cast<int>(repeat - 1);
        const bool for_rest =
            governor && rest.look(*governor, frame.drawn, std::chrono::duration<double>(now - start).count(),
                                  *session.relighter);
        if (!player) loss.look(universes, now.time_since_epoch());
        const std::string caption =
            arguments.no_caption ? std::string()
                                 : joined(governor && !rest.settled() ? governor->note() : "", loss.text());
        TRY_VOID(writer.add(*session.relighter, caption));
        // The pictures that repeat it would not be there had it been in time.
        if (governor && frame.drawn > 0 && !for_rest)
            govern(*governor, std::chrono::duration<double, std::milli>(Clock::now() - now).count(),
                   frame.haze_ms(), session, tally);
        TRY_VOID(writer.repeat(repeat - 1));
        written += repeat;
    }
    if (timecode && !timecode->at_s(0.0))
        log_warning(
            "no time code arrived: the rig stayed at its defaults; 'ghostlight monitor' shows what does");
    if (!timecode && tally.latency.count() == 0)
        log_warning(
            "no packet arrived: the rig stayed at its defaults; 'ghostlight monitor' shows who sends what");
    return {};
}

} // namespace ghost::app
