// SPDX-License-Identifier: Apache-2.0
#include "live/engine/governor.h"

#include "base/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ghost::app {
namespace {

constexpr double kMostShare = 0.95;   // of the time for a frame; what is left is for jitter
constexpr double kAgainShare = 0.85;  // what was too slow must get this fast to count as holding
constexpr double kRaiseShare = 0.8;   // the better level must be expected to take no more
constexpr double kGuessedRatio = 1.3; // between two levels, until it was seen
constexpr double kLeastRatio = 1.05;
constexpr double kMostRatio = 4.0;
constexpr std::size_t kMostSteps = 2; // down at once
constexpr double kLeastHaze = 0.2;    // share of a frame below which less haze is not worth it
constexpr double kWait_s = 2;
constexpr double kLongestWait_s = 60;
constexpr double kTrial_s = 5;   // a better level that lasted less was a mistake
constexpr double kProven_s = 20; // a better level that lasts so long was none

template <std::size_t count>
double median(std::array<double, count> values) {
    std::nth_element(values.begin(), values.begin() + count / 2, values.end());
    return values[count / 2];
}

} // namespace

std::vector<render::HazeQuality> quality_levels(const render::HazeIntegrator& full) {
    std::vector<render::HazeQuality> levels{{full.curvature, full.most_segments, 1}};
    if (full.beams != render::Beams::gate) return levels;
    // Segments go with the inverse root of the curvature: seven tenths, one half, a third of them.
    for (const float bend : {2.0f, 4.0f, 9.0f}) {
        const float most = static_cast<float>(full.most_segments) / std::sqrt(bend);
        levels.push_back({full.curvature * bend, std::max(static_cast<int>(std::lround(most)), 1), 1});
    }
    for (const std::uint32_t step : {2u, 4u}) {
        levels.push_back(levels.back());
        levels.back().wide_beam_step = step;
    }
    return levels;
}

Governor::Governor(double frames_per_s, std::vector<render::HazeQuality> levels)
    : levels_(std::move(levels)), frames_per_s_(frames_per_s), target_ms_(1000.0 / frames_per_s),
      wait_s_(kWait_s) {
    CHECK(frames_per_s > 0 && !levels_.empty());
    ratios_.assign(levels_.size() - 1, kGuessedRatio);
}

bool Governor::add(double frame_ms, double haze_ms) {
    const double frame_s = std::max(frame_ms, target_ms_) / 1000.0;
    since_s_ += frame_s;
    // The first frame at a level draws what rested before, too.
    if (seen_++ == 0) return false;
    recent_frame_ms_[seen_ % kWindow] = frame_ms;
    recent_haze_ms_[seen_ % kWindow] = std::clamp(haze_ms, 0.0, frame_ms);
    if (seen_ <= kWindow) return false;
    const Times times{median(recent_frame_ms_), median(recent_haze_ms_)};
    learn(times.haze_ms);
    if (raised_ && since_s_ >= kProven_s) wait_s_ = kWait_s;
    if (times.frame_ms > kMostShare * target_ms_) {
        calm_s_ = 0;
        return lower(times);
    }
    if (!holds_ && times.frame_ms <= kAgainShare * target_ms_) {
        holds_ = true;
        return true;
    }
    if (level_ == 0 || at_better_level_ms(times) > kRaiseShare * target_ms_) {
        calm_s_ = 0;
        return false;
    }
    calm_s_ += frame_s;
    return calm_s_ >= wait_s_ && raise(times);
}

double Governor::at_better_level_ms(const Times& times) const {
    return times.frame_ms - times.haze_ms + times.haze_ms * ratios_[level_ - 1];
}

void Governor::learn(double haze_ms) {
    if (before_haze_ms_ <= 0 || haze_ms <= 0) return;
    const std::size_t better = std::min(level_, level_before_);
    const std::size_t worse = std::max(level_, level_before_);
    const double all = level_ > level_before_ ? before_haze_ms_ / haze_ms : haze_ms / before_haze_ms_;
    const double each = std::pow(all, 1.0 / static_cast<double>(worse - better));
    for (std::size_t i = better; i < worse; ++i) ratios_[i] = std::clamp(each, kLeastRatio, kMostRatio);
    before_haze_ms_ = 0;
}

bool Governor::lower(const Times& times) {
    haze_is_slow_ = times.haze_ms >= kLeastHaze * times.frame_ms;
    if (level_ + 1 == levels_.size() || !haze_is_slow_) {
        if (holds_) noted_ms_ = times.frame_ms;
        return std::exchange(holds_, false);
    }
    if (raised_ && since_s_ < kTrial_s) wait_s_ = std::min(2 * wait_s_, kLongestWait_s);
    std::size_t level = level_;
    double expected_ms = times.haze_ms;
    const double rest_ms = times.frame_ms - times.haze_ms;
    for (std::size_t step = 0; step < kMostSteps && level + 1 < levels_.size(); ++step) {
        if (rest_ms + expected_ms <= kMostShare * target_ms_) break;
        expected_ms /= ratios_[level++];
    }
    raised_ = false;
    go_to(level, times);
    return true;
}

bool Governor::raise(const Times& times) {
    raised_ = true;
    go_to(level_ - 1, times);
    return true;
}

void Governor::go_to(std::size_t level, const Times& times) {
    level_before_ = level_;
    before_haze_ms_ = times.haze_ms;
    noted_ms_ = times.frame_ms;
    level_ = level;
    holds_ = true;
    seen_ = 0;
    since_s_ = calm_s_ = 0;
}

std::string Governor::note() const {
    if (level_ == 0 && holds_) return {};
    char text[160];
    if (!holds_ && !haze_is_slow_) {
        std::snprintf(text, sizeof text,
                      "too slow for %g fps (now %.0f ms), and haze is not what takes the time", frames_per_s_,
                      noted_ms_);
        return text;
    }
    const render::HazeQuality& quality = levels_[level_];
    const char* beams = quality.wide_beam_step == 4   ? ", wide beams at quarter resolution"
                        : quality.wide_beam_step == 2 ? ", wide beams at half resolution"
                                                      : "";
    std::snprintf(text, sizeof text, "haze: %d segments%s, %s %g fps (%s %.0f ms)", quality.most_segments,
                  beams, holds_ ? "to hold" : "too slow for", frames_per_s_, holds_ ? "was" : "now",
                  noted_ms_);
    return text;
}

} // namespace ghost::app
