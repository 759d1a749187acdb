#pragma once
// SPDX-License-Identifier: Apache-2.0
// LightBudget: where more lights turn at once than can be drawn in the time of a picture, each picture brings
// a part of them up to date, so that it is never late and no light is older than kOldest pictures. Parts are
// whole branches of the light tree (render/relight/light_tree.h), so that the others are a few kept images.
// Pure.

#include "shared/types.h"

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
    std::vector<shared::Light> shown_;
    bool is_short_ = false;
    int turn_ = 0;
};

} // namespace ghost::render
