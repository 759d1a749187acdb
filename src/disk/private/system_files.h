#pragma once
// SPDX-License-Identifier: Apache-2.0
// What whole files (disk/files.h), a person's files and their folders ask of the system. Any thread.

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>

namespace ghost {

// Fills bytes from the file's beginning; how many there were, fewer where it was cut short meanwhile.
Result<std::size_t> read_bytes(const std::filesystem::path& path, std::span<char> bytes);

// Renames within a folder where nothing has the new name. False: something has. Nothing: error says why not.
std::optional<bool> rename_to_new(const std::filesystem::path& from, const std::filesystem::path& to,
                                  std::string& error);

// The system's own way, which not every file system has. False: errno says why not. Linux and macOS.
bool rename_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to);

// The file and what was written to it are on the disk itself. fd: as the C library counts files.
bool flush_file(int fd);

// Of the user's; empty: there are none.
std::filesystem::path cache_of_user();
std::filesystem::path state_of_user();
bool may_write_in(const std::filesystem::path& folder);

} // namespace ghost
