// SPDX-License-Identifier: Apache-2.0
// Bounced light: the solver against particles (reference/light_walk.h), by order of bounce, and what it
// takes.
#include "bake/bounce.h"
#include "base/interrupt.h"
#include "bench/bench.h"
#include "bounce/bounce_solver.h"
#include "live/session/show_moment.h"
#include "reference/light_walk.h"
#include "shared/develop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

namespace ghost::app {
namespace {

constexpr double kMoments_s[] = {8, 28, 50, 66, 82};
constexpr int kSteps_hz = 25;
constexpr std::int64_t kParticles = 500'000;
constexpr int kSolves = 10; // the best counts
constexpr int kPowerOrders = 6;
constexpr std::size_t kObjectOrders = 4;
constexpr std::size_t kBrightest = 10; // objects

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Links of the show's stage, and where its lamps look.
struct Room {
    scene::BounceBox box;
    scene::Bounce bounce;
    std::vector<scene::LampSight> sights;
    std::vector<const scene::LampSight*> of_lights;
    std::vector<bake::BouncePoint> points;
    double links_s = 0, sights_s = 0;
};

Result<Room> room_of(const ShowMoment& moment, const bake::Tracer& tracer) {
    Room room;
    const std::vector<shared::Light> lights = moment.lights();
    room.box = scene::bounce_box(moment.stage(), lights);
    bake::BounceOptions options;
    options.box = room.box;
    options.stop = interrupted;
    options.points = &room.points;
    std::map<std::array<float, 3>, std::size_t> places;
    std::vector<std::size_t> place_of;
    for (const shared::Light& light : lights) {
        const glm::vec3 place_m = light.position_m - light.off_map_m;
        const auto [found, is_new] = places.try_emplace({place_m.x, place_m.y, place_m.z}, places.size());
        place_of.push_back(found->second);
        if (is_new) options.seeds_m.push_back(place_m);
    }
    const std::vector<glm::vec3> lamps_m = options.seeds_m;
    for (const scene::Camera& camera : moment.show().cameras) options.seeds_m.push_back(camera.position_m);
    double begin_s = now_s();
    TRY(room.bounce, bake::make_bounce(tracer, options));
    room.links_s = now_s() - begin_s;
    begin_s = now_s();
    const bake::SurfelIndex index(room.bounce);
    for (const glm::vec3& lamp_m : lamps_m)
        room.sights.push_back(bake::lamp_sight(tracer, room.bounce, index, lamp_m));
    room.sights_s = now_s() - begin_s;
    for (const std::size_t place : place_of) room.of_lights.push_back(&room.sights[place]);
    return room;
}

void room_row(const Room& room, const BenchSink& sink) {
    const scene::Bounce& bounce = room.bounce;
    sink({"bounce",
          "links",
          {{"made_s", room.links_s},
           {"sights_s", room.sights_s},
           {"cell_m", static_cast<double>(bounce.grid.sub_m * scene::kSubsOfCell)},
           {"cells", static_cast<double>(bounce.fine.cells.size())},
           {"surfels", static_cast<double>(bounce.fine.surfels.size())},
           {"coarse_nodes", static_cast<double>(bounce.coarse.cells.size() + bounce.coarse.surfels.size())},
           {"near_links_M", static_cast<double>(bounce.near.links.size()) / 1e6},
           {"far_links_M", static_cast<double>(bounce.far.links.size()) / 1e6},
           {"MB", static_cast<double>(bounce.bytes()) / 1e6}},
          "made once for a stage"});
}

std::string moment_name(double at_s) {
    return std::to_string(static_cast<int>(at_s)) + " s";
}

// What leaves the objects that reflect most, orders 1 to kObjectOrders together.
void object_rows(const ShowMoment& moment, const Room& room, const scene::BounceSolver& solver,
                 const bake::Walk& walked, const std::string& name, const BenchSink& sink) {
    const std::vector<scene::Instance>& instances = moment.stage().instances;
    std::map<std::string, std::pair<double, double>> by_object; // particles, solved
    for (std::size_t k = 0; k < instances.size(); ++k)
        for (std::size_t order = 1; order <= kObjectOrders; ++order)
            by_object[instances[k].name].first += walked.reflected_by_instance[k][order];
    for (const bake::BouncePoint& point : room.points) {
        const std::size_t slot = room.bounce.fine.surfel_slot(point.surfel);
        glm::vec3 lux(0);
        for (std::size_t order = 0; order < kObjectOrders; ++order)
            lux += glm::vec3(solver.kept_orders()[order][slot]);
        by_object[instances[point.instance].name].second +=
            static_cast<double>(shared::luminance_of(lux * point.albedo) * point.area_m2);
    }
    std::vector<std::pair<std::string, std::pair<double, double>>> objects(by_object.begin(),
                                                                           by_object.end());
    std::stable_sort(objects.begin(), objects.end(),
                     [](const auto& a, const auto& b) { return a.second.first > b.second.first; });
    for (std::size_t k = 0; k < std::min(objects.size(), kBrightest); ++k) {
        const auto& [object, power] = objects[k];
        sink({"bounce",
              name + ", of " + object,
              {{"share", power.first / walked.sent_lm}, {"reflected", power.second / power.first}},
              "orders 1 to 4; share of what is sent, by particles; solved / particles"});
    }
}

Result<void> power_rows(ShowMoment& moment, const Room& room, const bake::Tracer& tracer, Report& report,
                        const BenchSink& sink) {
    scene::BounceSolver solver(room.bounce);
    const shared::Haze haze = atmosphere_of(moment.show()).medium();
    solver.set_haze(haze);
    solver.keep_orders(true);
    for (const double at_s : kMoments_s) {
        if (interrupted()) return Error{"interrupted; the rows above are whole", ""};
        moment.step_to(at_s, kSteps_hz, report);
        const std::vector<shared::Light> lights = moment.lights();
        bake::WalkOptions walk;
        walk.particles = kParticles;
        walk.air_low_m = room.box.low_m;
        walk.air_high_m = room.box.high_m;
        if (solver.air().forward_fraction > 0) walk.straight_cosine = scene::kStraightCosine;
        walk.stop = interrupted;
        TRY(const bake::Walk walked, bake::walk_light(tracer, lights, moment.gobos().images, haze, walk));
        const scene::BounceSolution& solved =
            solver.solve(lights, room.of_lights, moment.gobos().images, kPowerOrders);
        const bake::OrderPower& landed = walked.orders[0];
        sink({"bounce",
              moment_name(at_s) + ", sent",
              {{"lm", walked.sent_lm},
               {"solved", solved.sent_lm / walked.sent_lm},
               {"goes_on", solved.orders[0].emitted / (landed.reflected + landed.in_air)}},
              "of all lamps; what goes on after it has landed: solved / particles"});
        double particles = 0, solution = 0;
        for (std::size_t k = 1; k <= kPowerOrders; ++k) {
            const bake::OrderPower& truth = walked.orders[k];
            const scene::BouncePower& ours = solved.orders[k];
            particles += truth.on_surfaces;
            solution += ours.on_surfaces;
            // Of what the order before sent on, what is met again; the rest escapes.
            const bake::OrderPower& sender = walked.orders[k - 1];
            const double met = (truth.on_surfaces + truth.in_air + truth.absorbed_in_air) /
                               (sender.reflected + sender.in_air);
            sink({"bounce",
                  moment_name(at_s) + ", order " + std::to_string(k),
                  {{"surfaces_share", truth.on_surfaces / walked.sent_lm},
                   {"air_share", truth.in_air / walked.sent_lm},
                   {"surfaces", ours.on_surfaces / truth.on_surfaces},
                   {"reflected", ours.reflected / truth.reflected},
                   {"air", ours.in_air / truth.in_air},
                   {"met_share", met},
                   {"met_solved", (ours.on_surfaces + ours.in_air) / solved.orders[k - 1].emitted}},
                  "shares of what is sent, by particles; solved / particles"});
        }
        sink({"bounce",
              moment_name(at_s) + ", all orders",
              {{"surfaces", solution / particles}},
              "solved / particles"});
        object_rows(moment, room, solver, walked, moment_name(at_s), sink);
    }
    return {};
}

Result<void> solve_rows(ShowMoment& moment, const Room& room, Report& report, const BenchSink& sink) {
    for (const double at_s : kMoments_s) {
        moment.step_to(at_s, kSteps_hz, report);
        const std::vector<shared::Light> lights = moment.lights();
        double all_ms = std::numeric_limits<double>::max(), same_ms = all_ms;
        for (int k = 0; k < kSolves; ++k) {
            scene::BounceSolver solver(room.bounce);
            solver.set_haze(atmosphere_of(moment.show()).medium());
            double begin_s = now_s();
            (void)solver.solve(lights, room.of_lights, moment.gobos().images);
            all_ms = std::min(all_ms, 1e3 * (now_s() - begin_s));
            begin_s = now_s();
            (void)solver.solve(lights, room.of_lights, moment.gobos().images);
            same_ms = std::min(same_ms, 1e3 * (now_s() - begin_s));
        }
        const auto lit = std::count_if(lights.begin(), lights.end(), [](const shared::Light& light) {
            return light.intensity_cd != glm::vec3(0);
        });
        sink({"bounce",
              moment_name(at_s) + ", solve",
              {{"lights", static_cast<double>(lit)}, {"all_turn_ms", all_ms}, {"only_dimmers_ms", same_ms}},
              "one core, best of " + std::to_string(kSolves)});
    }
    return {};
}

} // namespace

Result<void> bench_bounce(const BenchOptions& options, const BenchSink& sink) {
    SessionOptions opening;
    opening.show = options.show;
    opening.quiet = true;
    catch_interrupts();
    Report report;
    TRY(const auto moment, ShowMoment::open(opening, "", {}, report));
    const bake::Tracer tracer(moment->stage());
    TRY(const Room room, room_of(*moment, tracer));
    room_row(room, sink);
    return options.power ? power_rows(*moment, room, tracer, report, sink)
                         : solve_rows(*moment, room, report, sink);
}

} // namespace ghost::app
