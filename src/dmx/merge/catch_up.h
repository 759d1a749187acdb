#pragma once
// SPDX-License-Identifier: Apache-2.0
// CatchUp: what is shown after a pause in which the receiver did not run. What waited in the sockets is the
// past, from its beginning on; where a buffer was full its end is lost. So universes keep the look from
// before the pause until all of it was read. Where nothing was lost that is the present. Where something was,
// each universe goes on to keep its look until its sources were heard again, for kCatchUp at most. No clock:
// every call gets the time. One thread at a time.

#include "dmx/wire/universes.h"

#include <chrono>
#include <functional>

namespace ghost::dmx {

inline constexpr std::chrono::milliseconds kCatchUp{1000}; // unchanged sACN levels come every 0.8 to 1 s

class CatchUp {
public:
    // A pause is over. shown: the look from before it. While active only the time is new.
    void begin(const Universes& shown, std::chrono::nanoseconds now);
    // All that waited was read; lost: not all that came had room to wait.
    void read_all(bool lost);
    // Whether something may have to be shown now though nothing arrived.
    bool expire(std::chrono::nanoseconds now);

    bool active() const { return state_ != State::none; }
    bool reading() const { return state_ == State::reading; } // nothing new may be shown
    std::chrono::nanoseconds since() const { return since_; } // the end of the pause

    // What to show of the newest levels. heard: whether the levels of a universe are those of after the
    // pause.
    Universes view(const Universes& newest, const std::function<bool(std::uint16_t universe)>& heard);

private:
    enum class State { none, reading, waiting };
    State state_ = State::none;
    std::chrono::nanoseconds began_{0}, since_{0};
    Universes shown_;
};

} // namespace ghost::dmx
