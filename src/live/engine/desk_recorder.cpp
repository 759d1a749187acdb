// SPDX-License-Identifier: Apache-2.0
#include "live/engine/desk_recorder.h"

#include "base/steady_time.h"

#include <utility>

namespace ghost::app {

void DeskRecorder::put(const dmx::Universes& universes, std::chrono::nanoseconds now) {
    const std::lock_guard lock(mutex_);
    if (recording_) recording_->put(universes, now);
}

void DeskRecorder::record(const std::string& to, const dmx::ReceiverOptions* receiver,
                          const dmx::Universes* desk) {
    if (to != to_) {
        end();
        to_ = to;
        if (to_.empty()) return;
        auto begun = receiver ? RunningRecording::create(to_, dmx::asked_universes(*receiver))
                              : Error{"there is no desk to record: nothing listens to the network", to_};
        if (!begun.ok()) {
            link_.recorded.put({to_, 0, begun.error()});
            link_.on_news();
            return;
        }
        // What a desk that rests says already.
        if (desk && !desk->list.empty()) (*begun)->put(*desk, steady_now());
        const std::lock_guard lock(mutex_);
        recording_ = std::move(*begun);
    }
    if (!recording_) return;
    if (const Result<void> written = recording_->write(steady_now()); !written.ok()) {
        std::unique_ptr<RunningRecording> broken;
        {
            const std::lock_guard lock(mutex_);
            broken = std::move(recording_);
        }
        link_.recorded.put({to_, 0, written.error()});
        link_.on_news();
    }
}

void DeskRecorder::end() {
    std::unique_ptr<RunningRecording> ended;
    {
        const std::lock_guard lock(mutex_);
        ended = std::move(recording_);
    }
    if (!ended) return;
    const std::chrono::nanoseconds now = steady_now();
    const Result<void> finished = ended->finish(now);
    link_.recorded.put(
        {to_, ended->seconds(now), finished.ok() ? std::nullopt : std::optional(finished.error())});
    link_.on_news();
}

std::optional<double> DeskRecorder::seconds() const {
    return recording_ ? std::optional(recording_->seconds(steady_now())) : std::nullopt;
}

} // namespace ghost::app
