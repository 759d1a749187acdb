// SPDX-License-Identifier: Apache-2.0
#include "live/session/atmosphere.h"

#include <gtest/gtest.h>

namespace ghost::app {
namespace {

scene::Show hazy_show() {
    scene::Show show;
    show.haze.extinction_per_m = 0.04f;
    show.haze.albedo = 0.5f;
    show.ambient_lux = 3;
    show.ambient_colour = {1, 0.5f, 0.25f};
    return show;
}

TEST(Atmosphere, without_hands_it_is_the_shows) {
    const Atmosphere air = atmosphere_of(hazy_show());
    EXPECT_EQ(air.medium().extinction_per_m, 0.04f);
    EXPECT_EQ(air.medium().scattering_per_m, 0.02f);
    EXPECT_EQ(air.ambient, glm::vec3(3, 1.5f, 0.75f));
    EXPECT_EQ(air.field().attenuation.quadratic, 1.0f);
}

TEST(Atmosphere, a_look_and_a_remote_control_come_on_top_and_the_show_stays) {
    const scene::Show show = hazy_show();
    scene::SceneLook look;
    look.smoke = 2.0f;
    look.ambient_lux = 10.0f;
    look.attenuation = glm::vec3(1, 0.5f, 0);
    const Atmosphere air = atmosphere_of(show, look, 3.0f);
    EXPECT_FLOAT_EQ(air.medium().extinction_per_m, 0.24f);
    EXPECT_FLOAT_EQ(air.medium().scattering_per_m, 0.12f);
    EXPECT_EQ(air.ambient, glm::vec3(10, 5, 2.5f));
    EXPECT_EQ(air.field().attenuation.linear, 0.5f);
    EXPECT_EQ(air.field().attenuation.quadratic, 0.0f);
    EXPECT_EQ(show.haze.extinction_per_m, 0.04f);
}

TEST(Atmosphere, what_a_look_asks_for_has_limits) {
    scene::SceneLook look;
    look.smoke = -1.0f;
    look.ambient_lux = 1e9f;
    look.ambient_colour = glm::vec3(1);
    const Atmosphere air = atmosphere_of(hazy_show(), look);
    EXPECT_EQ(air.medium().extinction_per_m, 0.0f);
    EXPECT_EQ(air.ambient.x, 100000.0f);
}

TEST(Atmosphere, time_moves_only_what_is_uneven) {
    scene::Show show = hazy_show();
    show.haze.wind_m_s = glm::vec3(1, 0, 0);
    EXPECT_FALSE(atmosphere_of(show).is_uneven());
    EXPECT_EQ(atmosphere_of(show).field(5).drift_m, glm::vec3(0));
    show.haze.unevenness = 0.5f;
    EXPECT_TRUE(atmosphere_of(show).is_uneven());
    EXPECT_EQ(atmosphere_of(show).field(5).drift_m, glm::vec3(5, 0, 0));
    show.haze.unevenness = 0;
    show.hazers.push_back({});
    EXPECT_TRUE(atmosphere_of(show).is_uneven());
    EXPECT_EQ(atmosphere_of(show).field(5).hazers, 1);
}

} // namespace
} // namespace ghost::app
