#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the C++ library cannot ask of an open file. Any thread.

#include <cstdio>
#include <filesystem>

namespace ghost {

// As std::fopen(), which knows no names of Windows outside of its code page.
std::FILE* open_stream(const std::filesystem::path& path, const char* mode);

// What was written reaches the disk itself, so that a loss of power keeps it; takes as long as a disk does.
// The file's buffer must be flushed (std::fflush). False: the disk says no.
bool sync_to_disk(std::FILE* file);

// Ours until it is closed, among programs that ask. False: another program has it. Never waits.
bool lock_file(std::FILE* file);

} // namespace ghost
