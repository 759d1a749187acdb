#pragma once
// SPDX-License-Identifier: Apache-2.0
// RestFinder: where a recording comes to rest, so that its cues are found without a list of them: levels that
// stay for a while and are not those of the rest before. Fed with moments in their order. Seconds. One thread
// at a time.

#include "dmx/wire/universes.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ghost::scene {

inline constexpr double kRest_s = 1.0;          // as long as a look is seen as one
inline constexpr std::size_t kMostRests = 1000; // of a recording: more are no cues

class RestFinder {
public:
    // The levels from at_s on, until the next call.
    void feed(double at_s, const dmx::Universes& levels);
    // When the recording ends. Begins of the rests.
    std::vector<double> finish(double end_s);

private:
    void close(double until_s);

    std::optional<double> since_s_; // of the levels that are now
    dmx::Universes now_;
    std::optional<dmx::Universes> rested_; // of the rest before
    std::vector<double> rests_s_;
};

} // namespace ghost::scene
