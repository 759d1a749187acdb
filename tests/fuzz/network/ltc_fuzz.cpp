// SPDX-License-Identifier: Apache-2.0
// Sounds of any edges (a byte is how long the level stays): whatever comes, what is handed on is a time of
// day and a moment that was heard.
#include "dmx/wire/timecode.h"
#include "sound/ltc_decoder.h"

#include <cstdlib>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost;
    sound::LtcDecoder decoder(48'000);
    std::vector<std::int16_t> samples;
    std::int16_t level = 10'000;
    std::chrono::nanoseconds end{0};
    for (std::size_t k = 0; k < size; ++k) {
        samples.insert(samples.end(), data[k], level);
        level = static_cast<std::int16_t>(-level);
        if (samples.size() < 4800 && k + 1 < size) continue;
        end += std::chrono::nanoseconds(samples.size() * 1'000'000'000 / 48'000);
        decoder.feed(samples, end, [&](const dmx::TimeCode& time, std::chrono::nanoseconds at) {
            if (!dmx::is_timecode(time) || at > end) std::abort();
        });
        samples.clear();
    }
    return 0;
}
