// SPDX-License-Identifier: Apache-2.0
#include "farm/farm.h"

#include "base/child.h"
#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "disk/files.h"
#include "farm/farm_task.h"
#include "json_xml_toml/json.h"
#include "show/show.h"
#include "show_folder/hold.h"

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr auto kBetweenLooks = std::chrono::seconds(1);
constexpr int kLooksPerQuestion = 5;                 // to Slurm, which many ask
constexpr auto kPatience = std::chrono::seconds(15); // for what the last job wrote
constexpr int kLooksAtLast = 30;
constexpr JsonLimits kSubmittedLimits{.bytes = 1 << 20};

struct Submitted {
    FarmOptions options;
    std::vector<std::string> jobs; // of Slurm
};

fs::path submitted_file(const FarmPlan& plan) {
    return plan.folder / "submitted.json";
}

Result<void> write_submitted(const FarmPlan& plan, const Submitted& submitted) {
    return write_file_atomic(submitted_file(plan), json({{"engine", submitted.options.engine},
                                                         {"options", submitted.options.options},
                                                         {"at_once", submitted.options.jobs},
                                                         {"jobs", submitted.jobs}})
                                                           .dump() +
                                                       "\n");
}

Submitted read_submitted(const FarmPlan& plan) {
    Submitted submitted;
    const auto text = read_text_file(submitted_file(plan), kSubmittedLimits.bytes);
    if (!text.ok()) return submitted;
    const auto all = read_json(*text, submitted_file(plan).string(), kSubmittedLimits);
    if (!all.ok()) return submitted;
    try {
        submitted.options.engine = all->at("engine").get<std::string>();
        submitted.options.options = all->at("options").get<std::string>();
        submitted.options.jobs = std::clamp(all->at("at_once").get<int>(), 1, 1024);
        for (const json& job : all->at("jobs")) submitted.jobs.push_back(job.get<std::string>());
    } catch (const json::exception&) {
        log_warning(submitted_file(plan).string() +
                    ": is not what was written there; as if nothing were submitted");
        return {};
    }
    return submitted;
}

std::string name_of(const FarmPlan& plan) {
    return (plan.is_film() ? plan.out : plan.show).string();
}

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Counts {
    std::size_t done = 0, failed = 0;
    double seconds = 0; // of all that are done
    std::string first_failure;
};

Counts count(const FarmPlan& plan, bool is_whole) {
    Counts counts;
    std::error_code code;
    for (std::size_t task = 0; task <= plan.tasks.size(); ++task) {
        const bool is_task = task < plan.tasks.size();
        if (is_task && (is_whole || fs::exists(plan.done_file(task), code))) {
            ++counts.done;
            continue;
        }
        const std::string why = failure_of(plan, task);
        if (why.empty()) continue;
        if (is_task) ++counts.failed;
        if (counts.first_failure.empty())
            counts.first_failure =
                (is_task ? plan.tasks[task].name : std::string("putting together")) + ": " + why;
    }
    return counts;
}

std::string status_text(const FarmPlan& plan, const Counts& counts, const std::vector<SlurmJob>& jobs) {
    std::size_t running = 0, waiting = 0;
    std::set<std::string> nodes, reasons;
    for (const SlurmJob& job : jobs) {
        const bool runs = job.state == "RUNNING";
        ++(runs ? running : waiting);
        if (runs && !job.node.empty()) nodes.insert(job.node);
        if (!runs && !job.reason.empty() && job.reason != "None") reasons.insert(job.reason);
    }
    const auto listed = [](const std::set<std::string>& names) {
        std::string all;
        for (const std::string& name : names) all += (all.empty() ? " (" : ", ") + name;
        return all.empty() ? all : all + ")";
    };
    std::string text =
        std::to_string(counts.done) + " of " + std::to_string(plan.tasks.size()) + " tasks done";
    if (running > 0) text += ", " + std::to_string(running) + " running" + listed(nodes);
    if (waiting > 0) text += ", " + std::to_string(waiting) + " waiting" + listed(reasons);
    if (counts.failed > 0) text += ", " + std::to_string(counts.failed) + " failed";
    return text;
}

