#pragma once
// SPDX-License-Identifier: Apache-2.0
// A zip file to read, of which the name may be taken by another one while it is open.

#include <filesystem>

#include <zip.h>

namespace ghost::fixture {

// Null: code says why not, as zip_open() does.
zip_t* open_zip(const std::filesystem::path& path, int& code);

} // namespace ghost::fixture
