#pragma once
// SPDX-License-Identifier: Apache-2.0
// Pace: how many pixels a picture that moves may have, and its light, so that it is drawn at a wanted rate.
// The first step down leaves silhouettes and materials as they are and halves the sides of the light
// (render/relight/coarse_light.h); the next ones make both coarser: full light costs more than silhouettes of
// twice the sides (a festival of 400: 296 ms at 250x168, 205 at 350x235 with light at half of that). Begins
// at the middle, with many lights with the fewest pixels, for a thousand of them would take half a minute
// otherwise; the second frame (the first makes shaders) goes to where the time seems to be enough. Later down
// likewise after seven frames, or two that are far too slow, and up after many frames that leave much room
// and hardly one among them that would be too slow there: a picture of another size costs what several frames
// do, and one that comes and goes is worse than a coarse one. What a level costs beside the next is measured
// at each change. Below half of the sides only where nothing would move there any more, and up again as soon
// as it would. Pure: times come in, a level comes out.

#include <array>
#include <cstddef>

namespace ghost::app {

class Pace {
public:
    // Best first. share: what it costs about, as a picture all of whose parts have so much of the sides.
    // sides: of the picture; coarse_light: its light has half of these.
    struct Level {
        double share;
        double sides;
        bool coarse_light;
    };
    static constexpr std::array<Level, 5> kLevels{
        {{1.0, 1.0, false}, {0.7, 1.0, true}, {0.5, 0.7, true}, {0.35, 0.5, true}, {0.25, 0.35, true}}};

    explicit Pace(std::size_t lights);

    // A frame at this level took so long. True: the level changed.
    bool add(double frame_ms, double frames_per_s);
    const Level& level() const { return kLevels[level_]; }
    double share() const { return level().share; }
    // So slow that nobody should wait for two more of them.
    static bool is_far_over(double frame_ms, double frames_per_s);

private:
    std::size_t level_;
    std::array<double, kLevels.size() - 1> ratios_; // time at a level over that at the next one
    bool is_first_ = true, was_late_ = false;       // frames: the next one, the last one
    bool knows_ = false;                            // how fast it is
    std::array<double, 7> recent_ms_{};
    std::size_t seen_ = 0; // frames at this level
    int calm_ = 0;         // with which the better level would leave room, less those taken back
    int wait_;             // of those before the next try
    bool raised_ = false;  // how this level was reached
    double before_ms_ = 0; // median at the level before; 0: it was learnt from, or there was none
    std::size_t level_before_ = 0;

    double expected_ms(std::size_t level, double usual_ms) const;
    std::size_t best_level(double usual_ms, double wanted_ms) const;
    double bearable_ms(double wanted_ms) const;
    void learn(double usual_ms);
};

} // namespace ghost::app
