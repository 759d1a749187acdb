#pragma once
// SPDX-License-Identifier: Apache-2.0
// load_gdtf: reads a .gdtf archive (zip with description.xml, wheels/*.png, models/) into a Type. What cannot
// be kept is listed as a Message, with its place; an Error only where nothing can be kept (no zip, no XML, no
// FixtureType). Hard limits on entries, sizes, pictures and depth: see gdtf.cpp. Any thread; files are read
// whole, nothing stays open.

#include "base/byte_reader.h"
#include "base/result.h"
#include "fixture_files/common/loaded_type.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ghost::fixture {

Result<LoadedType> load_gdtf(const std::filesystem::path& path);
Result<LoadedType> load_gdtf(Bytes bytes, const std::string& name); // name: for messages

} // namespace ghost::fixture
