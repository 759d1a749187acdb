#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a machine of a farm does: one task, or putting together what the tasks made. Main thread; any number
// of processes and machines at once.

#include "base/child.h"
#include "base/progress.h"
#include "farm/farm_plan.h"

namespace ghost::app {

inline constexpr std::uintmax_t kMostPictureBytes = std::uintmax_t{1} << 31; // of one file

// kMadeButMissing: on a farm it makes a whole as well.
bool said_made_but_missing(const ChildResult& child);

// Does nothing where the task is done. Whatever goes wrong is also kept in failed/.
Result<void> run_farm_task(const FarmPlan& plan, std::size_t task);

// The film of the pictures, or the manifest of the passes. Error: names what is missing.
Result<void> assemble_farm(const FarmPlan& plan);

// Error: this is another build, the show was edited since, or this machine does not see it.
Result<void> check_same(const FarmPlan& plan);

// The passes that a film was begun with were baked anew since: what is done of it is of no use.
bool passes_changed(const FarmPlan& plan);

// Where Slurm says how many processors a task has, the program in these words takes so many threads.
void take_farm_threads(std::vector<std::string>& words);

} // namespace ghost::app
