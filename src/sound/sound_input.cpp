// SPDX-License-Identifier: Apache-2.0
#include "sound/sound_input.h"

#include "sound/private/alsa.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace ghost::sound {
namespace {

constexpr unsigned kInputLatency_us = 100'000; // room for a busy machine; samples are taken as they come
constexpr int kPatience_ms = 100;
constexpr snd_pcm_uframes_t kPiece = kInputRate_hz / 100;

} // namespace

struct SoundInput::Device : AlsaDevice {};

SoundInput::SoundInput(std::unique_ptr<Device> device)
    : device_(std::move(device)), samples_(kPiece * static_cast<std::size_t>(device_->channels)) {}
SoundInput::~SoundInput() = default;

int SoundInput::channels() const {
    return device_->channels;
}

Result<std::unique_ptr<SoundInput>> SoundInput::open(const std::string& name) {
    auto device = std::make_unique<Device>();
    TRY_VOID(device->open(name, SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK, kInputRate_hz, kInputLatency_us,
                          {2, 1}));
    if (const int code = snd_pcm_start(device->pcm); code < 0)
        return Error{std::string("cannot be started: ") + snd_strerror(code), name};
    return std::unique_ptr<SoundInput>(new SoundInput(std::move(device)));
}

std::optional<SoundInput::Heard> SoundInput::take() {
    snd_pcm_t* const pcm = device_->pcm;
    snd_pcm_sframes_t count = snd_pcm_readi(pcm, samples_.data(), kPiece);
    if (count == -EAGAIN) {
        const int ready = snd_pcm_wait(pcm, kPatience_ms);
        if (ready == 0) return Heard{};
        count = snd_pcm_readi(pcm, samples_.data(), kPiece);
    }
    if (count == -EAGAIN) return Heard{};
    if (count < 0) { // nobody took the samples in time, or the machine slept
        if (snd_pcm_recover(pcm, static_cast<int>(count), 1) < 0 || snd_pcm_start(pcm) < 0)
            return std::nullopt;
        return Heard{};
    }
    // What was heard after them.
    const snd_pcm_sframes_t later = std::max<snd_pcm_sframes_t>(snd_pcm_avail(pcm), 0);
    const std::chrono::nanoseconds later_ns(std::int64_t{later} * 1'000'000'000 / kInputRate_hz);
    return Heard{std::span(samples_).first(static_cast<std::size_t>(count) *
                                           static_cast<std::size_t>(device_->channels)),
                 std::chrono::steady_clock::now().time_since_epoch() - later_ns};
}

} // namespace ghost::sound
