#pragma once
// SPDX-License-Identifier: Apache-2.0
// Governor: holds a frame rate by lowering the quality of haze: first fewer segments, then fewer rays in wide
// beams. Lowers when three frames of five are too slow, raises after seconds in which the better level would
// have been fast enough, and waits longer each time that turned out wrong; a frame or two that stand out (a
// map came, the camera cut) change nothing. Pure: times come in, a level comes out.

#include "base/text.h"
#include "render/haze/haze_pass.h"
#include "render/haze/quality.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ghost::app {

// Best first: the settings' own quality, then what may be drawn instead.
std::vector<render::HazeQuality> quality_levels(const render::HazeIntegrator& full);

class Governor {
public:
    Governor(double frames_per_s, std::vector<render::HazeQuality> levels);

    // A frame in which lights were drawn took so long, haze that much of it. True: quality() or holds()
    // changed.
    bool add(double frame_ms, double haze_ms);

    const render::HazeQuality& quality() const { return levels_[level_]; }
    std::size_t level() const { return level_; }
    // False: even the lowest level is too slow, or what is slow is not haze, which then stays as it is.
    bool holds() const { return holds_; }
    // The level and why, for people; empty where the best level is good enough.
    std::string note() const;

private:
    static constexpr std::size_t kWindow = 5; // frames

    struct Times { // medians
        double frame_ms;
        double haze_ms;
    };

    // Time of a frame at a better level, as seen when the level changed.
    double at_better_level_ms(const Times& times) const;
    void learn(double haze_ms);
    bool lower(const Times& times);
    bool raise(const Times& times);
    void go_to(std::size_t level, const Times& times);

    std::vector<render::HazeQuality> levels_;
    double frames_per_s_;
    double target_ms_;
    std::vector<double> ratios_; // time of haze at level i over that at level i + 1
    std::size_t level_ = 0;
    std::array<double, kWindow> recent_frame_ms_{};
    std::array<double, kWindow> recent_haze_ms_{};
    std::size_t seen_ = 0; // frames since the level changed
    std::size_t level_before_ = 0;
    double before_haze_ms_ = 0; // median at the level before; 0: it was learnt from
    double since_s_ = 0;        // time at this level
    double calm_s_ = 0;         // time in which the better level would have been fast enough
    double wait_s_;             // until the next try
    double noted_ms_ = 0;       // why the level was chosen
    bool raised_ = false;       // how this level was reached
    bool haze_is_slow_ = true;  // when a frame last was too slow
    bool holds_ = true;
};

} // namespace ghost::app
