#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pace: how many pixels a picture that moves may have, so that it is drawn at a wanted rate. Begins at half
// of the sides, with many lights with the fewest, for a thousand of them would take half a minute otherwise;
// the first frame goes to where the time seems to be enough. Later down likewise after seven frames, or one
// that is far too slow, and up after many frames that leave much room: a picture of another size costs what
// several frames do, and one that comes and goes is worse than a coarse one. What a level costs beside the
// next is measured at each change. Below half of the sides only where nothing would move there any more.
// Pure: times come in, a share of the sides comes out.

#include <array>
#include <cstddef>

namespace ghost::app {

class Pace {
public:
    // Of width and height, best first.
    static constexpr std::array<double, 5> kShares{1.0, 0.7, 0.5, 0.35, 0.25};

    explicit Pace(std::size_t lights);

    // A frame at this share took so long. True: the share changed.
    bool add(double frame_ms, double frames_per_s);
    double share() const { return kShares[level_]; }
    // So slow that nobody should wait for two more of them.
    static bool is_far_over(double frame_ms, double frames_per_s);

private:
    std::size_t level_;
    std::array<double, kShares.size() - 1> ratios_; // time at a level over that at the next one
    bool knows_ = false;                            // how fast it is
    std::array<double, 7> recent_ms_{};
    std::size_t seen_ = 0; // frames at this level
    int calm_ = 0;         // in a row with which the better level would leave room
    int wait_;             // of those before the next try
    bool raised_ = false;  // how this level was reached
    double before_ms_ = 0; // median at the level before; 0: it was learnt from, or there was none
    std::size_t level_before_ = 0;

    double expected_ms(std::size_t level, double usual_ms) const;
    std::size_t best_level(double usual_ms, double wanted_ms) const;
    void learn(double usual_ms);
};

} // namespace ghost::app
