// SPDX-License-Identifier: Apache-2.0
#include "stage/private/mtl.h"

#include <algorithm>
#include <string_view>

namespace ghost::scene {

std::vector<std::uint8_t> mtl_for_assimp(Bytes mtl) {
    constexpr std::string_view kLineEnds("\n\r\f\0", 4); // Assimp's
    std::string_view left(reinterpret_cast<const char*>(mtl.data()), mtl.size());
    std::vector<std::uint8_t> fit;
    bool has_material = false;
    while (!left.empty()) {
        std::string_view line = left.substr(0, left.find_first_of(kLineEnds));
        left.remove_prefix(std::min(line.size() + 1, left.size()));
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        has_material = has_material || line.starts_with("newmtl");
        if (has_material && !line.starts_with("a")) fit.insert(fit.end(), line.begin(), line.end());
        fit.push_back('\n');
    }
    return fit;
}

} // namespace ghost::scene
