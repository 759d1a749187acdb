#pragma once
// SPDX-License-Identifier: Apache-2.0
// What may throw a soft shadow, from a distance map: its texels summed up in cells of 4, 8, 16 .. texels a
// side, so that a penumbra many texels wide is found from a few cells and nothing thin falls between them.
// The texels of a cell are taken for one or two groups, divided at the widest gap of their distances: a bar
// and the floor behind it, say. Pure.

#include <cstdint>
#include <vector>

namespace ghost::render {

inline constexpr std::uint32_t kLeastBlockerCell = 4; // texels
inline constexpr std::uint32_t kBlockerLevels = 5;    // up to 64 texels, or as many as the map has

// Half floats, laid out as shared/blockers.h says.
struct Blockers {
    std::uint16_t near_from = 0; // metres, of the nearer group
    std::uint16_t near_to = 0;
    std::uint16_t parts = 0;
    std::uint16_t far_to = 0; // of the other group, or of the only one
};

// Of a map with so many texels a side.
std::uint32_t blocker_levels(std::uint32_t side);

// Level after level, cells row by row. texels: half floats above zero, side x side.
std::vector<std::vector<Blockers>> blockers_of(const std::vector<std::uint16_t>& texels, std::uint32_t side);

// The same of a square of so many texels, which begins at a multiple of them; levels: of the whole map.
void update_blockers(const std::vector<std::uint16_t>& texels, std::uint32_t side, std::uint32_t x,
                     std::uint32_t y, std::uint32_t width, std::vector<std::vector<Blockers>>& levels);

} // namespace ghost::render
