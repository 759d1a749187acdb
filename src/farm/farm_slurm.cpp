// SPDX-License-Identifier: Apache-2.0
#include "farm/farm.h"

#include "base/child.h"
#include "disk/own_program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kUsualArray = 1001; // Slurm's own default

Result<std::string> said_by(const std::vector<std::string>& words) {
    const Result<ChildResult> child = run_child(words, {}, false);
    if (!child.ok())
        return Error{"Slurm is not here (" + words[0] + " " + child.error().what +
                         "); --farm local does the same on this machine",
                     "--farm slurm"};
    if (child->exit_code == 0) return child->output;
    std::istringstream lines(child->output);
    std::string line;
    std::getline(lines, line);
    for (const std::string& head : {words[0] + ": ", std::string("error: ")})
        if (line.starts_with(head)) line.erase(0, head.size());
    return Error{"Slurm says: " + (line.empty() ? "nothing" : line), words[0]};
}

std::string quoted(const std::string& word) { // for sh
    std::string result = "'";
    for (const char letter : word) result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return result + "'";
}

// What --output takes for more than a letter.
bool is_plain(const std::string& path) {
    return path.find_first_of("%\\\n") == std::string::npos;
}

// Slurm appends to what is there, also where that is a link.
Result<void> check_logs(const fs::path& folder) {
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code))
        if (!fs::is_regular_file(entry->symlink_status(code)))
            return Error{"is no file, expected a log of Slurm: nothing is written there",
                         entry->path().string()};
    return {};
}

std::size_t array_size() {
    const Result<std::string> all = said_by({"scontrol", "show", "config"});
    const std::size_t at = all.ok() ? all->find("MaxArraySize") : std::string::npos;
    if (at == std::string::npos) return kUsualArray;
    const std::size_t digits = all->find_first_of("0123456789", at);
    std::size_t size = 0;
    if (digits != std::string::npos) std::from_chars(all->data() + digits, all->data() + all->size(), size);
    return size > 1 ? size : kUsualArray;
}

// "2,5,9-11"
std::string ranges(const std::vector<std::size_t>& sorted) {
    std::string text;
    for (std::size_t k = 0; k < sorted.size();) {
        std::size_t last = k;
        while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1) ++last;
        text += (text.empty() ? "" : ",") + std::to_string(sorted[k]);
        if (last > k) text += "-" + std::to_string(sorted[last]);
        k = last + 1;
    }
    return text;
}

struct Sbatch {
    const FarmPlan& plan;
    std::vector<std::string> options;
    std::string program;

    Result<std::string> submit(const std::string& command, const std::string& array,
                               const std::vector<std::string>& after) const {
        std::vector<std::string> words{"sbatch", "--parsable", "--job-name=ghostlight", "--requeue",
                                       "--open-mode=append"};
        words.push_back("--output=" +
                        (plan.folder / "log" / (array.empty() ? "%j.txt" : "%A_%a.txt")).string());
        if (!array.empty()) words.push_back("--array=" + array);
        if (!after.empty()) {
            std::string all = "--dependency=afterany";
            for (const std::string& job : after) all += ":" + job;
            words.push_back(all);
        }
        words.insert(words.end(), options.begin(), options.end());
        words.push_back("--wrap=exec " + quoted(program) + " farm " + command);
        TRY(std::string id, said_by(words));
        id.erase(std::min(id.find_first_of(";\n"), id.size())); // "123;cluster"
        if (id.empty() || id.find_first_not_of("0123456789") != std::string::npos)
            return Error{"Slurm says: " + id + ", expected the number of a job", "sbatch"};
        return id;
    }
};

