#pragma once
// SPDX-License-Identifier: Apache-2.0
// show.toml -> Show, without opening any other file (docs/reference/show-file.md says what each key means).
// Pure.

#include "base/report.h"
#include "base/result.h"
#include "light/beam_shape.h"
#include "show/plot_entries.h"
#include "show/show.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::scene {

// Where a fixture's entries stand, for messages that come later; 0 where it has none.
struct FixtureSource {
    std::string mode;
    int line = 0;
    int gdtf_line = 0;
    int mode_line = 0;
    std::filesystem::path photometry; // as written, or empty
    int photometry_line = 0;
    int address_line = 0;
    int track_line = 0;
};

struct ParsedShow {
    Show show;                          // types and stage are not loaded
    std::vector<FixtureSource> sources; // one per fixture
    std::vector<ChangeEntry> changes;   // of the plot
    std::vector<SubstituteEntry> substitutes;
    std::vector<WallSettings> walls; // of the plot
    std::vector<PhotometryEntry> photometry;
    int stage_line = 0;
    int plot_line = 0;
    int hidden_layers_line = 0;
    int hidden_classes_line = 0;
    int recording_line = 0;
    std::vector<int> passes_lines; // one per camera
};

// Error: not TOML (with line). Everything else goes to the report and the rest is kept; cameras may be none.
Result<ParsedShow> parse_show(std::string_view text, const std::filesystem::path& file, Report& report);

} // namespace ghost::scene
