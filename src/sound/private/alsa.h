#pragma once
// SPDX-License-Identifier: Apache-2.0
// An input or output of ALSA, opened and set up: 16 bits, samples of all channels in turn. Errors name it.
// Any thread.

#include "base/result.h"

#include <alsa/asoundlib.h>

#include <initializer_list>
#include <string>

namespace ghost::sound {

struct AlsaDevice {
    snd_pcm_t* pcm = nullptr;
    int channels = 0;

    AlsaDevice() = default;
    AlsaDevice(const AlsaDevice&) = delete;
    AlsaDevice& operator=(const AlsaDevice&) = delete;
    ~AlsaDevice() {
        if (pcm) snd_pcm_close(pcm);
    }

    // mode: 0, or SND_PCM_NONBLOCK. channels: so many, or else the next of them.
    Result<void> open(const std::string& name, snd_pcm_stream_t direction, int mode, int rate_hz,
                      unsigned latency_us, std::initializer_list<int> channels);
};

} // namespace ghost::sound
