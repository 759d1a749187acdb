// SPDX-License-Identifier: Apache-2.0
// The light meter against what is known: a lamp of the demo straight above the floor gives I / d^2, the
// picture of lux and the rays say the same, shadows included, and what is hidden throws none.
#include "live/lux/light_meter.h"

#include "light/illuminance.h"
#include "shared/develop.h"
#include "support/demo_copy.h"
#include "support/must.h"
#include "support/test_stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

namespace ghost::app {
namespace {

struct Meter {
    Meter() {
        SessionOptions options;
        options.show = DemoCopy::show().string();
        options.live = true;
        options.quiet = true;
        options.keep_hidden = true;
        options.width = 96;
        options.height = 72;
        session = must(open_session(options));
        session->show->motion = fixture::Motion::as_commanded;
        session->show->haze.extinction_per_m = 0;
        session->show->ambient_lux = 0;
    }
    // One lamp, looking down with a wide beam.
    void light_one() {
        session->rig->step(
            {}, 0,
            {{0, {.intensity = 1.0f, .zoom_deg = 40.0f, .pan_deg = 0.0f, .tilt_deg = 0.0f, .gobo = 0}}});
        lit = session->lit();
    }
    void look_at(const glm::vec3& from_m, const glm::vec3& to_m) {
        scene::Camera camera = session->show->cameras.front();
        camera.position_m = from_m;
        camera.target_m = to_m;
        camera.fov_y_deg = 20;
        camera.width = 96;
        camera.height = 72;
        session->look_from(camera);
        session->draw();
    }
    const shared::Light& light() const { return lit.lights.front(); }

