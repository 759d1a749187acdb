#pragma once
// SPDX-License-Identifier: Apache-2.0
// Checks of options that are fractions. CLI::Range lets "nan" through, as no comparison with it holds.

#include <CLI/CLI.hpp>

namespace ghost::app {

// A finite number of low..high.
CLI::Validator number_in(double low, double high);

inline constexpr double kLongest_s = 1e9;

} // namespace ghost::app
