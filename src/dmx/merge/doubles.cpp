// SPDX-License-Identifier: Apache-2.0
#include "dmx/merge/doubles.h"

#include <algorithm>
#include <cstdlib>

namespace ghost::dmx {

namespace {

constexpr std::chrono::seconds kCompared{1}; // at least
constexpr std::chrono::seconds kNotComparable{5};
constexpr unsigned kFewPackets = 2;
constexpr int kMostMissed = 8; // in a row that goes on: start codes of other kinds, losses

int distance(const Levels& a, const Levels& b) {
    int sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
}

} // namespace

void LookPair::add(int stream, const Levels& levels, std::chrono::nanoseconds now) {
    if (now - start_ >= kCompared) conclude(now);
    Stream& one = streams_[static_cast<std::size_t>(stream)];
    const Stream& other = streams_[static_cast<std::size_t>(1 - stream)];
    if (one.known && levels != one.levels)
        for (std::size_t i = 0; i < levels.size(); ++i)
            one.moved[i] = static_cast<std::uint8_t>(one.moved[i] | (one.levels[i] ^ levels[i]));
    if (other.known && levels == other.levels)
        met_.fill(1);
    else if (other.known)
        for (std::size_t i = 0; i < levels.size(); ++i)
            met_[i] = static_cast<std::uint8_t>(met_[i] | (levels[i] == other.levels[i] ? 1 : 0));
    one.levels = levels;
    one.known = true;
    ++one.packets;
    turns_ += stream != last_ ? 1 : 0;
    last_ = stream;
}

void LookPair::conclude(std::chrono::nanoseconds now) {
    const auto& [a, b] = streams_;
    const bool enough = a.packets >= kFewPackets && b.packets >= kFewPackets && turns_ >= kFewTurns;
    if (!enough && now - start_ < kNotComparable) return;
    concluded_ |= enough;
    suspects_ = false;
    for (std::size_t i = 0; enough && i < met_.size(); ++i) {
        const bool apart = met_[i] == 0 && (a.moved[i] == 0 || b.moved[i] == 0);
        apart_for_[i] = apart ? static_cast<std::uint8_t>(std::min(apart_for_[i] + 1u, windows_)) : 0;
        suspects_ |= apart;
        if (apart_for_[i] >= windows_) told_ = now;
    }
    restart(now);
}

// What each showed last stays: that is what the next packet of the other one is compared with.
void LookPair::restart(std::chrono::nanoseconds now) {
    for (Stream& one : streams_) {
        one.packets = 0;
        one.moved = {};
    }
    met_ = {};
    turns_ = 0;
    start_ = now;
}

// The nearest row that a packet goes on with; of two that are as near, the one whose look is nearer.
std::optional<int> SharedRows::row_of(const Packet& packet, bool numbered) const {
    std::optional<int> best;
    int best_step = kMostMissed + 1;
    for (const int i : {1 - last_, last_}) {
        const Row& row = rows_[static_cast<std::size_t>(i)];
        if (!row.used || row.numbered != numbered) continue;
        if (!numbered) {
            if (row.port == packet.from_port) return i;
            continue;
        }
        const int step = static_cast<std::uint8_t>(packet.sequence - row.number);
        if (step == 0 || step > best_step || step > kMostMissed) continue;
        if (step == best_step &&
            (pair_.newest(i) == pair_.newest(1 - i) ||
             distance(packet.slots, pair_.newest(i)) >= distance(packet.slots, pair_.newest(1 - i))))
            continue;
        best = i;
        best_step = step;
    }
    return best;
}

void SharedRows::add(const Packet& packet, std::chrono::nanoseconds now) {
    const bool numbered = packet.protocol != Protocol::artnet || packet.sequence != 0;
    const std::optional<int> found = row_of(packet, numbered);
    const int row = found.value_or(1 - last_);
    if (!found) pair_.restart(now);
    rows_[static_cast<std::size_t>(row)] = {true, numbered, packet.sequence, packet.from_port};
    pair_.add(row, packet.slots, now);
    last_ = row;
}

std::array<std::uint16_t, 2> SharedRows::ports() const {
    const auto& [a, b] = rows_;
    if (!a.used || !b.used || a.numbered || b.numbered) return {0, 0};
    return {std::min(a.port, b.port), std::max(a.port, b.port)};
}

} // namespace ghost::dmx
