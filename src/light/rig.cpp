// SPDX-License-Identifier: Apache-2.0
#include "light/rig.h"

#include "base/check.h"
#include "beam_groups/light_places.h"
#include "beam_groups/prism.h"
#include "fixture_files/common/laser_type.h"
#include "image/colour.h"
#include "light/aim.h"
#include "light/laser_rays.h"
#include "light/led_wall_light.h"
#include "show/show.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace ghost::scene {
namespace {

constexpr float kLeastWhite = 1e-4f; // of a component that is divided by

// Every beam that shines, on its own.
BeamGroups apart(const BeamGroups& emitters) {
    BeamGroups result = emitters;
    result.lights.clear();
    for (const BeamGroup& emitter : emitters.lights)
        for (const int beam : emitter.beams)
            result.lights.push_back({{beam}, {1.0f}, emitter.place, emitter.copies});
    return result;
}

// What another lamp and a gel make of the light of a beam.
glm::vec3 swap_factor(const fixture::Programmer& programmer, const fixture::Beam& beam) {
    glm::vec3 factor = glm::max(programmer.gel.value_or(glm::vec3(1.0f)), glm::vec3(0.0f));
    factor *= std::max(programmer.lamp.value_or(1.0f), 0.0f);
    if (programmer.lamp_k)
        factor *= image::cct_to_rec2020(*programmer.lamp_k) /
                  glm::max(image::cct_to_rec2020(beam.color_temperature_k), glm::vec3(kLeastWhite));
    return factor;
}

// The lights of an emitter: as many as its prisms or its scanner may ever need, dark ones among them. What
// the camera sees in its lens, where it is split, is added to the faces.
std::vector<shared::Light> split_light(const shared::Light& light, const BeamGroup& emitter,
                                       const fixture::Type& type, const fixture::State& state,
                                       const std::optional<fixture::LaserCurve>& figure,
                                       std::vector<LensFace>& faces, std::vector<LensFace>& facets) {
    std::vector<shared::Light> lights{light};
    if (emitter.copies == 1) return lights;
    const auto beam = static_cast<std::size_t>(emitter.beams.front());
    const bool sweeps = figure && fixture::is_swept(figure->kind);
    const std::vector<Copy> copies = sweeps   ? std::vector<Copy>(1)
                                     : figure ? rays_of(*figure, light.tan_field)
                                              : copies_of(type, state.beams[beam].optics, emitter.copies);
    shared::Light dark = light;
    dark.intensity_cd = dark.bounce_cd = glm::vec3(0.0f);
    dark.wheel_count = dark.shaped = 0;
    // Dark lights never change: they are drawn once.
    dark.axis_u = {1, 0, 0};
    dark.axis_v = {0, -1, 0};
    dark.axis_w = {0, 0, -1};
    lights.assign(static_cast<std::size_t>(emitter.copies), dark);
    if (copies.size() == 1) {
        lights.front() = sweeps ? swept(light, *figure) : figure ? copied(light, copies.front()) : light;
        if (figure) faces[beam].light = sweeps ? swept(faces[beam].light, *figure) : lights.front();
        return lights;
    }
    for (std::size_t k = 0; k < copies.size(); ++k) lights[k] = copied(light, copies[k]);
    faces[beam].split = true;
    for (const Copy& copy : copies) {
        LensFace& facet = facets.emplace_back(faces[beam]);
        facet.split = false;
        facet.light = copied(facet.light, copy);
        facet.light.bounce_cd = glm::vec3(0.0f);
    }
    return lights;
}

// The watts are those of the whole fixture.
void colour_laser(const Laser& laser, const fixture::Type& type, const fixture::State& state,
                  std::vector<LensFace>& faces) {
    float lumens = 0.0f;
    for (const fixture::BeamState& beam : state.beams)
        lumens += type.geometries[static_cast<std::size_t>(beam.geometry)].beam->luminous_flux_lm;
    const float power =
        laser.watts > 0.0f && lumens > 0.0f ? laser.watts * fixture::kLaserLumensPerWatt / lumens : 1.0f;
    const glm::vec3 factor = laser.colour.value_or(glm::vec3(1.0f)) * power;
    for (LensFace& face : faces) {
        face.light.intensity_cd *= factor;
        face.light.bounce_cd *= factor;
    }
}

} // namespace

