#pragma once
// SPDX-License-Identifier: Apache-2.0
// Folders of the user's own, outside of shows. Any thread.

#include <filesystem>

namespace ghost {

// Where things are kept for a show that lies in a read-only place:
// $XDG_CACHE_HOME/ghostlight/HASH (~/.cache where that is not set), HASH of the folder's path; the cache's
// own folder is made where it is missing, not what is below. Empty: .ghost is in the folder or can be made
// there, or this user has no cache either.
std::filesystem::path user_cache_for(const std::filesystem::path& folder);

// Of this program, for what it can make again: $XDG_CACHE_HOME/ghostlight. Not made here. Empty: there is
// none.
std::filesystem::path user_cache();

// What the program remembers of this user: $XDG_STATE_HOME/ghostlight (~/.local/state where that is not set).
// Not made here. Empty: there is none.
std::filesystem::path user_state();

} // namespace ghost
