// SPDX-License-Identifier: Apache-2.0
#include "plots/export_plot.h"

#include "base/text.h"
#include "disk/files.h"
#include "mvr/mvr_write.h"
#include "plots/plot_changes.h"
#include "plots/plot_stage.h"
#include "plots/private/plot_movers.h"
#include "show_file/show_toml.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ghost::scene {
namespace {

namespace fs = std::filesystem;

void add_messages(const Report& from, Report& to) {
    to.messages.insert(to.messages.end(), from.messages.begin(), from.messages.end());
}

void say_what_stays(const ParsedShow& parsed, const fs::path& file, Report& report) {
    const auto say = [&](std::size_t count, const char* what) {
        if (count > 0)
            report.add(Severity::note, file.string(),
                       std::to_string(count) + what +
                           " of the show are no part of the plot and are not written");
    };
    say(parsed.show.fixtures.size(), " [[fixture]]");
    say(parsed.substitutes.size(), " [[substitute]]");
}

} // namespace

Result<ExportedPlot> export_plot(const fs::path& show, const fs::path& output, const MvrLoading& loading,
                                 Report& report) {
    std::error_code code;
    fs::path plot_file = show;
    ParsedShow parsed;
    std::string text;
    if (fs::is_directory(show, code) || lower(show.extension().string()) == ".toml") {
        const fs::path file = fs::is_directory(show, code) ? show / "show.toml" : show;
        TRY(text, read_text_file(file, kMaxShowBytes));
        TRY(parsed, parse_show(text, file, report));
        plot_file = parsed.show.plot_file;
        if (plot_file.empty())
            return Error{"is a show without a plot, so there is nothing to export; expected plot = "
                         "\"name.mvr\" in its [show]",
                         file.string()};
        say_what_stays(parsed, file, report);
    }
    TRY(LoadedPlot loaded, load_mvr(plot_file, loading));
    add_messages(loaded.report, report);
    Plot changed = loaded.plot;
    Report unheard; // write_mvr says what is not in the plot
    const std::vector<PlotChange> changes =
        apply_changes(changed, parsed.changes, origin_of(loaded.plot), unheard);
    TRY_VOID(write_mvr(loaded, changes, output, report));
    if (!text.empty()) TRY_VOID(export_movers(text, changed, output, report));
    ExportedPlot exported{loaded.plot.objects.size(), loaded.archive.names().size(), 0};
    const ObjectIndex index(loaded.plot);
    for (const PlotChange& change : changes)
        exported.changes += index.find(change.uuid) >= 0 && change.what != PlotChange::What::hidden;
    return exported;
}

} // namespace ghost::scene
