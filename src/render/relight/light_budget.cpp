// SPDX-License-Identifier: Apache-2.0
#include "render/relight/light_budget.h"

#include "render/relight/light_tree.h"
#include "render/relight/light_units.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace ghost::render {
const std::vector<shared::Light>& LightBudget::choose(const std::vector<shared::Light>& wanted, int most) {
    is_short_ = false;
    if (most > 0 && shown_.size() == wanted.size()) {
        int turned = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) turned += same_shape(shown_[i], wanted[i]) ? 0 : 1;
        is_short_ = turned > most;
    }
    if (!is_short_) {
        shown_ = wanted;
        return shown_;
    }
    // More branches than parts: the last ones may have no lights.
    constexpr auto kBranches = static_cast<std::size_t>(LightTree::kBranches);
    static_assert(kBranches == 2 * kOldest);
    turn_ = (turn_ + 1) % kOldest;
    const std::size_t leaves = std::max(std::bit_ceil(wanted.size()), kBranches);
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (static_cast<int>(i * kBranches / leaves) % kOldest == turn_) shown_[i] = wanted[i];
    return shown_;
}

} // namespace ghost::render
