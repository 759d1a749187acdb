#pragma once
// SPDX-License-Identifier: Apache-2.0
// PatchMap: what a show has at which DMX address: of every slot the fixture and channel that read it, and so
// the universes that a receiver has to join. Universes and addresses from 1. Pure; a copy of the names, so
// that the show may go.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {

struct Show;

// A slot, as a fixture or a mover reads it.
struct PatchedSlot {
    std::size_t fixture = 0; // of the show; movers come after the fixtures
    std::string fixture_name;
    std::string channel; // "Head_Dimmer (2 of 2)", "channel 7" where the mode says nothing of it
    bool dims = false;   // a byte of a dimmer
};

struct PatchedUniverse {
    std::uint16_t universe = 0;
    std::size_t fixtures = 0;
    std::string first;    // name of one of them
    int runs_on_from = 0; // universe on which that begins, where none of them begins on this one
};

class PatchMap {
public:
    PatchMap() = default;
    explicit PatchMap(const Show& show);

    const std::vector<PatchedUniverse>& universes() const { return universes_; } // sorted
    std::vector<std::uint16_t> universe_numbers() const;
    bool has(int universe) const;
    // Addresses that dimmers of fixtures read. Sorted.
    std::vector<int> dimmers(int universe) const;
    // Everyone who reads the slot; several may share an address.
    std::vector<const PatchedSlot*> at(int universe, int address) const;
    // Names of those who read slots of the universe past this address and none before, in the show's order.
    // (A desk may leave out the end of a fixture, channels that it never touched.)
    std::vector<std::string> readers_past(int universe, int address) const;

private:
    std::multimap<std::pair<int, int>, PatchedSlot> slots_;
    std::vector<PatchedUniverse> universes_;
};

} // namespace ghost::scene
