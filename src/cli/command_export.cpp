// SPDX-License-Identifier: Apache-2.0
// export SHOW -o OUT.mvr: a plot as other programs read it, with all that was in it and what the show
// changes.
#include "cli/commands.h"

#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "plots/export_plot.h"

#include <filesystem>
#include <memory>
#include <string>

namespace ghost::app {
namespace {

struct ExportOptions {
    std::string file;
    std::string output;
};

void log_messages(const Report& report) {
    for (const Message& message : report.messages) {
        const std::string text = message.where + ": " + message.what;
        if (message.severity == Severity::note)
            log_info(text);
        else
            log_warning(text);
    }
}

int run(const ExportOptions& options) {
    Progress progress("opening", Progress::style_for_stderr(), steady_now_s());
    scene::MvrLoading loading;
    loading.progress = [&](double share, std::string_view what) {
        progress.update(share, steady_now_s(), std::string(what));
    };
    Report report;
    const auto exported = scene::export_plot(options.file, options.output, loading, report);
    progress.finish();
    log_messages(report);
    if (!exported.ok()) {
        log_error(exported.error().text());
        return 1;
    }
    print_text("%s: %zu objects, %zu files, %zu changes of the show\n", one_line(options.output).c_str(),
               exported->objects, exported->files, exported->changes);
    return 0;
}

} // namespace

void add_export(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command =
        app.add_subcommand("export", "Write a plot (MVR) again, with everything that was in it");
    command
        ->add_option("SHOW", options->file,
                     "an .mvr file, or a show with a plot: with its [[change]] entries")
        ->required();
    command->add_option("-o,--output", options->output, "the .mvr file to write")->required();
    command->footer(
        "Example: ghostlight export festival.mvr -o festival_2.mvr\n         ghostlight export festival -o "
        "for_the_designer.mvr\nThe same plot gives the same bytes. "
        "Exit: 0 written, 1 not.");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace ghost::app
