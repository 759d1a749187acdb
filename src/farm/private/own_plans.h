#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whose files of a plan these are. A show may come from elsewhere with a plan in its .ghost, which names a
// command, where its film goes, and options of an engine. So what this user wrote of a plan is written down
// in a folder of their own (user_state() in disk/user_cache.h), whole, and what reads otherwise is not
// theirs. Any thread.

#include "base/result.h"

#include <filesystem>
#include <string>

namespace ghost::app {

// Error: the user has no such folder, or it cannot be written.
Result<void> note_as_ours(const std::filesystem::path& file, const std::string& text);
bool is_noted_as_ours(const std::filesystem::path& file, const std::string& text);

} // namespace ghost::app
