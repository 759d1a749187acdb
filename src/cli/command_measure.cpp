// SPDX-License-Identifier: Apache-2.0
// ghostlight measure: lux along a line or over an area of the stage, as a light meter would read them.
#include "base/interrupt.h"
#include "cli/commands.h"
#include "cli/options/bounce_option.h"
#include "cli/options/number_option.h"
#include "live/lux/light_meter.h"
#include "live/lux/lux_sheet.h"
#include "live/session/bounce_light.h"
#include "live/session/show_moment.h"

#include "base/log.h"
#include "base/print.h"
#include "base/progress.h"
#include "base/steady_time.h"
#include "disk/files.h"

#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

namespace ghost::app {
namespace {

namespace fs = std::filesystem;

constexpr double kFar_m = 10000;
constexpr int kMeterSteps_hz = 30; // as render steps, so that a strobe is where the picture has it

struct MeasureOptions {
    SessionOptions session;
    std::string replay;
    double at_s = 0;
    std::vector<float> line, area, towards;
    double step_m = 0.5;
    std::string out;
    bool json = false;
};

Result<LuxGrid> grid_of(const MeasureOptions& options) {
    const auto place = [](const std::vector<float>& numbers, std::size_t first) {
        return glm::vec3(numbers[first], numbers[first + 1], numbers[first + 2]);
    };
    const auto step_m = static_cast<float>(options.step_m);
    if (!options.line.empty()) return line_grid(place(options.line, 0), place(options.line, 3), step_m);
    const std::vector<float>& area = options.area; // two corners and a height
    return area_grid({area[0], area[1], area[4]}, {area[2], area[3], area[4]}, step_m);
}

Result<void> check_ending(const std::string& out) {
    const fs::path ending = fs::path(out).extension();
    if (out.empty() || ending == ".csv" || ending == ".svg") return {};
    return Error{"expected a name that ends with .csv or .svg", out};
}

Result<void> measure(const MeasureOptions& options, LuxGrid& grid) {
    Report report;
    TRY(const auto moment, ShowMoment::open(options.session, options.replay, {}, report));
    moment->step_to(options.at_s, kMeterSteps_hz, report);
    const bake::Tracer tracer(moment->stage());
    const std::vector<shared::Light> lights = moment->lights();
    const Atmosphere air = atmosphere_of(moment->show());
    TRY(const auto bounced,
        bounced_now(moment->show(), moment->stage(), options.session.bounce.value_or(moment->show().bounce),
                    moment->rig(), moment->gobos(), air.medium(), options.session.quiet));
    const bake::DenormalsOff mode;
    bake::Surface meter;
    meter.instance = 0;
    meter.facet_normal = meter.normal =
        options.towards.empty()
            ? glm::vec3(0, 0, 1)
            : glm::normalize(glm::vec3(options.towards[0], options.towards[1], options.towards[2]));
    Progress progress("measuring",
                      options.session.quiet ? Progress::Style::silent : Progress::style_for_stderr(),
                      steady_now_s());
    for (const glm::vec3& at_m : grid.points_m) {
        if (interrupted()) return Error{"interrupted", ""};
        meter.position = meter.shadow_origin = at_m;
        const Lux lux = lux_at(meter, lights, air, moment->gobos(), &tracer, bounced.get());
        grid.lux.push_back(lux.all);
        if (bounced) grid.bounced_lux.push_back(lux.bounced);
        progress.update(static_cast<double>(grid.lux.size()) / static_cast<double>(grid.points_m.size()),
                        steady_now_s(), "");
    }
    progress.finish();
    return {};
}

Result<void> run(const MeasureOptions& options) {
    if (options.line.empty() == options.area.empty())
        return Error{"expected either --line or --area", "measure"};
    if (!options.towards.empty() && options.towards == std::vector<float>{0, 0, 0})
        return Error{"expected a direction, not 0 0 0", "--towards"};
    TRY_VOID(check_ending(options.out));
    TRY(LuxGrid grid, grid_of(options));
    TRY_VOID(measure(options, grid));
    const LuxSummary all = summary_of(grid);
    if (options.out.ends_with(".csv")) TRY_VOID(write_file_atomic(options.out, lux_csv(grid)));
    if (options.out.ends_with(".svg")) {
        const std::string title = fs::path(options.session.show).filename().string() + " at " +
                                  std::to_string(options.at_s).substr(0, 6) + " s";
        TRY_VOID(write_file_atomic(options.out, lux_svg(grid, title)));
    }
    const auto place = [](const glm::vec3& at_m) { return std::array{at_m.x, at_m.y, at_m.z}; };
    nlohmann::json figures = {{"points", grid.lux.size()},
                              {"mean_lux", all.mean},
                              {"least_lux", all.least},
                              {"least_at_m", place(all.least_at_m)},
                              {"most_lux", all.most},
                              {"most_at_m", place(all.most_at_m)},
                              {"least_over_mean", all.uniformity()},
                              {"least_over_most", all.diversity()}};
    if (!grid.bounced_lux.empty()) figures["mean_bounced_lux"] = all.mean_bounced;
    if (options.json) {
        print_text("%s\n", figures.dump().c_str());
        return {};
    }
    print_text(
        "%zu points\nmean   %10.2f lx\nleast  %10.2f lx at (%.2f, %.2f, %.2f)\nmost   %10.2f lx at (%.2f, "
        "%.2f, %.2f)\nleast/mean %.3f, least/most %.3f\n",
        grid.lux.size(), static_cast<double>(all.mean), static_cast<double>(all.least),
        static_cast<double>(all.least_at_m.x), static_cast<double>(all.least_at_m.y),
        static_cast<double>(all.least_at_m.z), static_cast<double>(all.most),
        static_cast<double>(all.most_at_m.x), static_cast<double>(all.most_at_m.y),
        static_cast<double>(all.most_at_m.z), static_cast<double>(all.uniformity()),
        static_cast<double>(all.diversity()));
    if (!grid.bounced_lux.empty())
        print_text("of the mean %.2f lx bounced\n", static_cast<double>(all.mean_bounced));
    return {};
}

} // namespace

void add_measure(CLI::App& app, int& exit_code) {
    CLI::App* command = app.add_subcommand(
        "measure", "lux along a line or over an area of the stage, as a light meter would read them");
    auto a = std::make_shared<MeasureOptions>();
    command->add_option("show", a->session.show, "show folder or show.toml")->required()->type_name("SHOW");
    command->add_option("--at", a->at_s, "second of the recording")->check(number_in(0, kLongest_s));
    command->add_option("--replay", a->replay, "another recording than the show's")->type_name("FILE");
    CLI::Option* line = command->add_option("--line", a->line, "from one place to another, in metres")
                            ->expected(6)
                            ->type_name("X Y Z X Y Z")
                            ->check(number_in(-kFar_m, kFar_m));
    command->add_option("--area", a->area, "two corners, and the height of what is measured, in metres")
        ->expected(5)
        ->type_name("X Y X Y Z")
        ->check(number_in(-kFar_m, kFar_m))
        ->excludes(line);
    command->add_option("--step", a->step_m, "metres from one point to the next")
        ->check(number_in(0.001, 1000))
        ->capture_default_str();
    command->add_option("--towards", a->towards, "where the meter looks (default: up)")
        ->expected(3)
        ->type_name("X Y Z")
        ->check(number_in(-kFar_m, kFar_m));
    add_bounce_option(*command, a->session.bounce);
    command->add_option("-o,--out", a->out, "a table (.csv) or a sheet to print (.svg)")->type_name("FILE");
    command->add_flag("--json", a->json, "the summary as JSON");
    command->add_flag("-q,--quiet", a->session.quiet, "no progress");
    command->footer(
        "Example: ghostlight measure assets/demo --at 36 --area -6 -2 6 6 1.2 --step 1 -o stage.svg");
    command->callback([a, &exit_code] {
        const auto done = run(*a);
        if (!done.ok()) log_error(done.error().text());
        exit_code = done.ok() ? 0 : 1;
    });
}

} // namespace ghost::app
