#pragma once
// SPDX-License-Identifier: Apache-2.0
// The bodies of fixtures (yokes, heads) in a stage made by stage_with_bodies: which of its instances move,
// and where they are for what a rig does now. World metres. Pure functions; show, stage and rig belong
// together.

#include "base/report.h"
#include "fixture/type.h"
#include "light/rig.h"
#include "stage/stage.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

struct Show;

enum class HiddenObjects { left_out, kept };

// The stage as the show wants it: its [[object]] entries applied, all fixture bodies hung at their home pose
// (first stop) and marked with their fixture's index. Hidden objects are left out, or kept with shown = false
// for a view that can show them again.
Stage stage_with_bodies(const Show& show, Report& report, HiddenObjects hidden = HiddenObjects::left_out);

// Indices of the instances that may move: parts that a pan or tilt axis turns, and every part of a fixture
// that travels along a track or that a mover carries. A base that stands still is none of them.
std::vector<std::size_t> moving_instances(const Show& show, const Stage& stage);

// Reads all meshes of a fixture file as drawing it would, and says what is wrong with them.
void check_models(const fixture::Type& type, const std::string& file, Report& report);

// World matrix of an instance that is part of a body (Instance::part), as the rig has turned it.
glm::mat4 body_to_world(const Show& show, const Rig& rig, const Instance& instance);

// Places all moving instances of the stage.
void pose_bodies(const Show& show, const Rig& rig, Stage& stage);

// Objects of a stage that movers carry, with the world matrices that the stage has for them.
struct CarriedObject {
    std::size_t instance = 0;
    int mover = kNoMover;
    glm::mat4 home{1.0f};
};
std::vector<CarriedObject> carried_objects(const Show& show, const Stage& stage);
void pose_objects(const Rig& rig, const std::vector<CarriedObject>& carried, Stage& stage);

} // namespace ghost::scene
