#pragma once
// SPDX-License-Identifier: Apache-2.0
// The engines that do the tasks of a plan: processes of this machine, or Slurm. Whoever submits holds
// PLAN/submitting meanwhile. Main thread.

#include "farm/farm_plan.h"

#include <optional>
#include <set>

namespace ghost::app {

struct FarmOptions {
    std::string engine;  // "": no farm; local, slurm
    std::string options; // of sbatch
    int jobs = 1;        // tasks at the same time; local
};
// The words of the command line without those of a farm and these, each with `values` words after it.
std::vector<std::string> words_without(const std::map<std::string, int>& options);

// Stores the plan, has what is missing done, and waits. Exit code: 0 when the whole is there.
int start_farm(FarmPlan plan, const scene::Show& show, const FarmOptions& options, bool quiet);
// The same of a plan that is there, as it was asked for; what failed is tried again.
int retry_farm(const FarmPlan& plan);
inline constexpr double kMostSilence_s = 600; // of Slurm, which may be started anew
// Follows what others do, and gives up where Slurm does not answer for so long and nothing gets done
// meanwhile.
int wait_for_farm(const FarmPlan& plan, bool quiet, double most_silence_s = kMostSilence_s);
int print_farm_status(const FarmPlan& plan);
// Of a whole result: says so, in these words. Exit code: 1 where something that the show asks for lacks.
int whole_of_farm(const FarmPlan& plan, const std::string& words);
int cancel_farm(const FarmPlan& plan);

inline constexpr const char* kSubmittingFile = "submitting";
// What an engine was asked to do, in PLAN/submitted.json.
struct Submitted {
    FarmOptions options;
    std::vector<std::string> jobs; // of Slurm
    bool is_ours = false;          // this user submitted it
};
Result<void> write_submitted(const FarmPlan& plan, const Submitted& submitted);
Submitted read_submitted(const FarmPlan& plan); // nothing where none is there

// Slurm, by its commands.
struct SlurmJob {
    std::string state; // RUNNING, PENDING ..
    std::string node, reason;
    std::optional<std::size_t> index; // of an array's task; else it puts together
};
// Arrays of these tasks, the second after the first, and a job that assembles; the numbers of the jobs.
Result<std::vector<std::string>> submit_to_slurm(const FarmPlan& plan, const std::vector<std::size_t>& tasks,
                                                 const std::string& options);
// Those of them that have not ended. Error: Slurm does not answer.
Result<std::vector<SlurmJob>> slurm_jobs(const std::vector<std::string>& jobs);
// Not where Slurm holds back what it could not begin, and all others wait for that.
bool anybody_works(const std::vector<SlurmJob>& jobs);
// Where they could not even begin, as far as Slurm remembers it. Slurm 24 begins them also where there is no
// place for their log: so those that failed without having left a word count, too.
std::set<std::string> nodes_that_could_not_begin(const FarmPlan& plan, const std::vector<std::string>& jobs);
Result<void> cancel_slurm(const std::vector<std::string>& jobs);

} // namespace ghost::app
