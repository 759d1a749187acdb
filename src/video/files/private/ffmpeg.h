#pragma once
// SPDX-License-Identifier: Apache-2.0
// What all that is read or written by FFmpeg shares: its words as an error that names the file, and files
// opened as files only, so that a playlist cannot name an address. Any thread.

#include "base/result.h"

#include <filesystem>
#include <string>

struct AVFormatContext;

namespace ghost::video {

Error ffmpeg_error(const std::string& action, int code, const std::filesystem::path& path);

// expected: "a film". Error: not a plain file, or nothing that this FFmpeg reads; file is null then.
Result<void> open_plain_file(const std::filesystem::path& path, const std::string& expected,
                             AVFormatContext*& file);

} // namespace ghost::video
