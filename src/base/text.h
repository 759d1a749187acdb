#pragma once
// SPDX-License-Identifier: Apache-2.0
// Text that programs read: letters of ASCII, whatever the locale; names and patterns of names. Pure.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ghost {

std::string lower(std::string_view text);
std::string_view trimmed(std::string_view text);
std::vector<std::string_view> split(std::string_view text, char separator);

// Letter by letter and all of the name; ? stands for one UTF-8 letter, * for any number of them.
bool matches(std::string_view pattern, std::string_view name);
// The same, where pattern and name come from files, which can make it the product of both their lengths:
// takes what it compared off steps. Where these are used up nothing matches any more.
bool matches(std::string_view pattern, std::string_view name, std::uint64_t& steps);

// "a, b, c and 7 more"
std::string name_list(const std::vector<std::string>& names);

} // namespace ghost
