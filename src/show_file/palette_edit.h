#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the palettes in show.toml, as those of show_edit.h: all but the edited keys and blocks stays byte
// for byte. palettes: those of the show that is read from the text. Pure; any thread.

#include "base/result.h"
#include "show/palettes.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::scene {

// Behind the last [[palette]].
Result<std::string> add_palette(const std::string& text, const Palette& palette);
// Other values under the same name; where they stood, without the comments among them.
Result<std::string> replace_palette(const std::string& text, const std::vector<Palette>& palettes,
                                    std::size_t index, const Palette& palette);
Result<std::string> rename_palette(const std::string& text, const std::vector<Palette>& palettes,
                                   std::size_t index, const std::string& name);
Result<std::string> remove_palette(const std::string& text, const std::vector<Palette>& palettes,
                                   std::size_t index);

} // namespace ghost::scene
