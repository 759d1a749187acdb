// SPDX-License-Identifier: Apache-2.0
#include "app/commands.h"
namespace ghost::app {
void add_bench(CLI::App& app, int& exit_code) { (void)app; (void)exit_code; }
}
