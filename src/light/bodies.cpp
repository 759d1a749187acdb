// SPDX-License-Identifier: Apache-2.0
#include "light/bodies.h"

#include "base/check.h"
#include "fixture/decode.h"
#include "show/show.h"
#include "stage/box.h"
#include "stage/model_reader.h"
#include "stage/primitives.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {
namespace {

constexpr float kMinSize_m = 0.001f;

// A model of a type, as instances in the stage's meshes; to be multiplied from the left by where it is.
using Parts = std::vector<Instance>;

Box bounds(const Stage& stage) {
    Box box;
    for (const Instance& instance : stage.instances)
        for (const glm::vec3& position : stage.meshes[static_cast<std::size_t>(instance.mesh)].positions) {
            box.add(glm::vec3(instance.world * glm::vec4(position, 1.0f)));
        }
    return box;
}

// GDTF: a mesh is always scaled to the model's length, width and height; a size of 0 says nothing.
glm::mat4 fit(const Box& box, const glm::vec3& size_m) {
    glm::vec3 scale(1.0f);
    for (int k = 0; k < 3; ++k) {
        const float extent = box.high_m[k] - box.low_m[k];
        if (size_m[k] > 0.0f && extent > 1e-6f) scale[k] = size_m[k] / extent;
    }
    return glm::scale(glm::mat4(1.0f), scale);
}

// A stand-in of the model's size.
Stage primitive(const fixture::Model& model) {
    Stage stage;
    Material black;
    black.name = "fixture body";
    black.base_colour = glm::vec3(0.03f);
    black.roughness = 0.4f;
    stage.materials.push_back(std::move(black));
    stage.meshes.push_back(primitive_mesh(model.primitive));
    stage.meshes.back().name = model.name;
    stage.instances.push_back({model.name, 0, glm::mat4(1.0f), kNone});
    return stage;
}

class BodyShop {
public:
    BodyShop(Stage& stage, Report& report) : stage_(stage), report_(report) {}

    const Parts& parts_of(const fixture::Type& type, int index) {
        const auto [entry, is_new] = models_.try_emplace({&type, index});
        if (is_new) entry->second = build(type, type.models[static_cast<std::size_t>(index)]);
        return entry->second;
    }

private:
    Parts build(const fixture::Type& type, const fixture::Model& model) {
        if (!model.mesh.empty()) {
            auto loaded = load_model(model.mesh, model.mesh_extension, type.name + ": " + model.mesh_file,
                                     ModelSource::archive, report_);
            if (loaded.ok()) {
                const glm::mat4 place = fit(bounds(*loaded), model.size_m);
                return absorb(std::move(*loaded), place, stage_);
            }
            report_.add(Severity::error, loaded.error().where,
                        loaded.error().what + "; a plain shape stands in for it");
        } else if (model.primitive == "Undefined" || model.size_m == glm::vec3(0.0f)) {
            return {};
        }
        const glm::mat4 size = glm::scale(glm::mat4(1.0f), glm::max(model.size_m, glm::vec3(kMinSize_m)));
        return absorb(primitive(model), size, stage_);
    }

    Stage& stage_;
    Report& report_;
    std::map<std::pair<const fixture::Type*, int>, Parts> models_;
};

fixture::State home_state(const PatchedFixture& fixture) {
    fixture::Patch patch;
    patch.name = fixture.name;
    patch.type = fixture.type.get();
    patch.mode = fixture.mode;
    fixture::State state = fixture::make_state(patch);
    fixture::Targets targets = fixture::decode(patch, {});
    for (std::size_t k = 0; k < targets.axes.size() && k < state.axes.size(); ++k)
        targets.axes[k] = {false, state.axes[k].pan ? fixture.home_pan_deg : fixture.home_tilt_deg, 0.0f};
    fixture::step(state, patch, targets, 0.0);
    return state;
}

// An axis turns this node or what it hangs from.
bool turns(const fixture::Mode& mode, int node) {
    for (; node >= 0; node = mode.nodes[static_cast<std::size_t>(node)].parent)
        for (const fixture::Axis& axis : mode.axes)
            if (axis.node == node) return true;
    return false;
}

// The panel of a LED wall, behind its front. Part of the stage: it stops light.
void add_wall(const PatchedFixture& fixture, Stage& stage) {
    const LedWall& wall = *fixture.wall;
    const glm::vec3 size_m(wall.size_m.x, kWallDepth_m, wall.size_m.y);
    fixture::Model box;
    box.name = fixture.name;
    box.primitive = "Cube";
    Stage panel = primitive(box);
    const glm::mat4 place =
        glm::translate(fixture_to_world(fixture, 0), glm::vec3(0, 0.5f * kWallDepth_m, 0));
    for (Instance& piece : absorb(std::move(panel), glm::scale(place, size_m), stage)) {
        piece.name = fixture.name;
        stage.instances.push_back(std::move(piece));
    }
}

} // namespace

