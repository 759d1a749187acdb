// SPDX-License-Identifier: Apache-2.0
#include "base/interrupt.h"
#include "bench/tables.h"
#include "bench/window/window_tables.h"
#include "cli/commands.h"
#include "cli/options/number_option.h"

#include "base/log.h"
#include "base/print.h"
#include "disk/own_program.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

namespace ghost::app {
namespace {

// As docs/measurements/performance.md has them.
std::vector<BenchTable> all_tables() {
    std::vector<BenchTable> all(tables().begin(), tables().end());
    all.push_back({"window", "The window with a desk at 44 Hz", bench_window});
    all.push_back({"web", "Browsers that look on", bench_web});
    all.push_back({"start", "Start-up", bench_start});
    return all;
}

struct BenchArguments {
    BenchOptions options;
    std::string table;
    bool json = false;
};

int run_bench(const BenchArguments& arguments) {
    set_log_level(LogLevel::warning);
    int exit_code = 0;
    for (const BenchTable& table : all_tables()) {
        if (interrupted()) break;
        if (!arguments.table.empty() && arguments.table != table.name) continue;
        if (!arguments.json) print_text("\n%s: %s\n", table.name, table.title);
        const Result<void> done = run_table(table.run, arguments.options,
                                            [&](const BenchRow& row) { print_row(row, arguments.json); });
        if (done.ok()) continue;
        log_error(std::string(table.name) + ": " + done.error().text());
        exit_code = 1;
    }
    return exit_code;
}

} // namespace

void add_bench(CLI::App& app, int& exit_code) {
    CLI::App* command =
        app.add_subcommand("bench", "measure the published tables (docs/measurements/performance.md)");
    const auto a = std::make_shared<BenchArguments>();
    std::vector<std::string> names;
    for (const BenchTable& table : all_tables()) names.emplace_back(table.name);
    command->add_option("NAME", a->table, "only this table")->check(CLI::IsMember(names));
    command
        ->add_option("--show", a->options.show,
                     "show of the tables paper, live, bake, quality, window, web and start")
        ->capture_default_str();
    command->add_option("--frames", a->options.frames, "frames measured per row")
        ->check(CLI::Range(5, 10000))
        ->capture_default_str();
    command
        ->add_option("--row-seconds", a->options.row_seconds,
                     "rows of the table scale that would take longer are skipped, by name")
        ->check(number_in(1.0, 86400.0))
        ->capture_default_str();
    command
        ->add_option("--soak", a->options.soak_seconds,
                     "with network or window: an even load for so many seconds, one row a minute, instead of "
                     "the table; an error unless memory stayed flat and, with network, every packet came")
        ->check(number_in(1.0, 86400.0 * 7));
    command
        ->add_option("--desks", a->options.desk_seconds,
                     "with network: two desks of 512 universes each at 44 Hz for so many seconds, instead of "
                     "the table")
        ->check(number_in(1.0, 3600.0))
        ->type_name("SECONDS");
    command->add_flag("--power", a->options.power,
                      "with bounce: light by order, solved and by particles, instead of the table");
    command
        ->add_option("--pictures", a->options.pictures,
                     "with pictures or moments: a folder that they are written into")
        ->type_name("FOLDER");
    command
        ->add_option("--plot", a->options.plot,
                     "with window: a plot (MVR) that is opened, too, without a desk")
        ->type_name("FILE");
    command->add_option("--device", a->options.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    command->add_flag("--json", a->json, "one line of JSON per row");
    command->footer("Example: ghostlight bench paper --json\n"
                    "         ghostlight bench window --soak 3600");
    command->callback([a, &exit_code] {
        if (a->options.soak_seconds > 0 && a->table != "network" && a->table != "window") {
            log_error(
                "--soak: belongs to the tables network and window: ghostlight bench network --soak 3600");
            exit_code = 2;
            return;
        }
        if (a->options.desk_seconds > 0 && a->table != "network") {
            log_error("--desks: belongs to the table network: ghostlight bench network --desks 60");
            exit_code = 2;
            return;
        }
        if (!a->options.pictures.empty() && a->table != "pictures" && a->table != "moments") {
            log_error("--pictures: belongs to the tables pictures and moments: ghostlight bench moments "
                      "--pictures moments");
            exit_code = 2;
            return;
        }
        if (!a->options.plot.empty() && a->table != "window") {
            log_error("--plot: belongs to the table window: ghostlight bench window --plot tour.mvr");
            exit_code = 2;
            return;
        }
        if (a->options.power && a->table != "bounce") {
            log_error("--power: belongs to the table bounce: ghostlight bench bounce --power");
            exit_code = 2;
            return;
        }
        a->options.program = own_program().string();
        exit_code = run_bench(*a);
    });
}

} // namespace ghost::app
