// SPDX-License-Identifier: Apache-2.0
#include "image/colour.h"
#include "passes/distance_maps.h"
#include "shared/develop.h"
#include "show/haze_presets.h"
#include "show_file/show_toml.h"

#include <cmath>
#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

// Lines 1 to 7; line 8 is the first of what a test adds.
const std::string kHead = "[show]\n"
                          "name = \"Test\"\n"
                          "stage = \"tiny.glb\"\n"
                          "[[camera]]\n"
                          "name = \"house\"\n"
                          "position_m = [0, -10, 2]\n"
                          "target_m = [0, 0, 2]\n";

// The same with the short form of the even light, in line 4.
std::string with_ambient(const std::string& rest) {
    std::string text = kHead;
    text.insert(text.find("[[camera]]"), "ambient_lux = 3\n");
    return text + rest;
}

std::string all_text(const Report& report) {
    std::string text;
    for (const Message& message : report.messages) text += message.where + ": " + message.what + "\n";
    return text;
}

Show parse(const std::string& text, Report& report) {
    auto parsed = parse_show(text, "show/show.toml", report);
    EXPECT_TRUE(parsed.ok()) << parsed.error().text();
    return parsed.ok() ? std::move(parsed->show) : Show{};
}

Show good(const std::string& text) {
    Report report;
    Show show = parse(text, report);
    EXPECT_TRUE(report.messages.empty()) << all_text(report);
    return show;
}

void expect_near(const glm::vec3& value, const glm::vec3& expected) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(value[k], expected[k], 3e-4f) << "component " << k;
}

TEST(SceneToml, NestingHasAnEnd) {
    Report report;
    for (const char open : {'[', '{'}) {
        std::string text = "a = ";
        for (int k = 0; k < 2'000'000; ++k) text += open == '[' ? "[" : "{a=";
        const auto parsed = parse_show(text, "show/show.toml", report);
        ASSERT_FALSE(parsed.ok());
        EXPECT_NE(parsed.error().text().find("show/show.toml:1"), std::string::npos)
            << parsed.error().text().substr(0, 200);
    }
}

TEST(SceneToml, DefaultsArePhysical) {
    const Show show = good(kHead);
    EXPECT_EQ(show.ambient_lux, 0.0f);
    EXPECT_EQ(show.ambient_colour, glm::vec3(1));
    EXPECT_FLOAT_EQ(show.haze.extinction_per_m, 0.015f);
    EXPECT_EQ(show.haze.unevenness, 0.0f);
    EXPECT_EQ(show.haze.patch_m, 2.5f);
    EXPECT_EQ(show.haze.wind_m_s, glm::vec3(0));
    EXPECT_TRUE(show.hazers.empty());
    EXPECT_EQ(show.attenuation.constant, 0.0f);
    EXPECT_EQ(show.attenuation.linear, 0.0f);
    EXPECT_EQ(show.attenuation.quadratic, 1.0f);
    EXPECT_TRUE(show.shadows);
    EXPECT_EQ(show.distance_map_size, 0);
    EXPECT_TRUE(show.objects.empty());
}

TEST(SceneToml, EvenLight) {
    EXPECT_FLOAT_EQ(good(kHead + "[scene]\nintensity = 12.5\n").ambient_lux, 12.5f);
    EXPECT_FLOAT_EQ(good(with_ambient("")).ambient_lux, 3.0f);
    const Show blue = good(with_ambient("[scene]\ncolour = [0, 0, 1]\n"));
    EXPECT_FLOAT_EQ(blue.ambient_lux, 3.0f);
    EXPECT_NEAR(shared::luminance_of(blue.ambient_colour), 1.0f, 1e-4f);
    expect_near(blue.ambient_colour * 0.0722f, image::rec709_to_rec2020({0, 0, 1}));
    // How bright a colour is written does not matter.
    expect_near(good(kHead + "[scene]\nintensity = 1\ncolour = [0.2, 0.1, 0]\n").ambient_colour,
                good(kHead + "[scene]\nintensity = 1\ncolour = [1, 0.5, 0]\n").ambient_colour);
    expect_near(good(kHead + "[scene]\nintensity = 1\ncolour = \"#808080\"\n").ambient_colour, {1, 1, 1});
    // sRGB 188 is half the light: (0.5, 1, 0.5)
    const float half = image::srgb_to_linear(188.0f / 255.0f);
    expect_near(good(kHead + "[scene]\nintensity = 1\ncolour = \"#bcFFbc\"\n").ambient_colour,
                image::rec709_to_rec2020({half, 1, half}) / (0.2126f * half + 0.7152f + 0.0722f * half));
}

