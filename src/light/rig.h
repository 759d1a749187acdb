#pragma once
// SPDX-License-Identifier: Apache-2.0
// Rig: the live side of a show. DMX levels in, what every fixture does now, lights out. The same levels and
// time steps give the same bits. Refers to the show, which must outlive it. Main thread.

#include "beam_groups/beam_groups.h"
#include "dmx/wire/universes.h"
#include "fixture/programmer.h"
#include "light/frame_lights.h"
#include "light/gobos.h"
#include "passes/distance_maps.h"
#include "passes/passes.h"
#include "photometry/photometry.h"
#include "shared/types.h"
#include "show/led_wall.h"
#include "show/mover_motion.h"
#include "show/projector.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace ghost::scene {

struct Camera;
struct Show;

class Rig;
// The camera where the mover that carries it has it now; it stays upright.
Camera riding(const Camera& camera, const Rig& rig);

class Rig {
public:
    explicit Rig(const Show& show);

    // Decodes the levels and moves every fixture on by dt_s, as Show::motion says. programmer: by index of
    // the fixture, what a person wants instead; its gels and lamps are in the light, not in the state.
    void step(const dmx::Universes& universes, double dt_s,
              const std::map<std::size_t, fixture::Programmer>& programmer = {});

    // Heads that nobody asks for light, no hand (fixture::asks_for_light) and no desk, give none, whatever
    // their files have them do then; their state stays. What walls and projectors show is no such light.
    void leave_unasked_dark(bool leave) { leaves_unasked_dark_ = leave; }
    // Whether the last lit() left a fixture dark by that, and how many.
    bool is_left_dark(std::size_t fixture) const { return left_dark_[fixture]; }
    std::size_t left_dark() const;
    // Whether it is as long as no hand asks for its light.
    bool is_dark_without_hands(std::size_t fixture) const;

    // Fixtures go on from where they were in another rig: motors, wheels that turn, lamps. from: for each
    // fixture here its index there, or nothing. One of another type or mode starts anew.
    void go_on_from(const Rig& before, const std::vector<std::optional<std::size_t>>& from);

    // The head of this fixture (index into Show::fixtures) follows a point of the world instead of the desk's
    // pan and tilt, as fast as it can turn; nothing: the desk's again.
    void aim_at(std::size_t fixture, const std::optional<glm::vec3>& point_m);

    // All that shines, in the order of the show: the lights of each fixture's emitters, the face of each of
    // its beams. Fixtures without a readable type have none. A light whose pass is missing points at pass
    // number passes.lights.size(), the dark one.
    FrameLights lit(const GoboStack& gobos, const Passes& passes);

    // The same for a free camera: the shadows of a light are in its distance map (between two stops: the
    // nearer one's), if there is one.
    FrameLights lit(const GoboStack& gobos, const DistanceMaps& maps, Cells cells = Cells::grouped);

    // Of these the lights alone.
    std::vector<shared::Light> lights(const GoboStack& gobos, const Passes& passes);
    std::vector<shared::Light> lights(const GoboStack& gobos, const DistanceMaps& maps);

    const std::vector<fixture::State>& states() const { return states_; }
    // What the last step's levels asked of a fixture that had values by hand; null where it had none.
    const fixture::Programmer* asked(std::size_t fixture) const {
        const auto found = asked_.find(fixture);
        return found == asked_.end() ? nullptr : &found->second;
    }
    // What hands set of a fixture in the last step; null: nothing.
    const fixture::Programmer* by_hand(std::size_t fixture) const {
        const auto found = programmer_.find(fixture);
        return found == programmer_.end() ? nullptr : &found->second;
    }
    // How the beams of a fixture are grouped; nothing where it has no type.
    const BeamGroups& emitters(std::size_t fixture) const { return *emitters_[fixture]; }
    // What carries fixtures, objects and cameras; step moves it on, to at_s of the recording or time code.
    MoverMotion& movers() { return movers_; }
    const MoverMotion& movers() const { return movers_; }
    void set_time(std::optional<double> at_s) { at_s_ = at_s; }
    // From where the show hangs a fixture to where it is now.
    const glm::mat4& moved(std::size_t fixture) const;
    // Place along the track in stops, 0 where there is none.
    float track_position(std::size_t fixture) const { return track_[fixture]; }

private:
    struct Between; // two stops of a track
    Between between(std::size_t fixture) const;

    void follow(std::size_t fixture, fixture::Targets& targets) const;
    std::vector<LensFace> faces(std::size_t fixture, const FixturePose& hung, const GoboStack& gobos);
    void choose_medium(std::size_t fixture, const dmx::Universes& universes);
    std::optional<fixture::LaserCurve> figure_of(std::size_t fixture, const BeamGroup& emitter) const;
    void light_wall(std::size_t fixture, const GoboStack& gobos, std::vector<LensFace>& faces) const;
    void add_wall(std::size_t fixture, const FixturePose& hung, const GoboStack& gobos,
                  FrameLights& lit) const;
    const Projector* projector_of(std::size_t fixture) const {
        return projectors_[fixture] ? &*projectors_[fixture] : nullptr;
    }

    const Show& show_;
    std::vector<fixture::Patch> patches_;
    std::vector<fixture::State> states_;
    std::vector<float> track_;
    MoverMotion movers_;
    std::optional<double> at_s_;
    std::vector<std::optional<Projector>> projectors_; // with the medium that the desk has chosen
    std::vector<fixture::LaserCurve> figures_;  // of lasers whose show file has it, where it has turned to
    std::vector<std::optional<LedWall>> walls_; // the same
    std::vector<std::shared_ptr<const BeamGroups>> emitters_; // one for all fixtures of a type and mode
    std::vector<std::optional<glm::vec3>> aims_;
    std::map<std::size_t, fixture::Programmer> programmer_, asked_; // of the last step
    bool leaves_unasked_dark_ = false;
    std::vector<bool> left_dark_;
    ProfileTable profiles_; // of frames before, too: a light is the same with it and without
};

} // namespace ghost::scene
