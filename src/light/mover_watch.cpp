// SPDX-License-Identifier: Apache-2.0
#include "light/mover_watch.h"

#include "show/show.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace ghost::scene {
namespace {

constexpr float kTouch_m = 0.01f;     // what lies closer only touches
constexpr double kPast = 1e-3;        // metres or degrees past an end stop
constexpr std::size_t kMostSaid = 50; // sentences; more of them say nothing new
constexpr std::size_t kMostMet = 100'000;

std::string time_text(double at_s) {
    char text[32];
    std::snprintf(text, sizeof text, "at %.2f s ", at_s);
    return text;
}

std::string place_text(const glm::vec3& at_m) {
    char text[80];
    std::snprintf(text, sizeof text, "[%.2f, %.2f, %.2f]", static_cast<double>(at_m.x),
                  static_cast<double>(at_m.y), static_cast<double>(at_m.z));
    return text;
}

struct Turned {
    glm::vec3 middle_m{0};
    std::array<glm::vec3, 3> half_m{}; // from the middle to three faces
};

Turned turned(const Box& own, const glm::mat4& world) {
    Turned box;
    box.middle_m = glm::vec3(world * glm::vec4(own.middle_m(), 1.0f));
    for (int k = 0; k < 3; ++k)
        box.half_m[static_cast<std::size_t>(k)] = 0.5f * own.size_m()[k] * glm::vec3(world[k]);
    return box;
}

float reach_along(const Turned& box, const glm::vec3& way) {
    float reach = 0;
    for (const glm::vec3& half : box.half_m) reach += std::abs(glm::dot(half, way));
    return reach;
}

// Separating axes (Gottschalk 1996), of boxes that are each smaller by half of what still only touches.
bool meet(const Turned& a, const Turned& b) {
    std::vector<glm::vec3> ways;
    for (const glm::vec3& half : a.half_m) ways.push_back(half);
    for (const glm::vec3& half : b.half_m) ways.push_back(half);
    for (const glm::vec3& one : a.half_m)
        for (const glm::vec3& other : b.half_m) ways.push_back(glm::cross(one, other));
    for (const glm::vec3& way : ways) {
        const float length = glm::length(way);
        if (length < 1e-9f) continue;
        const glm::vec3 unit = way / length;
        const float apart = std::abs(glm::dot(b.middle_m - a.middle_m, unit));
        if (apart + kTouch_m >= reach_along(a, unit) + reach_along(b, unit)) return false;
    }
    return true;
}

bool overlap(const Box& a, const Box& b) {
    return glm::all(glm::lessThan(a.low_m + kTouch_m, b.high_m)) &&
           glm::all(glm::lessThan(b.low_m + kTouch_m, a.high_m));
}

} // namespace

MoverWatch::MoverWatch(const Show& show, const Stage& stage, std::uint64_t most_pairs)
    : show_(show), stage_(stage), left_pairs_(most_pairs) {
    std::vector<Box> meshes;
    for (const Mesh& mesh : stage.meshes) {
        Box& box = meshes.emplace_back();
        for (const glm::vec3& position : mesh.positions) box.add(position);
    }
    const std::vector<int> movers = movers_of_instances(show, stage);
    const auto add = [&](bool moves) {
        for (std::size_t k = 0; k < movers.size(); ++k) {
            const Instance& instance = stage.instances[k];
            if ((movers[k] != kNoMover) != moves || !instance.shown || instance.mesh < 0) continue;
            const Box& own = meshes[static_cast<std::size_t>(instance.mesh)];
            if (!own.is_empty()) bodies_.push_back({k, movers[k], own});
        }
    };
    add(true);
    moving_ = bodies_.size();
    add(false);
    std::vector<Placed> home;
    for (const Body& body : bodies_) home.push_back(placed(body, nullptr));
    look_for_meetings(home, 0, nullptr);
    for (std::size_t k = 0; k < moving_; ++k)
        if (home[k].round.low_m.z < -kTouch_m) low_.insert(k);
}

