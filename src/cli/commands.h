#pragma once
// SPDX-License-Identifier: Apache-2.0
// The commands. Each add_ function adds one subcommand to the command line; its callback runs the command and
// sets exit_code: 0 done, 1 the input was at fault, 2 wrong usage.

#include <CLI/CLI.hpp>

namespace ghost::app {

void add_bake(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);
void add_book(CLI::App& app, int& exit_code);
void add_capture(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_farm(CLI::App& app, int& exit_code);
void add_import(CLI::App& app, int& exit_code);
void add_measure(CLI::App& app, int& exit_code);
void add_monitor(CLI::App& app, int& exit_code);
void add_open(CLI::App& app, int& exit_code);
void add_paper(CLI::App& app, int& exit_code);
void add_play(CLI::App& app, int& exit_code);
void add_record(CLI::App& app, int& exit_code);
void add_render(CLI::App& app, int& exit_code);
void add_serve(CLI::App& app, int& exit_code);
void add_sheet(CLI::App& app, int& exit_code);
void add_tour(CLI::App& app, int& exit_code);
void add_xchange(CLI::App& app, int& exit_code);

} // namespace ghost::app
