#pragma once
// SPDX-License-Identifier: Apache-2.0
// Fan: how two values are spread over heads, as desks do it. Pure.

#include "ui/model/app_model.h"

#include <array>
#include <cstddef>
#include <vector>

namespace ghost::ui {

enum class Fan {
    line,      // from the first head to the last
    symmetric, // one value at both ends, the other in the middle
    centre,    // the middle has the one; towards the ends it is less and more by the other
};
inline constexpr std::array<const char*, 3> kFans{"line", "symmetric", "centre"};

// Of the number-th of so many heads, from 0. A head alone has the first value; of an even number two are in
// the middle of symmetric, and none in that of centre.
float fanned(Fan fan, float a, float b, std::size_t number, std::size_t count);
glm::vec3 fanned(Fan fan, const glm::vec3& a, const glm::vec3& b, std::size_t number, std::size_t count);

enum class HeadOrder { selection, list, left_to_right }; // the last as the house sees them
inline constexpr std::array<const char*, 3> kHeadOrders{"selection", "list", "left-to-right"};
// The selected fixtures.
std::vector<std::size_t> heads_in(HeadOrder order, const AppModel& app);

} // namespace ghost::ui
