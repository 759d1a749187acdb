// SPDX-License-Identifier: Apache-2.0
// ghostlight-bench: what a machine's graphics make of Ghostlight, without window, films and network. It runs
// in the folder that holds assets/, which is its own one where that has them.
#include "base/log.h"
#include "base/print.h"
#include "bench/report.h"
#include "bench/tables.h"
#include "stage/model_reader.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <string_view>

namespace {

namespace app = ghost::app;
namespace fs = std::filesystem;

// Of the folder that was unpacked somewhere: shows, fixtures and goldens lie beside the program.
void work_beside(const fs::path& program, fs::path& out) {
    std::error_code code;
    const fs::path folder = program.parent_path();
    if (!fs::exists(folder / "assets/demo/show.toml", code)) return;
    out = fs::absolute(out, code);
    fs::current_path(folder, code);
}

int run_tables(const std::vector<std::string>& wanted, const app::BenchOptions& options) {
    int exit_code = 0;
    for (const app::BenchTable& table : app::tables()) {
        if (std::find(wanted.begin(), wanted.end(), table.name) == wanted.end()) continue;
        const auto done =
            app::run_table(table.run, options, [](const app::BenchRow& row) { app::print_row(row, true); });
        if (done.ok()) continue;
        ghost::log_error(std::string(table.name) + ": " + done.error().text());
        exit_code = 1;
    }
    return exit_code;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == ghost::scene::kReadModels)
        return ghost::scene::serve_models();
    CLI::App program{
        "ghostlight-bench: measures this machine's graphics and writes a report, or prints tables as JSON",
        "ghostlight-bench"};
    app::ReportOptions report;
    app::BenchOptions& options = report.bench;
    std::string out = "ghostlight-report";
    std::vector<std::string> wanted, names;
    for (const app::BenchTable& table : app::tables()) names.emplace_back(table.name);
    program.add_option("TABLE", wanted, "only these; without -o they are printed as JSON instead")
        ->check(CLI::IsMember(names));
    program.add_option("-o,--out", out, "folder of the report")->take_last()->capture_default_str();
    program.add_flag("--quick", report.quick, "the most important tables only, with fewer frames");
    program.add_option("--show", options.show, "show of most tables")->capture_default_str();
    program.add_option("--frames", options.frames, "frames measured per row")
        ->check(CLI::Range(5, 10000))
        ->capture_default_str();
    program
        .add_option("--row-seconds", options.row_seconds,
                    "rows of the table scale that would take longer are skipped, by name")
        ->check(CLI::Range(1.0, 86400.0))
        ->capture_default_str();
    program.add_option("--device", options.device, "Vulkan device: part of its name, or its number")
        ->type_name("NAME");
    program.add_option("--only", options.only, "with scale: rows with this in their names");
    program.add_option("--shaders", options.shaders,
                       "with scale: a folder of shaders (.spv) instead of those built in");
    program
        .add_option("--compile-for", options.compile_for,
                    "with shaders: a device that compiles and need not draw")
        ->type_name("NAME");
    program
        .add_option("--lights-per-dispatch", options.lights_per_dispatch,
                    "with shaders: 1, 128, or 0 for what suits the device")
        ->check(CLI::IsMember({0, 1, 128}))
        ->capture_default_str();
    program.add_option("--pictures", options.pictures,
                       "with pictures and moments: a folder that they are written into");
    program.add_option("--against", options.against,
                       "a folder of pictures that another device drew; goldens/ where that is there");
    program.set_version_flag("--version", "ghostlight-bench 0.1.0");
    program.footer(
        "Example: ghostlight-bench -o my-gpu\n         ghostlight-bench scale --only \"400 lights\"");
    program.failure_message([](const CLI::App* where, const CLI::Error& error) {
        return "error: " + CLI::FailureMessage::simple(where, error);
    });
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2; // as ghostlight does
    }
    ghost::set_log_level(ghost::LogLevel::warning);
    std::error_code code;
    options.program = fs::read_symlink("/proc/self/exe", code).string();
    report.out = out;
    work_beside(options.program, report.out);
    if (options.against.empty() && fs::exists("goldens", code)) options.against = "goldens";
    if (!wanted.empty() && program.count("--out") == 0) return run_tables(wanted, options);
    report.tables = wanted;
    const ghost::Result<void> done = app::write_report(report);
    if (!done.ok()) {
        ghost::log_error(done.error().text());
        return 1;
    }
    ghost::print_text("%s\n", (fs::absolute(report.out, code) / "report.html").c_str());
    return 0;
}