struct Rig::Between {
    std::size_t stop = 0;
    std::size_t next = 0;
    float fraction = 0.0f;    // 0: at stop .. 1: at next
    glm::mat4 to_world{1.0f}; // of the fixture at stop
    glm::vec3 stop_m{0};      // where its middle is at stop
    glm::vec3 next_m{0};

    // Where it is, if those are the places of the two stops.
    FixturePose hung(const glm::vec3& at_stop_m, const glm::vec3& at_next_m) const {
        FixturePose result{to_world, glm::mix(at_stop_m, at_next_m, fraction)};
        result.to_world[3] += glm::vec4(result.middle_m - stop_m, 0.0f);
        return result;
    }
};

Rig::Rig(const Show& show)
    : show_(show), track_(show.fixtures.size(), 0.0f), movers_(show.movers), aims_(show.fixtures.size()),
      left_dark_(show.fixtures.size()) {
    std::map<std::tuple<const fixture::Type*, int, bool>, std::shared_ptr<const BeamGroups>> known;
    for (const PatchedFixture& fixture : show.fixtures) {
        patches_.push_back(fixture.patch());
        projectors_.push_back(fixture.projector);
        figures_.push_back(fixture.laser ? fixture.laser->figure : fixture::LaserCurve{});
        walls_.push_back(fixture.wall);
        states_.push_back(fixture.type ? fixture::make_state(patches_.back()) : fixture::State{});
        auto& emitters =
            known[{fixture.type.get(), fixture.type ? fixture.mode : 0, fixture.laser.has_value()}];
        if (!emitters)
            emitters = std::make_shared<const BeamGroups>(
                fixture.type
                    ? beam_groups_of(*fixture.type, patches_.back().mode_of(), fixture.laser.has_value())
                    : BeamGroups{});
        emitters_.push_back(emitters);
    }
}

void Rig::go_on_from(const Rig& before, const std::vector<std::optional<std::size_t>>& from) {
    for (std::size_t i = 0; i < states_.size() && i < from.size(); ++i) {
        if (!from[i] || *from[i] >= before.states_.size()) continue;
        const std::size_t other = *from[i];
        const PatchedFixture& now = show_.fixtures[i];
        const PatchedFixture& then = before.show_.fixtures[other];
        if (!now.type || !then.type || now.gdtf != then.gdtf || now.mode != then.mode) continue;
        if (states_[i].beams.size() != before.states_[other].beams.size()) continue; // walls of other sizes
        states_[i] = before.states_[other];
        if (figures_[i].deg_s != 0.0f) figures_[i].deg = before.figures_[other].deg;
        figures_[i].phase = before.figures_[other].phase;
        track_[i] = before.track_[other];
    }
    movers_.go_on_from(before.movers_);
}

Camera riding(const Camera& camera, const Rig& rig) {
    Camera moved = camera;
    const glm::mat4& by = rig.movers().moved(camera.mover);
    moved.position_m = glm::vec3(by * glm::vec4(camera.position_m, 1.0f));
    moved.target_m = glm::vec3(by * glm::vec4(camera.target_m, 1.0f));
    return moved;
}

const glm::mat4& Rig::moved(std::size_t fixture) const {
    return movers_.moved(show_.fixtures[fixture].mover);
}

void Rig::aim_at(std::size_t fixture, const std::optional<glm::vec3>& point_m) {
    CHECK(fixture < aims_.size());
    aims_[fixture] = point_m;
}

