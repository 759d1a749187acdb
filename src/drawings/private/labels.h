#pragma once
// SPDX-License-Identifier: Apache-2.0
// Labels: finds a place for words beside what they name, so that they cover neither each other nor what is
// drawn: first next to it, then farther away with a line that leads back. Points. One thread.

#include "drawings/private/view.h"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace ghost::scene {

struct PlacedLabel {
    Extent2 box;
    bool is_led = false; // so far away that a line must lead to it
};

class Labels {
public:
    // within: where words may be.
    explicit Labels(const Extent2& within) : within_(within) {}

    void keep_free(const Extent2& box) { add(box); }
    // size: of the words; around: what they name. Nothing: there is no room.
    std::optional<PlacedLabel> place(const glm::dvec2& size, const Extent2& around);

private:
    void add(const Extent2& box);
    bool is_free(const Extent2& box) const;

    Extent2 within_;
    std::vector<Extent2> taken_;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> cells_; // of taken_
};

} // namespace ghost::scene
