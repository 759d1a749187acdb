#pragma once
// SPDX-License-Identifier: Apache-2.0
// What the doctor found, for people (text) and for programs (JSON). Pure.

#include "cli/doctor/doctor.h"

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace ghost::app {

enum class Detail {
    losses,  // errors only
    grouped, // equal faults as one
    all,     // every one
};

// Findings of one file, and its line "x.gdtf: ok, ...".
std::string text_of(const Checked& checked, Detail detail);

// Files, totals and the most frequent faults: at most 22 lines of 79 letters, unless is_long.
std::string summary_of(std::span<const Checked> all, bool is_long);

nlohmann::json json_of(const Checked& checked);

} // namespace ghost::app
