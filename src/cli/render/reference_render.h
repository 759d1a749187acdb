#pragma once
// SPDX-License-Identifier: Apache-2.0
// render --reference: one moment of a show by brute force on the CPU (reference/reference.h), for any camera.
// What the fast renderers are judged by; takes minutes. No Vulkan device, no passes, no distance maps. PNG
// (at the camera's EV100, as every picture is developed) or EXR (linear Rec.2020, cd/m^2). Main thread;
// errors: unreadable show or recording, interrupted (then no file is written).

#include "base/result.h"
#include "dmx/record/capture.h"
#include "live/session/session.h"

#include <string>

namespace ghost::app {

struct ReferenceArguments {
    bool wanted = false;
    int samples = 4096;          // along each camera ray, per light
    int pixel_samples = 4;       // per axis of a pixel
    int lens_samples = 1;        // of the lens that throws the shadows; 1: a point
    int bounces = 0;             // orders of bounced light beside the direct one (reference/light_walk.h)
    int order = -1;              // that order alone, 0: direct light; below 0: all of them
    double particles_m = 20;     // millions, for bounced light
    std::string error_out;       // .exr: standard deviation of each pixel's bounced light; empty: none
    dmx::CaptureOptions capture; // how replay is read where it is a capture
};

// replay: recording, empty: the show's own. at_s: second of it, stepped through from its start at fps.
Result<void> render_reference(const SessionOptions& options, const ReferenceArguments& arguments,
                              const std::string& replay, double at_s, int fps, const std::string& out);

} // namespace ghost::app
