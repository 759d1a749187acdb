// SPDX-License-Identifier: Apache-2.0
#include "sound/private/alsa.h"

#include <cerrno>

namespace ghost::sound {
namespace {

void say_nothing(const char*, int, const char*, int, const char*, ...) {} // errors are ours to say

Error why_not(const std::string& name, bool is_input, int code) {
    if (code == -EACCES || code == -EPERM)
        return Error{"may not be opened; join the group that owns it: sudo usermod -aG audio $USER, then log "
                     "in again",
                     name};
    if (code == -EBUSY) return Error{"is in use by another program; close it and try again", name};
    if (code == -ENOENT || code == -ENODEV || code == -ENXIO)
        return Error{is_input ? "is neither a file nor an input of ALSA that is there (arecord -L lists them)"
                              : "is no output of ALSA that is there (aplay -L lists them)",
                     name};
    return Error{std::string("cannot be opened: ") + snd_strerror(code), name};
}

} // namespace

Result<void> AlsaDevice::open(const std::string& name, snd_pcm_stream_t direction, int mode, int rate_hz,
                              unsigned latency_us, std::initializer_list<int> wanted) {
    snd_lib_error_set_handler(say_nothing);
    int code = snd_pcm_open(&pcm, name.c_str(), direction, mode);
    if (code < 0) return why_not(name, direction == SND_PCM_STREAM_CAPTURE, code);
    for (const int count : wanted) {
        channels = count;
        code =
            snd_pcm_set_params(pcm, SND_PCM_FORMAT_S16, SND_PCM_ACCESS_RW_INTERLEAVED,
                               static_cast<unsigned>(count), static_cast<unsigned>(rate_hz), 1, latency_us);
        if (code >= 0) return {};
    }
    return Error{std::string("cannot be set up: ") + snd_strerror(code), name};
}

} // namespace ghost::sound
