// SPDX-License-Identifier: Apache-2.0
// Bounced light, solved: energy in closed rooms, walls, bad stages, the same bytes each time.
#include "bake/bounce.h"

#include "bounce/bounce_solver.h"
#include "bounce/bounce_volumes.h"
#include "reference/light_walk.h"
#include "support/test_stage.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <gtest/gtest.h>

namespace ghost::bake {
namespace {

constexpr shared::Haze kThin{0.05f, 0.05f, 0.0f, 0.0f, 0.0f}; // absorbs nothing

scene::Stage closed_room(const glm::vec3& half_m, float albedo) {
    scene::Stage stage;
    place(stage, add_mesh(stage, box_mesh(half_m), add_material(stage, glm::vec3(albedo))),
          glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, half_m.z)));
    return stage;
}

struct Solved {
    scene::Bounce bounce;
    scene::BounceSolution solution;
    bool made = false;
};

Solved solve(const scene::Stage& stage, const std::vector<shared::Light>& lights, const shared::Haze& haze,
             int passes = 2, int threads = 0, float cell_m = 1) {
    Solved solved;
    const Tracer tracer(stage);
    BounceOptions options;
    options.box = scene::bounce_box(stage, lights);
    for (const shared::Light& light : lights) options.seeds_m.push_back(light.position_m);
    options.threads = threads;
    options.cell_m = cell_m;
    options.rays_of_surfel = 128;
    options.rays_of_cell = 256;
    options.rays_of_block = 1024;
    auto made = make_bounce(tracer, options);
    if (!made.ok()) return solved;
    solved.made = true;
    solved.bounce = std::move(*made);
    const SurfelIndex index(solved.bounce);
    std::vector<scene::LampSight> sights;
    for (const shared::Light& light : lights)
        sights.push_back(lamp_sight(tracer, solved.bounce, index, light.position_m));
    std::vector<const scene::LampSight*> of_lights;
    for (const scene::LampSight& sight : sights) of_lights.push_back(&sight);
    scene::BounceSolver solver(solved.bounce);
    solver.set_haze(haze);
    solved.solution = solver.solve(lights, of_lights, {}, passes);
    return solved;
}

// Of what the lamps send, all orders together.
double absorbed(const Solved& solved) {
    double sum = solved.solution.sent_lm - solved.solution.orders[0].emitted;
    for (std::size_t k = 1; k < solved.solution.orders.size(); ++k)
        sum += solved.solution.orders[k].on_surfaces - solved.solution.orders[k].reflected;
    return sum;
}

TEST(Bounce, AClosedRoomAbsorbsAllLight) {
    for (const float albedo : {0.5f, 0.8f}) {
        const scene::Stage stage = closed_room({5, 6, 3}, albedo);
        const Solved solved = solve(stage, {spot({1, 0, 5}, {-1, 2, 0}, 20, 0)}, kThin, 40);
        ASSERT_TRUE(solved.made);
        const double fraction = absorbed(solved) / solved.solution.sent_lm;
        std::printf("albedo %.1f: absorbed / sent %.4f\n", static_cast<double>(albedo), fraction);
        EXPECT_GT(fraction, 0.985);
        EXPECT_LT(fraction, 1.01);
    }
}

// By order against particles, in a room with things in it.
TEST(Bounce, OrdersAreThoseOfParticles) {
    scene::Stage stage = closed_room({5, 6, 3}, 0.5f);
    place(stage, add_mesh(stage, box_mesh({0.5f, 0.4f, 0.6f}), add_material(stage, {0.6f, 0.3f, 0.2f})),
          glm::translate(glm::mat4(1.0f), glm::vec3(0.5f, 1, 0.6f)));
    place(stage, add_mesh(stage, sphere_mesh(0.5f, 12), add_material(stage, {0.7f, 0.7f, 0.7f})),
          glm::translate(glm::mat4(1.0f), glm::vec3(-1.5f, -1, 0.9f)));
    const std::vector<shared::Light> lights{spot({1, 0, 5}, {-1, 2, 0}, 20, 0),
                                            spot({-4, -4, 4}, {3, 3, 1}, 12, 1)};
    const Solved solved = solve(stage, lights, kThin, 5);
    ASSERT_TRUE(solved.made);
    const Tracer tracer(stage);
    WalkOptions options;
    options.particles = 300'000;
    const auto walk = walk_light(tracer, lights, {}, kThin, options);
    ASSERT_TRUE(walk.ok());
    EXPECT_NEAR(solved.solution.sent_lm / walk->sent_lm, 1.0, 0.02);
    for (std::size_t k = 1; k < 5; ++k) {
        const double surfaces = solved.solution.orders[k].on_surfaces / walk->orders[k].on_surfaces;
        // The solver's haze is without its forward fraction; this one has none.
        const double air = solved.solution.orders[k].in_air / walk->orders[k].in_air;
        std::printf("order %zu: surfaces %.3f, air %.3f of the particles'\n", k, surfaces, air);
        EXPECT_NEAR(surfaces, 1.0, 0.06);
        EXPECT_NEAR(air, 1.0, 0.06);
    }
}

