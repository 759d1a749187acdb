#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pace: how many pixels a picture that moves may have, so that it is drawn at a wanted rate. Goes down at
// once to where the time seems to be enough, and up a step at a time after many frames that leave room. Pure:
// times come in, a share of the sides comes out.

#include <array>
#include <cstddef>

namespace ghost::app {

class Pace {
public:
    // Of width and height, best first.
    static constexpr std::array<double, 5> kShares{1.0, 0.7, 0.5, 0.35, 0.25};

    // A frame at this share took so long. True: the share changed.
    bool add(double frame_ms, double frames_per_s);
    double share() const { return kShares[level_]; }

private:
    std::size_t level_ = 0;
    std::array<double, 3> recent_ms_{};
    std::size_t seen_ = 0; // frames at this level
    int calm_ = 0;         // in a row with which the better level would have been fast enough
    int wait_ = 10;        // of those before the next try
    bool raised_ = false;  // how this level was reached
};

} // namespace ghost::app
