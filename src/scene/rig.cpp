// SPDX-License-Identifier: Apache-2.0
#include "scene/rig.h"

#include <algorithm>
#include <cmath>

namespace ghost::scene {

Rig::Rig(const Show& show) : show_(show), track_(show.fixtures.size(), 0.0f) {
    for (const PatchedFixture& fixture : show.fixtures) {
        patches_.push_back(fixture.patch());
        states_.push_back(fixture.type ? fixture::make_state(patches_.back()) : fixture::State{});
    }
}

void Rig::step(const dmx::Universes& universes, double dt_s) {
    fixture::Levels levels;
    for (const dmx::Universe& universe : universes.list) levels.set(universe.number, *universe.levels);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        if (!patches_[i].type) continue;
        fixture::step(states_[i], patches_[i], fixture::decode(patches_[i], levels), dt_s, show_.motion);
        const auto& track = show_.fixtures[i].track;
        if (!track) continue;
        const auto universe = static_cast<std::uint16_t>(track->universe);
        const int value =
            universes.level(universe, track->address) * 256 + universes.level(universe, track->address + 1);
        track_[i] = static_cast<float>(value) / 65535.0f * static_cast<float>(track->stops_m.size() - 1);
    }
}

std::vector<shared::Light> Rig::lights(const GoboStack& gobos, const DistanceMaps& maps) const {
    std::vector<shared::Light> lights;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const PatchedFixture& fixture = show_.fixtures[i];
        if (!fixture.type) continue;
        const std::size_t last = fixture.track ? fixture.track->stops_m.size() - 1 : 0;
        const std::size_t stop = std::min(static_cast<std::size_t>(track_[i]), last);
        const std::size_t next = std::min(stop + 1, last);
        const float between = track_[i] - static_cast<float>(stop);
        const glm::vec3 position_m =
            glm::mix(light_position_m(fixture, stop), light_position_m(fixture, next), between);
        const int map = maps.find(fixture.name, static_cast<int>(between < 0.5f ? stop : next));
        for (const fixture::BeamState& beam : states_[i].beams) {
            lights.push_back(
                light_from(*fixture.type, beam, fixture_to_world(fixture, stop), position_m, gobos));
            lights.back().map = static_cast<std::uint32_t>(map + 1);
        }
    }
    return lights;
}

std::vector<shared::Light> Rig::lights(const GoboStack& gobos, const Passes& passes) const {
    std::vector<shared::Light> lights;
    const auto dark_pass = static_cast<std::uint32_t>(passes.lights.size());
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const PatchedFixture& fixture = show_.fixtures[i];
        if (!fixture.type) continue;
        const auto pass_of = [&](std::size_t stop) {
            const int found = passes.find(fixture.name, static_cast<int>(stop));
            return found < 0 ? dark_pass : static_cast<std::uint32_t>(found);
        };
        // A pass rendered elsewhere says where its light stood; that place is the truth for the masks, too.
        const auto place_of = [&](std::size_t stop) {
            const std::uint32_t pass = pass_of(stop);
            return pass < dark_pass ? passes.lights[pass].position_m : light_position_m(fixture, stop);
        };
        const std::size_t last = fixture.track ? fixture.track->stops_m.size() - 1 : 0;
        const std::size_t stop = std::min(static_cast<std::size_t>(track_[i]), last);
        const std::size_t next = std::min(stop + 1, last);
        const float between = track_[i] - static_cast<float>(stop);
        const glm::vec3 position_m = glm::mix(place_of(stop), place_of(next), between);
        const glm::mat4 to_world = fixture_to_world(fixture, stop);
        for (const fixture::BeamState& beam : states_[i].beams) {
            shared::Light light = light_from(*fixture.type, beam, to_world, position_m, gobos);
            light.pass = pass_of(stop);
            if (!fixture.track) {
                lights.push_back(light);
                continue;
            }
            // Between two stops the surfaces cross-fade from one pass to the other; the air needs no pass.
            shared::Light second = light;
            second.pass = pass_of(next);
            second.haze_samples = 0;
            second.intensity_cd *= between;
            second.bounce_cd *= between;
            shared::Light first = light;
            first.haze_samples = 0;
            first.intensity_cd *= 1.0f - between;
            first.bounce_cd *= 1.0f - between;
            light.pass = dark_pass;
            lights.insert(lights.end(), {first, second, light});
        }
    }
    return lights;
}

} // namespace ghost::scene
