#pragma once
// SPDX-License-Identifier: Apache-2.0
// What rooms without Qt say to people, in patterns: "%1" to "%9" are what they fill in. Constant, any thread.

#include <span>

namespace ghost::ui {

std::span<const char* const> sentence_list();
// What these are made of and what is known inside of them only: "channel %1", "%1 and channel %2".
std::span<const char* const> part_list();

} // namespace ghost::ui
