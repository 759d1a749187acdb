// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/catch_up.h"

#include <algorithm>

namespace ghost::dmx {

void CatchUp::begin(const Universes& shown, std::chrono::nanoseconds now) {
    if (!active()) {
        shown_ = shown;
        began_ = now;
    }
    state_ = State::reading;
    since_ = now;
}

void CatchUp::read_all(bool lost) {
    if (reading()) state_ = lost ? State::waiting : State::none;
}

bool CatchUp::expire(std::chrono::nanoseconds now) {
    if (!active() || now - began_ < kCatchUp) return false;
    state_ = State::none;
    return true;
}

Universes CatchUp::view(const Universes& newest, const std::function<bool(std::uint16_t)>& heard) {
    if (!active()) return newest;
    Universes result;
    // Grows with what is shown, so that nobody takes the rest, when it comes, for known.
    result.revision = shown_.revision;
    bool all = !reading();
    for (const Universe& universe : newest.list) {
        const bool present = !reading() && heard(universe.number);
        all &= present;
        const Universe* const chosen = present ? &universe : shown_.find(universe.number);
        if (!chosen) continue; // new since the pause
        result.list.push_back(*chosen);
        result.revision = std::max(result.revision, chosen->revision);
    }
    shown_ = result;
    if (!all) return result;
    state_ = State::none;
    return newest;
}

} // namespace ghost::dmx
