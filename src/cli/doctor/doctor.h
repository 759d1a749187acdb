#pragma once
// SPDX-License-Identifier: Apache-2.0
// The import doctor as a run over files: many at once, on all cores, in the order of their names whatever
// thread was first. Nothing is written.

#include "diagnose/doctor.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ghost::app {

struct Checked {
    std::string file;
    std::vector<scene::Finding> findings;
    std::string summary; // one line of what is in the file; empty where it could not be opened
    nlohmann::json facts = nlohmann::json::object();
    std::string title;    // of a fixture: maker and name
    bool is_done = false; // false: interrupted before it

    std::size_t count(Severity severity) const;
};

struct DoctorOptions {
    std::size_t threads = 0;                            // 0: one per core
    std::vector<std::filesystem::path> fixture_folders; // more files that may stand in for missing ones
    std::filesystem::path replay; // what movers run through instead of their show's recording; or empty
    // share 0..1 and the file that was finished last; called from the calling thread.
    std::function<void(double share, const std::string& file)> progress;
    std::function<bool()> stop; // asked often; true: what is finished comes back
};

// One entry per file, in the same order.
std::vector<Checked> check_files(const std::vector<std::string>& files, const DoctorOptions& options);

} // namespace ghost::app
