#pragma once
// SPDX-License-Identifier: Apache-2.0
// SoundOutput: what is heard, by ALSA (which PipeWire and PulseAudio answer, too): 48,000 pairs of samples a
// second. Errors name the output. One thread.

#include "base/result.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::sound {

inline constexpr int kOutputRate_hz = 48'000;

class SoundOutput {
public:
    // name: as ALSA has it ("default", "hw:1,0", what aplay -L lists). Error: none of that name, in use, no
    // permission.
    static Result<std::unique_ptr<SoundOutput>> open(const std::string& name);
    ~SoundOutput();
    SoundOutput(const SoundOutput&) = delete;
    SoundOutput& operator=(const SoundOutput&) = delete;

    // How long it takes until what is put next is heard. Nothing: the output is gone.
    std::optional<std::chrono::nanoseconds> delay();
    // Pairs of -1 to 1. Waits until there is room. False: the output is gone.
    bool put(const float* pairs, std::size_t count);

private:
    struct Device;
    explicit SoundOutput(std::unique_ptr<Device> device);

    std::unique_ptr<Device> device_;
    std::vector<std::int16_t> samples_;
};

} // namespace ghost::sound