void check_models(const fixture::Type& type, const std::string& file, Report& report) {
    for (const fixture::Model& model : type.models) {
        if (model.mesh.empty()) continue;
        const auto loaded = load_model(model.mesh, model.mesh_extension, file + ": " + model.mesh_file,
                                       ModelSource::archive, report);
        if (!loaded.ok())
            report.add(Severity::error, loaded.error().where,
                       loaded.error().what + "; a plain shape stands in for it");
    }
}

Stage stage_with_bodies(const Show& show, Report& report, HiddenObjects hidden) {
    Stage stage = show.stage;
    // Where the stage could not be read, that is said already, and every name would be unknown.
    if (!stage.instances.empty()) apply_objects(stage, show.objects, report);
    if (hidden == HiddenObjects::left_out) stage = visible(std::move(stage));
    BodyShop shop(stage, report);
    for (std::size_t k = 0; k < show.fixtures.size(); ++k) {
        const PatchedFixture& fixture = show.fixtures[k];
        if (!fixture.type) continue;
        if (fixture.wall && fixture.wall->has_body) add_wall(fixture, stage);
        const glm::mat4 to_world = fixture_to_world(fixture, 0);
        const std::vector<fixture::PartState> parts = home_state(fixture).parts;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            if (parts[p].model < 0) continue;
            for (const Instance& piece : shop.parts_of(*fixture.type, parts[p].model)) {
                Instance& instance = stage.instances.emplace_back();
                instance.name = fixture.name + ": " + piece.name;
                instance.mesh = piece.mesh;
                instance.world = to_world * parts[p].to_fixture * piece.world;
                instance.fixture = static_cast<int>(k);
                instance.part = static_cast<int>(p);
                instance.to_part = piece.world;
            }
        }
    }
    return stage;
}

std::vector<std::size_t> moving_instances(const Show& show, const Stage& stage) {
    std::vector<std::size_t> moving;
    for (std::size_t k = 0; k < stage.instances.size(); ++k) {
        const Instance& instance = stage.instances[k];
        if (instance.part == kNone) continue;
        const PatchedFixture& fixture = show.fixtures[static_cast<std::size_t>(instance.fixture)];
        const fixture::Mode& mode = fixture.type->modes[static_cast<std::size_t>(fixture.mode)];
        if (fixture.track || fixture.mover != kNoMover ||
            turns(mode, mode.parts[static_cast<std::size_t>(instance.part)]))
            moving.push_back(k);
    }
    return moving;
}

glm::mat4 body_to_world(const Show& show, const Rig& rig, const Instance& instance) {
    CHECK(instance.part != kNone);
    const auto index = static_cast<std::size_t>(instance.fixture);
    const PatchedFixture& fixture = show.fixtures[index];
    glm::mat4 to_world = fixture_to_world(fixture, 0);
    if (fixture.track) {
        const std::vector<glm::vec3>& stops = fixture.track->stops_m;
        const float along = rig.track_position(index);
        const std::size_t stop = std::min(static_cast<std::size_t>(along), stops.size() - 1);
        const std::size_t next = std::min(stop + 1, stops.size() - 1);
        to_world[3] = glm::vec4(glm::mix(stops[stop], stops[next], along - static_cast<float>(stop)), 1.0f);
    }
    const fixture::PartState& part = rig.states()[index].parts[static_cast<std::size_t>(instance.part)];
    return rig.moved(index) * to_world * part.to_fixture * instance.to_part;
}

std::vector<CarriedObject> carried_objects(const Show& show, const Stage& stage) {
    std::vector<CarriedObject> carried;
    if (show.movers.empty()) return carried;
    const std::vector<int> movers = movers_of_instances(show, stage);
    for (std::size_t k = 0; k < movers.size(); ++k)
        if (movers[k] != kNoMover && stage.instances[k].part == kNone)
            carried.push_back({k, movers[k], stage.instances[k].world});
    return carried;
}

void pose_objects(const Rig& rig, const std::vector<CarriedObject>& carried, Stage& stage) {
    for (const CarriedObject& object : carried)
        stage.instances[object.instance].world = rig.movers().moved(object.mover) * object.home;
}

void pose_bodies(const Show& show, const Rig& rig, Stage& stage) {
    for (const std::size_t k : moving_instances(show, stage))
        stage.instances[k].world = body_to_world(show, rig, stage.instances[k]);
}

} // namespace ghost::scene