// The first axis of each kind, as State::pan_deg and tilt_deg are.
void Rig::follow(std::size_t fixture, fixture::Targets& targets) const {
    const PatchedFixture& patched = show_.fixtures[fixture];
    const fixture::State& state = states_[fixture];
    const std::size_t last = patched.track ? patched.track->stops_m.size() - 1 : 0;
    const std::size_t stop = std::min(static_cast<std::size_t>(track_[fixture] + 0.5f), last);
    const glm::mat3 to_fixture = glm::inverse(glm::mat3(moved(fixture) * fixture_to_world(patched, stop)));
    const glm::vec3 lamp_m(moved(fixture) * glm::vec4(light_position_m(patched, stop), 1.0f));
    const PanTilt now{state.pan_deg, state.tilt_deg};
    const PanTilt wanted = aim(to_fixture * (*aims_[fixture] - lamp_m), now);
    bool has_pan = false, has_tilt = false;
    for (std::size_t k = 0; k < state.axes.size(); ++k) {
        const bool pan = state.axes[k].pan;
        bool& has = pan ? has_pan : has_tilt;
        if (has) continue;
        has = true;
        targets.axes[k].spinning = false;
        targets.axes[k].deg = pan ? wanted.pan_deg : wanted.tilt_deg;
    }
}

void Rig::step(const dmx::Universes& universes, double dt_s,
               const std::map<std::size_t, fixture::Programmer>& programmer) {
    fixture::Levels levels;
    for (const dmx::Universe& universe : universes.list) levels.set(universe.number, *universe.levels);
    programmer_ = programmer;
    asked_.clear();
    movers_.step(universes, at_s_, dt_s, show_.motion);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        if (!patches_[i].type) continue;
        fixture::Targets targets = fixture::decode(patches_[i], levels);
        if (aims_[i]) follow(i, targets);
        if (const auto found = programmer.find(i); found != programmer.end()) {
            asked_[i] = fixture::asked_for(targets, patches_[i]);
            if (found->second.sets_levels()) {
                targets = fixture::decode_levels(patches_[i],
                                                 fixture::levels_by_hand(found->second, patches_[i], levels));
                if (aims_[i] && found->second.levels.empty()) follow(i, targets);
            }
            fixture::apply(found->second, patches_[i], targets);
        }
        fixture::step(states_[i], patches_[i], targets, dt_s, show_.motion,
                      static_cast<double>(show_.shutter_deg) / 360.0);
        choose_medium(i, universes);
        fixture::step_figure(figures_[i], figures_[i], std::max(dt_s, 0.0));
        const auto& track = show_.fixtures[i].track;
        if (!track) continue;
        const auto universe = static_cast<std::uint16_t>(track->universe);
        const int value =
            universes.level(universe, track->address) * 256 + universes.level(universe, track->address + 1);
        track_[i] = static_cast<float>(value) / 65535.0f * static_cast<float>(track->stops_m.size() - 1);
    }
}

void Rig::choose_medium(std::size_t fixture, const dmx::Universes& universes) {
    const auto choose = [&](const auto& settings, auto& now) {
        if (!settings || settings->address == 0) return;
        const int chosen = universes.level(static_cast<std::uint16_t>(settings->universe), settings->address);
        const auto last = static_cast<int>(show_.media.size());
        now->media = chosen == 0 ? settings->media : std::min(chosen, last) - 1;
    };
    choose(show_.fixtures[fixture].projector, projectors_[fixture]);
    choose(show_.fixtures[fixture].wall, walls_[fixture]);
}

// What the scanner of a laser draws: what its channels choose; the show file's where it has none, or they are
// not patched.
std::optional<fixture::LaserCurve> Rig::figure_of(std::size_t index, const BeamGroup& emitter) const {
    const PatchedFixture& fixture = show_.fixtures[index];
    const auto beam = static_cast<std::size_t>(emitter.beams.front());
    const std::optional<fixture::LaserCurve>& chosen = states_[index].beams[beam].optics.figure;
    if (fixture.laser && fixture.laser->has_figure && (!chosen || fixture.address == 0))
        return figures_[index];
    return chosen;
}

// The cells of a wall, as bright as the picture there.
void Rig::light_wall(std::size_t index, const GoboStack& gobos, std::vector<LensFace>& faces) const {
    const LedWall& wall = *walls_[index];
    const auto media = static_cast<std::size_t>(wall.media);
    const bool shows = media < gobos.showing.size() && media < gobos.images.slides.size();
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const fixture::Optics& optics = states_[index].beams[k].optics;
        const glm::vec3 fraction =
            shows ? cell_fraction(wall, static_cast<int>(k), gobos.showing[media], gobos.images.slides[media])
                  : glm::vec3(0.0f);
        light_cell(wall, fraction * (optics.dimmer * optics.shutter), faces[k].light);
        faces[k].of_wall = true;
    }
}

