#pragma once
// SPDX-License-Identifier: Apache-2.0
// What OpenEXR believes before it has seen it: how long the attributes of a file's header are. Any thread.

#include "base/result.h"

#include <filesystem>

namespace ghost::image {

// Error: an attribute says that it is longer than the file, for which OpenEXR would take that much memory (up
// to 2 GiB). All else that may be wrong is left to OpenEXR.
Result<void> check_exr_attributes(const std::filesystem::path& path);

} // namespace ghost::image
