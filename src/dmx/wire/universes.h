#pragma once
// SPDX-License-Identifier: Apache-2.0
// Universes: the merged DMX levels of all universes at one moment; what the receiver publishes and a player
// returns. Numbering: Ghostlight universe n (from 1) = sACN universe n = Art-Net Port-Address n-1 (15 bits,
// net:sub:uni) unless an offset is set. A copy shares the levels, so it costs a few bytes per universe.
// Values only; safe to hand between threads.

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

namespace ghost::dmx {

inline constexpr std::size_t kSlots = 512;
inline constexpr std::uint16_t kMaxUniverse = 63999; // E1.31-2018 section 6.2.7

using Levels = std::array<std::uint8_t, kSlots>;

struct Universe {
    std::uint16_t number = 0;
    bool lost = false;                    // no live source: the last look is held, or
    bool black = false;                   // lost, and the look was taken away (LossPolicy)
    std::uint16_t slot_count = kSlots;    // somebody sends or sent so many; from there on levels are 0
    std::shared_ptr<const Levels> levels; // never null in a list; address 1 is element 0
    std::chrono::nanoseconds arrival{
        0};                     // steady time of the newest packet merged in; of a player: the show time
    std::uint64_t revision = 0; // grows when the levels change, and only then
};

struct Universes {
    std::vector<Universe> list; // sorted by number, each number once
    std::uint64_t revision = 0; // grows when the levels of any universe change
    // Steady time of the first packet since the last take of a receiver's levels that changed any; 0: none
    // did. Of a player: 0.
    std::chrono::nanoseconds first_change{0};

    const Universe* find(std::uint16_t number) const; // nullptr: nothing arrived there yet
    // Level 0..255 of a 1-based address; 0 where nothing arrived or the address is outside 1..512.
    std::uint8_t level(std::uint16_t number, int address) const;
    // The entry of a universe, inserted (all levels 0) where it is missing.
    Universe& at(std::uint16_t number);
};

} // namespace ghost::dmx
