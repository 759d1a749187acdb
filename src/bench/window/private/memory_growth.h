#pragma once
// SPDX-License-Identifier: Apache-2.0
// How much memory grew over an hour of the window. Most of what it has are its stage and pictures, which come
// and go with what is looked at and with the load of the machine: rows are compared with those of before that
// had as much on the device. Pure; megabytes.

#include <cstddef>
#include <optional>
#include <span>

namespace ghost::app {

struct MemoryRow {
    double process_mb = 0; // all of it
    double device_mb = 0;  // of that, stage and pictures
};

// From the first half of the rows after `warm` to the second one: the median over the rows of the second that
// have a like one in the first. Nothing: too few have.
std::optional<double> memory_growth_mb(std::span<const MemoryRow> rows, std::size_t warm);

} // namespace ghost::app
