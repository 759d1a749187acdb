#pragma once
// SPDX-License-Identifier: Apache-2.0
// Which files `check` looks at: those named, and what folders hold that are no shows themselves. Sorted by
// name, each once. Links to folders and hidden folders are not followed.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ghost::app {

inline constexpr std::size_t kMaxCheckedFiles = 20'000;
inline constexpr std::size_t kMaxSearchedEntries = 500'000;
inline constexpr int kMaxSearchDepth = 32;

struct FileSearch {
    std::vector<std::string> files;  // as the user wrote them, or folder/name
    std::vector<std::string> limits; // what was not searched, as sentences
    std::size_t other_json = 0;      // .json files that are no fixtures
    bool is_search = false;          // a folder was searched
};

FileSearch find_files(const std::vector<std::string>& arguments);

// Fixture files of one folder, and of those in it down to depth (0: of none), by name.
std::vector<std::filesystem::path> fixture_files(const std::filesystem::path& folder, std::size_t limit,
                                                 int depth);

// Of what comes with the program, "fixtures" or "demo", where it can be found; empty: nowhere.
std::filesystem::path own_folder(const std::string& name);

} // namespace ghost::app
