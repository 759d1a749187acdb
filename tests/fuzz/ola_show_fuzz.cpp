// SPDX-License-Identifier: Apache-2.0
// Any text as an OLA show file; what can be read is played at a few times.
#include "dmx/record/player.h"

#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    auto recording = parse_recording({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!recording.ok()) return 0;
    if (recording->problems.size() > 101) std::abort();
    Player player(std::move(*recording));
    for (const double t : {0.0, 0.5, 1e6}) {
        const Universes universes = player.at(t * player.duration_s());
        for (const Universe& universe : universes.list)
            if (!universe.levels || universe.number < 1) std::abort();
    }
    return 0;
}
