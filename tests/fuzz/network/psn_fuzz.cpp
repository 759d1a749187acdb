// SPDX-License-Identifier: Apache-2.0
// Any bytes as a PosiStageNet packet, into a table that lives as long as the run.
#include "psn_osc/psn.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ghost::dmx;
    static Trackers trackers;
    if (const auto packet = parse_psn({data, size})) {
        trackers.feed(*packet, std::chrono::seconds(1));
        for (const auto& [id, name] : packet->names)
            if (name.size() > kMostTrackerName) std::abort();
        for (const PsnPosition& position : packet->positions)
            for (const float axis : position.position_m)
                if (!std::isfinite(axis)) std::abort();
    }
    if (trackers.all().size() > kMostTrackers) std::abort();
    return 0;
}
