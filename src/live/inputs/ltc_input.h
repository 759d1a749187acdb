#pragma once
// SPDX-License-Identifier: Apache-2.0
// LtcInput: LTC from a sound card, or from a sound file that plays once, as if a card heard it. It may be
// plugged in later; one that went away is opened again when it is back, looked for once a second. The time
// code may be in either channel. A thread of its own hands it on; errors are said in the log, once each.

#include "base/result.h"
#include "dmx/wire/packet.h"
#include "sound/ltc_decoder.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>

namespace ghost::app {

// For people.
struct LtcStatus {
    std::string name; // of the input
    bool open = false;
    std::string problem;               // why it is not open
    std::uint64_t openings = 0;        // 1: never pulled out
    int channel = 0;                   // that brought the newest time code, from 1
    sound::LtcCounters counters;       // of it
    double loudest_dbfs = -100;        // of the last tenth of a second
    std::optional<dmx::TimeCode> time; // the newest
    std::chrono::nanoseconds arrival{0};
};

class LtcInput {
public:
    using Take = sound::LtcDecoder::Take;
    // name: a file, or an input as ALSA has it. take: called by a thread of ours, and must be quick.
    LtcInput(std::string name, Take take);
    ~LtcInput();
    LtcInput(const LtcInput&) = delete;
    LtcInput& operator=(const LtcInput&) = delete;

    LtcStatus status() const;

private:
    void run();
    Result<void> play_file();
    Result<void> listen();
    void opened();
    void feed(std::span<const std::int16_t> samples, int channels, std::chrono::nanoseconds end,
              std::array<sound::LtcDecoder, 2>& decoders);

    const std::string name_;
    const Take take_;
    mutable std::mutex mutex_; // of status_
    LtcStatus status_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

} // namespace ghost::app
