// SPDX-License-Identifier: Apache-2.0
// The judge of bounced light against closed forms (a closed room, one square of haze) and against the
// reference picture, which is another estimator of the same light.
#include "reference/light_walk.h"

#include "reference/reference.h"
#include "support/test_stage.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace ghost::bake {
namespace {

// Six walls, seen from within.
scene::Stage closed_room(const glm::vec3& half_m, float albedo) {
    scene::Stage stage;
    const int material = add_material(stage, glm::vec3(albedo));
    place(stage, add_mesh(stage, box_mesh(half_m), material),
          glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, half_m.z)));
    return stage;
}

Walk walked(const Tracer& tracer, const std::vector<shared::Light>& lights, const shared::Haze& haze,
            const WalkOptions& options) {
    auto walk = walk_light(tracer, lights, shared::Gobos{}, haze, options);
    EXPECT_TRUE(walk.ok()) << walk.error().text();
    return walk.ok() ? std::move(*walk) : Walk{};
}

// Where nothing is lost each order has the power of the one before, times the albedo.
TEST(LightWalk, OrdersOfAClosedRoomFallByItsAlbedo) {
    for (const float albedo : {0.5f, 0.8f}) {
        const scene::Stage stage = closed_room({5, 6, 3}, albedo);
        const Tracer tracer(stage);
        WalkOptions options;
        options.particles = 100'000;
        const Walk walk = walked(tracer, {spot({1, 0, 5}, {-1, 2, 0}, 20, 0)}, shared::Haze{}, options);
        ASSERT_GT(walk.sent_lm, 0);
        double expected = walk.sent_lm;
        for (std::size_t order = 0; order < 6; ++order, expected *= static_cast<double>(albedo)) {
            EXPECT_NEAR(walk.orders[order].on_surfaces, expected, 0.01 * expected) << "order " << order;
            EXPECT_EQ(walk.orders[order].escaped, 0.0);
        }
    }
}

// Haze that bends light by less begins no order: order 0 scatters that much less of it, and as much is
// absorbed.
TEST(LightWalk, LightThatGoesStraightOnBeginsNoOrder) {
    const scene::Stage stage = closed_room({5, 6, 3}, 0.5f);
    const Tracer tracer(stage);
    const shared::Haze haze{0.05f, 0.05f, 0.8f, 0.0f, 0.0f};
    WalkOptions options;
    options.particles = 200'000;
    const std::vector<shared::Light> lights{spot({1, 0, 5}, {-1, 2, 0}, 20, 0)};
    const Walk all = walked(tracer, lights, haze, options);
    options.straight_cosine = 0.98768834; // nine degrees
    const Walk bent = walked(tracer, lights, haze, options);
    // Henyey and Greenstein, integrated from there to 1.
    const double g = 0.8,
                 straight = (1 - g * g) / (2 * g) *
                            (1 / (1 - g) - 1 / std::sqrt(1 + g * g - 2 * g * options.straight_cosine));
    const double first = bent.orders[0].in_air / all.orders[0].in_air;
    // What went straight on may be scattered later on its way.
    EXPECT_GT(first, 1 - straight);
    EXPECT_LT(first, 1 - straight + 0.15 * straight);
    double absorbed_all = 0, absorbed_bent = 0;
    for (std::size_t k = 0; k < kWalkOrders; ++k) {
        absorbed_all += all.orders[k].on_surfaces - all.orders[k].reflected;
        absorbed_bent += bent.orders[k].on_surfaces - bent.orders[k].reflected;
    }
    EXPECT_NEAR(absorbed_bent / absorbed_all, 1.0, 0.005);
}

// Absorbed by surfaces and by haze, and escaped: all that was sent, whatever the haze.
TEST(LightWalk, AllLightSentIsAccountedFor) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    WalkOptions options;
    options.particles = 200'000;
    options.air_low_m = {-10, -10, 0};
    options.air_high_m = {10, 12, 9};
    const Walk walk =
        walked(tracer, {spot({2, 0, 6}, {-1, 5, 0}, 12, 0)}, {0.05f, 0.04f, 0.7f, -0.5f, 0.1f}, options);
    double accounted = 0;
    for (const OrderPower& order : walk.orders)
        accounted += order.on_surfaces - order.reflected + order.absorbed_in_air + order.escaped;
    EXPECT_NEAR(accounted / walk.sent_lm, 1.0, 0.01);
}

