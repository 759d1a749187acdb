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

// A part of a map, texels.
struct BlockerSquare {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t width = 0;
};

// A square of blocks of so many texels a side that has whole cells of every level: texels a side.
std::uint32_t blocker_unit(std::uint32_t block, std::uint32_t side);
// Such squares, which hold these blocks, numbered row by row. side: a multiple of them.
std::vector<BlockerSquare> squares_of(const std::vector<int>& blocks, std::uint32_t block,
                                      std::uint32_t side);

// The same as blockers_of in a square that begins at a multiple of its width, which is at least that of the
// coarsest cell; levels: of the whole map.
void update_blockers(const std::vector<std::uint16_t>& texels, std::uint32_t side,
                     const BlockerSquare& square, std::vector<std::vector<Blockers>>& levels);

} // namespace ghost::render
