#pragma once
// SPDX-License-Identifier: Apache-2.0
// [[model]] of show.toml: models that stand on the stage beside the one of [show], or of the plot: a piano, a
// riser, a set piece. Metres, degrees, Z up.

#include "base/report.h"
#include "stage/stage.h"

#include <string>

namespace ghost::scene {

struct Show;

// Says which of them are not there.
void check_models(const Show& show, Report& report);

// Their objects behind those that are there already. One that cannot be read is left out, with a message.
void add_models(const Show& show, Stage& stage, Report& report);

} // namespace ghost::scene
