// SPDX-License-Identifier: Apache-2.0
// import PLOT.mvr -o FOLDER: a show folder from a designer's plot, or the next version of one that is there.
#include "base/interrupt.h"
#include "cli/commands.h"
#include "live/session/session.h"
#include "plots/import_plot.h"
#include "show_folder/load_show.h"

#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <chrono>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

struct ImportArguments {
    std::string plot;
    std::string folder;
    bool json = false;
    bool quiet = false;
};

nlohmann::json json_of(const std::vector<scene::MergeEntry>& entries) {
    nlohmann::json list = nlohmann::json::array();
    for (const scene::MergeEntry& entry : entries)
        list.push_back({{"uuid", entry.uuid},
                        {"kind", scene::name_of(entry.kind)},
                        {"name", entry.name},
                        {"fixture_id", entry.fixture_id},
                        {"what", entry.what}});
    return list;
}

const char* name_of(scene::PlotChange::What what) {
    switch (what) {
    case scene::PlotChange::What::address:
        return "address";
    case scene::PlotChange::What::mode:
        return "mode";
    case scene::PlotChange::What::position:
        return "position";
    case scene::PlotChange::What::name:
        return "name";
    case scene::PlotChange::What::hidden:
        return "hidden";
    }
    return "";
}

nlohmann::json json_of(const scene::MergeReport& merge) {
    nlohmann::json kept = nlohmann::json::array();
    for (const scene::KeptChange& change : merge.kept)
        kept.push_back({{"uuid", change.change.uuid},
                        {"name", change.name},
                        {"fixture_id", change.fixture_id},
                        {"change", name_of(change.change.what)},
                        {"both", change.both},
                        {"plot_says", change.plot_says}});
    nlohmann::json gone = nlohmann::json::array();
    for (const scene::PlotChange& change : merge.gone)
        gone.push_back({{"uuid", change.uuid}, {"change", name_of(change.what)}});
    return {{"added", json_of(merge.added)},
            {"removed", json_of(merge.removed)},
            {"moved", json_of(merge.moved)},
            {"repatched", json_of(merge.repatched)},
            {"changed", json_of(merge.changed)},
            {"kept", kept},
            {"gone", gone},
            {"unchanged", merge.unchanged},
            {"unrelated", merge.unrelated}};
}

void print_json(const scene::ImportedPlot& imported, const Report& report) {
    nlohmann::json messages = nlohmann::json::array();
    for (const Message& message : report.messages)
        messages.push_back({{"where", message.where}, {"what", message.what}});
    nlohmann::json all = {{"show", imported.show_file.string()},
                          {"plot", imported.plot_file.string()},
                          {"objects", imported.objects},
                          {"fixtures", imported.fixtures},
                          {"dark_fixtures", imported.dark},
                          {"cameras", imported.cameras},
                          {"messages", messages}};
    if (imported.merge) all["merge"] = json_of(*imported.merge);
    print_text("%s\n", all.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void print_words(const scene::ImportedPlot& imported) {
    if (imported.merge) print_text("%s", scene::text_of(*imported.merge).c_str());
    print_text("%s: %zu objects, %zu fixtures", one_line(imported.show_file.string()).c_str(),
               imported.objects, imported.fixtures);
    if (imported.dark > 0) print_text(" (%zu dark)", imported.dark);
    print_text(", %zu cameras%s\n", imported.cameras,
               imported.merge ? "; what you changed in it is kept" : "");
}

int run(const ImportArguments& arguments) {
    if (arguments.quiet) set_log_level(LogLevel::error);
    const InterruptScope scope;
    Progress progress("importing", arguments.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    const scene::ShowLoading loading{
        [&](double share, const std::string& what) { progress.update(share, steady_now_s(), what); },
        interrupted};
    Report report;
    const auto opened = scene::load_show(arguments.plot, true, report, loading);
    const auto imported = opened.ok() ? scene::import_plot(*opened, arguments.folder, report)
                                      : Result<scene::ImportedPlot>(opened.error());
    progress.finish();
    print_report(report);
    if (!imported.ok()) {
        log_error(imported.error().text());
        return 1;
    }
    if (imported->merge && imported->merge->unrelated)
        log_warning("the old plot and the new one share no object: is it another show?");
    if (arguments.json)
        print_json(*imported, report);
    else if (!arguments.quiet)
        print_words(*imported);
    return 0;
}

} // namespace

void add_import(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand("import", "Makes a show of a designer's plot, or updates one");
    const auto arguments = std::make_shared<ImportArguments>();
    command->add_option("PLOT", arguments->plot, ".mvr file")->required();
    command
        ->add_option("-o,--out", arguments->folder,
                     "folder of the show; one that is there gets the new version of its plot")
        ->required();
    command->add_flag("--json", arguments->json, "print what was found and merged as JSON");
    command->add_flag("--quiet", arguments->quiet, "print errors only");
    command->footer(
        "Example: ghostlight import festival.mvr -o festival\nExit: 0 done (losses are listed; see "
        "check), 1 it could not be.");
    command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

} // namespace ghost::app
