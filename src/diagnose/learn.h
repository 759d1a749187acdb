#pragma once
// SPDX-License-Identifier: Apache-2.0
// Learner: finds out which address a fader is: move one, and it says which slots of which source moved and
// what the show has there, and one universe beside. What moves by itself is left out: slots that change while
// it listens first. Pure, no clock: it gets statistics with slots (dmx::MergeOptions::slot_status).

#include "diagnose/patch_map.h"
#include "dmx/receive/statistics.h"

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {

struct Moved {
    int universe = 0;
    int address = 0; // 1-based
    int from = 0, to = 0;
    dmx::Protocol protocol = dmx::Protocol::sacn;
    std::string source; // its name, or address
};

class Learner {
public:
    static constexpr std::chrono::seconds kListensFirst{2};
    static constexpr int kLeastMove = 8;          // of 255: less is noise of a fader
    static constexpr std::size_t kMostMoved = 32; // at once: more is a cue, no fader

    // Slots that moved, each once until it rests for a second; too many at once are none.
    std::vector<Moved> feed(const dmx::Statistics& statistics);
    bool listens_first() const { return !begin_ || now_ - *begin_ < kListensFirst; }
    // So many slots moved at once that it was no fader; of the last feed.
    std::size_t too_many() const { return too_many_; }

private:
    struct Seen {
        dmx::Levels rest{}; // levels that moves are measured from
        std::array<std::chrono::nanoseconds, dmx::kSlots> told{};
        std::set<std::size_t> restless; // move by themselves
    };

    std::map<std::pair<std::uint16_t, std::string>, Seen> sources_; // universe, id
    std::optional<std::chrono::nanoseconds> begin_;
    std::chrono::nanoseconds now_{0};
    std::size_t too_many_ = 0;
};

// What it would be: "universe 2 address 17 by Art-Net (Port-Address 0:0:1) from 10.0.0.5, 0 -> 255: 'Spot 1'
// Dimmer". Where nothing is patched there, but one universe beside: how to shift.
std::string moved_text(const Moved& moved, const PatchMap& patch, int artnet_offset);

} // namespace ghost::scene
