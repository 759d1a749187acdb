#pragma once
// SPDX-License-Identifier: Apache-2.0
// import_plot: a show folder from an .mvr: a copy of the plot and a show.toml with cameras and haze that fit
// it, and the movers of a file beside it (plot_movers.h). Where the folder has a show with a plot, the new
// version takes the old one's place and show.toml stays as it is: what the user changed is found again by
// UUID, and what became of it is reported. Files are replaced whole or not at all, show.toml and plot each.
// Main thread.

#include "base/report.h"
#include "base/result.h"
#include "mvr/mvr_merge.h"
#include "show/show.h"

#include <filesystem>
#include <optional>
#include <string>

namespace ghost::scene {

struct ImportedPlot {
    std::filesystem::path show_file;
    std::filesystem::path plot_file;
    std::size_t objects = 0;
    std::size_t fixtures = 0;
    std::size_t dark = 0; // of them, without a readable fixture file
    std::size_t cameras = 0;
    std::optional<MergeReport> merge; // of a show that was there
};

// opened: the .mvr as load_show (show_folder/load_show.h) opens it, with its stage. Error: it is a show, the
// folder cannot be written, or its show has no plot. Then nothing was changed, but for folders that were
// made.
Result<ImportedPlot> import_plot(const Show& opened, const std::filesystem::path& folder, Report& report);

// The show.toml for a plot that was opened as it is. plot_name: as show.toml shall name it.
std::string show_text(const Show& show, const std::string& plot_name);

} // namespace ghost::scene
