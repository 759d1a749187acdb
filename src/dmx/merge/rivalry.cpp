// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/rivalry.h"

#include <algorithm>
#include <utility>

namespace ghost::dmx {

namespace {

constexpr std::uint8_t kUp = 128, kFar = 128; // two that follow each other through a fade are less apart
constexpr std::uint8_t kLooksApart = 2;       // a tenth of a second at least: a backup is less late
constexpr int kOften = 3;                     // times apart

} // namespace

void Rivalry::add(const Levels& mine, const Levels& others, std::chrono::nanoseconds now) {
    if (looked_ && now - *looked_ < kLookEvery) return;
    looked_ = now;
    if (now - start_ >= kHalf) {
        before_ = std::exchange(now_, {});
        start_ = now;
    }
    for (std::size_t i = 0; i < mine.size(); ++i) {
        const std::uint8_t a = mine[i], b = others[i];
        const bool far = (a > b ? a - b : b - a) >= kFar;
        const auto looks = static_cast<std::uint8_t>(std::min<int>(apart_for_[i] + 1, kLooksApart + 1));
        apart_for_[i] = far ? looks : std::uint8_t{0};
        now_.times[i] = static_cast<std::uint8_t>(now_.times[i] + (apart_for_[i] == kLooksApart ? 1 : 0));
        now_.mine[i] = static_cast<std::uint8_t>(now_.mine[i] | (a >= kUp ? 1 : 0));
        now_.others[i] = static_cast<std::uint8_t>(now_.others[i] | (b >= kUp ? 1 : 0));
    }
    std::size_t count = 0;
    for (std::size_t i = 0; i < mine.size(); ++i) {
        const bool often = now_.times[i] + before_.times[i] >= kOften;
        count += often && (now_.mine[i] | before_.mine[i]) != 0 && (now_.others[i] | before_.others[i]) != 0
                     ? 1
                     : 0;
    }
    if (count == 0) return;
    count_ = std::max(count, fought(now));
    told_ = now;
}

} // namespace ghost::dmx
