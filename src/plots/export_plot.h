#pragma once
// SPDX-License-Identifier: Apache-2.0
// export_plot: the plot of a show as MVR, with what the show changes in it: addresses, modes, places, names
// ([[change]] of show.toml). All else of the plot is written as it was (mvr_write.h). What MVR or the plot
// has no place for (own fixtures of the show, substitutes, what is hidden) is said, movers are kept in a file
// beside it (plot_movers.h). An .mvr alone has no changes.

#include "base/result.h"
#include "mvr/mvr_load.h"

#include <cstddef>
#include <filesystem>

namespace ghost::scene {

struct ExportedPlot {
    std::size_t objects = 0;
    std::size_t files = 0;
    std::size_t changes = 0; // of [[change]] that were written
};

// show: an .mvr file, a show.toml or its folder. Error: as load_mvr and write_mvr, or a show without a plot.
Result<ExportedPlot> export_plot(const std::filesystem::path& show, const std::filesystem::path& output,
                                 const MvrLoading& loading, Report& report);

} // namespace ghost::scene
