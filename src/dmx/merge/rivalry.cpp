// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/rivalry.h"

#include <algorithm>
#include <utility>

namespace ghost::dmx {

namespace {

// Two that follow each other through a fade are apart for less, and a backup is less late.
constexpr std::uint8_t kUp = 96, kFar = 96, kApart = 50;
constexpr std::chrono::milliseconds kUnit{4};       // of kApart
constexpr int kOften = 3;                           // times apart
constexpr std::uint8_t kMine = 0xFF, kTheOther = 1; // who is above
// Of one of both; of the other one shifted by kOther.
enum Seen : unsigned { kHigh = 1, kDown = 2, kLit = 4, kAbove = 8, kOther = 4 };

constexpr bool covers_it(unsigned one, unsigned other) {
    return (one & (kAbove | kDown)) == kAbove && (other & (kAbove | kLit)) == kLit;
}

} // namespace

// In bytes without branches, sixteen at once: this is done for every packet.
void Rivalry::follow(const Levels& mine, const Levels& others, std::chrono::nanoseconds now) {
    const auto units = (now - followed_) / kUnit;
    followed_ += units * kUnit;
    const auto passed = static_cast<std::uint8_t>(std::clamp<std::int64_t>(units, 0, kApart));
    const auto flag = [](bool is) { return static_cast<std::uint8_t>(is ? 0xFF : 0); };
    // Copies, so that the compiler knows them apart.
    const Levels first = mine, second = others, above_before = above_, apart_before = apart_for_;
    Levels above_now, apart_now, times = now_.times;
    for (std::size_t i = 0; i < kSlots; ++i) {
        const std::uint8_t a = first[i], b = second[i], high = std::max(a, b), low = std::min(a, b);
        const std::uint8_t far = flag(static_cast<std::uint8_t>(high - low) >= kFar);
        const auto above = static_cast<std::uint8_t>(far & (flag(a == high) | kTheOther));
        const std::uint8_t same = flag(above == above_before[i]);
        const auto longer = static_cast<std::uint8_t>(apart_before[i] + passed);
        const auto apart = static_cast<std::uint8_t>(far & same & std::min(kApart, longer));
        const auto counts =
            static_cast<std::uint8_t>(flag(apart == kApart) & flag(apart_before[i] != kApart));
        times[i] = static_cast<std::uint8_t>(times[i] + (counts & 1));
        above_now[i] = above;
        apart_now[i] = apart;
    }
    now_.times = times;
    above_ = above_now;
    apart_for_ = apart_now;
}

void Rivalry::conclude(const Levels& mine, const Levels& others, std::chrono::nanoseconds now) {
    const auto did = [](std::uint8_t level, bool is_above) {
        return (level >= kUp ? kHigh : kDown) | (level > 0 ? kLit : 0u) | (is_above ? kAbove : 0u);
    };
    std::array<std::size_t, 2> counts{};
    for (std::size_t i = 0; i < kSlots; ++i) {
        now_.seen[i] |= static_cast<std::uint8_t>(did(mine[i], above_[i] == kMine) |
                                                  did(others[i], above_[i] == kTheOther) << kOther);
        if (now_.times[i] + before_.times[i] < kOften) continue;
        const unsigned seen = now_.seen[i] | before_.seen[i];
        const unsigned one = seen & ((1u << kOther) - 1), other = seen >> kOther;
        if (covers_it(one, other) || covers_it(other, one))
            ++counts[covers];
        else if ((one & other & kHigh) != 0)
            ++counts[shares];
    }
    for (const Kind kind : {covers, shares})
        if (counts[kind] > 0) met_[kind] = {std::max(counts[kind], met(kind, now)), now};
    if (now - half_ < kHalf) return;
    before_ = std::exchange(now_, {});
    half_ = now;
}

} // namespace ghost::dmx
