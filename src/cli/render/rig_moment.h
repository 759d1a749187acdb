#pragma once
// SPDX-License-Identifier: Apache-2.0
// What all fixtures of a show do at one moment, at rest: in a cue, in a look, at a second of the recording,
// or when nothing is sent. Without a device. Main thread.

#include "base/report.h"
#include "base/result.h"
#include "fixture/state.h"
#include "print/print_style.h"
#include "show/mover_motion.h"

#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {
struct Show; // show/show.h
}

namespace ghost::app {

struct RigMomentOptions {
    std::string cue, look;      // by name
    std::optional<double> at_s; // of the show's recording; at most one of the three
    bool quiet = false;
};

struct RigMoment {
    std::vector<fixture::State> states; // one for each fixture
    scene::MoverMotion movers;          // where they are; refers to the show's
    std::string said;                   // "As in cue 'Blue'."
};

// Error: no such cue or look, a recording that cannot be read.
Result<RigMoment> moment_of(const scene::Show& show, const RigMomentOptions& options,
                            const scene::PrintStyle& style, Report& report);

} // namespace ghost::app