Result<void> do_here(const FarmPlan& plan, const std::vector<std::size_t>& tasks, int at_once, bool quiet) {
    std::error_code code;
    const std::string program = fs::read_symlink("/proc/self/exe", code).string();
    Progress progress("farm", quiet ? Progress::Style::silent : Progress::style_for_stderr(), now_s());
    std::size_t ended = 0;
    for (const int stage : {0, 1}) {
        int running = 0;
        const auto wait_for_one = [&] {
            if (wait_for_child() < 0) return;
            --running;
            ++ended;
            progress.update(static_cast<double>(ended) / static_cast<double>(tasks.size()), now_s(),
                            std::to_string(ended) + " of " + std::to_string(tasks.size()) + " tasks");
        };
        for (const std::size_t task : tasks) {
            if (plan.tasks[task].stage != stage || interrupted()) continue;
            if (running == at_once) wait_for_one();
            TRY_VOID(
                start_child({program, "farm", "run", plan.folder.string(), std::to_string(task), "--quiet"}));
            ++running;
        }
        while (running > 0) wait_for_one();
        for (std::size_t task = 0; task < plan.tasks.size(); ++task)
            if (plan.tasks[task].stage == stage && stage == 0 && !done_of(plan, task)) {
                progress.finish();
                return assemble_farm(plan); // which says why it cannot
            }
    }
    progress.finish();
    if (interrupted())
        return Error{"interrupted; finished tasks are kept, the same command goes on from there",
                     name_of(plan)};
    return assemble_farm(plan);
}

int ended(const FarmPlan& plan, const Result<void>& done) {
    if (!done.ok()) {
        log_error(done.error().text());
        return 1;
    }
    log_info(name_of(plan) + ": done, " + std::to_string(plan.tasks.size()) + " tasks");
    return 0;
}

