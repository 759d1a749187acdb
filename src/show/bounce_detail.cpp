// SPDX-License-Identifier: Apache-2.0
#include "show/bounce_detail.h"

#include "base/suggest.h"

#include <algorithm>
#include <vector>

namespace ghost::scene {

std::optional<BounceDetail> find_bounce_detail(std::string_view name) {
    const auto* const found = std::find(std::begin(kBounceDetails), std::end(kBounceDetails), name);
    if (found == std::end(kBounceDetails)) return std::nullopt;
    return static_cast<BounceDetail>(found - std::begin(kBounceDetails));
}

std::string no_such_bounce_detail(std::string_view name) {
    const std::vector<std::string> names(std::begin(kBounceDetails), std::end(kBounceDetails));
    std::string listed;
    for (const std::string& one : names) listed += (listed.empty() ? " \"" : ", \"") + one + "\"";
    return "is '" + std::string(name.substr(0, 40)) + "', expected one of" + listed +
           did_you_mean(name, names);
}

} // namespace ghost::scene
