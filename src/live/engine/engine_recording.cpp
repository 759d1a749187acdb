// SPDX-License-Identifier: Apache-2.0
// The recorder of the window: what the desk sends goes into a file while it is shown, and files are played in
// the place of the show's own recording.
#include "live/engine/engine.h"

#include <exception>

namespace ghost::app {
namespace {

std::chrono::nanoseconds steady_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

} // namespace

// On the receiver's thread.
void Engine::hear(const dmx::Universes& universes, std::chrono::nanoseconds now) {
    const std::lock_guard lock(recording_mutex_);
    if (recording_) recording_->put(universes, now);
}

void Engine::record() {
    if (request_.record_to != recording_to_) {
        end_recording();
        recording_to_ = request_.record_to;
        if (recording_to_.empty()) return;
        auto begun = receiver_
                         ? RunningRecording::create(recording_to_, dmx::asked_universes(options_.receiver))
                         : Error{"there is no desk to record: nothing listens to the network", recording_to_};
        if (!begun.ok()) {
            link_.recorded.put({recording_to_, 0, begun.error()});
            link_.on_news();
            return;
        }
        // What a desk that rests says already.
        if (input_ && !input_->desk().list.empty()) (*begun)->put(input_->desk(), steady_now());
        const std::lock_guard lock(recording_mutex_);
        recording_ = std::move(*begun);
    }
    if (!recording_) return;
    if (const Result<void> written = recording_->write(steady_now()); !written.ok()) {
        std::unique_ptr<RunningRecording> broken;
        {
            const std::lock_guard lock(recording_mutex_);
            broken = std::move(recording_);
        }
        link_.recorded.put({recording_to_, 0, written.error()});
        link_.on_news();
    }
}

void Engine::end_recording() {
    std::unique_ptr<RunningRecording> ended;
    {
        const std::lock_guard lock(recording_mutex_);
        ended = std::move(recording_);
    }
    if (!ended) return;
    const std::chrono::nanoseconds now = steady_now();
    const Result<void> finished = ended->finish(now);
    link_.recorded.put(
        {recording_to_, ended->seconds(now), finished.ok() ? std::nullopt : std::optional(finished.error())});
    link_.on_news();
}

void Engine::choose_recording() {
    if (request_.recording == played_) return;
    played_ = request_.recording;
    const std::filesystem::path file =
        played_.empty() ? session_->show->recording : std::filesystem::path(played_);
    if (auto loaded = input_->load_recording(file, session_->report); !loaded.ok()) {
        link_.failed.put(loaded.error());
        link_.on_news();
    }
}

} // namespace ghost::app