// Fins on the floor beside the pool of a beam: what lies between them sees little of the room, and the pool,
// in the same blocks, all of it. No light is lost between first landing and next (5 % were, of blocks'
// means).
TEST(Bounce, LightOfTheOpenReachesWhatIsFar) {
    scene::Stage stage = closed_room({6, 6, 4}, 0.5f);
    const int fin = add_mesh(stage, box_mesh({0.02f, 2.5f, 0.6f}), add_material(stage, glm::vec3(0.1f)));
    for (int k = 0; k < 12; ++k) {
        const float x = 0.7f + 0.25f * static_cast<float>(k);
        place(stage, fin, glm::translate(glm::mat4(1.0f), glm::vec3(x, 0, 0.6f)));
        place(stage, fin, glm::translate(glm::mat4(1.0f), glm::vec3(-x, 0, 0.6f)));
    }
    const std::vector<shared::Light> lights{spot({0, 0, 7}, {0, 0, 0}, 4, 0)};
    const Solved solved = solve(stage, lights, kThin, 5);
    ASSERT_TRUE(solved.made);
    const scene::BouncePower& first = solved.solution.orders[1];
    const double met = (first.on_surfaces + first.in_air) / solved.solution.orders[0].emitted;
    std::printf("met again %.4f of what leaves the pool\n", met);
    EXPECT_GT(met, 0.985);
    const Tracer tracer(stage);
    WalkOptions options;
    options.particles = 200'000;
    const auto walk = walk_light(tracer, lights, {}, kThin, options);
    ASSERT_TRUE(walk.ok());
    EXPECT_NEAR(solved.solution.orders[1].on_surfaces / walk->orders[1].on_surfaces, 1.0, 0.03);
    EXPECT_NEAR(solved.solution.orders[2].on_surfaces / walk->orders[2].on_surfaces, 1.0, 0.06);
}

// What leaves where a beam lands is by what is there, not by the mean of the surfel that it belongs to.
TEST(Bounce, ABeamOnSomethingSmallAndWhite) {
    scene::Stage stage = closed_room({5, 5, 3}, 0.04f);
    const int sheet = add_mesh(stage, quad_mesh({-0.15f, -0.15f, 0}, {0.3f, 0, 0}, {0, 0.3f, 0}),
                               add_material(stage, glm::vec3(0.9f)));
    place(stage, sheet, glm::translate(glm::mat4(1.0f), glm::vec3(0.25f, 0.25f, 0.01f)));
    const std::vector<shared::Light> lights{spot({0.25f, 0.25f, 5.5f}, {0.25f, 0.25f, 0}, 1, 0)};
    const Solved solved = solve(stage, lights, shared::Haze{}, 2);
    ASSERT_TRUE(solved.made);
    const Tracer tracer(stage);
    WalkOptions options;
    options.particles = 100'000;
    const auto walk = walk_light(tracer, lights, {}, shared::Haze{}, options);
    ASSERT_TRUE(walk.ok());
    EXPECT_NEAR(solved.solution.orders[0].emitted / walk->orders[0].reflected, 1.0, 0.04);
}

// A wall as thin as paper that cuts sub-voxels: next to nothing comes through (0.25 % when this was written).
TEST(Bounce, NoLightGoesThroughWalls) {
    scene::Stage stage = closed_room({5, 6, 3}, 0.7f);
    place(stage, add_mesh(stage, quad_mesh({0.1f, -6, 0}, {0, 12, 0}, {0, 0, 6}), 0));
    const std::vector<shared::Light> lights{spot({-3, 0, 5}, {-2, 1, 0}, 20, 0),
                                            spot({3, 0, 5}, {2, 1, 0}, 20, 1)};
    std::vector<shared::Light> one_side = lights;
    one_side[1].intensity_cd = glm::vec3(0); // hangs in the other room, and is out
    const Solved solved = solve(stage, one_side, kThin);
    ASSERT_TRUE(solved.made);
    double here = 0, there = 0;
    for (std::size_t k = 0; k < solved.bounce.fine.surfels.size(); ++k) {
        const scene::BounceSurfel& surfel = solved.bounce.fine.surfels[k];
        const double lumens = static_cast<double>(solved.solution.lux[k].y * surfel.area_m2);
        const bool is_there = surfel.place_m.x > 0.2f || (surfel.place_m.x > 0 && surfel.normal.x > 0.5f);
        (is_there ? there : here) += lumens;
    }
    EXPECT_GT(here, 0);
    EXPECT_LT(there, 4e-3 * here);
}

