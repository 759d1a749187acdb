#pragma once
// SPDX-License-Identifier: Apache-2.0
// load_show: a show's folder, or an .mvr as it is, into a Show, whole: the text of show.toml, the plot,
// fixture files, photometry and, where it is asked for, the stage. Opens files; what is wrong goes to the
// report.

#include "base/report.h"
#include "base/result.h"
#include "show/loading.h"
#include "show/show.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace ghost::scene {

// Of fixture files, by whole path in its normal form.
using KnownTypes = std::map<std::filesystem::path, std::shared_ptr<const fixture::Type>>;

// path: show.toml, the folder that holds it, or an .mvr. Where it says no camera, it gets some of its own
// (show/default_cameras.h). An error only where nothing can go on (no such file, not TOML, stopped); all else
// goes to the report with file and line, and the rest is kept. load_stage = false leaves the stage empty (a
// renderer with baked passes needs no geometry), unless default cameras have to be made from it.
Result<Show> load_show(const std::filesystem::path& path, bool load_stage, Report& report,
                       const ShowLoading& loading = {});

// load_show of a show.toml that says this instead of what is in the file.
Result<Show> load_show_text(const std::filesystem::path& file, const std::string& text, bool load_stage,
                            Report& report, const ShowLoading& loading);

// The show that was open, with fixtures, cameras and air as the text has them, for who must show an edit at
// once: its fixtures are those that load_show_text would give. Of files, only those of [[fixture]] and
// [[substitute]] that were not read before are opened: a fixture of the plot that needs another one is dark,
// and a screen that was hidden is not there, until the show is opened. known: read elsewhere.
Result<Show> preview_edit(const Show& before, const std::string& text, KnownTypes known = {});

// The model of stage_file and all that the plot draws. What cannot be read goes to the report. Error:
// stopped.
Result<Stage> read_stage(const Show& show, Report& report, const ShowLoading& loading = {});

} // namespace ghost::scene
