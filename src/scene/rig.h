#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rig: the live side of a show. DMX levels in, what every fixture does now, lights out. The same levels and
// time steps give the same bits. Refers to the show, which must outlive it. Main thread.

#include "dmx/universes.h"
#include "fixture/decode.h"
#include "scene/distance_maps.h"
#include "scene/gobos.h"
#include "scene/passes.h"
#include "scene/show.h"
#include "shared/types.h"

#include <vector>

namespace ghost::scene {

class Rig {
public:
    explicit Rig(const Show& show);

    // Decodes the levels and moves every fixture on by dt_s, as Show::motion says.
    void step(const dmx::Universes& universes, double dt_s);

    // One light per beam of each fixture, in the order of the show; fixtures without a readable type have
    // none. A light whose pass is missing points at pass number passes.lights.size(), the dark one.
    std::vector<shared::Light> lights(const GoboStack& gobos, const Passes& passes) const;

    // The same for a free camera: the shadows of a light are in its distance map (between two stops: the
    // nearer one's), if there is one.
    std::vector<shared::Light> lights(const GoboStack& gobos, const DistanceMaps& maps) const;

    const std::vector<fixture::State>& states() const { return states_; }
    // Place along the track in stops, 0 where there is none.
    float track_position(std::size_t fixture) const { return track_[fixture]; }

private:
    const Show& show_;
    std::vector<fixture::Patch> patches_;
    std::vector<fixture::State> states_;
    std::vector<float> track_;
};

// What one beam of a fixture emits. stop: place along the track in stops; to_world: of the fixture hung
// there.
shared::Light light_from(const fixture::Type& type, const fixture::BeamState& beam, const glm::mat4& to_world,
                         const glm::vec3& position_m, const GoboStack& gobos);

} // namespace ghost::scene
