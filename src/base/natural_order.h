#pragma once
// SPDX-License-Identifier: Apache-2.0
// The order that people count in: "Spot 2" before "Spot 10". Letters go by their bytes. Pure, any thread.

#include <string_view>

namespace ghost {

bool natural_less(std::string_view a, std::string_view b);

} // namespace ghost
