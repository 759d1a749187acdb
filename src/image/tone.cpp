// SPDX-License-Identifier: Apache-2.0
#include "image/tone.h"

namespace ghost::image {

std::string name_of(Tone tone) {
    switch (tone) {
    case Tone::aces:
        return "aces";
    case Tone::linear:
        return "linear";
    default:
        return "agx";
    }
}

Result<Tone> tone_from(const std::string& name) {
    for (const Tone tone : kTones)
        if (name == name_of(tone)) return tone;
    return Error{"'" + name + "' is no tone curve: agx, aces or linear", ""};
}

} // namespace ghost::image
