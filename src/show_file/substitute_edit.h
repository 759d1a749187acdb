#pragma once
// SPDX-License-Identifier: Apache-2.0
// An edit of show.toml: another fixture file for one that the plot asks for ([[substitute]]). As in
// show_edit.h: the rest of the text stays byte for byte. Pure, any thread.

#include "base/result.h"

#include <string>

namespace ghost::scene {

// wanted: the file's name as the plot has it. mode empty: the one whose name is nearest. An entry that is for
// just that name gets the new file and mode; else there is one more. Error: no TOML, or written in a way that
// cannot be edited.
Result<std::string> set_substitute(const std::string& text, const std::string& wanted,
                                   const std::string& gdtf, const std::string& mode = "");

} // namespace ghost::scene
