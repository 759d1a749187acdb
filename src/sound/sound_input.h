#pragma once
// SPDX-License-Identifier: Apache-2.0
// SoundInput: what a sound card hears, by ALSA: 48,000 samples a second of 16 bits, its first two channels,
// or the one that it has. Errors name the input. One thread.

#include "base/result.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ghost::sound {

inline constexpr int kInputRate_hz = 48'000;

class SoundInput {
public:
    // name: as ALSA has it ("default", "hw:1,0", what arecord -L lists). Error: none of that name, in use, no
    // permission, not such samples.
    static Result<std::unique_ptr<SoundInput>> open(const std::string& name);
    ~SoundInput();
    SoundInput(const SoundInput&) = delete;
    SoundInput& operator=(const SoundInput&) = delete;

    struct Heard {
        std::span<const std::int16_t> samples; // of all channels in turn, until the next call; may be none
        std::chrono::nanoseconds end{0};       // steady time at which the last was heard
    };
    // What was heard since the last call, at most 10 ms of it; waits for it a tenth of a second at most.
    // Nothing: the input is gone.
    std::optional<Heard> take();
    int channels() const;

private:
    struct Device;
    explicit SoundInput(std::unique_ptr<Device> device);

    std::unique_ptr<Device> device_;
    std::vector<std::int16_t> samples_;
};

} // namespace ghost::sound