    std::unique_ptr<Session> session;
    scene::FrameLights lit;
};

TEST(LightMeter, straight_below_a_lamp_it_shows_candela_over_the_square_of_metres) {
    Meter meter;
    meter.light_one();
    const bake::DenormalsOff mode;
    const bake::Tracer tracer(meter.session->live->solid());
    const shared::Light& light = meter.light();
    const bake::Surface floor = tracer.first_hit(light.position_m, light.axis_w, 0.5f, bake::Sees::no_bodies);
    ASSERT_GE(floor.instance, 0);
    const float peak_cd = shared::luminance_of(light.intensity_cd);
    ASSERT_GT(peak_cd, 10000) << "a VL2500 Spot";
    const float cosine = -glm::dot(floor.facet_normal, light.axis_w);
    const float wanted = peak_cd * cosine / (floor.distance_m * floor.distance_m);
    EXPECT_NEAR(lux_at(floor, meter.lit, *meter.session, tracer).all, wanted, 0.01f * wanted);
    meter.look_at(floor.position + glm::vec3(1.5f, -1.5f, 2.5f), floor.position);
    const image::ImageF lux = lux_picture(*meter.session, meter.lit);
    EXPECT_NEAR(*lux.at(48, 36), wanted, 0.02f * wanted);
    // Even light adds what the show says.
    meter.session->show->ambient_lux = 50;
    EXPECT_NEAR(lux_at(floor, meter.lit, *meter.session, tracer).all, wanted + 50, 0.01f * wanted);
    EXPECT_NEAR(*lux_picture(*meter.session, meter.lit).at(48, 36), wanted + 50, 0.02f * wanted);
}

TEST(LightMeter, the_picture_and_the_rays_say_the_same) {
    Meter meter;
    std::map<std::size_t, fixture::Programmer> programmer;
    for (std::size_t i = 0; i < meter.session->show->fixtures.size(); ++i)
        programmer[i] = {.intensity = 1.0f, .zoom_deg = 45.0f, .tilt_deg = 20.0f, .gobo = 0};
    meter.session->rig->step({}, 0, programmer);
    meter.lit = meter.session->lit();
    meter.look_at({0, -9, 4}, {0, 4, 1});
    const image::ImageF lux = lux_picture(*meter.session, meter.lit);
    const bake::DenormalsOff mode;
    const bake::Tracer tracer(meter.session->live->solid());
    std::vector<float> ratios;
    for (int y = 2; y < 72; y += 3)
        for (int x = 2; x < 96; x += 3) {
            const glm::vec2 place((static_cast<float>(x) + 0.5f) / 96, (static_cast<float>(y) + 0.5f) / 72);
            const bake::Surface surface = surface_at(meter.session->live->camera(), place, tracer);
            if (surface.instance < 0) continue;
            const float by_rays = lux_at(surface, meter.lit, *meter.session, tracer).all;
            if (by_rays >= 1) ratios.push_back(*lux.at(x, y) / by_rays);
        }
    ASSERT_GT(ratios.size(), 100u);
    std::sort(ratios.begin(), ratios.end());
    const auto at = [&](double share) {
        return ratios[static_cast<std::size_t>(share * static_cast<double>(ratios.size() - 1))];
    };
    std::printf("picture / rays in %zu places: %.3f %.3f %.3f %.3f %.3f\n", ratios.size(), double(at(0.1)),
                double(at(0.25)), double(at(0.5)), double(at(0.75)), double(at(0.9)));
    EXPECT_NEAR(at(0.5), 1, 0.02);
    // A pixel is decimetres of stage with its edges and half-shadows, a ray is a point.
    EXPECT_GT(at(0.25), 0.75);
    EXPECT_LT(at(0.75), 1.25);
}

// Of two pictures, in lux.
float most_difference(const image::ImageF& a, const image::ImageF& b) {
    float most = 0;
    for (std::size_t i = 0; i < a.samples.size(); ++i)
        most = std::max(most, std::abs(a.samples[i] - b.samples[i]));
    return most;
}

TEST(LightMeter, of_what_moves_the_picture_is_that_of_a_meter_that_is_new) {
    Meter meter;
    std::map<std::size_t, fixture::Programmer> programmer;
    const auto turn = [&](float pan_deg) {
        for (std::size_t i = 0; i < meter.session->show->fixtures.size(); ++i)
            programmer[i] = {.intensity = 1.0f, .zoom_deg = 30.0f, .pan_deg = pan_deg, .tilt_deg = 20.0f};
        meter.session->rig->step({}, 0, programmer);
        meter.session->draw();
        meter.lit = meter.session->lit();
    };
    const auto measured = [&] { return lux_picture(*meter.session, meter.lit, false); };
    const auto measured_anew = [&] {
        meter.session->lux_light.reset();
        return measured();
    };
    const auto brightest = [](const image::ImageF& lux) {
        return *std::max_element(lux.samples.begin(), lux.samples.end());
    };
    turn(0);
    meter.look_at({0, -9, 4}, {0, 4, 1});
    for (int k = 0; k < 3; ++k) (void)measured(); // what surfaces see of lamps is kept by then
    // The camera moves,
    meter.look_at({3, -8, 3}, {-1, 4, 2});
    const image::ImageF from_there = measured();
    ASSERT_GT(brightest(from_there), 100);
    EXPECT_LT(most_difference(from_there, measured_anew()), 0.002f * brightest(from_there));
    // heads that are seen turn,
    meter.look_at({0, 2, 9}, {0, 4, 0});
    for (int k = 0; k < 3; ++k) (void)measured();
    turn(40);
    const image::ImageF turned = measured();
    ASSERT_GT(brightest(turned), 100);
    EXPECT_LT(most_difference(turned, measured_anew()), 0.002f * brightest(turned));
    // and a flight has a picture of its own.
    meter.session->options.parks = true;
    scene::Camera camera = meter.session->live->camera();
    camera.position_m.x += 1;
    meter.session->look_from(camera, true);
    const image::ImageF flown = measured();
    ASSERT_GT(brightest(flown), 100);
    EXPECT_LT(most_difference(flown, measured_anew()), 0.002f * brightest(flown));
    camera.position_m.x += 1;
    meter.session->look_from(camera, false);
    meter.session->drop_parked();
    const image::ImageF landed = measured();
    EXPECT_LT(most_difference(landed, measured_anew()), 0.002f * brightest(landed));
}

TEST(LightMeter, what_is_hidden_throws_no_shadow) {
    Meter meter;
    meter.light_one();
    const bake::DenormalsOff mode;
    const shared::Light& light = meter.light();
    bake::Surface under;
    std::size_t first_object = 0;
    {
        const bake::Tracer tracer(meter.session->live->solid());
        const bake::Surface first =
            tracer.first_hit(light.position_m, light.axis_w, 0.5f, bake::Sees::no_bodies);
        ASSERT_GE(first.instance, 0);
        // solid() is the whole stage: nothing is hidden in the demo.
        first_object = static_cast<std::size_t>(first.instance);
    }
    meter.session->live->show(first_object, false);
    const scene::Stage without = meter.session->live->solid_now();
    const bake::Tracer tracer(without);
    under = tracer.first_hit(light.position_m, light.axis_w, 0.5f, bake::Sees::no_bodies);
    ASSERT_GE(under.instance, 0) << "something lies below what was hidden";
    meter.look_at(under.position + glm::vec3(0, -1.0f, 0.5f), under.position);
    const float wanted = lux_at(under, meter.lit, *meter.session, tracer).all;
    ASSERT_GT(wanted, 10);
    EXPECT_LT(*lux_picture(*meter.session, meter.lit).at(48, 36), 0.1f * wanted)
        << "the shadow is there until the maps are made";
    for (int i = 0; i < 600 && (i == 0 || meter.session->live->is_making_maps()); ++i) {
        meter.session->draw();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    EXPECT_NEAR(*lux_picture(*meter.session, meter.lit).at(48, 36), wanted, 0.1f * wanted);
    // And it comes back with the object.
    meter.session->live->show(first_object, true);
    for (int i = 0; i < 600 && (i == 0 || meter.session->live->is_making_maps()); ++i) {
        meter.session->draw();
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    meter.session->live->show(first_object, false); // so that the floor below is seen
    meter.look_at(under.position + glm::vec3(0, -1.0f, 0.5f), under.position);
    EXPECT_LT(*lux_picture(*meter.session, meter.lit).at(48, 36), 0.1f * wanted);
}

// A bar of 6 cm, 10 m away, before a wall.
TEST(LightMeter, a_lattice_before_a_wall_is_met_where_the_way_goes_past_its_bars) {
    scene::Stage stage;
    const int grey = bake::add_material(stage, {0.5f, 0.5f, 0.5f});
    bake::place(stage, bake::add_mesh(stage, bake::quad_mesh({-20, 20, -20}, {40, 0, 0}, {0, 0, 40}), grey));
    const int bar = bake::add_mesh(stage, bake::box_mesh({0.03f, 0.03f, 3}), grey);
    bake::place(stage, bar, glm::translate(glm::mat4(1.0f), glm::vec3(0, 10, 0)));
    bake::place(stage, bar, glm::translate(glm::mat4(1.0f), glm::vec3(2, 10, 0)), 0); // of a fixture
    const bake::Tracer tracer(stage);
    const auto met = [&](float x_m, float beside) {
        return surface_near({0, 0, 0}, glm::normalize(glm::vec3(x_m, 10, 0)), beside, tracer).instance;
    };
    EXPECT_EQ(met(0, 0), 1);
    EXPECT_EQ(met(0.1f, 0), 0) << "past it";
    EXPECT_EQ(met(0.1f, 0.012f), 1);
    EXPECT_EQ(met(-0.1f, 0.012f), 1);
    EXPECT_EQ(met(0.3f, 0.012f), 0) << "not that near";
    EXPECT_EQ(met(1.9f, 0.012f), 0) << "heads have marks of their own";
    EXPECT_EQ(met(2.0f, 0.012f), 2) << "what is met itself is meant";
}

} // namespace
} // namespace ghost::app
