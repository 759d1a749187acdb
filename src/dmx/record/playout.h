#pragma once
// SPDX-License-Identifier: Apache-2.0
// Playout: which universes of a recording go out when. Every look at its time, one after the other also where
// the caller comes late; a universe that rests is repeated. A look is not repeated before two periods, so
// that a desk a little slower than the rate is not doubled: E1.31-2018 6.6.1 allows no universe more than the
// refresh rate of E1.11. No clock, no sockets. One thread.

#include "dmx/record/player.h"

#include <chrono>
#include <map>
#include <optional>

namespace ghost::dmx {

inline constexpr double kMostCaughtUp_s = 1.0; // of looks that the caller is late for; from there on it jumps

class Playout {
public:
    // period: of repeats. every_look false: looks that lie between two calls are left out, for a recording
    // that is played faster than it was made. player must outlive this.
    Playout(Player& player, std::chrono::nanoseconds period, bool every_look = true)
        : player_(player), period_(period), every_look_(every_look) {}

    // What goes out now, where the recording stands at t_s. Call until it is empty.
    Universes due(double t_s, std::chrono::nanoseconds now);
    // The recording goes on elsewhere, however near.
    void rewind() { at_s_.reset(); }

    // When the next look comes, in seconds of the recording, and when something is repeated.
    std::optional<double> next_look_s() const;
    std::optional<std::chrono::nanoseconds> next_repeat() const;

private:
    struct Sent {
        std::shared_ptr<const Levels> levels;
        std::uint16_t slot_count = 0;
        std::chrono::nanoseconds again{0}; // when it is repeated
    };
    // The next look up to t_s, or t_s; whether more may follow up to there.
    bool step(double t_s);
    Universes take_due(std::chrono::nanoseconds now);

    Player& player_;
    std::chrono::nanoseconds period_;
    bool every_look_;
    std::optional<double> at_s_; // looks up to there were taken
    std::map<std::uint16_t, Sent> sent_;
};

} // namespace ghost::dmx
