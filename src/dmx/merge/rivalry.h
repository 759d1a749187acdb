#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rivalry: whether two sources that have the same say fight over channels that never stand still: one was
// forgotten and holds what the other one chases, or both run one chase out of step. A channel is fought over
// where both had it up and they were far apart again and again, each time for longer than a backup follows
// its desk. Whoever hands a channel over is apart from the next one once or twice. No clock.

#include "dmx/wire/packet.h"

#include <chrono>
#include <optional>

namespace ghost::dmx {

class Rivalry {
public:
    explicit Rivalry(const SourceKey& other) : other_(other) {}

    const SourceKey& other() const { return other_; }
    // What both show now; looks that come sooner than kLookEvery are passed over.
    void add(const Levels& mine, const Levels& others, std::chrono::nanoseconds now);
    // Channels that they fought over of late.
    std::size_t fought(std::chrono::nanoseconds now) const {
        return told_ && now - *told_ <= kForgotten ? count_ : 0;
    }

    static constexpr std::chrono::milliseconds kLookEvery{100};

private:
    struct Half {                // of the time that is looked at
        Levels times{};          // that they came apart
        Levels mine{}, others{}; // not 0 where it was up
    };
    static constexpr std::chrono::seconds kHalf{5}, kForgotten{10};

    SourceKey other_;
    Levels apart_for_{}; // looks in a row
    Half now_, before_;
    std::chrono::nanoseconds start_{0};
    std::optional<std::chrono::nanoseconds> looked_, told_;
    std::size_t count_ = 0;
};

} // namespace ghost::dmx
