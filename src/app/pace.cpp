// SPDX-License-Identifier: Apache-2.0
#include "app/pace.h"

#include <algorithm>

namespace ghost::app {
namespace {

constexpr double kTooSlow = 1.5; // of a frame's time: below, a coarser picture is worse than a late one
constexpr double kFarOver = 10;  // likewise
constexpr double kRoom = 0.8;    // of a frame's time, that the better level may seem to need
constexpr int kLongestWait = 160;
constexpr double kHalf = 0.5;
constexpr double kStillMoves = 2; // frame times that half of the sides may take
constexpr double kMostFixed = 0.9;
constexpr double kGuessedFixed = 0.75; // of the first frame, which is the smallest

} // namespace

bool Pace::is_far_over(double frame_ms, double frames_per_s) {
    return frame_ms > kFarOver * 1000.0 / frames_per_s;
}

double Pace::expected_ms(std::size_t level, double usual_ms) const {
    const double sides = kShares[level] / kShares[level_];
    const double fixed_ms = std::min(fixed_ms_, kMostFixed * usual_ms);
    return fixed_ms + (usual_ms - fixed_ms) * sides * sides;
}

std::size_t Pace::best_level(double usual_ms, double wanted_ms) const {
    std::size_t level = 0;
    while (level + 1 < kShares.size() && expected_ms(level, usual_ms) > kRoom * wanted_ms) ++level;
    return level;
}

void Pace::learn(double usual_ms) {
    if (before_ms_ == 0) return;
    const double sides = kShares[level_before_] / kShares[level_], pixels = sides * sides;
    const double of_pixels_ms = (before_ms_ - usual_ms) / (pixels - 1); // here
    fixed_ms_ = std::clamp(usual_ms - of_pixels_ms, 0.0, kMostFixed * usual_ms);
    before_ms_ = 0;
}

bool Pace::add(double frame_ms, double frames_per_s) {
    const double wanted_ms = 1000.0 / frames_per_s;
    if (!knows_) {
        knows_ = true;
        fixed_ms_ = kGuessedFixed * frame_ms;
        const std::size_t best = best_level(frame_ms, wanted_ms);
        const bool changes = best != level_;
        level_ = best;
        return changes;
    }
    recent_ms_[seen_++ % recent_ms_.size()] = frame_ms;
    const bool is_far = is_far_over(frame_ms, frames_per_s);
    if (seen_ < recent_ms_.size() && !is_far) return false;
    auto sorted = recent_ms_;
    std::sort(sorted.begin(), sorted.end());
    const double usual_ms = is_far ? frame_ms : sorted[sorted.size() / 2];
    learn(usual_ms);
    std::size_t level = level_;
    if (usual_ms > kTooSlow * wanted_ms) {
        while (level + 1 < kShares.size() && (level == level_ || expected_ms(level, usual_ms) > wanted_ms)) {
            const bool is_half = kShares[level] <= kHalf;
            if (is_half && expected_ms(level, usual_ms) <= kStillMoves * wanted_ms) break;
            ++level;
        }
        if (raised_ && level > level_) wait_ = std::min(2 * wait_, kLongestWait);
    } else if (level_ > 0 && expected_ms(level_ - 1, usual_ms) < kRoom * wanted_ms) {
        if (++calm_ >= wait_) level = std::min(best_level(usual_ms, wanted_ms), level_);
    } else {
        calm_ = 0;
    }
    if (level == level_) return false;
    before_ms_ = usual_ms;
    level_before_ = level_;
    raised_ = level < level_;
    level_ = level;
    seen_ = 0;
    calm_ = 0;
    return true;
}

} // namespace ghost::app
