#pragma once
// SPDX-License-Identifier: Apache-2.0
// [[change]] of show.toml: what the user changes about objects of a plot, by UUID, without touching the
// plot's file, so that it outlives the designer's next version. Places are world metres and degrees as
// everywhere in show.toml. Pure; what cannot be done goes to the report with file and line.

#include "base/report.h"
#include "mvr/mvr_merge.h"
#include "show/plot_entries.h"

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show; // show/show.h

// For this plot. An entry whose object the plot does not have (or no longer has) becomes changes all the
// same, which merge_plots reports; apply_changes says so.
std::vector<PlotChange> plot_changes(const Plot& plot, const std::vector<ChangeEntry>& entries,
                                     const glm::dvec3& origin_m);

// What feeds the fixtures of the plot; plots say nothing of it.
void apply_circuits(Show& show, const std::vector<ChangeEntry>& entries);

// One by one, in their order: a child is placed in the frame of a parent that has been moved already. They
// come back as they were applied.
std::vector<PlotChange> apply_changes(Plot& plot, const std::vector<ChangeEntry>& entries,
                                      const glm::dvec3& origin_m, Report& report);

} // namespace ghost::scene
