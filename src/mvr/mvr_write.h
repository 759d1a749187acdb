#pragma once
// SPDX-License-Identifier: Apache-2.0
// write_mvr: an opened .mvr file again, with changes. Everything that we do not understand stays: the
// description is the original text in which only the changed elements are edited, all other members are
// copied packed as they are. The same plot and changes give the same bytes: fixed times, the order of the
// original, the description first. Written whole or not at all.

#include "base/result.h"
#include "mvr/mvr_load.h"

#include <filesystem>
#include <span>

namespace ghost::scene {

// Changes of objects that do not exist, and hidden, for which MVR has no element, are warnings in report.
// Error: cannot write, or the original cannot be read any more.
Result<void> write_mvr(LoadedPlot& loaded, std::span<const PlotChange> changes,
                       const std::filesystem::path& path, Report& report);

} // namespace ghost::scene
