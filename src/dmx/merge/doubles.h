#pragma once
// SPDX-License-Identifier: Apache-2.0
// Doubles: whether two senders hide behind one identity, told by what they show over time. LookPair compares
// two streams of levels: they are two senders' where for a second a channel differs in every comparison and
// stands still in one of them. A copy that is no second late (by another way: no two seconds) has the same
// level at some time; one that moves in both tells nothing. SharedRows finds the streams in what comes one
// way: two rows of numbers that each count up, two ports that unnumbered packets come from, or numbered ones
// and others. No clock.

#include "dmx/wire/packet.h"

#include <array>
#include <chrono>
#include <optional>

namespace ghost::dmx {

inline constexpr std::chrono::seconds kDoubleForgotten{5}; // unchanged levels: one a second

class LookPair {
public:
    // windows: seconds in a row that tell, for streams that may be late by so long.
    explicit LookPair(unsigned windows = 1) : windows_(windows) {}

    void add(int stream, const Levels& levels, std::chrono::nanoseconds now); // stream: 0 or 1
    // One of the streams is another one from now on.
    void restart(std::chrono::nanoseconds now);
    // Two senders, of late.
    bool differ(std::chrono::nanoseconds now) const { return told_ && now - *told_ <= kDoubleForgotten; }
    // Both streams come, and nothing is known yet.
    bool undecided() const { return turns_ >= kFewTurns && !concluded_; }
    // A window was compared, and tells nothing yet of the next one.
    bool is_one() const { return concluded_ && !suspects_; }
    const Levels& newest(int stream) const { return streams_[static_cast<std::size_t>(stream)].levels; }

private:
    struct Stream {
        Levels levels{};
        Levels moved{}; // not 0 where the level changed since start_
        unsigned packets = 0;
        bool known = false;
    };
    void conclude(std::chrono::nanoseconds now);

    static constexpr unsigned kFewTurns = 3; // a sender that begins anew, or is late once, takes fewer

    std::array<Stream, 2> streams_;
    Levels met_{};       // not 0 where both were equal once since start_
    Levels apart_for_{}; // windows in a row in which a channel told two senders
    unsigned windows_;
    unsigned turns_ = 0;
    int last_ = 0;
    bool concluded_ = false, suspects_ = false; // of the window before
    std::chrono::nanoseconds start_{0};
    std::optional<std::chrono::nanoseconds> told_;
};

class SharedRows {
public:
    // Levels, whether they are used or dropped as late.
    void add(const Packet& packet, std::chrono::nanoseconds now);
    bool are_two(std::chrono::nanoseconds now) const { return pair_.differ(now); }
    bool undecided() const { return pair_.undecided(); }
    // Of unnumbered rows: the lower and the higher port, or 0.
    std::array<std::uint16_t, 2> ports() const;

private:
    struct Row {
        bool used = false, numbered = false;
        std::uint8_t number = 0;
        std::uint16_t port = 0;
    };
    std::optional<int> row_of(const Packet& packet, bool numbered) const;

    std::array<Row, 2> rows_;
    int last_ = 1; // row
    LookPair pair_;
};

} // namespace ghost::dmx
