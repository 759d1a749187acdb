#pragma once
// SPDX-License-Identifier: Apache-2.0
// --size of the commands that draw: WIDTHxHEIGHT in pixels. Main thread.

#include "base/result.h"

#include <glm/glm.hpp>
#include <string>

namespace ghost::app {

// Error: another form, or a side below least or above most.
Result<glm::ivec2> size_from(const std::string& text, const glm::ivec2& least, int most);

} // namespace ghost::app
