// SPDX-License-Identifier: Apache-2.0
#include "show/names.h"

namespace ghost::scene {

bool is_good_name(std::string_view name) {
    return !name.empty() && name.size() <= kMostNameBytes && name.front() != '.' &&
           name.find_first_of("/\\:*?\"<>|") == std::string_view::npos;
}

} // namespace ghost::scene
