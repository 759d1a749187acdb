// SPDX-License-Identifier: Apache-2.0
#include "show/mover_motion.h"

#include "show/mover_pose.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::scene {
namespace {

constexpr float kJump_m = 3; // between two packets: no performer and no machine goes so far
constexpr double kSilent_s = 2;
constexpr double kJumped_s = 1; // a tracker that is elsewhere so long has not jumped

double key_value(const std::vector<MoverKey>& keys, std::size_t axis, double at_s) {
    const auto next = std::upper_bound(keys.begin(), keys.end(), at_s,
                                       [](double s, const MoverKey& key) { return s < key.at_s; });
    if (next == keys.begin()) return keys.front().values[axis];
    if (next == keys.end()) return keys.back().values[axis];
    const MoverKey& before = *(next - 1);
    const double share = (at_s - before.at_s) / (next->at_s - before.at_s);
    return std::lerp(static_cast<double>(before.values[axis]), static_cast<double>(next->values[axis]),
                     share);
}

bool is_near(const glm::vec3& place_m) {
    const auto limit = static_cast<float>(kFarthestMove_m);
    return std::abs(place_m.x) <= limit && std::abs(place_m.y) <= limit && std::abs(place_m.z) <= limit;
}

// Where its end stops let it go.
double stopped(const MoverAxis& axis, double asked) {
    return std::clamp(asked, static_cast<double>(axis.low), static_cast<double>(axis.high));
}

// Raw value of a channel as a fraction of its range.
double level_of(const std::vector<fixture::Address>& levels, const dmx::Universes& universes) {
    double value = 0, most = 0;
    for (const fixture::Address& byte : levels) {
        value = value * 256 + universes.level(static_cast<std::uint16_t>(byte.universe), byte.channel);
        most = most * 256 + 255;
    }
    return most > 0 ? value / most : 0.0;
}

} // namespace

MoverMotion::MoverMotion(const std::vector<Mover>& movers)
    : movers_(&movers), order_(parents_first(movers)), states_(movers.size()),
      world_(movers.size(), glm::dmat4(1.0)), moved_(movers.size(), glm::mat4(1.0f)) {
    for (std::size_t k = 0; k < movers.size(); ++k) {
        states_[k].motors.resize(movers[k].axes.size());
        states_[k].asked.resize(movers[k].axes.size());
        states_[k].by_others.resize(movers[k].axes.size());
    }
}

const glm::mat4& MoverMotion::moved(int mover) const {
    static const glm::mat4 kStays(1.0f);
    return mover == kNoMover ? kStays : moved_[static_cast<std::size_t>(mover)];
}

bool MoverMotion::has_moved() const {
    return std::any_of(moved_.begin(), moved_.end(),
                       [](const glm::mat4& moved) { return moved != glm::mat4(1.0f); });
}

std::vector<float> MoverMotion::values(std::size_t mover) const {
    std::vector<float> values;
    for (const fixture::Motor& motor : states_[mover].motors)
        values.push_back(static_cast<float>(motor.position));
    return values;
}

std::vector<float> MoverMotion::goals(std::size_t mover) const {
    return between_stops(mover, states_[mover].asked);
}

std::vector<float> MoverMotion::goals_without_hand(std::size_t mover) const {
    return between_stops(mover, states_[mover].by_others);
}

std::vector<float> MoverMotion::between_stops(std::size_t mover, const std::vector<double>& asked) const {
    std::vector<float> values;
    for (std::size_t k = 0; k < asked.size(); ++k)
        values.push_back(static_cast<float>(stopped((*movers_)[mover].axes[k], asked[k])));
    return values;
}

void MoverMotion::warn(const Mover& mover, bool& said, const std::string& what) {
    if (std::exchange(said, true)) return;
    const std::string tracker = mover.tracker_id >= 0 ? "tracker " + std::to_string(mover.tracker_id)
                                                      : "tracker '" + mover.tracker.substr(0, 60) + "'";
    messages_.push_back(
        {Severity::warning, mover.where, tracker + " of mover '" + mover.name.substr(0, 60) + "' " + what});
}

void MoverMotion::follow(std::size_t index, const glm::vec3& point_m) {
    State& state = states_[index];
    const Mover& mover = (*movers_)[index];
    state.silent_s = 0;
    state.said_silent = false;
    if (!is_near(point_m))
        return warn(mover, state.said_nowhere,
                    "tells a place that is no number or farther than 1 km away; the mover stays at the last "
                    "one");
    if (state.tracked_m && glm::distance(*state.tracked_m, point_m) > kJump_m && state.jumped_s < kJumped_s) {
        state.has_jumped = true;
        return warn(mover, state.said_jump,
                    "jumps by more than 3 m; the mover goes there when it stays for a second");
    }
    state.tracked_m = point_m;
    state.has_jumped = false;
    state.jumped_s = 0;
}

