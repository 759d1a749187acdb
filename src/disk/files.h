#pragma once
// SPDX-License-Identifier: Apache-2.0
// Whole files in and out. Reading has a limit, writing is atomic: a temporary file beside the target, fsync,
// rename; a full disk or a kill leaves the old file. Any thread.

#include "base/byte_reader.h"
#include "base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ghost {

// Error where the file is missing, not a plain file, unreadable, or larger than limit_bytes.
Result<std::vector<std::uint8_t>> read_file(const std::filesystem::path& path, std::uintmax_t limit_bytes);
Result<std::string> read_text_file(const std::filesystem::path& path, std::uintmax_t limit_bytes);

Result<void> write_file_atomic(const std::filesystem::path& path, Bytes bytes);
Result<void> write_file_atomic(const std::filesystem::path& path, std::string_view text);

// Makes a folder and those above it, but never `home`, which is to be there: who renames a show's folder does
// not find another one in its place.
Result<void> make_folders(const std::filesystem::path& folder, const std::filesystem::path& home);

// For writers that want a file name: write to the returned path (same folder), then commit_temporary.
std::filesystem::path temporary_beside(const std::filesystem::path& path);
Result<void> commit_temporary(const std::filesystem::path& temporary, const std::filesystem::path& path);

// A temporary file that another process, or this one, is still writing. Those of processes that are gone are
// leftovers.
bool is_temporary_in_use(const std::filesystem::path& path);

} // namespace ghost
