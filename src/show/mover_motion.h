#pragma once
// SPDX-License-Identifier: Apache-2.0
// MoverMotion: what all movers of a show do: DMX, keys, trackers and hands in; where what they carry is out.
// Of several that drive one mover a hand goes before a tracker, a tracker before keys, and keys before its
// channels. As the machine: within the limits of speed and acceleration of each axis. Metres, degrees,
// seconds. The same calls give the same bits. One thread; the movers must outlive it.

#include "dmx/wire/universes.h"
#include "fixture/motion.h"
#include "fixture/motor.h"
#include "show/movers.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

class MoverMotion {
public:
    explicit MoverMotion(const std::vector<Mover>& movers);

    // at_s: of the recording, or time code; keys do nothing without it. The first step is there at once.
    void step(const dmx::Universes& universes, std::optional<double> at_s, double dt_s,
              fixture::Motion motion);

    // Where the tracker of a mover is, in the show, as often as it is heard. Places that are no numbers or
    // too far away, and jumps that do not last, are left out; one that is not heard stays where it was.
    void follow(std::size_t mover, const glm::vec3& point_m);
    // Values of its axes by hand, instead of all others; empty: the others again. What are no numbers, or of
    // too many axes, changes nothing.
    void drive(std::size_t mover, std::vector<float> values);
    // By index; of those that are not there, the others again.
    void drive(const std::map<std::size_t, std::vector<float>>& by_hand);

    // From where the show has what it carries to where that is now.
    const glm::mat4& moved(std::size_t mover) const { return moved_[mover]; }
    const glm::mat4& moved(int mover) const; // kNoMover: the identity
    std::vector<float> values(std::size_t mover) const;
    // Where its axes go: what is asked, between their end stops; and where they would, if no hand held it.
    std::vector<float> goals(std::size_t mover) const;
    std::vector<float> goals_without_hand(std::size_t mover) const;
    bool has_moved() const; // something is elsewhere than the show has it
    // What is asked of an axis before its end stops and limits.
    double asked(std::size_t mover, std::size_t axis) const { return states_[mover].asked[axis]; }
    // Goes on from where the same movers were in another one.
    void go_on_from(const MoverMotion& before);

    // What went wrong since the last call, each once.
    std::vector<Message> take_messages();

private:
    struct State {
        std::vector<fixture::Motor> motors;
        std::vector<double> asked;
        std::vector<double> by_others; // what is asked without a hand
        std::vector<float> by_hand;
        std::optional<glm::vec3> tracked_m;
        bool has_jumped = false;
        double jumped_s = 0; // since the tracker is elsewhere
        double silent_s = 0; // since it was heard
        bool said_nowhere = false, said_jump = false, said_silent = false;
    };
    std::vector<float> between_stops(std::size_t mover, const std::vector<double>& asked) const;
    void ask(std::size_t mover, const dmx::Universes& universes, std::optional<double> at_s);

    void warn(const Mover& mover, bool& said, const std::string& what);

    const std::vector<Mover>* movers_;
    std::vector<std::size_t> order_; // parents first
    std::vector<State> states_;
    std::vector<glm::dmat4> world_;
    std::vector<glm::mat4> moved_;
    std::vector<Message> messages_;
    bool has_begun_ = false;
};

} // namespace ghost::scene
