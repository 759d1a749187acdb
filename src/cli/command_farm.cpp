// SPDX-License-Identifier: Apache-2.0
#include "base/interrupt.h"
#include "base/log.h"
#include "base/print.h"
#include "cli/commands.h"
#include "farm/farm.h"
#include "farm/farm_task.h"

#include <functional>
#include <memory>

namespace ghost::app {
namespace {

struct FarmArguments {
    std::string plan;
    std::size_t task = 0;
    double most_silence_s = kMostSilence_s;
    bool quiet = false;
    bool trust = false;
};

int ended(const Result<void>& done) {
    if (!done.ok()) log_error(done.error().text());
    return done.ok() ? 0 : 1;
}

} // namespace

void add_farm(CLI::App& app, int& exit_code) {
    CLI::App* farm =
        app.add_subcommand("farm", "bakes and films that bake --farm and render --farm cut into tasks");
    farm->require_subcommand(1);
    const auto a = std::make_shared<FarmArguments>();
    const auto add = [&](const char* name, const char* what, std::function<int(const FarmPlan&)> act) {
        CLI::App* command = farm->add_subcommand(name, what);
        command->add_option("SHOW", a->plan, "a show, whose newest plan it then is, or the plan's folder")
            ->required();
        command->callback([a, act, &exit_code] {
            if (a->quiet) set_log_level(LogLevel::warning);
            Result<FarmPlan> plan = find_plan(a->plan);
            if (!plan.ok()) log_error(plan.error().text());
            if (plan.ok()) plan->is_trusted = a->trust;
            exit_code = plan.ok() ? act(*plan) : 1;
        });
        return command;
    };
    add("status", "how far it is, where it runs, what failed first; exit code 0 when all is done",
        print_farm_status);
    add("wait", "follow it to its end",
        [a](const FarmPlan& plan) { return wait_for_farm(plan, false, a->most_silence_s); })
        ->add_option("--patience", a->most_silence_s,
                     "seconds for which Slurm may give no answer while nothing gets done")
        ->check(CLI::Range(0.0, 1e6))
        ->type_name("SECONDS")
        ->capture_default_str();
    const auto add_trusting = [&](const char* name, const char* what,
                                  std::function<int(const FarmPlan&)> act) {
        CLI::App* command = add(name, what, std::move(act));
        command->add_flag(
            "--trust", a->trust,
            "also a plan that you did not make here, which may have come with the show: it says "
            "what is run, and what is written where");
        return command;
    };
    add_trusting("retry", "do what is missing, and only that", retry_farm);
    add_trusting("cancel", "take it back from the engine; what is done stays", cancel_farm);
    add_trusting("assemble", "put together what the tasks made", [](const FarmPlan& plan) {
        catch_interrupts();
        const Result<void> done = assemble_farm(plan);
        return done.ok() ? whole_of_farm(plan, "put together") : ended(done);
    });
    add("tasks", "the numbers of the tasks that are missing, one a line", [](const FarmPlan& plan) {
        for (const std::size_t task : missing_tasks(plan)) print_text("%zu\n", task);
        return 0;
    });
    CLI::App* run = add_trusting("run", "do one task, here", [a](const FarmPlan& plan) {
        catch_interrupts();
        return ended(run_farm_task(plan, a->task));
    });
    run->add_option("TASK", a->task, "its number")->required();
    run->add_flag("--quiet", a->quiet, "print warnings and errors only");
    farm->footer("Example: ghostlight render tour -o tour.mp4 --from 0 --to 3600 --farm slurm\n"
                 "         ghostlight farm status tour\n"
                 "         ghostlight farm tasks tour | parallel --sshlogin a,b ghostlight farm run tour {}");
}

} // namespace ghost::app
