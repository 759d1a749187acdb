#pragma once
// SPDX-License-Identifier: Apache-2.0
// Marks: moments of a recording that somebody wrote down, in an audio editor or a spreadsheet: CSV (RFC 4180)
// with time, number, name and note, of which the last three may be missing, parted by what parts the first
// line: ';' or a tab, with which decimals may have a comma, else ','. A time is seconds, H:MM:SS.s, or time
// code with frames. What is no mark goes to the report with its line; the others are kept. Pure.

#include "base/report.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

inline constexpr std::size_t kMostMarksBytes = std::size_t{8} << 20;

struct Mark {
    double at_s = 0; // of the recording
    std::string number, name, note;
};

// frames_per_s: of time code; 0: nobody says it, and a time with frames is refused.
std::vector<Mark> read_marks(std::string_view csv, const std::string& file, double frames_per_s,
                             Report& report);

} // namespace ghost::scene
