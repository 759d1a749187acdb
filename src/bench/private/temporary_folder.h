#pragma once
// SPDX-License-Identifier: Apache-2.0
// TemporaryFolder: a folder for a measurement, which goes with its owner. Main thread.

#include "base/result.h"

#include <filesystem>

namespace ghost::app {

struct TemporaryFolder {
    std::filesystem::path path;
    TemporaryFolder();
    ~TemporaryFolder();
    // Error: there is none.
    Result<void> made() const;
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

} // namespace ghost::app
