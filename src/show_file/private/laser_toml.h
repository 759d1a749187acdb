#pragma once
// SPDX-License-Identifier: Apache-2.0
// Reads the keys `laser` of a [[fixture]] (docs/reference/show-file.md). What is wrong goes to the report.
// Pure.

#include "base/report.h"
#include "light/laser_rays.h"

#include <string>
#include <toml++/toml.h>

namespace ghost::scene {

// table: laser = { .. } of a fixture.
Laser read_laser(const toml::table& table, const std::string& section, const std::string& file,
                 Report& report);

} // namespace ghost::scene