MoverWatch::Placed MoverWatch::placed(const Body& body, const Rig* rig) const {
    const Instance& instance = stage_.instances[body.instance];
    Placed now{instance.world, {}};
    if (rig && instance.part != kNone)
        now.world = body_to_world(show_, *rig, instance);
    else if (rig)
        now.world = rig->movers().moved(body.mover) * instance.world;
    for (int k = 0; k < 8; ++k)
        now.round.add(glm::vec3(now.world * glm::vec4(k & 1 ? body.own.high_m.x : body.own.low_m.x,
                                                      k & 2 ? body.own.high_m.y : body.own.low_m.y,
                                                      k & 4 ? body.own.high_m.z : body.own.low_m.z, 1.0f)));
    return now;
}

void MoverWatch::look_for_meetings(const std::vector<Placed>& now, double at_s, Report* report) {
    if (meetings_ > kMostSaid) return;
    for (std::size_t a = 0; a < moving_; ++a) {
        const std::uint64_t pairs = bodies_.size() - a - 1;
        gave_up_ = gave_up_ || pairs > left_pairs_ || said_.size() > kMostMet;
        if (gave_up_) return;
        left_pairs_ -= pairs;
        for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
            if (bodies_[a].mover == bodies_[b].mover || !overlap(now[a].round, now[b].round)) continue;
            if (said_.contains({a, b})) continue;
            const Turned one = turned(bodies_[a].own, now[a].world);
            const Turned other = turned(bodies_[b].own, now[b].world);
            if (!meet(one, other)) continue;
            said_.insert({a, b});
            const Mover& mover = show_.movers[static_cast<std::size_t>(bodies_[a].mover)];
            if (!report) continue;
            if (++meetings_ > kMostSaid) {
                report->add(Severity::warning, mover.where,
                            time_text(at_s) + "more bodies of movers meet; they are not named");
                return;
            }
            const glm::vec3 low_m = glm::max(now[a].round.low_m, now[b].round.low_m);
            const glm::vec3 high_m = glm::min(now[a].round.high_m, now[b].round.high_m);
            report->add(Severity::warning, mover.where,
                        time_text(at_s) + "'" + stage_.instances[bodies_[a].instance].name + "' of mover '" +
                            mover.name + "' meets '" + stage_.instances[bodies_[b].instance].name + "' at " +
                            place_text(0.5f * (low_m + high_m)));
        }
    }
}

void MoverWatch::look(const Rig& rig, double at_s, Report& report) {
    for (std::size_t m = 0; m < show_.movers.size(); ++m)
        for (std::size_t a = 0; a < show_.movers[m].axes.size(); ++a) {
            const MoverAxis& axis = show_.movers[m].axes[a];
            const double asked = rig.movers().asked(m, a);
            const bool is_past = asked < static_cast<double>(axis.low) - kPast ||
                                 asked > static_cast<double>(axis.high) + kPast;
            if (!is_past || !past_.insert({m, a}).second) continue;
            char text[160];
            std::snprintf(text, sizeof text, "is asked to go to %.2f %s, past its end stops [%.2f, %.2f]",
                          asked, axis.is_angle ? "degrees" : "m", static_cast<double>(axis.low),
                          static_cast<double>(axis.high));
            report.add(Severity::warning, show_.movers[m].where,
                       time_text(at_s) + "axis '" + axis.name + "' of mover '" + show_.movers[m].name + "' " +
                           text);
        }
    std::vector<Placed> now;
    for (const Body& body : bodies_) now.push_back(placed(body, &rig));
    for (std::size_t k = 0; k < moving_; ++k) {
        const float low_m = now[k].round.low_m.z;
        if (low_m >= -kTouch_m || !low_.insert(k).second) continue;
        const Mover& mover = show_.movers[static_cast<std::size_t>(bodies_[k].mover)];
        const glm::vec3 middle_m = now[k].round.middle_m();
        report.add(Severity::warning, mover.where,
                   time_text(at_s) + "'" + stage_.instances[bodies_[k].instance].name + "' of mover '" +
                       mover.name + "' is below the floor, at " +
                       place_text({middle_m.x, middle_m.y, low_m}));
    }
    look_for_meetings(now, at_s, &report);
    if (!gave_up_ || std::exchange(said_so_, true)) return;
    report.add(Severity::warning, show_.movers.front().where,
               time_text(at_s) +
                   "and later it is not looked at whether bodies of movers meet: they are too many");
}

} // namespace ghost::scene
