// SPDX-License-Identifier: Apache-2.0
#include "base/log.h"
#include "base/progress.h"
#include "cli/commands.h"
#include "cli/options/number_option.h"
#include "stage/model_reader.h"

#include <exception>
#include <iostream>
#include <new>
#include <string_view>

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == ghost::scene::kReadModels)
        return ghost::scene::serve_models();
    CLI::App app{
        "Ghostlight: a concert-lighting visualiser. It draws a stage as a real lighting desk drives it.",
        "ghostlight"};
    app.require_subcommand(1);
    app.footer("Example: ghostlight render assets/demo -o demo.png --at 20");
    double progress_every_s = 5;
    app.add_option("--progress-every", progress_every_s,
                   "seconds between lines of progress where standard error is no terminal")
        ->check(ghost::app::number_in(0.05, 3600.0))
        ->capture_default_str()
        ->each([](const std::string& seconds) { ghost::Progress::set_lines_every(std::stod(seconds)); });
    app.set_version_flag("--version", "ghostlight 0.1.0");
    int exit_code = 0;
    ghost::app::add_bake(app, exit_code);
    ghost::app::add_bench(app, exit_code);
    ghost::app::add_book(app, exit_code);
    ghost::app::add_capture(app, exit_code);
    ghost::app::add_check(app, exit_code);
    ghost::app::add_compare(app, exit_code);
    ghost::app::add_explain(app, exit_code);
    ghost::app::add_export(app, exit_code);
    ghost::app::add_farm(app, exit_code);
    ghost::app::add_import(app, exit_code);
    ghost::app::add_measure(app, exit_code);
    ghost::app::add_monitor(app, exit_code);
    ghost::app::add_open(app, exit_code);
    ghost::app::add_paper(app, exit_code);
    ghost::app::add_play(app, exit_code);
    ghost::app::add_record(app, exit_code);
    ghost::app::add_render(app, exit_code);
    ghost::app::add_serve(app, exit_code);
    ghost::app::add_sheet(app, exit_code);
    ghost::app::add_tour(app, exit_code);
    ghost::app::add_xchange(app, exit_code);
    app.failure_message([](const CLI::App* where, const CLI::Error& error) {
        return "error: " + CLI::FailureMessage::simple(where, error);
    });
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // CLI11 has a code of its own per fault; ours are 0 done (help, version) and 2 wrong usage.
        return app.exit(error) == 0 ? 0 : 2;
    } catch (const std::bad_alloc&) {
        ghost::log_error(
            "out of memory: the picture (--size), the stage or the rig is too large for this machine");
        return 1;
    } catch (const std::exception& error) {
        ghost::log_error(std::string("unexpected: ") + error.what());
        return 1;
    }
    return exit_code;
}
