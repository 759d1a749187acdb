#pragma once
// SPDX-License-Identifier: Apache-2.0
// Names that lead elsewhere: symbolic links, and of Windows junctions and all other reparse points, of which
// the C++ library there knows nothing. Any thread.

#include <filesystem>
#include <system_error>

namespace ghost {

bool is_link(const std::filesystem::path& path);

// Where it really is, all links followed; a file may be missing. code: a folder is, or there is a loop.
std::filesystem::path behind_links(const std::filesystem::path& path, std::error_code& code);

// With all that is in it, of links the links. What cannot be removed stays.
void remove_whole(const std::filesystem::path& folder);

} // namespace ghost
