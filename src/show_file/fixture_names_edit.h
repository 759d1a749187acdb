#pragma once
// SPDX-License-Identifier: Apache-2.0
// What refers to fixtures, or cameras, by their names in show.toml, after they got others: trackers, movers
// with what they carry and what drives them, palettes. As show_edit.h: all else stays byte for byte. Pure,
// any thread.

#include "base/result.h"
#include "show/same_fixtures.h"

#include <set>
#include <string>

namespace ghost::scene {

// all: the names of the show's fixtures as they are now. A pattern stays, the new name stands beside it where
// it does not fit, and one that fits nothing any more goes. Error: it is written in a way that cannot be
// edited.
Result<std::string> rename_in_references(const std::string& text, const FixtureNames& renamed,
                                         const std::set<std::string>& all);
// The same of cameras: cues and trackers that name one, movers that carry one.
Result<std::string> rename_camera_in_references(const std::string& text, const FixtureNames& renamed,
                                                const std::set<std::string>& all);

} // namespace ghost::scene
