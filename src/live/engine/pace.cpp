// SPDX-License-Identifier: Apache-2.0
#include "live/engine/pace.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::app {
namespace {

constexpr std::size_t kManyLights = 64;
constexpr std::size_t kHalf = 2;      // level
constexpr double kTooSlow = 1.5;      // of a frame's time: below, a coarser picture is worse than a late one
constexpr double kFarOver = 10;       // likewise
constexpr double kHopeless_ms = 2000; // a frame that nobody waits for twice
constexpr double kRoom = 0.8;         // of a frame's time, that a level may seem to need at the beginning,
constexpr double kMuchRoom = 0.6;     // and later, where another size costs time itself
constexpr double kStillMoves = 4;     // frame times that half of the sides may take
constexpr int kShortestWait = 40, kLongestWait = 640;
constexpr int kTakenBack = 10; // frames of such a wait, by one that would be too slow there
constexpr double kLeastPaceRatio = 1.02, kMostPaceRatio = 2.2;
// Until they are measured: three quarters of the smallest picture do not go with its pixels.
constexpr std::array<double, Pace::kLevels.size() - 1> kGuessedRatios{1.75, 1.55, 1.41, 1.24};

} // namespace

Pace::Pace(std::size_t lights)
    : level_(lights <= kManyLights ? kHalf : kLevels.size() - 1), ratios_(kGuessedRatios),
      wait_(kShortestWait) {}

bool Pace::is_far_over(double frame_ms, double frames_per_s) {
    return frame_ms > kFarOver * 1000.0 / frames_per_s;
}

double Pace::expected_ms(std::size_t level, double usual_ms) const {
    double ms = usual_ms;
    for (std::size_t i = level; i < level_; ++i) ms *= ratios_[i];
    for (std::size_t i = level_; i < level; ++i) ms /= ratios_[i];
    return ms;
}

std::size_t Pace::best_level(double usual_ms, double wanted_ms) const {
    std::size_t level = 0;
    while (level + 1 < kLevels.size() && expected_ms(level, usual_ms) > wanted_ms) ++level;
    return level;
}

// Of the next better level. A blur is worse than a picture that is late.
double Pace::bearable_ms(double wanted_ms) const {
    return level_ > kHalf ? kStillMoves * wanted_ms : wanted_ms;
}

void Pace::learn(double usual_ms) {
    if (before_ms_ == 0) return;
    const std::size_t first = std::min(level_, level_before_), last = std::max(level_, level_before_);
    const double expected = expected_ms(level_before_, usual_ms), seen = before_ms_;
    // Of a better level more than expected: its steps cost more.
    const double more = level_before_ < level_ ? seen / expected : expected / seen;
    const double of_each = std::pow(more, 1.0 / static_cast<double>(last - first));
    for (std::size_t i = first; i < last; ++i)
        ratios_[i] = std::clamp(ratios_[i] * of_each, kLeastPaceRatio, kMostPaceRatio);
    before_ms_ = 0;
}

bool Pace::add(double frame_ms, double frames_per_s) {
    const double wanted_ms = 1000.0 / frames_per_s;
    // Shaders are made and caches filled in the first one.
    if (std::exchange(is_first_, false) && frame_ms < kHopeless_ms) return false;
    if (!knows_) {
        knows_ = true;
        std::size_t best = best_level(frame_ms, kRoom * wanted_ms);
        if (level_ <= kHalf && frame_ms <= kStillMoves * wanted_ms) best = std::min(best, kHalf);
        return best != std::exchange(level_, best);
    }
    recent_ms_[seen_++ % recent_ms_.size()] = frame_ms;
    // One may have waited for something else; two have not.
    const bool is_late = is_far_over(frame_ms, frames_per_s);
    const bool is_far = is_late && (was_late_ || frame_ms > kHopeless_ms);
    was_late_ = is_late;
    if (seen_ < recent_ms_.size() && !is_far) return false;
    auto sorted = recent_ms_;
    std::sort(sorted.begin(), sorted.end());
    const double usual_ms = is_far ? frame_ms : sorted[sorted.size() / 2];
    if (!is_far) learn(usual_ms);
    std::size_t level = level_;
    if (usual_ms > kTooSlow * wanted_ms) {
        while (level + 1 < kLevels.size() && (level == level_ || expected_ms(level, usual_ms) > wanted_ms)) {
            if (level >= kHalf && expected_ms(level, usual_ms) <= kStillMoves * wanted_ms) break;
            ++level;
        }
        if (raised_ && level > level_) wait_ = std::min(2 * wait_, kLongestWait);
        calm_ = 0;
    } else if (level_ > 0 && expected_ms(level_ - 1, usual_ms) < kMuchRoom * bearable_ms(wanted_ms)) {
        const bool is_rough = expected_ms(level_ - 1, frame_ms) > kTooSlow * bearable_ms(wanted_ms);
        calm_ = is_rough ? std::max(calm_ - kTakenBack, 0) : calm_ + 1;
        if (calm_ >= wait_) {
            level = level_ > kHalf ? level_ - 1 : level_;
            level = std::min(best_level(usual_ms, kMuchRoom * wanted_ms), level);
        }
    } else {
        calm_ = 0;
    }
    if (level == level_) return false;
    before_ms_ = is_far ? 0 : usual_ms;
    level_before_ = level_;
    raised_ = level < level_;
    level_ = level;
    seen_ = 0;
    calm_ = 0;
    return true;
}

} // namespace ghost::app