TEST(Bounce, SameBytesOnAnyNumberOfThreads) {
    const scene::Stage stage = edgy_stage();
    const std::vector<shared::Light> lights{spot({2, 0, 6}, {-1, 5, 0}, 12, 0)};
    const Solved one = solve(stage, lights, kThin, 2, 1, 2), two = solve(stage, lights, kThin, 2, 2, 2);
    ASSERT_TRUE(one.made && two.made);
    EXPECT_EQ(one.solution.lux, two.solution.lux);
    EXPECT_EQ(one.solution.flux, two.solution.flux);
}

// Whatever was solved before, and in whatever order lights changed.
TEST(Bounce, HistoryChangesNoByte) {
    const scene::Stage stage = closed_room({4, 4, 2}, 0.6f);
    const Tracer tracer(stage);
    std::vector<shared::Light> lights{spot({1, 0, 3}, {-1, 2, 0}, 20, 0), spot({-1, 0, 3}, {1, 1, 0}, 9, 1)};
    BounceOptions options;
    options.box = scene::bounce_box(stage, lights);
    options.seeds_m = {lights[0].position_m};
    options.cell_m = 1;
    options.rays_of_block = options.rays_of_cell = options.rays_of_surfel = 64;
    auto bounce = make_bounce(tracer, options);
    ASSERT_TRUE(bounce.ok());
    const SurfelIndex index(*bounce);
    const scene::LampSight sights[] = {lamp_sight(tracer, *bounce, index, lights[0].position_m),
                                       lamp_sight(tracer, *bounce, index, lights[1].position_m)};
    const std::vector<const scene::LampSight*> of_lights{&sights[0], &sights[1]};
    scene::BounceSolver fresh(*bounce), used(*bounce);
    std::vector<shared::Light> before = lights;
    before[0].axis_w = glm::vec3(0, 0, -1);
    before[1].intensity_cd = glm::vec3(0);
    used.set_haze({0.2f, 0.1f, 0.5f, 0, 0});
    (void)used.solve(before, of_lights, {});
    used.set_haze(kThin);
    before[1].intensity_cd = glm::vec3(3);
    (void)used.solve(before, of_lights, {});
    fresh.set_haze(kThin);
    const auto expected = fresh.solve(lights, of_lights, {});
    EXPECT_EQ(used.solve(lights, of_lights, {}).lux, expected.lux);
}

TEST(Bounce, LightIsNeverMadeFromNothing) {
    std::vector<std::pair<const char*, scene::Stage>> stages;
    stages.emplace_back("nothing", scene::Stage{});
    stages.emplace_back("white room", closed_room({4, 4, 2}, 1.0f));
    stages.emplace_back("edgy", edgy_stage());
    scene::Stage inverted = closed_room({4, 4, 2}, 0.7f);
    for (std::size_t k = 0; k + 2 < inverted.meshes[0].indices.size(); k += 3)
        std::swap(inverted.meshes[0].indices[k], inverted.meshes[0].indices[k + 1]);
    stages.emplace_back("inverted", inverted);
    scene::Stage nested = closed_room({4, 4, 2}, 0.7f);
    place(nested, 0, glm::scale(glm::mat4(1.0f), glm::vec3(0.3f)));
    stages.emplace_back("meshes in meshes", nested);
    scene::Stage open = closed_room({4, 4, 2}, 0.7f);
    open.meshes[0].indices.resize(open.meshes[0].indices.size() / 2); // three walls
    stages.emplace_back("three walls", open);
    scene::Stage broken = closed_room({4, 4, 2}, 0.7f);
    broken.instances[0].world[3][0] = std::nanf("");
    stages.emplace_back("a matrix of no numbers", broken);
    const std::vector<shared::Light> lights{spot({1, 0, 3}, {-1, 2, 0}, 20, 0)};
    for (const shared::Haze& haze : {shared::Haze{}, kThin, shared::Haze{1, 1, 0.8f, -0.5f, 0.1f}})
        for (const auto& [name, stage] : stages) {
            const Solved solved = solve(stage, lights, haze, 10);
            if (!solved.made) continue; // no room: no light
            double before = solved.solution.sent_lm * 1.001;
            for (const scene::BouncePower& order : solved.solution.orders) {
                EXPECT_LE(order.emitted, before) << name;
                EXPECT_TRUE(std::isfinite(order.emitted)) << name;
                before = order.emitted * 1.001;
            }
            for (const glm::vec4& lux : solved.solution.lux) ASSERT_TRUE(std::isfinite(lux.x)) << name;
        }
}

