#pragma once
// SPDX-License-Identifier: Apache-2.0
// Leftovers: temporary files (temporary_beside in disk/files.h) of programs that were killed before they
// could remove them. Any thread.

#include <cstddef>
#include <filesystem>

namespace ghost {

enum class Below { left_alone, included }; // folders in the folder

// Removes those that no process of this machine writes and that rested for a minute; those of another
// machine, which may write there, too, and whose clock may be off by hours, after a day. The folder is
// reached from home without following a link (own_folder.h). Returns how many; what cannot be read or removed
// stays.
std::size_t remove_leftovers(const std::filesystem::path& folder, const std::filesystem::path& home,
                             Below below);

} // namespace ghost
