#pragma once
// SPDX-License-Identifier: Apache-2.0
// What a fixture sends out now: lights, which brighten surfaces and air, and faces, which the camera sees
// when it looks into them. A single lamp is one of each; a bar of cells is a face a cell and few lights
// (beam_groups/beam_groups.h). Pure. docs/design/multi-cell.md.

#include "beam_groups/beam_groups.h"
#include "fixture/state.h"
#include "fixture/type.h"
#include "light/gobos.h"
#include "light/projector_beam.h"
#include "photometry/photometry.h"
#include "shared/led_wall.h"
#include "shared/types.h"

#include <vector>

namespace ghost::scene {

// The glass of one beam. A beam that only glows is as bright from every side, as paper is, and lights
// nothing.
struct LensFace {
    shared::Light light;
    bool glows = false;
    bool split = false;   // by a prism: its beam is seen in the faces of the facets, after those of all beams
    bool of_wall = false; // the camera sees the wall's picture instead
};

struct FrameLights {
    std::vector<shared::Light> lights;
    std::vector<LensFace> faces;
    std::vector<shared::LedWall> walls;
};

// An apex this near to its place is there, where no map has to be seen from beside it.
inline constexpr float kOnPlace_m = 0.015f;

// apart: every beam is a light of its own, as a reference.
enum class Cells { grouped, apart };

// Where a fixture hangs now.
struct FixturePose {
    glm::mat4 to_world{1.0f};
    glm::vec3 middle_m{0}; // BeamGroups::middle_m in the world
};

// What one beam of a fixture emits. to_world: of the fixture. profiles: of beams before. projector: what it
// projects instead of a round field, null: nothing; shape: measured light instead of the profile, null: none.
shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const GoboStack& gobos);
shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const GoboStack& gobos, ProfileTable& profiles, const Projector* projector = nullptr,
                         const BeamShape* shape = nullptr);

// BeamGroups::places_m in the world.
glm::vec3 hung_place_m(const BeamGroups& emitters, int place, const FixturePose& hung);

// The face of every beam of a fixture.
std::vector<LensFace> faces_of(const fixture::Type& type, const std::vector<fixture::BeamState>& beams,
                               const glm::mat4& to_world, const GoboStack& gobos, ProfileTable& profiles,
                               const Projector* projector = nullptr, const BeamShape* shape = nullptr);

// One light of its cells: candela and bounced light added, in the middle of them by their lumens at full,
// as large as they are together. place_m: of its distance map.
shared::Light light_of(const BeamGroup& emitter, const std::vector<LensFace>& faces,
                       const glm::vec3& place_m);

} // namespace ghost::scene
