// SPDX-License-Identifier: Apache-2.0
#include "dmx/record/activity.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace ghost::dmx {
namespace {

// Looks between two ends of a part: what goes up and down again counts, too.
constexpr int kLooks = 8;

std::uint64_t change(const Universes& before, const Universes& after) {
    std::uint64_t sum = 0;
    for (const Universe& now : after.list) {
        const auto then = std::find_if(before.list.begin(), before.list.end(),
                                       [&](const Universe& one) { return one.number == now.number; });
        if (then != before.list.end() && then->levels == now.levels) continue;
        for (std::size_t i = 0; i < now.levels->size(); ++i) {
            const int was = then == before.list.end() ? 0 : (*then->levels)[i];
            sum += static_cast<std::uint64_t>(std::abs((*now.levels)[i] - was));
        }
    }
    return sum;
}

} // namespace

std::vector<float> activity_of(Player& player, std::size_t parts, const std::function<bool()>& stop) {
    std::vector<std::uint64_t> sums(parts);
    const double part_s = player.duration_s() / static_cast<double>(std::max<std::size_t>(parts, 1));
    Universes before = player.at(0);
    for (std::size_t i = 0; i < parts; ++i) {
        if (stop && stop()) return {};
        for (int look = 1; look <= kLooks; ++look) {
            Universes after =
                player.at(part_s * (static_cast<double>(i) + static_cast<double>(look) / kLooks));
            sums[i] += change(before, after);
            before = std::move(after);
        }
    }
    const std::uint64_t most = parts > 0 ? *std::max_element(sums.begin(), sums.end()) : 0;
    std::vector<float> activity(parts);
    for (std::size_t i = 0; i < parts && most > 0; ++i)
        activity[i] = static_cast<float>(sums[i]) / static_cast<float>(most);
    return activity;
}

} // namespace ghost::dmx
