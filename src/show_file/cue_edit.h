#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the cue list in show.toml: its [[cue]] entries. As in show_edit.h: each function gives the whole
// new text, of which the rest stays byte for byte. Error, of all of them: no TOML, no such cue, or an entry
// that could not be read, so that which is which is not known. Pure, any thread.

#include "base/result.h"
#include "show/cues.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ghost::scene {

// cues: those of the show that was read from the text; index: of them. All keys of the cue are written, those
// that say what is usual go.
Result<std::string> edit_cue(const std::string& text, const std::vector<Cue>& cues, std::size_t index,
                             const Cue& cue);
// Behind the last one.
Result<std::string> add_cue(const std::string& text, const Cue& cue);
Result<std::string> remove_cue(const std::string& text, const std::vector<Cue>& cues, std::size_t index);
// It and the one before it change their places; comments inside of them go along.
Result<std::string> move_cue_up(const std::string& text, const std::vector<Cue>& cues, std::size_t index);

} // namespace ghost::scene
