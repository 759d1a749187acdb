#pragma once
// SPDX-License-Identifier: Apache-2.0
// Options that several commands have, for what stands below them. What they fill must outlive the command.
// Main thread.

#include "cli/options/input_options.h"
#include "farm/farm.h"
#include "link/rdm.h"
#include "live/engine/live_controls.h"
#include "live/inputs/timecode_input.h"

#include <CLI/CLI.hpp>
#include <string>

namespace ghost::app {

// Adds --timecode, and --midi, --ltc and --freewheel, which need it. options and midi must outlive command.
CLI::Option* add_timecode_options(CLI::App& command, TimeCodeOptions& options, std::string& midi);
// Adds --ltc. name must outlive command.
CLI::Option* add_ltc_option(CLI::App& command, std::string& name);
// RDM is asked for, and nobody will find us (--no-poll-reply): logs it.
void warn_of_silent_rdm(bool answers_rdm, const InputOptions& input);
// Adds --rdm. access must outlive command.
void add_rdm_option(CLI::App& command, ui::RdmAccess& access);
// Adds --osc and --psn. options must outlive command.
void add_live_control_options(CLI::App& command, LiveControlOptions& options);
// --farm, --farm-options and --farm-jobs.
void add_farm_options(CLI::App& command, FarmOptions& options);

} // namespace ghost::app
