#pragma once
// SPDX-License-Identifier: Apache-2.0
// A moment of a show's recording without a device: its stage with bodies, what the rig does, every beam a
// light of its own. What render --reference and the tables of bounced light begin with. Main thread.

#include "base/result.h"
#include "dmx/record/capture.h"
#include "dmx/record/player.h"
#include "light/bodies.h"
#include "light/gobos.h"
#include "light/rig.h"
#include "live/session/session.h"
#include "show/show.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::app {

class ShowMoment {
public:
    // replay: recording, empty: the show's own. Errors: unreadable show or recording. What the show asks for
    // and is not there is in the report, and printed.
    static Result<std::unique_ptr<ShowMoment>> open(const SessionOptions& options, const std::string& replay,
                                                    const dmx::CaptureOptions& capture, Report& report);

    // Moments come in order: the rig is stepped through the recording from its start, as a film is.
    // What its moving pictures lack goes to the report.
    void step_to(double at_s, int fps, Report& report);

    const scene::Show& show() const { return *show_; }
    scene::Rig& rig() { return *rig_; }
    const scene::GoboStack& gobos() const { return gobos_; }
    const scene::Stage& stage() const { return stage_; } // heads turned as they are now
    std::vector<shared::Light> lights() const;

private:
    ShowMoment() = default;

    std::unique_ptr<scene::Show> show_; // the rig keeps its address
    scene::GoboStack gobos_;
    scene::Stage stage_;
    std::vector<scene::CarriedObject> carried_;
    std::unique_ptr<scene::Rig> rig_;
    std::optional<dmx::Player> player_;
    long next_ = 0; // frame
};

} // namespace ghost::app
