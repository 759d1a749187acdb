#pragma once
// SPDX-License-Identifier: Apache-2.0
// Makes the distance maps of a show (passes/distance_maps.h) and keeps them in .ghost/distances/SIZE/. Only
// what changed is made: a light that moved, and those that see an object that was shown, hidden or moved.
// Each finished map is on disk before it counts, so an interrupted update goes on where it was. Runs on any
// thread; uses all cores.

#include "base/report.h"
#include "base/result.h"
#include "passes/distance_maps.h"
#include "show/show.h"
#include "stage/stage.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace ghost::bake {

struct DistanceMapOptions {
    int size = scene::kDistanceMapSize;
    int threads = 0;               // 0: one per core
    std::function<bool()> stop;    // asked from any thread; true: keep what is finished and return
    std::function<double()> now_s; // clock of the figures; none: they stay 0
    // Fraction of the work done and what is being done; never two calls at once.
    std::function<void(double fraction, const std::string& note)> progress;
    // A map was made; index: its place among all maps of the show. From any thread, never two calls at once.
    std::function<void(std::size_t index, const scene::DistanceMap& map)> on_map;
};

struct DistanceMapStats {
    int made = 0;
    int kept = 0;
    std::uint64_t rays = 0;
    double seconds = 0;
    double trace_seconds = 0; // without finding out what is to be made
    bool interrupted = false;
};

// maps: all maps in the order of show.fixtures and their stops; after an interruption those that are right,
// without the others. It is written once, at the end. A folder that cannot be written costs a warning, the
// maps are made all the same. Error: a size beyond the limits.
Result<DistanceMapStats> update_distance_maps(const scene::Show& show, const scene::Stage& stage,
                                              const DistanceMapOptions& options, scene::DistanceMaps& maps,
                                              Report& report);

} // namespace ghost::bake