// What the camera sees of it.
void Rig::add_wall(std::size_t index, const FixturePose& hung, const GoboStack& gobos,
                   FrameLights& lit) const {
    if (!walls_[index] || states_[index].beams.empty()) return;
    const LedWall& wall = *walls_[index];
    const auto media = static_cast<std::size_t>(wall.media);
    if (media >= gobos.showing.size()) return;
    const fixture::BeamState& beam = states_[index].beams.front();
    glm::vec3 factor(beam.optics.dimmer * beam.optics.shutter);
    if (const auto programmer = programmer_.find(index); programmer != programmer_.end())
        factor *= swap_factor(
            programmer->second,
            *show_.fixtures[index].type->geometries[static_cast<std::size_t>(beam.geometry)].beam);
    const glm::mat4 place = show_.fixtures[index].type->modes.front().nodes.front().local;
    lit.walls.push_back(seen_wall(wall, hung.to_world * place, gobos.showing[media], factor));
}

Rig::Between Rig::between(std::size_t index) const {
    const PatchedFixture& fixture = show_.fixtures[index];
    const std::size_t last = fixture.track ? fixture.track->stops_m.size() - 1 : 0;
    Between result;
    result.stop = std::min(static_cast<std::size_t>(track_[index]), last);
    result.next = std::min(result.stop + 1, last);
    result.fraction = track_[index] - static_cast<float>(result.stop);
    result.to_world = moved(index) * fixture_to_world(fixture, result.stop);
    const glm::vec4 middle_m(emitters_[index]->middle_m, 1.0f);
    result.stop_m = glm::vec3(result.to_world * middle_m);
    result.next_m = glm::vec3(moved(index) * fixture_to_world(fixture, result.next) * middle_m);
    return result;
}

bool Rig::is_dark_without_hands(std::size_t index) const {
    if (!leaves_unasked_dark_ || walls_[index] || projectors_[index] || !patches_[index].type) return false;
    const std::vector<fixture::Channel>& channels = patches_[index].mode_of().channels;
    return std::any_of(channels.begin(), channels.end(),
                       [](const fixture::Channel& channel) { return !channel.offsets.empty(); });
}

std::size_t Rig::left_dark() const {
    return static_cast<std::size_t>(std::count(left_dark_.begin(), left_dark_.end(), true));
}

std::vector<LensFace> Rig::faces(std::size_t index, const FixturePose& hung, const GoboStack& gobos) {
    const fixture::Type& type = *show_.fixtures[index].type;
    std::vector<LensFace> faces = faces_of(type, states_[index].beams, hung.to_world, gobos, profiles_,
                                           projector_of(index), show_.fixtures[index].shape.get());
    if (walls_[index]) light_wall(index, gobos, faces);
    if (show_.fixtures[index].laser) colour_laser(*show_.fixtures[index].laser, type, states_[index], faces);
    const auto programmer = programmer_.find(index);
    const bool is_lit_by_hand =
        programmer != programmer_.end() && fixture::asks_for_light(programmer->second, patches_[index]);
    if (!is_lit_by_hand && is_dark_without_hands(index)) {
        for (LensFace& face : faces) {
            if (face.light.intensity_cd != glm::vec3(0)) left_dark_[index] = true;
            face.light.intensity_cd = face.light.bounce_cd = glm::vec3(0);
        }
    }
    if (programmer == programmer_.end()) return faces;
    for (std::size_t k = 0; k < faces.size(); ++k) {
        const auto geometry = static_cast<std::size_t>(states_[index].beams[k].geometry);
        const glm::vec3 factor = swap_factor(programmer->second, *type.geometries[geometry].beam);
        faces[k].light.intensity_cd *= factor;
        faces[k].light.bounce_cd *= factor;
    }
    return faces;
}

