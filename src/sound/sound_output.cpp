// SPDX-License-Identifier: Apache-2.0
#include "sound/sound_output.h"

#include "sound/private/alsa.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::sound {
namespace {

constexpr unsigned kOutputLatency_us = 60'000; // less tears where a machine is busy
constexpr int kChannels = 2;
constexpr int kMostFailures = 8; // to put a piece

} // namespace

struct SoundOutput::Device : AlsaDevice {};

SoundOutput::SoundOutput(std::unique_ptr<Device> device) : device_(std::move(device)) {}
SoundOutput::~SoundOutput() = default;

Result<std::unique_ptr<SoundOutput>> SoundOutput::open(const std::string& name) {
    auto device = std::make_unique<Device>();
    TRY_VOID(device->open(name, SND_PCM_STREAM_PLAYBACK, 0, kOutputRate_hz, kOutputLatency_us, {kChannels}));
    return std::unique_ptr<SoundOutput>(new SoundOutput(std::move(device)));
}

std::optional<std::chrono::nanoseconds> SoundOutput::delay() {
    snd_pcm_sframes_t frames = 0;
    if (const int code = snd_pcm_delay(device_->pcm, &frames); code < 0) {
        if (snd_pcm_recover(device_->pcm, code, 1) < 0) return std::nullopt;
        frames = 0;
    }
    return std::chrono::nanoseconds(std::int64_t{std::max<snd_pcm_sframes_t>(frames, 0)} * 1'000'000'000 /
                                    kOutputRate_hz);
}

bool SoundOutput::put(const float* pairs, std::size_t count) {
    samples_.resize(2 * count);
    std::transform(pairs, pairs + 2 * count, samples_.begin(), [](float value) {
        return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767));
    });
    std::size_t done = 0;
    for (int failures = 0; done < count && failures < kMostFailures;) {
        const snd_pcm_sframes_t put = snd_pcm_writei(device_->pcm, samples_.data() + 2 * done, count - done);
        if (put < 0 && snd_pcm_recover(device_->pcm, static_cast<int>(put), 1) < 0) return false;
        failures += put <= 0 ? 1 : 0;
        done += put > 0 ? static_cast<std::size_t>(put) : 0;
    }
    return done == count;
}

} // namespace ghost::sound
