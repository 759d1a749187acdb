// SPDX-License-Identifier: Apache-2.0
#include "render/haze/private/blockers.h"

#include "base/check.h"
#include "shared/blockers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <span>

namespace ghost::render {
namespace {

constexpr std::uint32_t kFewestCells = 4; // a side; a shadow looks at five, and beyond an edge once

// The bits of half floats above zero are in their order, and about their logarithm: 1024 to the octave.
constexpr int kGap = 140; // groups are a tenth apart at least

struct Group {
    int from = 0; // bits of half floats
    int to = 0;
    float fraction = 0;
};

struct Cell {
    Group near;
    Group far; // without one: there is only one
};

// Sorts the groups and makes two of them.
Cell divided(std::span<Group> groups) {
    std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.from < b.from; });
    std::size_t first_far = groups.size();
    int widest = kGap - 1, to = 0;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        if (k > 0 && groups[k].from - to > widest) {
            widest = groups[k].from - to;
            first_far = k;
        }
        to = std::max(to, groups[k].to);
    }
    Cell cell{{groups[0].from, groups[0].to, 0}, {groups[std::min(first_far, groups.size() - 1)].from, 0, 0}};
    for (std::size_t k = 0; k < groups.size(); ++k) {
        Group& part = k < first_far ? cell.near : cell.far;
        part.to = std::max(part.to, groups[k].to);
        part.fraction += groups[k].fraction;
    }
    return cell;
}

Cell cell_of(const std::uint16_t* corner, std::size_t side) {
    int least = 0xffff, most = 0;
    for (std::size_t y = 0; y < kLeastBlockerCell; ++y)
        for (std::size_t x = 0; x < kLeastBlockerCell; ++x) {
            const int value = corner[y * side + x];
            least = std::min(least, value);
            most = std::max(most, value);
        }
    if (most - least < kGap) return {{least, most, 1}, {}};
    std::array<Group, std::size_t{kLeastBlockerCell} * kLeastBlockerCell> groups;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        const int value = corner[k / kLeastBlockerCell * side + k % kLeastBlockerCell];
        groups[k] = {value, value, 1.0f / static_cast<float>(groups.size())};
    }
    return divided(groups);
}

Cell merged(const Cell* corner, std::size_t side) {
    std::array<Group, 8> groups;
    std::size_t count = 0;
    for (const Cell* cell : {corner, corner + 1, corner + side, corner + side + 1})
        for (const Group& group : {cell->near, cell->far})
            if (group.fraction > 0) groups[count++] = {group.from, group.to, 0.25f * group.fraction};
    return divided(std::span(groups).first(count));
}

float metres(int bits) {
    return std::max(glm::unpackHalf1x16(static_cast<std::uint16_t>(bits)), 1e-3f);
}

Blockers packed(const Cell& cell) {
    const bool one = cell.far.fraction <= 0;
    const int far_to = one ? cell.near.to : cell.far.to;
    float steps = shared::kFromSteps;
    if (!one && cell.far.from < far_to) {
        const float start = 1 / metres(cell.near.to), end = 1 / metres(far_to);
        // Rather too near than too far.
        steps = std::floor(steps * (start - 1 / metres(cell.far.from)) / std::max(start - end, 1e-9f));
    }
    // No group is lost.
    const float fraction = one ? shared::kFractionSteps
                               : std::clamp(std::round(shared::kFractionSteps * cell.near.fraction), 1.0f,
                                            shared::kFractionSteps - 1.0f);
    const float parts = shared::pack_parts(fraction, std::clamp(steps, 0.0f, shared::kFromSteps));
    return {static_cast<std::uint16_t>(cell.near.from), static_cast<std::uint16_t>(cell.near.to),
            glm::packHalf1x16(parts), static_cast<std::uint16_t>(far_to)};
}

} // namespace

std::uint32_t blocker_levels(std::uint32_t side) {
    std::uint32_t levels = 1;
    while (levels < kBlockerLevels && side >> (levels + 2) >= kFewestCells) ++levels;
    return levels;
}

std::vector<std::vector<Blockers>> blockers_of(const std::vector<std::uint16_t>& texels, std::uint32_t side) {
    std::vector<std::vector<Blockers>> levels(blocker_levels(side));
    std::size_t cells = std::max(side / kLeastBlockerCell, 1u);
    for (std::vector<Blockers>& level : levels) {
        level.resize(cells * cells);
        cells /= 2;
    }
    update_blockers(texels, side, {0, 0, side}, levels);
    return levels;
}

std::uint32_t blocker_unit(std::uint32_t block, std::uint32_t side) {
    return std::max(block, kLeastBlockerCell << (blocker_levels(side) - 1));
}

std::vector<BlockerSquare> squares_of(const std::vector<int>& blocks, std::uint32_t block,
                                      std::uint32_t side) {
    const std::uint32_t unit = blocker_unit(block, side), units = side / unit, across = side / block;
    CHECK_EQ(side % unit, 0u);
    std::vector<BlockerSquare> squares;
    std::vector<bool> has(std::size_t{units} * units);
    for (const int number : blocks) {
        const auto k = static_cast<std::uint32_t>(number);
        const std::uint32_t x = k % across * block / unit, y = k / across * block / unit;
        if (!has[y * units + x]) squares.push_back({x * unit, y * unit, unit});
        has[y * units + x] = true;
    }
    return squares;
}

void update_blockers(const std::vector<std::uint16_t>& texels, std::uint32_t side,
                     const BlockerSquare& square, std::vector<std::vector<Blockers>>& levels) {
    const auto [x, y, width] = square;
    CHECK(width == side || width >= kLeastBlockerCell << (levels.size() - 1));
    std::size_t cells = std::max(width / kLeastBlockerCell, 1u);
    std::vector<Cell> level(cells * cells);
    for (std::size_t k = 0; k < level.size(); ++k)
        level[k] = cell_of(
            &texels[(y + kLeastBlockerCell * (k / cells)) * side + x + kLeastBlockerCell * (k % cells)],
            side);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        if (l > 0) {
            const std::size_t finer = cells;
            cells /= 2;
            std::vector<Cell> coarser(cells * cells);
            for (std::size_t k = 0; k < coarser.size(); ++k)
                coarser[k] = merged(&level[2 * (k / cells * finer + k % cells)], finer);
            level = std::move(coarser);
        }
        const std::size_t of_all = std::max(side / kLeastBlockerCell, 1u) >> l;
        const std::size_t first_x = x / kLeastBlockerCell >> l, first_y = y / kLeastBlockerCell >> l;
        for (std::size_t k = 0; k < level.size(); ++k)
            levels[l][(first_y + k / cells) * of_all + first_x + k % cells] = packed(level[k]);
    }
}

} // namespace ghost::render
