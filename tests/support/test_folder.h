#pragma once
// SPDX-License-Identifier: Apache-2.0
// A folder of its own for a test, which goes with it.
#include <filesystem>
#include <stdlib.h>
#include <string>

namespace ghost {

struct TestFolder {
    std::filesystem::path path;
    TestFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "ghost_test_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~TestFolder() {
        std::error_code code;
        std::filesystem::remove_all(path, code);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
};

} // namespace ghost
