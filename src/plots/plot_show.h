#pragma once
// SPDX-License-Identifier: Apache-2.0
// Turns a plot into a show: fixtures by GDTF and mode, with all their addresses, where the plot hangs them.
// A fixture in identity hangs as its GDTF draws it (Z up, light down), in MVR as in show.toml, so places are
// taken over as they are. What cannot be is in the report, once, with how many fixtures it concerns.

#include "base/report.h"
#include "base/result.h"
#include "mvr/mvr_load.h"
#include "plots/plot_stage.h"
#include "plots/plot_types.h"
#include "show/loading.h"
#include "show/show.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ghost::scene {

// The plot of a file, its messages in the report. Error: as load_mvr, or stopped.
Result<std::shared_ptr<LoadedPlot>> load_plot(const std::filesystem::path& file, Report& report,
                                              const ShowLoading& loading);

// Adds what shines to show.fixtures: fixtures, and devices of other kinds (screens, projectors, hoists) that
// have a GDTF file and no geometry of their own. show.plot must be there. Files that the archive lacks are
// looked for beside the plot. Screens with a geometry become LED walls, like the last of walls that names
// them. Names are made unique against those that are in show.fixtures already. Error: stopped.
Result<void> add_plot_fixtures(Show& show, const std::vector<bool>& shown,
                               const std::vector<SubstituteEntry>& substitutes,
                               const std::vector<WallSettings>& walls, Report& report,
                               const ShowLoading& loading);

// The same where the show was open before: plot is show.plot's as an edit changes it, before are the fixtures
// that it had. Of files only new substitutes are read: types, pictures and measured light are those of
// before; a fixture of another type that none of them has is dark, and a screen that was hidden is left out.
void add_known_fixtures(Show& show, const Plot& plot, const std::vector<bool>& shown,
                        const std::vector<SubstituteEntry>& substitutes,
                        const std::vector<WallSettings>& walls, const std::vector<PatchedFixture>& before);

// A matrix as a turn, by what rotation_deg of show.toml means.
struct Placement {
    glm::vec3 position_m{0};
    glm::vec3 rotation_deg{0};
    bool mirrored = false;  // what the matrix mirrors is drawn unmirrored
    bool scaled = false;    // by more than a hundredth, or skewed
    bool flattened = false; // how it is turned is made up
};
Placement placement_of(const glm::dmat4& world);

// "GeneralSceneDescription.xml:120" of the plot, for messages.
std::string place_of(const LoadedPlot& loaded, const PlotObject& object);

} // namespace ghost::scene
