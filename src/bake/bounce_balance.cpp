// SPDX-License-Identifier: Apache-2.0
#include "bake/private/bounce_balance.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace ghost::bake {
namespace {

// Any haze would do: it says how much of a cell counts beside surfaces.
constexpr float kTypicalHaze_per_m = 0.02f;
constexpr float kLeastLink = 3e-4f; // of what both ends see in all: fainter links are left out
constexpr int kRounds = 20;
constexpr float kMostFactor = 4;

// Light that goes the other way.
std::uint32_t reversed(const scene::BounceLevel& level, std::uint32_t slot) {
    if (slot >= level.cells.size() * scene::kBounceBins) return slot;
    const std::size_t bin = slot % scene::kBounceBins;
    return static_cast<std::uint32_t>(slot - bin + scene::bounce_reversed(bin));
}

std::size_t node_of(const scene::BounceLevel& level, std::uint32_t slot) {
    const std::size_t in_cells = level.cells.size() * scene::kBounceBins;
    return slot < in_cells ? slot / scene::kBounceBins : level.cells.size() + (slot - in_cells);
}

} // namespace

void make_reciprocal(const scene::BounceLevel& level, std::vector<std::vector<FoundLink>>& rows) {
    const std::size_t in_cells = level.cells.size() * scene::kBounceBins;
    // From what a slot gets to lumens, where all that sends is as bright as all else.
    const auto lumens = [&](const FoundLink& link) {
        const float got = link.receiver < in_cells
                              ? kTypicalHaze_per_m * level.cells[link.receiver / scene::kBounceBins].volume_m3
                              : level.surfels[link.receiver - in_cells].area_m2;
        return got * (link.emitter < in_cells ? kTypicalHaze_per_m : 1.0f) *
               std::exp(-kTypicalHaze_per_m * link.distance_m);
    };
    std::vector<float> sees(level.slots(), 0);
    std::vector<std::vector<FoundLink>> both(rows.size());
    for (const auto& row : rows)
        for (const FoundLink& link : row) {
            const float fraction = link.weight * lumens(link);
            sees[link.receiver] += fraction;
            FoundLink one{link.receiver, link.emitter, 0.5f * fraction, link.distance_m};
            both[node_of(level, one.receiver)].push_back(one);
            std::swap(one.receiver, one.emitter);
            one.receiver = reversed(level, one.receiver);
            one.emitter = reversed(level, one.emitter);
            both[node_of(level, one.receiver)].push_back(one);
        }
    tbb::parallel_for(std::size_t{0}, both.size(), [&](std::size_t node) {
        std::vector<FoundLink>& links = both[node];
        std::stable_sort(links.begin(), links.end(), [](const FoundLink& a, const FoundLink& b) {
            return a.receiver != b.receiver ? a.receiver < b.receiver : a.emitter < b.emitter;
        });
        std::size_t kept = 0;
        for (std::size_t k = 0; k < links.size();) {
            FoundLink sum = links[k];
            float metres = sum.weight * sum.distance_m;
            for (++k;
                 k < links.size() && links[k].receiver == sum.receiver && links[k].emitter == sum.emitter;
                 ++k) {
                sum.weight += links[k].weight;
                metres += links[k].weight * links[k].distance_m;
            }
            sum.distance_m = sum.weight > 0 ? metres / sum.weight : 0;
            if (sum.weight > kLeastLink * std::min(sees[sum.receiver], sees[reversed(level, sum.emitter)]))
                links[kept++] = sum;
        }
        links.resize(kept);
    });
    // d K d has the sums that the nodes see (Sinkhorn, symmetric).
    std::vector<float> factor(level.slots(), 1), sums(level.slots());
    for (int round = 0; round < kRounds; ++round) {
        std::fill(sums.begin(), sums.end(), 0.0f);
        tbb::parallel_for(std::size_t{0}, both.size(), [&](std::size_t node) {
            for (const FoundLink& link : both[node])
                sums[link.receiver] += link.weight * factor[reversed(level, link.emitter)];
        });
        for (std::size_t slot = 0; slot < factor.size(); ++slot)
            if (sums[slot] > 0)
                factor[slot] = std::clamp(std::sqrt(factor[slot] * sees[slot] / sums[slot]), 1 / kMostFactor,
                                          kMostFactor);
    }
    tbb::parallel_for(std::size_t{0}, both.size(), [&](std::size_t node) {
        for (FoundLink& link : both[node])
            link.weight *= factor[link.receiver] * factor[reversed(level, link.emitter)] / lumens(link);
    });
    rows = std::move(both);
}

} // namespace ghost::bake
