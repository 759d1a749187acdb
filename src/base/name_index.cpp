// SPDX-License-Identifier: Apache-2.0
#include "base/name_index.h"

#include "base/text.h"

#include <algorithm>

namespace ghost {
namespace {

constexpr std::uint64_t kStepsOfFound = 16; // who finds everything with each pattern has to go through it

} // namespace

std::vector<std::size_t> NameIndex::find(std::string_view pattern, std::uint64_t& steps) const {
    std::vector<std::size_t> found;
    if (steps == 0) return found;
    if (pattern.find_first_of("*?") == std::string_view::npos) {
        if (const auto same = things_.find(pattern); same != things_.end()) found = same->second;
    } else {
        for (const auto& [name, things] : things_)
            if (matches(pattern, name, steps)) found.insert(found.end(), things.begin(), things.end());
    }
    std::sort(found.begin(), found.end());
    steps -= std::min<std::uint64_t>(steps, kStepsOfFound * found.size());
    return steps > 0 ? found : std::vector<std::size_t>{};
}

} // namespace ghost
