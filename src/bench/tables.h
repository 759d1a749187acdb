#pragma once
// SPDX-License-Identifier: Apache-2.0
// The tables by name, for the programs that measure them. Main thread.

#include "bench/bench.h"

#include <span>

namespace ghost::app {

struct BenchTable {
    const char* name;
    const char* title;
    Result<void> (*run)(const BenchOptions&, const BenchSink&);
};

// All that need neither the window nor the program itself.
std::span<const BenchTable> tables();

// What a device throws (gpu/device_failures.h) is an error, too: the next table has another one.
Result<void> run_table(Result<void> (*run)(const BenchOptions&, const BenchSink&),
                       const BenchOptions& options, const BenchSink& sink);

// On standard output, as a line of JSON or of words.
void print_row(const BenchRow& row, bool json);

} // namespace ghost::app