// Lumens of an open beam that is even up to its edge: 2 pi I (1 - cos).
TEST(LightWalk, SendsTheLumensOfTheBeam) {
    const scene::Stage stage = closed_room({5, 6, 3}, 0);
    const Tracer tracer(stage);
    shared::Light light = spot({0, 0, 5}, {0, 0, 0}, 30, 0);
    light.profile_scale = 0;
    light.cut_radius = 1;
    light.iris_radius = 4;
    WalkOptions options;
    options.particles = 100'000;
    const Walk walk = walked(tracer, {light}, shared::Haze{}, options);
    const double expected = 2 * 3.14159265 * 1000 * (1 - std::cos(glm::radians(30.0)));
    EXPECT_NEAR(walk.sent_lm / expected, 1.0, 0.01);
}

// Order 0, joined to the camera, is the reference picture. Its mean: pixels are noisy. Lamps hang out of
// sight: haze is singular there.
TEST(LightWalk, OrderZeroIsTheReferencePicture) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    const scene::Camera camera = edgy_camera(32, 18);
    const std::vector<shared::Light> lights{spot({2, 0, 6}, {-1, 5, 0}, 12, 0),
                                            spot({-3, 8, 9}, {0, 4, 1}, 8, 1)};
    const shared::Haze haze{0.05f, 0.04f, 0.6f, -0.5f, 0.1f};
    WalkOptions options;
    options.particles = 2'000'000;
    options.camera = &camera;
    options.first_order = options.last_order = 0;
    const Walk walk = walked(tracer, lights, haze, options);
    ReferenceOptions exact;
    exact.air_samples = 64;
    exact.pixel_samples = 24; // the bars are thin;
    auto reference = reference_picture(&tracer, camera, lights, {}, haze, 0, exact);
    ASSERT_TRUE(reference.ok()) << reference.error().text();
    double ours = 0, theirs = 0, variance = 0;
    for (std::size_t i = 0; i < walk.picture.samples.size(); ++i) {
        ours += static_cast<double>(walk.picture.samples[i]);
        theirs += static_cast<double>(reference->samples[i]);
        variance += std::pow(static_cast<double>(walk.error.samples[i]), 2);
    }
    EXPECT_NEAR(ours / theirs, 1.0, 0.015);
    EXPECT_LT(std::sqrt(variance), 0.02 * theirs);
}

TEST(LightWalk, SameBytesOnAnyNumberOfThreads) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    const scene::Camera camera = edgy_camera(16, 9);
    WalkOptions options;
    options.particles = 20'000;
    options.camera = &camera;
    std::vector<Walk> walks;
    for (const int threads : {1, 2, 3}) {
        options.threads = threads;
        walks.push_back(
            walked(tracer, {spot({2, 0, 6}, {-1, 5, 0}, 12, 0)}, {0.05f, 0.04f, 0.6f, 0, 0}, options));
    }
    for (const Walk& walk : walks) {
        EXPECT_EQ(walk.picture.samples, walks[0].picture.samples);
        EXPECT_EQ(walk.error.samples, walks[0].error.samples);
        EXPECT_EQ(std::memcmp(&walk.orders, &walks[0].orders, sizeof walk.orders), 0);
    }
}

TEST(LightWalk, RefusesNumbersOutOfRange) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    WalkOptions options;
    options.particles = 0;
    EXPECT_FALSE(walk_light(tracer, {}, {}, {}, options).ok());
    options.particles = 100;
    options.first_order = 3;
    options.last_order = 2;
    EXPECT_FALSE(walk_light(tracer, {}, {}, {}, options).ok());
    options.first_order = 1;
    const Walk nothing = walked(tracer, {}, {}, options); // no lights, no light
    EXPECT_EQ(nothing.sent_lm, 0.0);
}

TEST(LightWalk, Stops) {
    const scene::Stage stage = edgy_stage();
    const Tracer tracer(stage);
    WalkOptions options;
    options.particles = 1'000'000'000;
    options.stop = [] { return true; };
    EXPECT_FALSE(walk_light(tracer, {spot({2, 0, 6}, {-1, 5, 0}, 12, 0)}, {}, {}, options).ok());
}

} // namespace
} // namespace ghost::bake
