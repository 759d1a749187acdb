// SPDX-License-Identifier: Apache-2.0
#include "farm/farm.h"

#include "base/child.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "disk/own_program.h"
#include "farm/farm_task.h"
#include "show/show.h"
#include "show_folder/hold.h"

#include <chrono>
#include <fstream>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr auto kBetweenQuestions = std::chrono::seconds(1);
constexpr int kLooksAtLast = 30;
constexpr int kTries = 5;
constexpr auto kBetweenTries = std::chrono::milliseconds(100);

// The right to submit. Who follows a farm has it for a moment, to see whether somebody else does.
Result<Hold> hold_of(const FarmPlan& plan) {
    for (int attempt = 1;; ++attempt) {
        auto hold = Hold::take(plan.folder / kSubmittingFile, home_of(plan), Hold::Other::keeps);
        if (!hold.ok() || hold->is_ours() || attempt == kTries) return hold;
        std::this_thread::sleep_for(kBetweenTries);
    }
}

Result<void> do_here(const FarmPlan& plan, const std::vector<std::size_t>& tasks, int at_once, bool quiet) {
    const std::string program = own_program().string();
    Progress progress("farm", quiet ? Progress::Style::silent : Progress::style_for_stderr(), steady_now_s());
    std::size_t ended = 0;
    for (const int stage : {0, 1}) {
        int running = 0;
        const auto wait_for_one = [&] {
            if (wait_for_child() < 0) {
                running = 0;
                return;
            }
            --running;
            ++ended;
            progress.update(static_cast<double>(ended) / static_cast<double>(tasks.size()), steady_now_s(),
                            std::to_string(ended) + " of " + std::to_string(tasks.size()) + " tasks");
        };
        for (const std::size_t task : tasks) {
            if (plan.tasks[task].stage != stage || interrupted()) continue;
            if (running == at_once) wait_for_one();
            TRY_VOID(start_child(
                {program, "farm", "run", plan.folder.string(), std::to_string(task), "--quiet", "--trust"}));
            ++running;
        }
        while (running > 0) wait_for_one();
        for (std::size_t task = 0; task < plan.tasks.size() && !interrupted(); ++task)
            if (plan.tasks[task].stage == stage && stage == 0 && !done_of(plan, task)) {
                progress.finish();
                return assemble_farm(plan); // which says why it cannot
            }
    }
    progress.finish();
    if (interrupted())
        return Error{"interrupted; finished tasks are kept, the same command goes on from there",
                     plan.result_name()};
    return assemble_farm(plan);
}

// What is in the show's folder may have come with it.
Result<void> check_submitted_by_us(const FarmPlan& plan, const Submitted& submitted) {
    TRY_VOID(check_ours(plan));
    if (submitted.is_ours || plan.is_trusted) return {};
    return Error{"you did not give it to this farm here: engine '" + submitted.options.engine +
                     "', its options '" + submitted.options.options +
                     "'; start the command again, or say --trust if they are yours",
                 plan.folder.string()};
}

int ended(const FarmPlan& plan, const Result<void>& done) {
    if (!done.ok()) {
        log_error(done.error().text());
        return 1;
    }
    return whole_of_farm(plan, "done, " + std::to_string(plan.tasks.size()) + " tasks");
}

