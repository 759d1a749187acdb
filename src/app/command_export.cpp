// SPDX-License-Identifier: Apache-2.0
// export SHOW.mvr -o OUT.mvr: a plot as other programs read it, with all that was in it.
#include "app/commands.h"

#include "base/log.h"
#include "base/progress.h"
#include "scene/mvr_write.h"

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string file;
    std::string output;
};

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void print(const scene::Report& report) {
    for (const scene::Message& message : report.messages) {
        const std::string text = message.where + ": " + message.what;
        if (message.severity == scene::Severity::note)
            log_info(text);
        else
            log_warning(text);
    }
}

int run(const Options& options) {
    Progress progress("opening", Progress::style_for_stderr(), now_s());
    scene::MvrLoading loading;
    loading.progress = [&](double share, std::string_view what) {
        progress.update(share, now_s(), std::string(what));
    };
    auto loaded = scene::load_mvr(fs::path(options.file), loading);
    progress.finish();
    if (!loaded.ok()) {
        log_error(loaded.error().text());
        return 1;
    }
    print(loaded->report);
    scene::Report written;
    if (const auto result = scene::write_mvr(*loaded, {}, options.output, written); !result.ok()) {
        log_error(result.error().text());
        return 1;
    }
    print(written);
    std::cout << options.output << ": " << loaded->plot.objects.size() << " objects, "
              << loaded->archive.names().size() << " files\n";
    return 0;
}

} // namespace

void add_export(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("export", "Write a plot (MVR) again, with everything that was in it");
    command->add_option("SHOW", options->file, "an .mvr file")->required();
    command->add_option("-o,--output", options->output, "the .mvr file to write")->required();
    command->footer(
        "Example: ghostlight export festival.mvr -o festival_2.mvr\nThe same plot gives the same bytes. "
        "Exit: 0 written, 1 not.");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace ghost::app
