#pragma once
// SPDX-License-Identifier: Apache-2.0
// load_ofl: reads a fixture of the Open Fixture Library (JSON, schema 12) into a Type. It has no geometry:
// bodies are invented, and words like "slow" estimated (docs/reference/fixture-formats.md). What cannot be
// kept is listed as a Message, with file and JSON pointer; an Error only where nothing can be kept. Hard
// limits on size, depth and counts: ofl.cpp. Any thread.

#include "base/byte_reader.h"
#include "base/result.h"
#include "fixture_files/common/loaded_type.h"

#include <filesystem>
#include <string>

namespace ghost::fixture {

// The maker, which stands in no field of the library's own files, is the folder's name.
Result<LoadedType> load_ofl(const std::filesystem::path& path);
// folder: where the file lies; gobo pictures are looked for there. Empty: no pictures are read.
Result<LoadedType> load_ofl(Bytes bytes, const std::string& name, const std::filesystem::path& folder = {});

} // namespace ghost::fixture