FrameLights Rig::lit(const GoboStack& gobos, const DistanceMaps& maps, Cells cells) {
    FrameLights lit;
    std::vector<LensFace> facets;
    profiles_.trim();
    left_dark_.assign(left_dark_.size(), false);
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const PatchedFixture& fixture = show_.fixtures[i];
        if (!fixture.type) continue;
        const Between track = between(i);
        const FixturePose hung = track.hung(track.stop_m, track.next_m);
        const BeamGroups emitters = cells == Cells::apart ? apart(*emitters_[i]) : *emitters_[i];
        std::vector<LensFace> faces = this->faces(i, hung, gobos);
        const auto stop = static_cast<int>(track.fraction < 0.5f ? track.stop : track.next);
        std::vector<int> map_of;
        for (int place = 0; place < static_cast<int>(emitters.places_m.size()); ++place)
            map_of.push_back(maps.find(fixture.name, stop, place));
        for (const BeamGroup& emitter : emitters.lights) {
            shared::Light light = light_of(emitter, faces, hung_place_m(emitters, emitter.place, hung));
            light.map = static_cast<std::uint32_t>(map_of[static_cast<std::size_t>(emitter.place)] + 1);
            const std::vector<shared::Light> lights =
                split_light(light, emitter, *fixture.type, states_[i], figure_of(i, emitter), faces, facets);
            lit.lights.insert(lit.lights.end(), lights.begin(), lights.end());
        }
        lit.faces.insert(lit.faces.end(), faces.begin(), faces.end());
        add_wall(i, hung, gobos, lit);
    }
    lit.faces.insert(lit.faces.end(), facets.begin(), facets.end());
    return lit;
}

FrameLights Rig::lit(const GoboStack& gobos, const Passes& passes) {
    FrameLights lit;
    std::vector<LensFace> facets;
    profiles_.trim();
    left_dark_.assign(left_dark_.size(), false);
    const auto dark_pass = static_cast<std::uint32_t>(passes.lights.size());
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const PatchedFixture& fixture = show_.fixtures[i];
        if (!fixture.type) continue;
        const auto pass_of = [&](std::size_t stop) {
            const int found = passes.find(fixture.name, static_cast<int>(stop));
            return found < 0 ? dark_pass : static_cast<std::uint32_t>(found);
        };
        // A pass rendered elsewhere says where its light stood; that place is the truth for the masks, too.
        const auto place_of = [&](std::size_t stop, const glm::vec3& shown_m) {
            const std::uint32_t pass = pass_of(stop);
            return pass < dark_pass ? passes.lights[pass].position_m : shown_m;
        };
        const Between track = between(i);
        const FixturePose hung =
            track.hung(place_of(track.stop, track.stop_m), place_of(track.next, track.next_m));
        const BeamGroups& emitters = *emitters_[i];
        std::vector<LensFace> faces = this->faces(i, hung, gobos);
        for (const BeamGroup& emitter : emitters.lights) {
            shared::Light whole = light_of(emitter, faces, hung_place_m(emitters, emitter.place, hung));
            whole.pass = pass_of(track.stop);
            for (shared::Light& light : split_light(whole, emitter, *fixture.type, states_[i],
                                                    figure_of(i, emitter), faces, facets)) {
                if (!fixture.track) {
                    lit.lights.push_back(light);
                    continue;
                }
                // Between two stops the surfaces cross-fade from one pass to the other; the air needs no
                // pass.
                shared::Light second = light;
                second.pass = pass_of(track.next);
                second.haze_samples = 0;
                second.intensity_cd *= track.fraction;
                second.bounce_cd *= track.fraction;
                shared::Light first = light;
                first.haze_samples = 0;
                first.intensity_cd *= 1.0f - track.fraction;
                first.bounce_cd *= 1.0f - track.fraction;
                light.pass = dark_pass;
                lit.lights.insert(lit.lights.end(), {first, second, light});
            }
        }
        lit.faces.insert(lit.faces.end(), faces.begin(), faces.end());
        add_wall(i, hung, gobos, lit);
    }
    lit.faces.insert(lit.faces.end(), facets.begin(), facets.end());
    return lit;
}

std::vector<shared::Light> Rig::lights(const GoboStack& gobos, const Passes& passes) {
    return lit(gobos, passes).lights;
}

std::vector<shared::Light> Rig::lights(const GoboStack& gobos, const DistanceMaps& maps) {
    return lit(gobos, maps).lights;
}

} // namespace ghost::scene