TEST(SceneToml, HazePresets) {
    double before = -1;
    for (const HazePreset& preset : kHazePresets) {
        const Show show = good(kHead + "[haze]\npreset = \"" + std::string(preset.name) + "\"\n");
        EXPECT_FLOAT_EQ(show.haze.extinction_per_m, static_cast<float>(preset.milligrams_per_m3 * 0.0045));
        EXPECT_FLOAT_EQ(show.haze.forward_g, 0.77f);
        EXPECT_FLOAT_EQ(show.haze.back_g, -0.60f);
        EXPECT_FLOAT_EQ(show.haze.back_weight, 0.035f);
        EXPECT_GT(preset.milligrams_per_m3, before) << "each thicker than the one before";
        before = preset.milligrams_per_m3;
    }
    EXPECT_EQ(good(kHead + "[haze]\npreset = \"none\"\n").haze.extinction_per_m, 0.0f);
    EXPECT_FLOAT_EQ(good(kHead + "[haze]\npreset = \"haze\"\n").haze.extinction_per_m, 0.0225f);
    EXPECT_FLOAT_EQ(good(kHead + "[haze]\npreset = \"fog\"\n").haze.extinction_per_m, 0.18f);
    EXPECT_FLOAT_EQ(good(kHead + "[haze]\nmilligrams_per_m3 = 2\n").haze.extinction_per_m, 0.009f);
}

TEST(SceneToml, HazeIntensityScalesAll) {
    EXPECT_FLOAT_EQ(good(kHead + "[haze]\npreset = \"haze\"\nintensity = 2\n").haze.extinction_per_m, 0.045f);
    EXPECT_FLOAT_EQ(good(kHead + "[haze]\nintensity = 0.5\n").haze.extinction_per_m, 0.0075f);
    EXPECT_EQ(good(kHead + "[haze]\npreset = \"fog\"\nintensity = 0\n").haze.extinction_per_m, 0.0f);
}

TEST(SceneToml, HazeThatNothingIsSeenThroughIsDrawnAndSaid) {
    Report report;
    const Show show = parse(kHead + "[haze]\nextinction_per_m = 9\nintensity = 10\n", report);
    EXPECT_EQ(show.haze.extinction_per_m, 10.0f);
    ASSERT_EQ(report.messages.size(), 1u) << all_text(report);
    EXPECT_NE(report.messages[0].what.find("half of all light is gone after 7 cm"), std::string::npos);
}

TEST(SceneToml, TheMostExactDensityWins) {
    Report report;
    const Show show = parse(kHead + "[haze]\npreset = \"fog\"\nconcentration_mg_per_m3 = 1\n"
                                    "milligrams_per_m3 = 2\nextinction_per_m = 0.5\n",
                            report);
    EXPECT_FLOAT_EQ(show.haze.extinction_per_m, 0.5f);
    EXPECT_EQ(report.messages.size(), 3u) << all_text(report);
    for (const char* key : {"preset", "concentration_mg_per_m3", "milligrams_per_m3"})
        EXPECT_NE(all_text(report).find(std::string(key) + " is not used: extinction_per_m is there, too"),
                  std::string::npos)
            << all_text(report);
    report = {};
    // What is no use does not win.
    EXPECT_FLOAT_EQ(
        parse(kHead + "[haze]\npreset = \"fog\"\nextinction_per_m = nan\n", report).haze.extinction_per_m,
        0.18f);
    EXPECT_EQ(report.messages.size(), 1u) << all_text(report);
}

