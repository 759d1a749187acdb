// SPDX-License-Identifier: Apache-2.0
#include "drawings/private/labels.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace ghost::scene {
namespace {

constexpr double kCell_pt = 20;
constexpr double kGap_pt = 1.2; // between words and what they name
constexpr double kStep_pt = 7;  // farther away
constexpr int kMostSteps = 12;
constexpr int kWays = 16;
constexpr std::int64_t kMostCells = 4000; // across: of a sheet of 10 m

std::int64_t cell_of(double value) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(value / kCell_pt)), -kMostCells,
                                    kMostCells);
}

void for_cells(const Extent2& box, const auto& use) {
    for (std::int64_t y = cell_of(box.low.y); y <= cell_of(box.high.y); ++y)
        for (std::int64_t x = cell_of(box.low.x); x <= cell_of(box.high.x); ++x)
            if (!use(y * (2 * kMostCells + 1) + x)) return;
}

} // namespace

void Labels::add(const Extent2& box) {
    for_cells(box, [&](std::int64_t cell) {
        cells_[cell].push_back(taken_.size());
        return true;
    });
    taken_.push_back(box);
}

bool Labels::is_free(const Extent2& box) const {
    if (!within_.holds(box)) return false;
    bool has_room = true;
    for_cells(box, [&](std::int64_t cell) {
        if (const auto found = cells_.find(cell); found != cells_.end())
            for (const std::size_t index : found->second) has_room = has_room && !taken_[index].touches(box);
        return has_room;
    });
    return has_room;
}

std::optional<PlacedLabel> Labels::place(const glm::dvec2& size, const Extent2& around) {
    const glm::dvec2 middle = around.middle(), reach = 0.5 * (around.size() + size) + kGap_pt;
    const auto try_at = [&](const glm::dvec2& at, bool is_led) -> std::optional<PlacedLabel> {
        PlacedLabel label{{at - 0.5 * size, at + 0.5 * size}, is_led};
        if (!is_free(label.box)) return std::nullopt;
        add(label.box);
        return label;
    };
    for (const glm::dvec2& side : {glm::dvec2(0, 1), glm::dvec2(0, -1), glm::dvec2(1, 0), glm::dvec2(-1, 0)})
        if (const auto label = try_at(middle + side * reach, false)) return label;
    for (int step = 1; step <= kMostSteps; ++step)
        for (int way = 0; way < kWays; ++way) {
            const double angle = 2 * glm::pi<double>() * (way + 0.5) / kWays;
            const glm::dvec2 out(std::cos(angle), std::sin(angle));
            const double most = std::max(std::abs(out.x), std::abs(out.y));
            const glm::dvec2 at = middle + out / most * (reach + step * kStep_pt);
            if (const auto label = try_at(at, true)) return label;
        }
    return std::nullopt;
}

} // namespace ghost::scene
