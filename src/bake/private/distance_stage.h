#pragma once
// SPDX-License-Identifier: Apache-2.0
// What distance maps depend on: a key of the shape, holes and place of each instance, and its bounds.
// Colours, normals and fixture bodies change nothing. Pure.

#include "passes/distance_maps_file.h"
#include "stage/stage.h"

#include <string>
#include <vector>

namespace ghost::bake {

struct StageForDistances {
    scene::DistanceStage stage;    // also_right is empty
    std::vector<std::string> keys; // per instance of the stage; empty: it stops no light
};

// Names in the report what cannot be placed: a matrix that holds no numbers or leads out of the world.
StageForDistances stage_for_distances(const scene::Stage& stage, Report& report);

} // namespace ghost::bake