TEST(SceneToml, HazeThatMoves) {
    const Show show = good(kHead + R"([haze]
unevenness = 0.4
patch_m = 1.5
wind_m_s = [0.2, 0, -0.1]
[[hazer]]
position_m = [1, 2, 0.3]
direction = [0, -4, 3]
rate = 8
spread_deg = 25
reach_m = 4.5
[[hazer]]
position_m = [-1, 2, 0]
)");
    EXPECT_FLOAT_EQ(show.haze.unevenness, 0.4f);
    EXPECT_FLOAT_EQ(show.haze.patch_m, 1.5f);
    expect_near(show.haze.wind_m_s, {0.2f, 0, -0.1f});
    ASSERT_EQ(show.hazers.size(), 2u);
    expect_near(show.hazers[0].position_m, {1, 2, 0.3f});
    expect_near(show.hazers[0].direction, {0, -0.8f, 0.6f});
    EXPECT_FLOAT_EQ(show.hazers[0].rate, 8);
    EXPECT_FLOAT_EQ(show.hazers[0].spread_deg, 25);
    EXPECT_FLOAT_EQ(show.hazers[0].reach_m, 4.5f);
    EXPECT_EQ(show.hazers[1].direction, glm::vec3(0, 0, 1));
}

TEST(SceneToml, AttenuationAndShadows) {
    const Show show = good(kHead + "[attenuation]\nconstant = 1\nlinear = 0.09\nquadratic = 0.032\n"
                                   "[shadows]\non = false\nmap_size = 1024\n");
    EXPECT_FLOAT_EQ(show.attenuation.constant, 1);
    EXPECT_FLOAT_EQ(show.attenuation.linear, 0.09f);
    EXPECT_FLOAT_EQ(show.attenuation.quadratic, 0.032f);
    EXPECT_FALSE(show.shadows);
    EXPECT_EQ(show.distance_map_size, 1024);
    const Show linear = good(kHead + "[attenuation]\nlinear = 0.5\n");
    EXPECT_FLOAT_EQ(linear.attenuation.linear, 0.5f);
    EXPECT_FLOAT_EQ(linear.attenuation.quadratic, 1) << "what is not named stays";
    EXPECT_FLOAT_EQ(good(kHead + "[attenuation]\nlinear = 1\nquadratic = 0\n").attenuation.quadratic, 0);
}

TEST(SceneToml, Objects) {
    const Show show = good(kHead + R"([[object]]
name = "Drum*"
diffuse = [0.5, 0.25, 0]
specular = 0.5
shininess = 510
metalness = 1
shown = false
move_m = [0, 1, 0]
[[object]]
name = "Wall"
diffuse = 0.5
roughness = 0.3
)");
    ASSERT_EQ(show.objects.size(), 2u);
    const ObjectSettings& drums = show.objects[0];
    EXPECT_EQ(drums.name, "Drum*");
    EXPECT_EQ(drums.where, "show/show.toml:9");
    ASSERT_TRUE(drums.diffuse.has_value());
    expect_near(*drums.diffuse, image::rec709_to_rec2020({0.5f, 0.25f, 0}));
    EXPECT_FALSE(drums.diffuse_factor.has_value());
    EXPECT_EQ(drums.specular, 0.5f);
    EXPECT_NEAR(drums.roughness.value_or(0), 0.25f, 1e-6f);
    EXPECT_EQ(drums.metalness, 1.0f);
    EXPECT_EQ(drums.shown, false);
    EXPECT_EQ(drums.move_m, glm::vec3(0, 1, 0));
    const ObjectSettings& wall = show.objects[1];
    EXPECT_FALSE(wall.diffuse.has_value());
    EXPECT_EQ(wall.diffuse_factor, 0.5f);
    EXPECT_EQ(wall.roughness, 0.3f);
    EXPECT_FALSE(wall.shown.has_value());
    EXPECT_FALSE(wall.move_m.has_value());
}

struct Wrong {
    const char* title;
    std::string text;
    int line;
    Severity severity;
    const char* part;
};

class SceneTomlWrong : public testing::TestWithParam<Wrong> {};