// Of these, those whose states Slurm is asked for; "": all that have not ended.
Result<std::vector<SlurmJob>> jobs_in(const std::vector<std::string>& jobs, const std::string& states) {
    std::vector<SlurmJob> found;
    if (jobs.empty()) return found;
    // All of ours: asked for by number, Slurm fails where it has forgotten one.
    std::vector<std::string> words{"squeue", "-h", "-r", "--name=ghostlight", "-o", "%i|%T|%N|%r"};
    if (!states.empty()) words.push_back("--states=" + states);
    TRY(const std::string all, said_by(words));
    std::istringstream lines(all);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> parts;
        std::istringstream columns(line);
        for (std::string part; std::getline(columns, part, '|');) parts.push_back(part);
        if (parts.size() < 3) continue;
        const std::string id = parts[0].substr(0, parts[0].find('_'));
        if (parts[1] == "COMPLETING" || std::find(jobs.begin(), jobs.end(), id) == jobs.end()) continue;
        SlurmJob& job =
            found.emplace_back(SlurmJob{parts[1], parts[2], parts.size() > 3 ? parts[3] : "", {}});
        if (const std::size_t of_array = parts[0].find('_'); of_array != std::string::npos) {
            job.index.emplace();
            std::from_chars(parts[0].data() + of_array + 1, parts[0].data() + parts[0].size(), *job.index);
        }
    }
    return found;
}

} // namespace

Result<std::vector<std::string>> submit_to_slurm(const FarmPlan& plan, const std::vector<std::size_t>& tasks,
                                                 const std::string& options) {
    if (!is_plain(plan.folder.string()))
        return Error{"Slurm cannot write its log where a folder's name has % or \\", plan.folder.string()};
    TRY_VOID(check_logs(plan.folder / "log"));
    const Sbatch sbatch{plan, CLI::detail::split_up(options), own_program().string()};
    const std::string folder = quoted(plan.folder.string());
    const std::size_t most = array_size();
    std::vector<std::string> jobs, before;
    const auto submit_all = [&]() -> Result<void> {
        for (const int stage : {0, 1}) {
            std::vector<std::string> of_stage;
            // An index is below MaxArraySize, so a task's number is one and an offset.
            for (std::size_t offset = 0; offset < plan.tasks.size(); offset += most) {
                std::vector<std::size_t> part;
                for (const std::size_t task : tasks)
                    if (plan.tasks[task].stage == stage && task >= offset && task < offset + most)
                        part.push_back(task - offset);
                if (part.empty()) continue;
                TRY(const std::string id, sbatch.submit("run " + folder + " $((SLURM_ARRAY_TASK_ID+" +
                                                            std::to_string(offset) + ")) --trust",
                                                        ranges(part), before));
                of_stage.push_back(id);
                jobs.push_back(id);
            }
            if (!of_stage.empty()) before = of_stage;
        }
        // Whatever becomes of them: it says what is missing. afterok would wait for ever after one failure.
        TRY(const std::string id, sbatch.submit("assemble " + folder + " --trust", "", before));
        jobs.push_back(id);
        return {};
    };
    const Result<void> submitted = submit_all();
    if (submitted.ok()) return jobs;
    if (!jobs.empty()) (void)cancel_slurm(jobs); // half a farm makes nothing
    return submitted.error();
}

Result<std::vector<SlurmJob>> slurm_jobs(const std::vector<std::string>& jobs) {
    return jobs_in(jobs, "");
}

bool anybody_works(const std::vector<SlurmJob>& jobs) {
    const auto is_held = [](const SlurmJob& job) { return job.reason == "launch failed requeued held"; };
    const bool holds_back = std::any_of(jobs.begin(), jobs.end(), is_held);
    return std::any_of(jobs.begin(), jobs.end(), [&](const SlurmJob& job) {
        return !holds_back || (!is_held(job) && job.reason != "Dependency");
    });
}

std::set<std::string> nodes_that_could_not_begin(const FarmPlan& plan, const std::vector<std::string>& jobs) {
    std::set<std::string> nodes;
    const auto failed = jobs_in(jobs, "FAILED");
    if (!failed.ok() || failed->empty()) return nodes;
    const std::size_t most = array_size();
    const auto is_silent = [&](const SlurmJob& job) {
        if (!job.index || job.reason != "NonZeroExitCode") return false;
        for (std::size_t task = *job.index; task < plan.tasks.size(); task += most)
            if (!done_of(plan, task) && failure_of(plan, task).empty()) return true;
        return false;
    };
    for (const SlurmJob& job : *failed)
        if (job.reason == "JobLaunchFailure" || is_silent(job)) nodes.insert(job.node);
    return nodes;
}

Result<void> cancel_slurm(const std::vector<std::string>& jobs) {
    std::vector<std::string> words{"scancel"};
    words.insert(words.end(), jobs.begin(), jobs.end());
    TRY_VOID(said_by(words));
    return {};
}

} // namespace ghost::app
