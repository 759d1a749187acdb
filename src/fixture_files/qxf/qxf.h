#pragma once
// SPDX-License-Identifier: Apache-2.0
// load_qxf: reads a fixture definition of QLC+ 4 and 5 (.qxf) into a Type. It has no geometry and few
// physical values: bodies are invented, rates estimated (docs/reference/fixture-formats.md). What cannot be
// kept is listed as a Message, with file and line; an Error only where nothing can be kept. Hard limits on
// sizes: qxf.cpp. Any thread. Follows the presets of QLC+ 4.12 to 4.14.

#include "base/byte_reader.h"
#include "base/result.h"
#include "fixture_files/common/loaded_type.h"

#include <filesystem>
#include <string>

namespace ghost::fixture {

Result<LoadedType> load_qxf(const std::filesystem::path& path);
// folder: where the file lies; gobo pictures are looked for in and beside it. Empty: no pictures are read.
Result<LoadedType> load_qxf(Bytes bytes, const std::string& name, const std::filesystem::path& folder = {});

} // namespace ghost::fixture