// One message, and what is as if nothing had been written: the defaults, and the camera.
TEST_P(SceneTomlWrong, NamesTheLineAndKeepsTheDefault) {
    Report report;
    const Show show = parse(GetParam().text, report);
    ASSERT_EQ(report.messages.size(), 1u) << all_text(report);
    EXPECT_EQ(report.messages[0].where, "show/show.toml:" + std::to_string(GetParam().line))
        << all_text(report);
    EXPECT_EQ(report.messages[0].severity, GetParam().severity) << all_text(report);
    EXPECT_NE(report.messages[0].what.find(GetParam().part), std::string::npos) << all_text(report);
    ASSERT_EQ(show.cameras.size(), 1u);
    EXPECT_FLOAT_EQ(show.haze.extinction_per_m, 0.015f);
    EXPECT_EQ(show.haze.unevenness, 0.0f);
    EXPECT_EQ(show.haze.patch_m, 2.5f);
    EXPECT_EQ(show.haze.wind_m_s, glm::vec3(0));
    EXPECT_EQ(show.attenuation.quadratic, 1.0f);
    EXPECT_TRUE(show.shadows);
    EXPECT_EQ(show.distance_map_size, 0);
    for (const Hazer& hazer : show.hazers) {
        EXPECT_NEAR(glm::length(hazer.direction), 1.0f, 1e-5f);
        EXPECT_EQ(hazer.rate, Hazer{}.rate);
        EXPECT_EQ(hazer.spread_deg, Hazer{}.spread_deg);
        EXPECT_EQ(hazer.reach_m, Hazer{}.reach_m);
    }
    for (const ObjectSettings& object : show.objects) {
        EXPECT_FALSE(object.diffuse || object.diffuse_factor || object.specular || object.metalness ||
                     object.shown || object.move_m);
        if (object.roughness) {
            EXPECT_EQ(*object.roughness, 0.5f);
        }
    }
}

const std::string kHazer = kHead + "[[hazer]]\nposition_m = [0, 0, 0]\n";
const std::string kObject = kHead + "[[object]]\nname = \"x\"\n";

