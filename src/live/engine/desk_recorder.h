#pragma once
// SPDX-License-Identifier: Apache-2.0
// DeskRecorder: what the desk sends goes into a file while it is shown. What becomes of it is told by the
// link. The receiver's thread brings the levels, all else is of the engine's.

#include "dmx/receive/receiver_options.h"
#include "link/link.h"
#include "live/inputs/running_recording.h"

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace ghost::app {

class DeskRecorder {
public:
    explicit DeskRecorder(ui::Link& link) : link_(link) {}
    ~DeskRecorder() { end(); }
    DeskRecorder(const DeskRecorder&) = delete;
    DeskRecorder& operator=(const DeskRecorder&) = delete;

    // Any thread.
    void put(const dmx::Universes& universes, std::chrono::nanoseconds now);
    // Before each frame. to: the file that is wanted; empty: none. receiver: what is heard; null: nothing
    // listens. desk: the levels that it sends already, or null.
    void record(const std::string& to, const dmx::ReceiverOptions* receiver, const dmx::Universes* desk);
    void end();
    // Of the recording that runs.
    std::optional<double> seconds() const;

private:
    ui::Link& link_;
    std::mutex mutex_;
    std::unique_ptr<RunningRecording> recording_; // with mutex_, where it is replaced or fed
    std::string to_;
};

} // namespace ghost::app
