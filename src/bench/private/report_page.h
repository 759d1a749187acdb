#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a report says, and the page that says it: one HTML file that asks for nothing from elsewhere but the
// pictures beside it. Values.

#include "bench/bench.h"

#include <string>
#include <utility>
#include <vector>

namespace ghost::app {

struct ReportTable {
    std::string name;
    std::string title;
    std::vector<BenchRow> rows;
    std::string error; // why it is not whole; empty: it is
};

struct ReportPage {
    std::string program;
    std::string time;
    std::vector<std::pair<std::string, std::string>> facts; // of the device
    std::vector<ReportTable> tables;
};

std::string html_of(const ReportPage& page);

} // namespace ghost::app