const Wrong kWrong[] = {
    {"two_even_lights", with_ambient("[scene]\nintensity = 5\n"), 4, Severity::warning,
     "[show] ambient_lux is not used: [scene] intensity (line 10) says the same"},
    {"colour_of_nothing", kHead + "[scene]\ncolour = [1, 0, 0]\n", 9, Severity::warning,
     "intensity (lux) is missing"},
    {"black", with_ambient("[scene]\ncolour = [0, 0, 0]\n"), 10, Severity::error, "is black"},
    {"colour_word", with_ambient("[scene]\ncolour = \"blue\"\n"), 10, Severity::error,
     "is 'blue', expected a colour: [red, green, blue], each from 0 to 1, or \"#rrggbb\""},
    {"colour_letters", with_ambient("[scene]\ncolour = \"#12345g\"\n"), 10, Severity::error,
     "expected a colour"},
    {"colour_short", with_ambient("[scene]\ncolour = \"#fff\"\n"), 10, Severity::error, "expected a colour"},
    {"colour_nan", with_ambient("[scene]\ncolour = [nan, 0, 0]\n"), 10, Severity::error, "expected a colour"},
    {"colour_of_bytes", with_ambient("[scene]\ncolour = [255, 0, 0]\n"), 10, Severity::error,
     "expected a colour"},
    {"intensity", kHead + "[scene]\nintensity = -1\n", 9, Severity::error,
     "expected a number from 0 to 200000"},
    {"scene_key", kHead + "[scene]\nintensitty = 1\n", 9, Severity::warning, "did you mean 'intensity'?"},
    {"preset", kHead + "[haze]\npreset = \"fogs\"\n", 9, Severity::error,
     "is 'fogs', expected one of \"none\", \"hint\", \"light haze\", \"haze\", \"heavy haze\", \"fog\", did "
     "you mean "
     "'fog'?"},
    {"preset_number", kHead + "[haze]\npreset = 3\n", 9, Severity::error, "expected a text"},
    {"milligrams", kHead + "[haze]\nmilligrams_per_m3 = 1e9\n", 9, Severity::error,
     "expected a number from 0 to 1000"},
    {"smoke", kHead + "[haze]\nintensity = -0.5\n", 9, Severity::error, "expected a number from 0 to 10"},
    {"unevenness", kHead + "[haze]\nunevenness = 1.5\n", 9, Severity::error, "expected a number from 0 to 1"},
    {"patch", kHead + "[haze]\npatch_m = 0\n", 9, Severity::error, "expected a number from 0.1 to 100"},
    {"wind", kHead + "[haze]\nwind_m_s = [0, inf, 0]\n", 9, Severity::error, "expected three numbers"},
    {"hazer_nowhere", kHead + "[[hazer]]\nrate = 3\n", 8, Severity::error, "position_m is missing"},
    {"hazer_not_a_number", kHead + "[[hazer]]\nposition_m = [nan, 0, 0]\n", 9, Severity::error,
     "expected three numbers"},
    {"hazer_direction", kHazer + "direction = [0, 0, 0]\n", 10, Severity::error, "it goes up"},
    {"hazer_rate", kHazer + "rate = inf\n", 10, Severity::error, "expected a number from 0 to 1000"},
    {"hazer_spread", kHazer + "spread_deg = 0\n", 10, Severity::error, "expected a number from 1 to 180"},
    {"hazer_reach", kHazer + "reach_m = 0\n", 10, Severity::error, "expected a number from 0.1 to 1000"},
    {"hazer_table", kHead + "[hazer]\nposition_m = [0, 0, 0]\n", 8, Severity::error, "write [[hazer]]"},
    {"attenuation", kHead + "[attenuation]\nlinear = -1\n", 9, Severity::error,
     "expected a number from 0 to 1000"},
    {"attenuation_nan", kHead + "[attenuation]\nquadratic = nan\n", 9, Severity::error,
     "expected a number from 0 to 1000"},
    {"no_attenuation", kHead + "[attenuation]\n\nquadratic = 0\n", 10, Severity::error,
     "expected one of the three above 0"},
    {"shadows", kHead + "[shadows]\non = 1\n", 9, Severity::error,
     "[shadows] on is 1, expected true or false"},
    {"map_size", kHead + "[shadows]\nmap_size = 63\n", 9, Severity::error,
     "expected a whole number from 64 to 4096"},
    {"map_size_large", kHead + "[shadows]\nmap_size = 4097\n", 9, Severity::error, "expected a whole number"},
    {"map_size_fraction", kHead + "[shadows]\nmap_size = 512.5\n", 9, Severity::error,
     "expected a whole number"},
    {"object_without_name", kHead + "[[object]]\nshown = false\n", 8, Severity::error, "name is missing"},
    {"object_without_keys", kObject, 9, Severity::warning, "'x' says nothing about the object"},
    {"object_key", kObject + "roughness = 0.5\nshinyness = 3\n", 11, Severity::warning,
     "did you mean 'shininess'?"},
    {"diffuse_factor", kObject + "diffuse = -1\n", 10, Severity::error, "expected a number from 0 to 100"},
    {"diffuse_colour", kObject + "diffuse = [1, 2, 3]\n", 10, Severity::error, "expected a colour"},
    {"specular", kObject + "specular = 1.1\n", 10, Severity::error, "expected a number from 0 to 1"},
    {"shininess", kObject + "shininess = 0\n", 10, Severity::error, "expected a number from 1 to 10000"},
    {"shininess_large", kObject + "shininess = 10001\n", 10, Severity::error,
     "expected a number from 1 to 10000"},
    {"shininess_and_roughness", kObject + "roughness = 0.5\nshininess = 100\n", 11, Severity::warning,
     "shininess is not used: roughness is there, too"},
    {"metalness", kObject + "metalness = \"gold\"\n", 10, Severity::error, "expected a number from 0 to 1"},
    {"shown", kObject + "shown = \"no\"\n", 10, Severity::error, "expected true or false"},
    {"moved_out_of_the_world", kObject + "move_m = [0, 1e30, 0]\n", 10, Severity::error,
     "expected three numbers"},
};

INSTANTIATE_TEST_SUITE_P(All, SceneTomlWrong, testing::ValuesIn(kWrong),
                         [](const auto& wrong) { return std::string(wrong.param.title); });

