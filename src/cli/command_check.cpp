// SPDX-License-Identifier: Apache-2.0
// check FILE|FOLDER...: the import doctor. What fixture files, plots and shows would lose, and where.
#include "cli/commands.h"

#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "cli/doctor/doctor.h"
#include "cli/doctor/doctor_files.h"
#include "cli/doctor/doctor_text.h"

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

struct CheckOptions {
    std::vector<std::string> files;
    std::vector<std::string> fixtures;
    std::string replay;
    std::size_t threads = 0;
    bool json = false;
    bool strict = false;
    bool quiet = false;
    bool summary = false;
    bool all = false;
};

std::vector<Checked> check(const std::vector<std::string>& files, const CheckOptions& options) {
    Progress progress("checking", options.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    DoctorOptions doctor;
    doctor.threads = options.threads;
    doctor.fixture_folders.assign(options.fixtures.begin(), options.fixtures.end());
    doctor.replay = options.replay;
    doctor.stop = interrupted;
    doctor.progress = [&](double share, const std::string& file) {
        progress.update(share, steady_now_s(), file);
    };
    std::vector<Checked> all = check_files(files, doctor);
    progress.finish();
    return all;
}

void print(const std::vector<Checked>& all, const CheckOptions& options) {
    if (options.json) {
        nlohmann::json list = nlohmann::json::array();
        for (const Checked& checked : all) list.push_back(json_of(checked));
        // A file may say anything in its names; what is no UTF-8 is replaced, not thrown.
        print_text("%s\n", list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
        return;
    }
    const Detail detail = options.quiet ? Detail::losses : options.all ? Detail::all : Detail::grouped;
    if (!options.summary)
        for (const Checked& checked : all) print_text("%s", text_of(checked, detail).c_str());
    if (options.summary || (!options.quiet && all.size() > 1))
        print_text("%s", summary_of(all, options.all).c_str());
}

int run(const CheckOptions& options) {
    const InterruptScope scope;
    const FileSearch found = find_files(options.files);
    for (const std::string& limit : found.limits) log_warning(limit);
    if (found.other_json > 0)
        log_info(std::to_string(found.other_json) + " .json files are no fixtures and are left out");
    if (found.files.empty()) {
        if (options.json) print_text("[]\n");
        log_error(
            options.files.front() +
            ": nothing to check, expected .gdtf, .qxf, .mvr, fixtures in .json or folders with a show.toml");
        return 1;
    }
    const std::vector<Checked> all = check(found.files, options);
    print(all, options);
    bool fault = !found.limits.empty();
    std::size_t left = 0;
    for (const Checked& checked : all) {
        fault |= checked.count(Severity::error) > 0;
        fault |= options.strict && checked.count(Severity::warning) > 0;
        left += checked.is_done ? 0 : 1;
    }
    if (left > 0) log_warning("interrupted; " + std::to_string(left) + " files are not checked");
    return fault || left > 0 ? 1 : 0;
}

} // namespace

void add_check(CLI::App& app, int& exit_code) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        app.add_subcommand("check", "What fixture files, plots and shows would lose, and where");
    command
        ->add_option(
            "FILE", options->files,
            ".gdtf, .qxf and .json fixture files, .mvr plots, show.toml files, folders of shows, and folders "
            "to search for all of these")
        ->required();
    command->add_flag("--json", options->json, "one JSON list on standard output, with every message");
    command->add_flag("--strict", options->strict, "exit 1 for repairs and guesses, too");
    command->add_flag("--all,--verbose", options->all, "list every message, every file and more faults");
    command->add_flag("--summary", options->summary, "print the summary only");
    command->add_flag("--quiet", options->quiet, "print losses only");
    command->add_option("--replay", options->replay,
                        "recording that the movers of shows run through, instead of their own: what meets, "
                        "goes through the floor or is asked to go past its end stops");
    command
        ->add_option("--fixtures", options->fixtures,
                     "folders with fixture files that may stand in for missing ones")
        ->allow_extra_args(false);
    command->add_option("--threads", options->threads, "files checked at the same time; 0: one per core")
        ->check(CLI::Range(0, 64));
    command->footer("Example: ghostlight check assets/demo assets/fixtures/*.gdtf\n"
                    "         ghostlight check --summary --strict plots\n"
                    "         ghostlight check --replay rehearsal.ghostdmx assets/kinetic\n"
                    "Exit: 0 nothing lost, 1 something was (--strict: or was repaired), 2 wrong usage.");
    command->callback([options, &exit_code] { exit_code = run(*options); });
}

} // namespace ghost::app
