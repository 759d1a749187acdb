// SPDX-License-Identifier: Apache-2.0
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/passes_sources.h"
#include "app/session.h"
#include "bake/bake_show.h"
#include "bake/frame.h"
#include "scene/show.h"

#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ghost::app {
namespace {

struct BakeArguments {
    std::string show;
    std::vector<std::string> views;
    int spp = 16;
    int bounces = 0;
    bool quiet = false;
    bool json = false;
};

double mega_rays(std::uint64_t rays, double seconds) {
    return seconds > 0 ? static_cast<double>(rays) / seconds * 1e-6 : 0.0;
}

void print_json(const bake::BakeStats& stats, const scene::Report& report) {
    nlohmann::json passes = nlohmann::json::array();
    for (const bake::BakedPass& pass : stats.passes)
        passes.push_back(
            {{"camera", pass.camera}, {"name", pass.name}, {"ms", pass.ms}, {"rays", pass.rays}});
    nlohmann::json messages = nlohmann::json::array();
    for (const scene::Message& message : report.messages)
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
        print_text("%-12s %-28s %8.0f ms\n", pass.camera.c_str(), pass.name.c_str(), pass.ms);
    print_text("%zu passes baked, %d patched, %d kept, %d cameras, %.2f s", stats.passes.size(),
               stats.patched, stats.kept, stats.cameras, stats.seconds);
    if (stats.rays > 0)
        print_text(", tracing %.2f s, %.1f Mrays/s", stats.trace_seconds,
                   mega_rays(stats.rays, stats.trace_seconds));
    print_text("\n");
}

int run_bake(const BakeArguments& arguments) {
    if (arguments.quiet) set_log_level(LogLevel::warning);
    scene::Report report;
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
    if (!stats->interrupted && !report.lost_anything()) {
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
    return report.lost_anything() ? 1 : 0;
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
    command->add_flag("--quiet", arguments->quiet, "print warnings and errors only");
    command->add_flag("--json", arguments->json, "print the figures as JSON");
    command->footer("Example: ghostlight bake assets/demo --view house");
    command->callback([arguments, &exit_code] { exit_code = run_bake(*arguments); });
}

} // namespace ghost::app
