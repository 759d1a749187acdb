#pragma once
// SPDX-License-Identifier: Apache-2.0
// load_type: any fixture file that Ghostlight reads -> a Type: GDTF, QLC+ .qxf, Open Fixture Library .json.
// What the file holds decides, its name only helps where that is unclear. Messages and limits are those of
// the readers (gdtf.h, qxf.h, ofl.h). Any thread.

#include "base/byte_reader.h"
#include "base/result.h"
#include "fixture_files/common/loaded_type.h"

#include <array>
#include <filesystem>
#include <string_view>

namespace ghost::fixture {

// Of the names of fixture files: GDTF, QLC+, Open Fixture Library.
inline constexpr std::array<std::string_view, 3> kTypeEndings = {".gdtf", ".qxf", ".json"};

Result<LoadedType> load_type(const std::filesystem::path& path);

// Has the file the name of a fixture file? (one of kTypeEndings in any case)
bool has_type_extension(const std::filesystem::path& path);

} // namespace ghost::fixture
