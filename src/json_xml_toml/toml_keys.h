#pragma once
// SPDX-License-Identifier: Apache-2.0
// What edits of show.toml are made of: keys with their new TOML text, written into the text and, to compare,
// into the values that it should then have. Pure, any thread.

#include "json_xml_toml/toml_text.h"

#include <glm/glm.hpp>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ghost::scene {

// What an edit writes: a key with its TOML text, or without: the key goes.
using Keys = std::vector<std::pair<std::string, std::optional<std::string>>>;

std::string toml_text(const glm::vec3& numbers);

Result<void> write(TomlText& document, const toml::table& table, const Keys& keys);
// The same in values, to compare with what the new text says.
void write(toml::table& table, const Keys& keys);

// A whole table: its header and the keys that have a text.
std::string block_of(const std::string& header, const Keys& keys, const std::string& line_end);
toml::array& array_of(toml::table& root, const std::string& name);

// The cut text. Error: it does not say what is expected, for it is written in a way that cannot be edited.
Result<std::string> checked(const TomlText& document, const toml::table& expected);

// The number-th [[name]], from 0. Error: there is none, or one of them is no table.
Result<const toml::table*> entry_of(const TomlText& document, const std::string& name, std::size_t number);
// Into the one table [name], which is made where there is none.
Result<std::string> set_in(const std::string& text, const std::string& name, const Keys& keys);
// One more [[name]], behind the last one.
Result<std::string> add_entry(const std::string& text, const std::string& name, const Keys& keys);
// Likewise, with tables below it: a block that begins with its header, lines that end with "\n".
Result<std::string> add_block(const std::string& text, const std::string& name, const std::string& block);
// Another block where the number-th one stands.
Result<std::string> replace_entry(const std::string& text, const std::string& name, std::size_t number,
                                  const std::string& block);
// Each with the blank line behind it.
Result<std::string> remove_entries(const std::string& text, const std::string& name,
                                   const std::set<std::size_t>& numbers);

} // namespace ghost::scene
