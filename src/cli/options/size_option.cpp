// SPDX-License-Identifier: Apache-2.0
#include "cli/options/size_option.h"

#include <cstdio>

namespace ghost::app {

Result<glm::ivec2> size_from(const std::string& text, const glm::ivec2& least, int most) {
    glm::ivec2 size(0);
    char end = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &size.x, &size.y, &end) == 2 && size.x >= least.x &&
        size.y >= least.y && size.x <= most && size.y <= most)
        return size;
    return Error{"'" + text + "' is not WIDTHxHEIGHT between " + std::to_string(least.x) + "x" +
                     std::to_string(least.y) + " and " + std::to_string(most) + "x" + std::to_string(most),
                 "--size"};
}

} // namespace ghost::app
