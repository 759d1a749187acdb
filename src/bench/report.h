#pragma once
// SPDX-License-Identifier: Apache-2.0
// The report of a machine's graphics: the tables of a device, its limits, the pictures that it draws, how
// near these are to what was drawn elsewhere, and what the Khronos validation layer has to say. A table that
// fails is in the report with its reason. Main thread.

#include "bench/bench.h"

#include <filesystem>

namespace ghost::app {

struct ReportOptions {
    BenchOptions bench;
    std::filesystem::path out;       // a folder; report.html, report.json and pictures come into it
    std::vector<std::string> tables; // by name; empty: all
    bool quick = false;              // without the longest ones, and with fewer frames
};

// Error: there is no device, or the folder cannot be written.
Result<void> write_report(const ReportOptions& options);

} // namespace ghost::app
