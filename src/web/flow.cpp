// SPDX-License-Identifier: Apache-2.0
#include "web/flow.h"

#include <algorithm>
#include <iterator>

namespace ghost::web {
namespace {

constexpr std::size_t kMostOnTheWay = 2;
constexpr double kLate_s = 0.15;
constexpr int kLateInARow = 3; // one alone is a hiccup, or a tab that was hidden
constexpr double kFast_s = 0.06;
constexpr double kFastFor_s = 5;
constexpr double kCalm_s = 0.5;
constexpr int kSteps = static_cast<int>(std::size(kWidths));

} // namespace

void Flow::want(int width, bool calm) {
    wanted_width_ = width;
    calm_ = calm;
}

int Flow::width() const {
    return std::min(wanted_width_, kWidths[step_]);
}

bool Flow::may_send(double now_s) const {
    if (calm_ && now_s - sent_s_ < kCalm_s) return false;
    return !is_full(now_s);
}

bool Flow::is_full(double now_s) const {
    if (on_the_way_.empty()) return false;
    const double ack_s = 1e-3 * ack_ms_;
    const bool is_slower = ack_s > kLate_s || now_s - on_the_way_.front().sent_s >= ack_s;
    return step_ > 0 || is_slower || on_the_way_.size() >= kMostOnTheWay;
}

void Flow::sent(std::uint32_t number, double now_s) {
    on_the_way_.push_back({number, now_s});
    newest_ = number;
    sent_s_ = now_s;
}

bool Flow::painted(std::uint32_t number, double now_s) {
    const auto done = std::find_if(on_the_way_.begin(), on_the_way_.end(),
                                   [&](const OnTheWay& picture) { return picture.number == number; });
    if (done == on_the_way_.end()) return false;
    const double took_s = now_s - done->sent_s;
    ack_ms_ = 1e3 * took_s;
    on_the_way_.erase(on_the_way_.begin(), std::next(done));
    late_ = took_s > kLate_s ? late_ + 1 : 0;
    if (took_s > kFast_s)
        fast_s_ = -1;
    else if (fast_s_ < 0)
        fast_s_ = now_s;
    if (late_ >= kLateInARow) {
        step_ = std::min(step_ + 1, kSteps - 1);
        late_ = 0;
    } else if (step_ > 0 && fast_s_ >= 0 && now_s - fast_s_ >= kFastFor_s) {
        --step_;
        fast_s_ = now_s;
    }
    return true;
}

bool Ration::has_some(double now_s) {
    left_ = std::min(left_ + per_s_ * std::max(now_s - filled_s_, 0.0), most_);
    filled_s_ = now_s;
    return left_ > 0;
}

} // namespace ghost::web
