#pragma once
// SPDX-License-Identifier: Apache-2.0
// What ghostlight monitor says: who sends what, and what is wrong with it, as a table or as a line of JSON.
// Main thread.

#include "diagnose/patch_map.h"
#include "dmx/receive/receiver.h"
#include "live/inputs/ltc_input.h"

#include <optional>
#include <string>

namespace ghost::app {

struct MonitorReport {
    double unix_s = 0.0; // when these were the newest levels
    dmx::Universes universes;
    dmx::Statistics statistics;
    bool has_patch = false; // of a show
    scene::PatchMap patch;
    std::optional<LtcStatus> ltc; // where one was asked for
};

// levels: all 512 of each universe.
std::string monitor_json(const MonitorReport& report, bool levels);
void print_monitor_table(const MonitorReport& report);

} // namespace ghost::app
