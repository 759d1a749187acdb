#pragma once
// SPDX-License-Identifier: Apache-2.0
// The tables that need the window, which most machines that are measured have not (bench/tables.h). Main
// thread.

#include "bench/bench.h"

namespace ghost::app {

// The window with a desk at 44 Hz: packet to window, and what the window itself costs.
Result<void> bench_window(const BenchOptions& options, const BenchSink& sink);
// What browsers that look on cost the engine, and how old their pictures are.
Result<void> bench_web(const BenchOptions& options, const BenchSink& sink);
// The window open for so long instead, with a person at work, one row a minute. Error: memory grew, or no
// packet was seen.
Result<void> window_soak(const BenchOptions& options, const BenchSink& sink);

} // namespace ghost::app
