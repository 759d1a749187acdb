#pragma once
// SPDX-License-Identifier: Apache-2.0
// "did you mean": the nearest of the known names. Pure.

#include <span>
#include <string>
#include <string_view>

namespace ghost {

// ", did you mean 'x'?" for the candidate nearest to word (at most a third of its letters apart), else "".
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

} // namespace ghost
