#pragma once
// SPDX-License-Identifier: Apache-2.0
// A folder of its own for a test, which goes with it.
#include <filesystem>
#include <random>
#include <string>

namespace ghost {

struct TestFolder {
    std::filesystem::path path;
    TestFolder() {
        do
            path = std::filesystem::temp_directory_path() /
                   ("ghost_test_" + std::to_string(std::random_device{}()));
        while (!std::filesystem::create_directory(path));
    }
    ~TestFolder() {
        std::error_code code;
        std::filesystem::remove_all(path, code);
    }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
};

} // namespace ghost
