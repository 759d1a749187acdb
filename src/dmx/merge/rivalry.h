#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rivalry: what two sources that have the same say do to each other on channels that never stand still. They
// meet on a channel where they were far apart again and again, each time for longer than a backup follows its
// desk. One covers the other where it never takes the channel down and is never below it: a forgotten desk
// over a chase. Else, where both had it up, they share it: two operators of one lamp, or one chase out of
// step. Whoever hands a channel over is apart from the next one once or twice. No clock.

#include "dmx/wire/packet.h"

#include <array>
#include <chrono>
#include <optional>

namespace ghost::dmx {

class Rivalry {
public:
    enum Kind { covers, shares };

    Rivalry(const SourceKey& other, std::chrono::nanoseconds now)
        : other_(other), followed_(now), half_(now) {}

    const SourceKey& other() const { return other_; }
    // What both show when a packet of one of them came.
    void follow(const Levels& mine, const Levels& others, std::chrono::nanoseconds now);
    // What that says. Call it a few times a second, with what both show then.
    void conclude(const Levels& mine, const Levels& others, std::chrono::nanoseconds now);
    // Channels on which they met of late.
    std::size_t met(Kind kind, std::chrono::nanoseconds now) const {
        const Met& met = met_[kind];
        return met.at && now - *met.at <= kForgotten ? met.count : 0;
    }

private:
    struct Half {       // of the time that is looked at
        Levels times{}; // that they came apart
        Levels seen{};  // what each of both did, as bits
    };
    struct Met {
        std::size_t count = 0;
        std::optional<std::chrono::nanoseconds> at;
    };
    static constexpr std::chrono::seconds kHalf{5}, kForgotten{10};

    SourceKey other_;
    // Of each channel: who is far above the other (0: nobody), and for how long.
    Levels above_{}, apart_for_{};
    Half now_, before_;
    std::chrono::nanoseconds followed_, half_; // when it was done last, when now_ began
    std::array<Met, 2> met_;
};

} // namespace ghost::dmx
