#pragma once
// SPDX-License-Identifier: Apache-2.0
// Movers beside a plot: MVR has no place for them, so an export of a show with movers writes NAME.movers.toml
// beside NAME.mvr: its [[mover]] entries as they are, and which object of the plot, by UUID, each of their
// names is. An import that finds such a file takes them into the new show, under the names that these objects
// have now. At most 16 MiB.

#include "base/report.h"
#include "base/result.h"
#include "mvr/plot.h"
#include "show/show.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace ghost::scene {

std::filesystem::path movers_file(const std::filesystem::path& plot_file);

// show_toml: the text of the show; plot: as it is written. How many movers there are; none: no file is
// written.
Result<std::size_t> export_movers(const std::string& show_toml, const Plot& plot,
                                  const std::filesystem::path& plot_file, Report& report);

// Text for a show.toml; "": there is no such file. opened: the plot as a show.
Result<std::string> imported_movers(const Show& opened, const std::filesystem::path& plot_file,
                                    Report& report);

} // namespace ghost::scene