void MoverMotion::drive(std::size_t mover, std::vector<float> values) {
    const bool good = values.size() == states_[mover].motors.size() &&
                      std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
    if (good || values.empty()) states_[mover].by_hand = std::move(values);
}

void MoverMotion::drive(const std::map<std::size_t, std::vector<float>>& by_hand) {
    for (std::size_t k = 0; k < states_.size(); ++k) {
        const auto found = by_hand.find(k);
        drive(k, found == by_hand.end() ? std::vector<float>{} : found->second);
    }
}

void MoverMotion::ask(std::size_t index, const dmx::Universes& universes, std::optional<double> at_s) {
    const Mover& mover = (*movers_)[index];
    State& state = states_[index];
    std::vector<double> tracked;
    if (state.tracked_m) {
        // In the frame of what carries it, which is done already.
        const glm::dmat4 carried =
            mover.parent == kNoMover ? glm::dmat4(1.0) : world_[static_cast<std::size_t>(mover.parent)];
        const glm::dvec3 there(glm::inverse(carried) * glm::dvec4(glm::dvec3(*state.tracked_m), 1.0));
        tracked = values_towards(mover, there - glm::dvec3(mover.home_m));
    }
    for (std::size_t k = 0; k < mover.axes.size(); ++k) {
        const MoverAxis& axis = mover.axes[k];
        double& asked = state.by_others[k];
        const bool is_heard =
            std::all_of(axis.levels.begin(), axis.levels.end(), [&](const fixture::Address& byte) {
                return universes.find(static_cast<std::uint16_t>(byte.universe)) != nullptr;
            });
        if (!tracked.empty() && !axis.is_angle)
            asked = tracked[k];
        else if (!mover.keys.empty() && at_s)
            asked = key_value(mover.keys, k, *at_s);
        else if (!axis.levels.empty() && is_heard) // else it stays where it is: nobody has spoken
            asked = std::lerp(static_cast<double>(axis.from), static_cast<double>(axis.to),
                              level_of(axis.levels, universes));
        state.asked[k] = state.by_hand.empty() ? asked : static_cast<double>(state.by_hand[k]);
    }
}

void MoverMotion::step(const dmx::Universes& universes, std::optional<double> at_s, double dt_s,
                       fixture::Motion motion) {
    for (const std::size_t k : order_) {
        const Mover& mover = (*movers_)[k];
        State& state = states_[k];
        if (state.has_jumped) state.jumped_s += dt_s;
        if (state.tracked_m) state.silent_s += dt_s;
        if (state.silent_s > kSilent_s)
            warn(mover, state.said_silent, "is not heard any more; the mover stays where it is");
        ask(k, universes, at_s);
        std::vector<double> values;
        for (std::size_t a = 0; a < mover.axes.size(); ++a) {
            const MoverAxis& axis = mover.axes[a];
            fixture::Motor& motor = state.motors[a];
            const double goal = stopped(axis, state.asked[a]);
            const fixture::MotorLimits limits{
                axis.speed > 0 ? static_cast<double>(axis.speed) : fixture::kNoLimit,
                axis.acceleration > 0 ? static_cast<double>(axis.acceleration) : fixture::kNoLimit};
            if (!has_begun_ || motion == fixture::Motion::as_commanded)
                fixture::jump(motor, goal);
            else
                fixture::move(motor, goal, 0.0, limits, std::max(dt_s, 0.0));
            values.push_back(motor.position);
        }
        const glm::dmat4 own = pose_of(mover, values);
        world_[k] = mover.parent == kNoMover ? own : world_[static_cast<std::size_t>(mover.parent)] * own;
        moved_[k] = glm::mat4(world_[k]);
    }
    has_begun_ = true;
}

void MoverMotion::go_on_from(const MoverMotion& before) {
    for (std::size_t k = 0; k < states_.size(); ++k)
        for (std::size_t other = 0; other < before.states_.size(); ++other) {
            if ((*before.movers_)[other].name != (*movers_)[k].name ||
                before.states_[other].motors.size() != states_[k].motors.size())
                continue;
            states_[k] = before.states_[other];
            has_begun_ = before.has_begun_;
        }
}

std::vector<Message> MoverMotion::take_messages() {
    return std::exchange(messages_, {});
}

} // namespace ghost::scene
