#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rows of `bench window` without a desk: the show, a festival of 400 and, where one is named, a plot. Main
// thread; errors: as run_loaded_window.

#include "bench/bench.h"

namespace ghost::app {

Result<void> window_opening(const BenchOptions& options, const BenchSink& sink);

} // namespace ghost::app
