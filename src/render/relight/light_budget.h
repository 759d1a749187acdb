#pragma once
// SPDX-License-Identifier: Apache-2.0
// LightBudget: where more lights turn at once than can be drawn in the time of a picture, each picture brings
// a part of them up to date, so that it is never late and no light is older than kOldest pictures. Parts are
// whole branches of the light tree (render/relight/light_tree.h), so that the others are a few kept images.
// Those that wait longest come first, of these those whose light changes most; a branch that goes dark waits
// for no turn, for what is dark takes no time. Pure.

#include "render/relight/light_tree.h"
#include "shared/types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ghost::render {

class LightBudget {
public:
    static constexpr int kOldest = 4; // pictures

    // Which lights to show of those that are wanted, as many as in the last call. most: of those that may
    // differ in more than their intensity from the last picture; 0: all.
    const std::vector<shared::Light>& choose(const std::vector<shared::Light>& wanted, int most);
    // Of the last choice: some lights are shown as they were.
    bool is_short() const { return is_short_; }

private:
    static constexpr auto kBranches = static_cast<std::size_t>(LightTree::kBranches);

    std::vector<shared::Light> shown_;
    std::array<int, kBranches> ages_{}; // pictures that a branch has waited
    int room_ = 0;                      // lights that the last picture had too many; 0 or less
    bool is_short_ = false;
};

} // namespace ghost::render