// Places and turns that are no numbers, or far out of the world.
TEST(SceneToml, PlacesThatAreNone) {
    for (const std::string bad : {"nan", "inf", "-inf", "1e300", "1e39", "-10001"}) {
        Report report;
        const std::string point = "[0, " + bad + ", 1]";
        const Show show =
            parse("[show]\nstage = \"x.glb\"\n[[camera]]\nname = \"a\"\nposition_m = " + point +
                      "\ntarget_m = " + point + "\nfov_y_deg = " + bad + "\nev100 = " + bad +
                      "\n[[fixture]]\nname = \"f\"\ngdtf = \"f.gdtf\"\naddress = 1\nposition_m = " + point +
                      "\nrotation_deg = " + point + "\nhome_deg = [" + bad + ", 0]\n",
                  report);
        ASSERT_EQ(report.messages.size(), 7u) << all_text(report);
        for (const char* line : {"5", "6", "7", "8", "13", "14", "15"})
            EXPECT_NE(all_text(report).find(std::string("show.toml:") + line + ": "), std::string::npos)
                << all_text(report);
        EXPECT_EQ(show.cameras[0].position_m, Camera{}.position_m);
        EXPECT_EQ(show.cameras[0].target_m, Camera{}.target_m);
        EXPECT_EQ(show.cameras[0].fov_y_deg, 40.0f);
        EXPECT_EQ(show.cameras[0].ev100, 6.0f);
        EXPECT_EQ(show.fixtures[0].position_m, glm::vec3(0));
        EXPECT_EQ(show.fixtures[0].rotation_deg, glm::vec3(0));
        EXPECT_EQ(show.fixtures[0].home_pan_deg, 0.0f);
        EXPECT_TRUE(std::isfinite(fixture_to_world(show.fixtures[0], 0)[3].y));
    }
}

TEST(SceneToml, HowLightBounces) {
    EXPECT_EQ(good(kHead).bounce, BounceDetail::off);
    EXPECT_EQ(good(kHead + "[light]\n").bounce, BounceDetail::off);
    for (const char* const name : kBounceDetails)
        EXPECT_STREQ(name_of(good(kHead + "[light]\nbounce = \"" + name + "\"\n").bounce), name);
    Report report;
    EXPECT_EQ(parse(kHead + "[light]\nbounce = \"normel\"\n", report).bounce, BounceDetail::off);
    EXPECT_EQ(all_text(report),
              "show/show.toml:9: [light] bounce is 'normel', expected one of \"off\", \"room\", "
              "\"normal\", \"fine\", did you mean 'normal'?\n");
    for (const char* const wrong :
         {"bounce = true", "bounce = 2", "bounce = [\"fine\"]", "bounces = \"fine\""}) {
        Report said;
        EXPECT_EQ(parse(kHead + "[light]\n" + wrong + "\n", said).bounce, BounceDetail::off);
        EXPECT_EQ(said.messages.size(), 1u) << wrong << "\n" << all_text(said);
    }
    Report of_list;
    (void)parse(kHead + "[[light]]\nbounce = \"fine\"\n", of_list);
    EXPECT_EQ(of_list.messages.size(), 1u) << all_text(of_list);
}

TEST(CircuitToml, says_what_feeds_fixtures) {
    Report report;
    const Show show = parse(kHead + R"([[circuit]]
name = "A1"
phase = "L2"
breaker_a = 16
voltage_v = 230
[[circuit]]
name = "A2"
phase = "L4"
breaker_a = -1
[[circuit]]
phase = "L1"
[[circuit]]
name = "A1"
[[fixture]]
name = "Spot"
gdtf = "a.gdtf"
address = 1
position_m = [0, 0, 5]
circuit = "A11"
)",
                            report);
    ASSERT_EQ(show.circuits.size(), 2u);
    EXPECT_EQ(show.circuits[0].phase, "L2");
    EXPECT_EQ(show.circuits[0].breaker_a, 16);
    EXPECT_EQ(show.circuits[0].voltage_v, 230);
    EXPECT_EQ(show.circuits[1].phase, "");
    EXPECT_EQ(show.circuits[1].breaker_a, 0);
    EXPECT_EQ(show.fixtures.at(0).circuit, "A11");
    check_circuits(show, report);
    const std::string said = all_text(report);
    for (const char* part :
         {"'L4', expected \"L1\", \"L2\" or \"L3\"", "by which fixtures name it",
          "is that of another circuit", "no [[circuit]] is called 'A11', which feeds 'Spot'"})
        EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
}

} // namespace
} // namespace ghost::scene