// What a meter reads of it: in a closed room all that was sent lands, and goes on, albedo by albedo.
TEST(Bounce, TheMeterReadsWhatLands) {
    constexpr float kAlbedo = 0.5f;
    const glm::vec3 half_m(5, 6, 3);
    const scene::Stage stage = closed_room(half_m, kAlbedo);
    const Solved solved = solve(stage, {spot({1, 0, 5}, {-1, 2, 0}, 20, 0)}, {}, 20);
    ASSERT_TRUE(solved.made);
    scene::BounceVolumes volumes;
    fill_lux(solved.bounce, solved.solution, volumes);
    // Over all walls, at places between the surfels, too.
    double lumens = 0, area_m2 = 0;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        constexpr int kAcross = 31;
        for (int k = 0; k < kAcross * kAcross; ++k) {
            glm::vec3 place_m(0), normal(0);
            normal[axis] = side % 2 == 0 ? 1.0f : -1.0f; // inwards
            place_m[axis] = -normal[axis] * half_m[axis];
            place_m[u] = half_m[u] * (2 * (static_cast<float>(k % kAcross) + 0.5f) / kAcross - 1);
            place_m[v] = half_m[v] * (2 * (static_cast<float>(k / kAcross) + 0.5f) / kAcross - 1);
            place_m.z += half_m.z;
            const double share_m2 = 4 * static_cast<double>(half_m[u] * half_m[v]) / (kAcross * kAcross);
            lumens += share_m2 * static_cast<double>(lux_on(volumes, place_m, normal).y);
            area_m2 += share_m2;
        }
    }
    const double expected_lm = solved.solution.sent_lm * kAlbedo / (1 - kAlbedo);
    std::printf("bounced onto the walls %.4f of what lands there\n", lumens / expected_lm);
    EXPECT_NEAR(lumens / expected_lm, 1.0, 0.05);
    // Half way up and looking up it reads the air.
    const double in_air = static_cast<double>(lux_on(volumes, {0, 0, 3}, {0, 0, 1}).y);
    EXPECT_GT(in_air, 0.3 * lumens / area_m2);
    EXPECT_LT(in_air, 3 * lumens / area_m2);
    EXPECT_EQ(lux_on(volumes, {0, 0, 100}, {0, 0, -1}).y, lux_on(volumes, {0, 0, 90}, {0, 0, -1}).y)
        << "outside it is as at the edge";
}

TEST(Bounce, TellsHowFarItIs) {
    const scene::Stage stage = closed_room({4, 4, 2}, 0.5f);
    const Tracer tracer(stage);
    BounceOptions options;
    options.box = {{-5, -5, -1}, {5, 5, 5}};
    options.seeds_m = {{1, 0, 3}};
    options.cell_m = 1;
    std::vector<double> told;
    options.progress = [&](double fraction) { told.push_back(fraction); };
    ASSERT_TRUE(make_bounce(tracer, options).ok());
    EXPECT_GT(told.size(), 10u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0);
    EXPECT_GT(told.front(), 0.0);
}

TEST(Bounce, SaysWhyThereIsNone) {
    const scene::Stage stage;
    const Tracer tracer(stage);
    EXPECT_FALSE(make_bounce(tracer, {}).ok()); // neither stage nor lamps
    BounceOptions stopped;
    stopped.box = {{0, 0, 0}, {9, 9, 9}};
    stopped.seeds_m = {{1, 1, 1}};
    stopped.stop = [] { return true; };
    EXPECT_FALSE(make_bounce(tracer, stopped).ok());
    BounceOptions huge;
    huge.box = {glm::vec3(-5e4f), glm::vec3(5e4f)};
    huge.seeds_m = {{1, 1, 1}};
    EXPECT_FALSE(make_bounce(tracer, huge).ok());
}

} // namespace
} // namespace ghost::bake