int do_missing(const FarmPlan& plan, const FarmOptions& options, bool quiet) {
    const auto fail = [](const Error& error) {
        log_error(error.text());
        return 1;
    };
    std::error_code code;
    auto hold = Hold::take(plan.folder / "submitting", plan.folder, Hold::Other::keeps);
    if (!hold.ok()) return fail(hold.error());
    if (!hold->is_ours()) {
        log_info(name_of(plan) + ": is given to the farm by " + hold->holder() + "; following it");
        return wait_for_farm(plan, quiet);
    }
    if (has_result(plan)) {
        log_info(name_of(plan) + ": is done already");
        return 0;
    }
    const Submitted before = read_submitted(plan);
    if (options.engine == "slurm") {
        auto living = slurm_jobs(before.jobs);
        // Those of a whole that was finished, and is gone since, are just ending.
        for (int look = 0;
             look < kLooksAtLast && living.ok() && !living->empty() && fs::exists(plan.result_file(), code);
             ++look) {
            std::this_thread::sleep_for(kBetweenLooks);
            living = slurm_jobs(before.jobs);
        }
        if (!living.ok()) return fail(living.error());
        if (!living->empty()) {
            log_info(name_of(plan) + ": is on the farm already; following it");
            return wait_for_farm(plan, quiet);
        }
    }
    if (fs::exists(plan.result_file(), code)) // of what is gone since
        for (const auto& entry : fs::directory_iterator(plan.folder / "done", code))
            fs::remove(entry.path(), code);
    for (const auto& entry : fs::directory_iterator(plan.folder / "failed", code))
        fs::remove(entry.path(), code);
    const std::vector<std::size_t> missing = missing_tasks(plan);
    Submitted now{options, {}};
    if (options.engine == "local") {
        if (const auto written = write_submitted(plan, now); !written.ok()) return fail(written.error());
        catch_interrupts();
        return ended(plan, do_here(plan, missing, options.jobs, quiet));
    }
    auto jobs = submit_to_slurm(plan, missing, options.options);
    if (!jobs.ok()) return fail(jobs.error());
    now.jobs = std::move(*jobs);
    if (const auto written = write_submitted(plan, now); !written.ok()) {
        (void)cancel_slurm(now.jobs);
        return fail(written.error());
    }
    log_info(name_of(plan) + ": " + std::to_string(missing.size()) +
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
    int skip = 1; // the program
    for (std::string word; std::getline(file, word, '\0');) {
        if (skip > 0) {
            --skip;
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
        log_error(name_of(plan) + ": " + std::to_string(plan.tasks.size()) + " tasks are more than the " +
                  std::to_string(kMostFarmTasks) + " of one plan; give it in parts");
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
        log_error(name_of(plan) + ": was given to no farm; start the command again");
        return 1;
    }
    if (const Result<void> same = check_same(plan); !same.ok()) {
        log_error(same.error().text());
        return 1;
    }
    return do_missing(plan, before.options, false);
}

int wait_for_farm(const FarmPlan& plan, bool quiet) {
    catch_interrupts();
    const Submitted submitted = read_submitted(plan);
    Progress progress("farm", quiet ? Progress::Style::silent : Progress::style_for_stderr(), now_s());
    std::vector<SlurmJob> jobs;
    double alone_since_s = -1; // nobody is left who does something; below 0: somebody is
    for (long look = 0;; ++look) {
        const bool is_whole = has_result(plan);
        const Counts counts = count(plan, is_whole);
        if (is_whole) {
            progress.finish();
            return ended(plan, {});
        }
        if (interrupted()) {
            progress.finish();
            log_info("the farm goes on; ghostlight farm status says how far it is");
            return 1;
        }
        bool is_alone = false;
        if (submitted.options.engine == "slurm") {
            if (look % kLooksPerQuestion == 0) {
                auto living = slurm_jobs(submitted.jobs);
                if (living.ok()) {
                    jobs = std::move(*living);
                    is_alone = jobs.empty();
                } else if (look == 0) { // later it may be started anew
                    progress.finish();
                    log_error(living.error().text());
                    return 1;
                }
            } else {
                is_alone = alone_since_s >= 0;
            }
        } else {
            const auto hold = Hold::take(plan.folder / "submitting", plan.folder, Hold::Other::keeps);
            is_alone = !hold.ok() || hold->is_ours();
        }
        if (!is_alone)
            alone_since_s = -1;
        else if (alone_since_s < 0)
            alone_since_s = now_s();
        const double alone_s = is_alone ? now_s() - alone_since_s : 0;
        if (is_alone &&
            (!counts.first_failure.empty() || alone_s > std::chrono::duration<double>(kPatience).count())) {
            progress.finish();
            log_error(name_of(plan) + ": " + status_text(plan, counts, {}) + ", and nobody does more" +
                      (counts.first_failure.empty() ? "; its logs: " + (plan.folder / "log").string()
                                                    : "; " + counts.first_failure) +
                      "; ghostlight farm retry does what is missing");
            return 1;
        }
        progress.update(static_cast<double>(counts.done) /
                            static_cast<double>(std::max(plan.tasks.size(), std::size_t{1})),
                        now_s(), status_text(plan, counts, jobs));
        std::this_thread::sleep_for(kBetweenLooks);
    }
}

int print_farm_status(const FarmPlan& plan) {
    const Submitted submitted = read_submitted(plan);
    const bool is_whole = has_result(plan);
    std::vector<SlurmJob> jobs;
    if (!is_whole && submitted.options.engine == "slurm") {
        auto living = slurm_jobs(submitted.jobs);
        if (living.ok())
            jobs = std::move(*living);
        else
            log_warning(living.error().text());
    }
    const Counts counts = count(plan, is_whole);
    print_text("%s: %s%s\n", one_line(name_of(plan)).c_str(), status_text(plan, counts, jobs).c_str(),
               is_whole ? ", all put together" : "");
    if (!counts.first_failure.empty())
        print_text("first failure: %s\n", one_line(counts.first_failure).c_str());
    double seconds = 0;
    std::size_t timed = 0;
    if (!is_whole)
        for (std::size_t task = 0; task < plan.tasks.size(); ++task)
            if (const auto done = done_of(plan, task); done && plan.tasks[task].stage == 1) {
                seconds += done->seconds;
                ++timed;
            }
    const auto running = static_cast<std::size_t>(
        std::count_if(jobs.begin(), jobs.end(), [](const SlurmJob& job) { return job.state == "RUNNING"; }));
    if (timed > 0 && running > 0)
        print_text("about %.0f s left\n", seconds / static_cast<double>(timed) *
                                              static_cast<double>(plan.tasks.size() - counts.done) /
                                              static_cast<double>(running));
    return is_whole ? 0 : 1;
}

int cancel_farm(const FarmPlan& plan) {
    const Submitted submitted = read_submitted(plan);
    if (submitted.options.engine != "slurm") {
        log_error(name_of(plan) + ": no engine has it; tasks of this machine end with Ctrl-C");
        return 1;
    }
    const Result<void> done = cancel_slurm(submitted.jobs);
    if (!done.ok()) log_error(done.error().text());
    return done.ok() ? 0 : 1;
}

} // namespace ghost::app
