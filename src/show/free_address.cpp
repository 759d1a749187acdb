// SPDX-License-Identifier: Apache-2.0
#include "show/free_address.h"

#include "dmx/wire/universes.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace ghost::fixture {
namespace {

constexpr int kChannels = static_cast<int>(dmx::kSlots);

} // namespace

int footprint_of(const Type& type, int mode) {
    const std::vector<int>& footprint = type.modes[static_cast<std::size_t>(mode)].footprint;
    return footprint.empty() ? 1 : std::max(1, footprint.front());
}

std::optional<Address> find_free_address(std::span<const Patch> patches, int footprint, Address from) {
    std::set<std::pair<int, int>> taken; // absolute channel: first and behind the last
    for (const Patch& patch : patches) {
        const std::vector<int>& sizes = patch.mode_of().footprint;
        for (std::size_t k = 0; k < patch.addresses.size() && k < sizes.size(); ++k) {
            const Address& address = patch.addresses[k];
            if (address.channel <= 0 || sizes[k] <= 0) continue;
            const int first = (address.universe - 1) * kChannels + address.channel;
            taken.insert({first, first + sizes[k]});
        }
    }
    const int wanted = std::clamp(footprint, 1, kChannels);
    int first = (from.universe - 1) * kChannels + std::max(from.channel, 1);
    const auto keep_in_universe = [&] {
        if ((first - 1) % kChannels + wanted > kChannels)
            first = ((first - 1) / kChannels + 1) * kChannels + 1;
    };
    keep_in_universe();
    for (const auto& [begin, end] : taken) {
        if (end <= first) continue;
        if (begin >= first + wanted) break; // those that follow begin later
        first = end;
        keep_in_universe();
    }
    const int universe = (first - 1) / kChannels + 1;
    if (universe > dmx::kMaxUniverse) return std::nullopt;
    return Address{universe, (first - 1) % kChannels + 1};
}

Address next_address(Address from, int footprint, int footprint_of_next) {
    Address next{from.universe, from.channel + footprint};
    while (next.channel > kChannels) {
        next.channel -= kChannels;
        ++next.universe;
    }
    if (next.channel + footprint_of_next - 1 > kChannels) next = {next.universe + 1, 1};
    return next;
}

} // namespace ghost::fixture
