#pragma once
// SPDX-License-Identifier: Apache-2.0
// [[model]] of show.toml: models that stand on the stage beside the one of [show], or of the plot: a piano, a
// riser, a set piece. Metres, degrees, Z up.

#include "scene/report.h"
#include "scene/show.h"
#include "scene/toml_reader.h"

#include <string>

namespace ghost::scene {

// Show::models. One without a file is left out, with a message.
void read_models(TableReader& top, const std::string& file, Show& show, Report& report);

// Says which of them are not there.
void check_models(const Show& show, Report& report);

// Their objects behind those that are there already. One that cannot be read is left out, with a message.
void add_models(const Show& show, Stage& stage, Report& report);

} // namespace ghost::scene
