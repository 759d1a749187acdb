#pragma once
// SPDX-License-Identifier: Apache-2.0
// Bakes the passes of a show into its .ghost folder, for load_passes. Only what changed is baked (keys.h);
// every finished batch of lights is on disk before the next begins, so an interrupted bake goes on where it
// was. All cores.
//
// What moving a fixture costs: its own pass is baked again; where its body is in sight, the pixels around the
// old and the new place are traced again for all passes, which gives the same bytes as a bake from scratch.

#include "base/report.h"
#include "base/result.h"
#include "show/show.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ghost::bake {

// What a task of a farm bakes of its one camera: pictures only, never the manifest. A bake afterwards finds
// them, and writes it.
struct BakePart {
    bool surroundings = false; // and the first kBatch lights, which share their rays
    std::size_t first_light = 0;
    std::size_t last_light = 0;
};

struct BakeOptions {
    std::vector<std::string> views; // names of cameras; empty: all
    int spp = 16;                   // samples per pixel, 1..1024
    int bounces = 0;                // 0..16
    int threads = 0;                // 0: one per core
    std::optional<BakePart> part;   // of a single camera in views; else all
    std::function<bool()> stop;     // asked from any thread; true: keep what is finished and return
    std::function<double()> now_s;  // clock of the figures; none: they stay 0
    // Fraction of the work done and what is being done; never two calls at once.
    std::function<void(double fraction, const std::string& note)> progress;
};

struct BakedPass {
    std::string camera;
    std::string name; // of the fixture and stop, or "surroundings": positions, normals, albedo, depth,
                      // ambient, emission
    double ms = 0;    // of tracing; lights are traced several at a time and share it
    std::uint64_t rays = 0;
};

struct BakeStats {
    std::vector<BakedPass> passes; // baked now
    int kept = 0;                  // passes that were up to date
    int patched = 0;               // passes where only the pixels round a moved body were traced
    int cameras = 0;
    bool interrupted = false;
    double seconds = 0;
    double trace_seconds = 0;
    std::uint64_t rays = 0;
};

// Errors: an unknown camera, a file that cannot be written. What was lost on the way (a fixture without a
// type) is in report.
Result<BakeStats> bake_show(const scene::Show& show, const BakeOptions& options, Report& report);

// What bake_show would have to do.
struct CameraWork {
    std::string camera;
    std::size_t lights = 0; // all of them
    bool is_done = false;
};
Result<std::vector<CameraWork>> plan_bake(const scene::Show& show, const BakeOptions& options,
                                          Report& report);

// From here on this many threads bake and make maps, whatever a call asks for, while the program lives.
// 0: one per core.
void limit_threads(int threads);

// Lights traced together share the camera rays. More would save little and lose more work when interrupted.
inline constexpr std::size_t kBatch = 8;

} // namespace ghost::bake
