// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/rivalry.h"

#include <algorithm>
#include <utility>

namespace ghost::dmx {

namespace {

// Two that follow each other through a fade are apart for less, and a backup is less late.
constexpr std::uint8_t kUp = 96, kFar = 96, kApart = 50;
constexpr std::chrono::milliseconds kUnit{4}; // of kApart
constexpr int kOften = 3;                     // times apart
enum Seen : std::uint8_t { kMineUp = 1, kMineDown = 2, kOthersUp = 4, kOthersDown = 8 };

} // namespace

// In bytes without branches, sixteen at once: this is done for every packet.
void Rivalry::follow(const Levels& mine, const Levels& others, std::chrono::nanoseconds now) {
    const auto units = (now - followed_) / kUnit;
    followed_ += units * kUnit;
    const auto passed = static_cast<std::uint8_t>(std::clamp<std::int64_t>(units, 0, kApart));
    const auto flag = [](bool is) { return static_cast<std::uint8_t>(is ? 0xFF : 0); };
    // Copies, so that the compiler knows them apart.
    const Levels first = mine, second = others, above_before = above_, apart_before = apart_for_;
    Levels above_now, apart_now;
    Half half = now_;
    for (std::size_t i = 0; i < kSlots; ++i) {
        const std::uint8_t a = first[i], b = second[i], high = std::max(a, b), low = std::min(a, b);
        const std::uint8_t far = flag(static_cast<std::uint8_t>(high - low) >= kFar);
        const auto above = static_cast<std::uint8_t>(far & (flag(a == high) | 1)); // 0xFF: mine, 1: the other
        const std::uint8_t same = flag(above == above_before[i]);
        const auto longer = static_cast<std::uint8_t>(apart_before[i] + passed);
        const auto apart = static_cast<std::uint8_t>(far & same & std::min(kApart, longer));
        const auto counts =
            static_cast<std::uint8_t>(flag(apart == kApart) & flag(apart_before[i] != kApart));
        half.times[i] = static_cast<std::uint8_t>(half.times[i] + (counts & 1));
        above_now[i] = above;
        apart_now[i] = apart;
        const std::uint8_t mine_up = flag(a >= kUp), others_up = flag(b >= kUp);
        half.seen[i] |= static_cast<std::uint8_t>((mine_up & kMineUp) | (~mine_up & kMineDown) |
                                                  (others_up & kOthersUp) | (~others_up & kOthersDown));
    }
    now_ = half;
    above_ = above_now;
    apart_for_ = apart_now;
}

void Rivalry::conclude(std::chrono::nanoseconds now) {
    std::array<std::size_t, 2> counts{};
    for (std::size_t i = 0; i < kSlots; ++i) {
        if (now_.times[i] + before_.times[i] < kOften) continue;
        const int seen = now_.seen[i] | before_.seen[i];
        if ((seen & (kMineUp | kOthersUp)) != (kMineUp | kOthersUp)) continue;
        const bool both_go_down = (seen & (kMineDown | kOthersDown)) == (kMineDown | kOthersDown);
        ++counts[both_go_down ? by_turns : covers];
    }
    for (const Kind kind : {covers, by_turns})
        if (counts[kind] > 0) met_[kind] = {std::max(counts[kind], met(kind, now)), now};
    if (now - half_ < kHalf) return;
    before_ = std::exchange(now_, {});
    half_ = now;
}

} // namespace ghost::dmx
