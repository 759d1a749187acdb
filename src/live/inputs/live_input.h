#pragma once
// SPDX-License-Identifier: Apache-2.0
// LiveInput: the levels that a window shows: those of a desk, or of the show's recording, which plays, rests
// and jumps as a person wants. A desk is heard all the time, also while the recording is shown; what one held
// that was silent before this began counts for nothing until it sends again. Seconds; one thread.

#include "base/result.h"
#include "diagnose/explain.h"
#include "dmx/receive/receiver.h"
#include "dmx/record/player.h"
#include "link/link.h"
#include "live/inputs/timecode_input.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {

class LiveInput {
public:
    // receiver: may be null (a port was taken), else must outlive this.
    // timecode: what the recording follows instead of the transport, once it is heard; may be null, too.
    explicit LiveInput(dmx::Receiver* receiver, const TimeCodeInput* timecode = nullptr)
        : receiver_(receiver), timecode_(timecode) {}
    ~LiveInput();
    LiveInput(const LiveInput&) = delete;
    LiveInput& operator=(const LiveInput&) = delete;

    // One that could not be started before.
    void set_receiver(dmx::Receiver* receiver) { receiver_ = receiver; }
    // Instead of the recording before; an empty path: none.
    Result<void> load_recording(const std::filesystem::path& file, Report& report);
    // dmx::activity_of the recording, once, when it is measured.
    std::optional<std::vector<float>> take_activity();
    double recording_s() const { return player_ ? player_->duration_s() : 0; }

    // What is there now, dt_s after the call before. 0: time stands still, and what a desk sends meanwhile
    // and a time code's moments wait; a jump within the recording is made.
    void step(ui::Input wanted, const ui::Transport& transport, double dt_s);
    const dmx::Universes& universes() const { return shows_desk_ ? desk_ : played_; }
    const dmx::Universes& desk() const { return desk_; } // heard, shown or not
    bool shows_desk() const { return shows_desk_; }
    double at_s() const { return at_s_; }
    std::uint64_t seeks() const { return seeks_; } // the last jump of the transport that was made
    // "time code freewheels since 0.4 s"; "" while it runs, and where none is followed.
    std::string timecode_text() const {
        return timecode_ ? dmx::chase_text(timecode_->status()) : std::string();
    }
    // The recording that plays has other levels so much later.
    bool plays_else_in(double dt_s) const;
    // A remote control jumps; the transport goes on from there.
    void jump(double at_s) { at_s_ = at_s; }
    // Goes on where another one was: its desk, its place in the recording.
    void go_on_from(const LiveInput& before);
    // Steady time of the first packet that changed what the last step brought of a desk; else 0.
    std::chrono::nanoseconds arrival() const { return arrival_; }
    // The newest statistics of the network, each once.
    std::optional<dmx::Statistics> take_statistics();

    // For scene::Explainer: how the levels came here, and the clock of their arrivals.
    scene::Reception reception(const scene::PatchMap& patch) const;
    double now_s() const;

private:
    dmx::Receiver* receiver_;
    const TimeCodeInput* timecode_;
    std::filesystem::path file_;
    std::unique_ptr<dmx::Player> player_;
    std::vector<std::pair<int, double>> first_frames_s_; // of each universe
    dmx::Universes desk_, played_;
    dmx::Statistics statistics_;
    bool statistics_are_new_ = false;
    bool shows_desk_ = false;
    double at_s_ = 0;
    std::chrono::nanoseconds since_ = std::chrono::steady_clock::now().time_since_epoch();
    double listened_s_ = 0;
    std::uint64_t seeks_ = 0;
    std::chrono::nanoseconds arrival_{0};
    bool was_frozen_ = false; // in the step before
    std::atomic<bool> stop_measuring_{false};
    std::future<std::vector<float>> measuring_; // the last member: it uses the one above
};

} // namespace ghost::app