int do_missing(const FarmPlan& plan, const FarmOptions& options, bool quiet) {
    const auto fail = [](const Error& error) {
        log_error(error.text());
        return 1;
    };
    std::error_code code;
    if (const auto made = make_plan_folders(plan); !made.ok()) return fail(made.error());
    auto hold = hold_of(plan);
    if (!hold.ok()) return fail(hold.error());
    if (!hold->is_ours()) {
        log_info(plan.result_name() + ": is given to the farm by " + hold->holder() + "; following it");
        return wait_for_farm(plan, quiet);
    }
    const bool is_stale = passes_changed(plan);
    if (!is_stale && has_result(plan)) return whole_of_farm(plan, "is done already");
    const Submitted before = read_submitted(plan);
    if (options.engine == "slurm") {
        auto living = slurm_jobs(before.jobs);
        // Those of a whole that was finished, and is gone since, are just ending.
        for (int look = 0; look < kLooksAtLast && living.ok() && anybody_works(*living) &&
                           fs::exists(plan.result_file(), code);
             ++look) {
            std::this_thread::sleep_for(kBetweenQuestions);
            living = slurm_jobs(before.jobs);
        }
        if (!living.ok()) return fail(living.error());
        if (anybody_works(*living)) {
            log_info(plan.result_name() + ": is on the farm already; following it");
            { const Hold given_back = std::move(*hold); }
            return wait_for_farm(plan, quiet);
        }
    }
    if (is_stale || fs::exists(plan.result_file(), code)) // of what is gone since
        if (const auto forgotten = forget_of_tasks(plan, "done"); !forgotten.ok())
            return fail(forgotten.error());
    if (const auto forgotten = forget_of_tasks(plan, "failed"); !forgotten.ok())
        return fail(forgotten.error());
    const std::vector<std::size_t> missing = missing_tasks(plan);
    Submitted now{options, {}};
    if (options.engine == "local") {
        if (const auto written = write_submitted(plan, now); !written.ok()) return fail(written.error());
        catch_interrupts();
        return ended(plan, do_here(plan, missing, options.jobs, quiet));
    }
    if (before.is_ours && !before.jobs.empty()) (void)cancel_slurm(before.jobs); // those that it holds back
    auto jobs = submit_to_slurm(plan, missing, options.options);
    if (!jobs.ok()) return fail(jobs.error());
    now.jobs = std::move(*jobs);
    if (const auto written = write_submitted(plan, now); !written.ok()) {
        (void)cancel_slurm(now.jobs);
        return fail(written.error());
    }
    log_info(plan.result_name() + ": " + std::to_string(missing.size()) +
             " tasks given to Slurm; Ctrl-C stops watching only");
    { const Hold given_back = std::move(*hold); }
    return wait_for_farm(plan, quiet);
}

} // namespace

std::vector<std::string> words_without(const std::map<std::string, int>& options) {
    std::map<std::string, int> left_out = options;
    for (const char* const name : {"--farm", "--farm-options", "--farm-jobs", "--progress-every"})
        left_out[name] = 1;
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    int skip = 1;           // the program
    bool are_names = false; // what comes behind "--"
    for (std::string word; std::getline(file, word, '\0');) {
        if (skip > 0) {
            --skip;
            continue;
        }
        // Options of tasks come behind them, and shall not be taken for names.
        if (are_names) {
            words.push_back(word.starts_with('-') ? "./" + word : word);
            continue;
        }
        if (word == "--") {
            are_names = true;
            continue;
        }
        const auto found = left_out.find(word.substr(0, word.find('=')));
        if (found != left_out.end()) {
            skip = word.find('=') == std::string::npos ? found->second : 0;
            continue;
        }
        if (word.starts_with("-o") && !word.starts_with("--") && left_out.contains("-o")) continue; // -oNAME
        words.push_back(word);
    }
    return words;
}

int start_farm(FarmPlan plan, const scene::Show& show, const FarmOptions& options, bool quiet) {
    if (plan.tasks.size() > kMostFarmTasks) {
        log_error(plan.result_name() + ": " + std::to_string(plan.tasks.size()) +
                  " tasks are more than the " + std::to_string(kMostFarmTasks) +
                  " of one plan; give it in parts");
        return 1;
    }
    if (const Result<void> stored = store_plan(plan, show); !stored.ok()) {
        log_error(stored.error().text());
        return 1;
    }
    return do_missing(plan, options, quiet);
}

int retry_farm(const FarmPlan& plan) {
    const Submitted before = read_submitted(plan);
    if (before.options.engine.empty()) {
        log_error(plan.result_name() + ": was given to no farm; start the command again");
        return 1;
    }
    if (const Result<void> ours = check_submitted_by_us(plan, before); !ours.ok()) {
        log_error(ours.error().text());
        return 1;
    }
    if (const Result<void> same = check_same(plan); !same.ok()) {
        log_error(same.error().text());
        return 1;
    }
    return do_missing(plan, before.options, false);
}

int cancel_farm(const FarmPlan& plan) {
    const Submitted submitted = read_submitted(plan);
    if (submitted.options.engine != "slurm") {
        log_error(plan.result_name() + ": no engine has it; tasks of this machine end with Ctrl-C");
        return 1;
    }
    const Result<void> ours = check_submitted_by_us(plan, submitted);
    const Result<void> done = ours.ok() ? cancel_slurm(submitted.jobs) : ours;
    if (!done.ok()) log_error(done.error().text());
    return done.ok() ? 0 : 1;
}

} // namespace ghost::app
