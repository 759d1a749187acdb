#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pace: how many pixels a picture that moves may have, so that it is drawn at a wanted rate. Begins with the
// fewest, for a thousand lights would take half a minute with all of them, and with the first frame goes to
// where the time seems to be enough; later down likewise after seven frames, or one that is far too slow, and
// up a step at a time after many frames that leave room. How much of a frame goes with its pixels is measured
// at each change. Below half of the sides only where even half the rate is not held there. Pure: times come
// in, a share of the sides comes out.

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
    // So slow that nobody should wait for two more of them.
    static bool is_far_over(double frame_ms, double frames_per_s);

private:
    std::size_t level_ = kShares.size() - 1;
    bool knows_ = false; // how fast it is
    std::array<double, 7> recent_ms_{};
    std::size_t seen_ = 0; // frames at this level
    int calm_ = 0;         // in a row with which the better level would have been fast enough
    int wait_ = 20;        // of those before the next try
    bool raised_ = false;  // how this level was reached
    std::size_t best_level(double usual_ms, double wanted_ms) const;
    double expected_ms(std::size_t level, double usual_ms) const;
    void learn(double usual_ms);
    double before_ms_ = 0; // median at the level before; 0: it was learnt from, or there was none
    std::size_t level_before_ = 0;
    double fixed_ms_ = 0; // of a frame: what does not go with its pixels, as it was seen
};

} // namespace ghost::app
