// SPDX-License-Identifier: Apache-2.0
#include "farm/farm.h"

#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "show_folder/hold.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <thread>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr auto kBetweenLooks = std::chrono::seconds(1);
constexpr int kLooksPerQuestion = 5;    // to Slurm, which many ask
constexpr double kPatience_s = 15;      // for what the last job wrote
constexpr std::uintmax_t kFull = 65536; // bytes; a disk that has fewer holds no picture and hardly a word

struct Counts {
    std::size_t done = 0, failed = 0;
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

std::string listed(const std::set<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
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
    const auto bracketed = [](const std::set<std::string>& names) {
        return names.empty() ? std::string() : " (" + listed(names) + ")";
    };
    std::string text =
        std::to_string(counts.done) + " of " + std::to_string(plan.tasks.size()) + " tasks done";
    if (running > 0) text += ", " + std::to_string(running) + " running" + bracketed(nodes);
    if (waiting > 0) text += ", " + std::to_string(waiting) + " waiting" + bracketed(reasons);
    if (counts.failed > 0) text += ", " + std::to_string(counts.failed) + " failed";
    return text;
}

bool is_being_submitted(const FarmPlan& plan) {
    const auto hold = Hold::take(plan.folder / kSubmittingFile, home_of(plan), Hold::Other::keeps);
    return hold.ok() && !hold->is_ours();
}

struct Engine {
    std::vector<SlurmJob> jobs; // that have not ended
    std::optional<Error> silence;
};

Engine ask_engine(const FarmPlan& plan) {
    const Submitted submitted = read_submitted(plan);
    if (submitted.options.engine != "slurm") return {};
    auto living = slurm_jobs(submitted.jobs);
    if (!living.ok()) return {{}, living.error()};
    return {std::move(*living), std::nullopt};
}

// Why the whole is not there though nobody works on it, and what to do.
std::string reason(const FarmPlan& plan, const Counts& counts) {
    std::string text;
    if (counts.done + counts.failed < plan.tasks.size()) { // some ended without a word
        std::error_code code;
        const Submitted submitted = read_submitted(plan);
        const std::set<std::string> nodes = submitted.options.engine == "slurm"
                                                ? nodes_that_could_not_begin(plan, submitted.jobs)
                                                : std::set<std::string>();
        if (const auto space = fs::space(plan.folder, code); !code && space.available < kFull)
            text += "; the disk is full: " + plan.folder.string();
        else if (!nodes.empty())
            text += "; Slurm could not begin tasks on " + listed(nodes) +
                    ", which must see this folder: " + plan.folder.string();
    }
    if (!counts.first_failure.empty())
        text += "; " + counts.first_failure;
    else
        text += "; its logs: " + (plan.folder / "log").string();
    const std::string retry = "ghostlight farm retry";
    return text.find(retry) != std::string::npos ? text : text + "; " + retry + " does what is missing";
}

} // namespace

int whole_of_farm(const FarmPlan& plan, const std::string& words) {
    log_info(plan.result_name() + ": " + words);
    if (!result_lacks_something(plan)) return 0;
    log_error(plan.show.string() +
              ": made, but something that the show asks for is missing; ghostlight check says what");
    return 1;
}

int wait_for_farm(const FarmPlan& plan, bool quiet, double most_silence_s) {
    catch_interrupts();
    Progress progress("farm", quiet ? Progress::Style::silent : Progress::style_for_stderr(), steady_now_s());
    Engine engine;
    bool is_alone = false;
    double worked_s = steady_now_s(), answered_s = worked_s; // when somebody last did
    std::size_t done_before = 0;
    const auto end = [&](const Counts& counts, const std::string& why) {
        progress.finish();
        log_error(plan.result_name() + ": " + status_text(plan, counts, engine.jobs) + ", and " + why);
        return 1;
    };
    for (long look = 0;; ++look) {
        const bool is_whole = has_result(plan);
        const Counts counts = count(plan, is_whole);
        if (is_whole) {
            progress.finish();
            return whole_of_farm(plan, "done, " + std::to_string(plan.tasks.size()) + " tasks");
        }
        if (interrupted()) {
            progress.finish();
            log_info("the farm goes on; ghostlight farm status says how far it is");
            return 1;
        }
        if (look % kLooksPerQuestion == 0) {
            // First, for who submits may be handing over to Slurm just now.
            const bool is_submitting = is_being_submitted(plan);
            engine = ask_engine(plan);
            is_alone = !is_submitting && !anybody_works(engine.jobs) && !engine.silence;
        }
        if (engine.silence && look == 0) {
            progress.finish();
            log_error(engine.silence->text());
            return 1;
        }
        const double now_s = steady_now_s();
        if (!is_alone) worked_s = now_s;
        if (!engine.silence || counts.done != done_before) answered_s = now_s;
        done_before = counts.done;
        // What runs goes on while Slurm is started anew.
        if (now_s - answered_s > most_silence_s)
            return end(counts, "Slurm does not answer any more (" + engine.silence->what +
                                   "); what runs goes on, and ghostlight farm wait follows it again");
        if (is_alone && (!counts.first_failure.empty() || now_s - worked_s > kPatience_s))
            return end(counts, "nobody does more" + reason(plan, counts));
        progress.update(static_cast<double>(counts.done) /
                            static_cast<double>(std::max(plan.tasks.size(), std::size_t{1})),
                        now_s,
                        status_text(plan, counts, engine.jobs) +
                            (engine.silence ? ", Slurm does not answer" : ""));
        std::this_thread::sleep_for(kBetweenLooks);
    }
}

int print_farm_status(const FarmPlan& plan) {
    const bool is_whole = has_result(plan);
    Engine engine;
    if (!is_whole) engine = ask_engine(plan);
    if (engine.silence) log_warning(engine.silence->text());
    const Counts counts = count(plan, is_whole);
    print_text("%s: %s%s\n", one_line(plan.result_name()).c_str(),
               status_text(plan, counts, engine.jobs).c_str(), is_whole ? ", all put together" : "");
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
    const auto running = static_cast<std::size_t>(std::count_if(
        engine.jobs.begin(), engine.jobs.end(), [](const SlurmJob& job) { return job.state == "RUNNING"; }));
    if (timed > 0 && running > 0)
        print_text("about %.0f s left\n", seconds / static_cast<double>(timed) *
                                              static_cast<double>(plan.tasks.size() - counts.done) /
                                              static_cast<double>(running));
    return is_whole ? 0 : 1;
}

} // namespace ghost::app
