// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/player.h"

#include <algorithm>
#include <cmath>

namespace ghost::dmx {

using std::chrono::microseconds;

double Player::duration_s() const {
    return std::chrono::duration<double>(recording_.duration()).count();
}

// A block that cannot be read begins with what the one before ends with.
void Player::load(std::size_t block) {
    cursor_ = recording_.block(block);
    for (std::size_t i = block; cursor_.states().empty() && !cursor_.next_time() && i > 0;) {
        cursor_ = recording_.block(--i);
        while (cursor_.next_time()) cursor_.next();
        recording_.check(cursor_, i);
    }
    block_ = block;
    time_ = microseconds(-1);
}

void Player::go_to(microseconds time) {
    const std::size_t wanted = recording_.block_at(time);
    if (block_ != wanted || time < time_) load(wanted);
    while (cursor_.next_time() && *cursor_.next_time() <= time) cursor_.next();
    recording_.check(cursor_, wanted);
    time_ = time;
}

// Rounded: a frame stamped 40 ms is on at t = 0.04 whatever way that was computed.
void Player::go_to(double t_s) {
    const double longest_s = std::chrono::duration<double>(kLongestRecording).count();
    const double wanted_s = t_s > 0.0 ? std::min(t_s, longest_s) : 0.0;
    go_to(microseconds(std::llround(wanted_s * 1e6)));
}

Universes Player::at(double t_s) {
    go_to(t_s);
    Universes result;
    result.list.reserve(cursor_.states().size());
    for (const auto& [number, state] : cursor_.states()) {
        Universe universe;
        universe.number = number;
        universe.lost = state.lost;
        universe.slot_count = state.slot_count;
        universe.levels = state.levels;
        universe.arrival = state.time;
        universe.revision = state.revision;
        result.revision = std::max(result.revision, state.revision);
        result.list.push_back(std::move(universe));
    }
    return result;
}

std::optional<double> Player::next_after(double t_s) {
    go_to(t_s);
    std::optional<microseconds> next = cursor_.next_time();
    if (!next && *block_ + 1 < recording_.blocks()) next = recording_.block_place(*block_ + 1).start;
    if (!next) return std::nullopt;
    return std::chrono::duration<double>(*next).count();
}

} // namespace ghost::dmx
