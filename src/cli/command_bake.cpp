// SPDX-License-Identifier: Apache-2.0
#include "bake/bake_show.h"
#include "bake/frame.h"
#include "base/interrupt.h"
#include "cli/commands.h"
#include "cli/options/live_options.h"
#include "farm/farm.h"
#include "farm/farm_task.h"
#include "live/session/passes_sources.h"
#include "live/session/session.h"
#include "show/show.h"

#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

struct BakeArguments {
    std::string show;
    std::vector<std::string> views;
    int spp = 16;
    int bounces = 0;
    int threads = 0;
    FarmOptions farm;
    std::string lights;
    bool surroundings = false;
    bool quiet = false;
    bool json = false;
};

double mega_rays(std::uint64_t rays, double seconds) {
    return seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0.0;
}

void print_json(const bake::BakeStats& stats, const Report& report) {
    nlohmann::json passes = nlohmann::json::array();
    for (const bake::BakedPass& pass : stats.passes)
        passes.push_back(
            {{"camera", pass.camera}, {"name", pass.name}, {"ms", pass.ms}, {"rays", pass.rays}});
    nlohmann::json messages = nlohmann::json::array();
    for (const Message& message : report.messages)
        messages.push_back({{"where", message.where}, {"what", message.what}});
    const nlohmann::json all = {{"cameras", stats.cameras},
                                {"baked", stats.passes.size()},
                                {"kept", stats.kept},
                                {"patched", stats.patched},
                                {"interrupted", stats.interrupted},
                                {"seconds", stats.seconds},
                                {"trace_seconds", stats.trace_seconds},
                                {"rays", stats.rays},
                                {"mrays_per_s", mega_rays(stats.rays, stats.trace_seconds)},
                                {"passes", passes},
                                {"messages", messages}};
    print_text("%s\n", all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
}

void print_table(const bake::BakeStats& stats) {
    for (const bake::BakedPass& pass : stats.passes)
        print_text("%-12s %-28s %8.0f ms\n", one_line(pass.camera).c_str(), one_line(pass.name).c_str(),
                   pass.ms);
    print_text("%zu passes baked, %d patched, %d kept, %d cameras, %.2f s", stats.passes.size(),
               stats.patched, stats.kept, stats.cameras, stats.seconds);
    if (stats.rays > 0)
        print_text(", tracing %.2f s, %.1f Mrays/s", stats.trace_seconds,
                   mega_rays(stats.rays, stats.trace_seconds));
    print_text("\n");
}

// For each camera its surroundings with its first lights, then the others by as many as are traced together.
// Nothing: all is there.
Result<std::optional<int>> run_on_farm(const BakeArguments& arguments, const scene::Show& show,
                                       const bake::BakeOptions& options) {
    namespace fs = std::filesystem;
    Report report; // the tasks say the same
    TRY(const std::vector<bake::CameraWork> works, bake::plan_bake(show, options, report));
    std::error_code code;
    FarmPlan plan;
    TRY(plan.build, farm_build());
    plan.from = fs::current_path(code);
    plan.show = fs::absolute(arguments.show, code);
    plan.inputs = farm_inputs(show, {});
    plan.words = words_without({{"--view", 1}, {"--json", 0}, {"--quiet", 0}});
    plan.words.push_back("--quiet");
    // All of a camera, done or not: the same command is the same plan, however far it is.
    for (const bake::CameraWork& work : works) {
        const auto add = [&](const std::string& what, int stage, std::vector<std::string> words) {
            words.insert(words.begin(), {"--view", work.camera});
            plan.tasks.push_back({what + " of " + work.camera, stage, std::move(words)});
        };
        add("surroundings and first lights", 0, {"--surroundings"});
        for (std::size_t first = bake::kBatch; first < work.lights; first += bake::kBatch) {
            const std::string range =
                std::to_string(first) + "-" + std::to_string(std::min(first + bake::kBatch, work.lights) - 1);
            add("lights " + range, 1, {"--lights", range});
        }
    }
    if (std::all_of(works.begin(), works.end(), [](const auto& work) { return work.is_done; }))
        return std::optional<int>();
    return std::optional(start_farm(std::move(plan), show, arguments.farm, arguments.quiet));
}

int run_bake(const BakeArguments& arguments) {
    if (arguments.quiet) set_log_level(LogLevel::warning);
    Report report;
    const Result<scene::Show> show = open_show(arguments.show, true, arguments.quiet, report);
    if (!show.ok()) {
        log_error(show.error().text());
        return 1;
    }
    std::error_code code;
    if (show->stage.instances.empty() && !show->stage_file.empty() &&
        std::filesystem::exists(show->cache_folder() / "passes", code)) {
        print_report(report);
        log_error(show->stage_file.string() +
                  ": the stage cannot be read; the passes that are there are kept");
        return 1;
    }
    catch_interrupts();
    Progress progress("baking", arguments.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    bake::BakeOptions options;
    options.views = arguments.views;
    options.spp = arguments.spp;
    options.bounces = arguments.bounces;
    options.threads = arguments.threads;
    if (arguments.surroundings) options.part = bake::BakePart{.surroundings = true};
    if (!arguments.lights.empty()) {
        std::size_t first = 0, last = 0;
        char end = 0;
        if (std::sscanf(arguments.lights.c_str(), "%4zu-%4zu%c", &first, &last, &end) != 2 || last < first) {
            log_error("--lights: '" + arguments.lights +
                      "' is not FIRST-LAST, two numbers of lights from 0 on");
            return 2;
        }
        options.part = bake::BakePart{.first_light = first, .last_light = last};
    }
    if (!arguments.farm.engine.empty()) {
        if (options.part) {
            log_error("--farm: a part is what a farm's task does");
            return 2;
        }
        const auto done = run_on_farm(arguments, *show, options);
        if (!done.ok()) log_error(done.error().text());
        if (!done.ok()) return 1;
        if (*done) return **done;
    }
    options.stop = interrupted;
    options.now_s = steady_now_s;
    options.progress = [&](double share, const std::string& note) {
        progress.update(share, steady_now_s(), note);
    };
    const Result<bake::BakeStats> stats = bake::bake_show(*show, options, report);
    progress.finish();
    print_report(report);
    if (!stats.ok()) {
        log_error(stats.error().text());
        return 1;
    }
    // So that renders and windows need not ask the bake again.
    if (!stats->interrupted && !report.lost_anything() && !options.part) {
        const std::string sources = passes_fingerprint(*show);
        for (const scene::Camera& camera : show->cameras) {
            const bool is_meant = arguments.views.empty() ||
                                  std::find(arguments.views.begin(), arguments.views.end(), camera.name) !=
                                      arguments.views.end();
            if (!is_meant || !camera.foreign_passes.empty()) continue;
            if (const Result<void> written = remember_sources(*show, camera.name, sources); !written.ok())
                log_warning(written.error().text());
        }
    }
    if (arguments.json)
        print_json(*stats, report);
    else if (!arguments.quiet)
        print_table(*stats);
    if (stats->interrupted) {
        log_warning(
            "interrupted; " + std::to_string(stats->passes.size() + static_cast<std::size_t>(stats->kept)) +
            " passes are finished and kept (they come by eights), the same command goes on from there");
        return 1;
    }
    if (!report.lost_anything()) return 0;
    log_error(show->file.string() + ": " + kMadeButMissing);
    return 1;
}

} // namespace

void add_bake(CLI::App& app, int& exit_code) {
    CLI::App* command =
        app.add_subcommand("bake", "trace the passes of a show: one picture per light and camera");
    const auto arguments = std::make_shared<BakeArguments>();
    command->add_option("SHOW", arguments->show, "folder with show.toml, or an .mvr")->required();
    command->add_option("--view", arguments->views, "only this camera (may be repeated)")->type_name("NAME");
    command->add_option("--spp", arguments->spp, "samples per pixel")
        ->check(CLI::Range(1, bake::kMaxSpp))
        ->capture_default_str();
    command
        ->add_option("--bounces", arguments->bounces,
                     "bounces of indirect light, kept in pictures of their own")
        ->check(CLI::Range(0, bake::kMaxBounces))
        ->capture_default_str();
    command->add_option("--threads", arguments->threads, "processor threads (0: one per core)")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    CLI::Option* const surroundings =
        command->add_flag("--surroundings", arguments->surroundings,
                          "a part: what a camera's pictures share, and its first " +
                              std::to_string(bake::kBatch) + " lights; a bake afterwards finds them");
    command
        ->add_option("--lights", arguments->lights,
                     "a part: these of a camera's lights, whose surroundings are there; the first is 0")
        ->type_name("FIRST-LAST")
        ->excludes(surroundings);
    add_farm_options(*command, arguments->farm);
    command->add_flag("--quiet", arguments->quiet, "print warnings and errors only");
    command->add_flag("--json", arguments->json, "print the figures as JSON");
    command->footer("Example: ghostlight bake assets/demo --view house");
    command->callback([arguments, &exit_code] { exit_code = run_bake(*arguments); });
}

} // namespace ghost::app
