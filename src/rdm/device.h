#pragma once
// SPDX-License-Identifier: Apache-2.0
// A device as RDM tells it: what a fixture of the show looks like to a desk. Values only. Texts are cut to 32
// bytes where they are sent. Clauses of ANSI E1.20-2010 where a table of it is meant.

#include "rdm/message.h"

namespace ghost::rdm {

// Of experimental devices: no maker of ours is registered (E1.20 B, 0x7FF0 to 0x7FFF).
inline constexpr std::uint16_t kMaker = 0x7FF0;
inline constexpr std::uint16_t kFixedFixture = 0x0101, kMovingYoke = 0x0102; // product categories, table A-5
inline constexpr std::uint16_t kUndefinedSlot = 0xFFFF;                      // table C-2
inline constexpr std::size_t kMostPersonalities = 255, kMostSensors = 254;

struct Slot {
    std::uint16_t label = kUndefinedSlot; // table C-2; of a fine byte the slot (0-based) that it refines
    bool fine = false;                    // table C-1: secondary, fine
    std::string name;
};

struct Personality {
    std::string name;
    std::uint16_t footprint = 0; // slots
};

// An angle, in tenths of a degree.
struct Sensor {
    std::string name;
    std::int16_t least = 0, most = 0, value = 0;
    std::int16_t lowest = 0, highest = 0; // so far
};

struct Device {
    Uid uid;
    std::uint16_t universe = 0; // of the show; 0: not patched
    std::uint16_t model = 0;
    std::uint16_t category = kFixedFixture;
    std::string model_name, maker_name, software;
    std::uint32_t software_version = 0;
    std::string label;
    std::vector<Personality> personalities; // at least one
    std::uint8_t personality = 1;           // 1-based
    std::uint16_t start_address = 1;
    std::vector<Slot> slots; // of the personality
    std::vector<Sensor> sensors;
    bool identifies = false;

    std::uint16_t footprint() const {
        return personality >= 1 && personality <= personalities.size()
                   ? personalities[personality - 1].footprint
                   : std::uint16_t{0};
    }
};

// What a desk wants to be changed; the device changes when the show says it did.
struct Change {
    enum class What { start_address, personality, label, identify } what = What::identify;
    Uid uid;
    std::uint16_t number = 0; // address, personality, 0 or 1
    std::string label;
};

} // namespace ghost::rdm
