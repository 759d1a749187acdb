// SPDX-License-Identifier: Apache-2.0
// Open Fixture Library fixtures written here.
#include "fixture_files/ofl/ofl.h"

#include "fixture_files/load_type.h"
#include "fixture_files/ofl/private/ofl_reader.h"
#include "support/tiny_ofl.h"

#include <fstream>

namespace ghost::fixture {
namespace {

TEST(ofl, entities_have_units_and_words) {
    const EntityScale turn{2, 360};
    EXPECT_FLOAT_EQ(*entity(Json("10Hz"), Quantity::strobe, {1, 20}), 10.0f);
    EXPECT_FLOAT_EQ(*entity(Json("120bpm"), Quantity::strobe, {1, 20}), 2.0f);
    EXPECT_FLOAT_EQ(*entity(Json("fast"), Quantity::strobe, {1, 20}), 20.0f);
    EXPECT_FLOAT_EQ(*entity(Json("slow"), Quantity::strobe, {1, 20}), 1.0f);
    EXPECT_FLOAT_EQ(*entity(Json("stop"), Quantity::strobe, {1, 20}), 0.0f);
    EXPECT_FLOAT_EQ(*entity(Json("slow CCW"), Quantity::rotation, turn), -2.0f);
    EXPECT_FLOAT_EQ(*entity(Json("fast CW"), Quantity::rotation, turn), 360.0f);
    EXPECT_FLOAT_EQ(*entity(Json("10rpm"), Quantity::rotation, turn), 60.0f);
    EXPECT_FLOAT_EQ(*entity(Json("0.5Hz"), Quantity::rotation, turn), 180.0f);
    EXPECT_FLOAT_EQ(*entity(Json("50%"), Quantity::share, {}), 0.5f);
    EXPECT_FLOAT_EQ(*entity(Json("bright"), Quantity::share, {}), 1.0f);
    EXPECT_FLOAT_EQ(*entity(Json("120deg"), Quantity::angle, {0, 540}), 120.0f);
    EXPECT_FLOAT_EQ(*entity(Json("50%"), Quantity::angle, {0, 540}), 270.0f);
    EXPECT_FLOAT_EQ(*entity(Json("narrow"), Quantity::beam_angle, {8, 40}), 8.0f);
    EXPECT_FLOAT_EQ(*entity(Json("250ms"), Quantity::time, {0, 10}), 0.25f);
    EXPECT_FLOAT_EQ(*entity(Json("3200K"), Quantity::temperature, {3200, 9000, 6000}), 3200.0f);
    EXPECT_FLOAT_EQ(*entity(Json("warm"), Quantity::temperature, {3200, 9000, 6000}), 3200.0f);
    EXPECT_NEAR(*entity(Json("10m"), Quantity::distance, {}), 0.5, 1e-4);
    EXPECT_FLOAT_EQ(*entity(Json("far"), Quantity::distance, {}), 1.0f);
    EXPECT_FLOAT_EQ(*entity(Json(2.5), Quantity::plain, {}), 2.5f);
    for (const Json& bad : {Json("nan%"), Json("1e999Hz"), Json("fastish"), Json(""), Json("--5%"),
                            Json(nullptr), Json("5 parsecs"), Json(1e300)})
        EXPECT_FALSE(entity(bad, Quantity::strobe, {1, 20}).has_value()) << bad.dump();
}

TEST(ofl, a_moving_head_with_wheels_and_fine_channels) {
    const LoadedType type = loaded(fixture(kPhysical + R"json(
"wheels": {"Colour": {"slots": [{"type": "Open"}, {"type": "Color", "name": "Red", "colors": ["#ff0000"]},
  {"type": "Color", "name": "Blue", "colors": ["#0000ff"]}, {"type": "Color", "name": "CTO", "colorTemperature": "3200K"}]},
 "Gobos": {"slots": [{"type": "Open"}, {"type": "Gobo", "name": "Leaf", "resource": "leaf"}, {"type": "Gobo"}]}},
"availableChannels": {
 "Pan": {"fineChannelAliases": ["Pan fine", "Pan fine^2"], "capability": {"type": "Pan", "angleStart": "0deg", "angleEnd": "540deg"}},
 "Tilt": {"fineChannelAliases": ["Tilt fine"], "dmxValueResolution": "8bit", "defaultValue": 128,
  "capability": {"type": "Tilt", "angleStart": "-120deg", "angleEnd": "120deg"}},
 "Spin": {"capabilities": [{"dmxRange": [0, 127], "type": "NoFunction"},
  {"dmxRange": [128, 255], "type": "TiltContinuous", "speedStart": "slow CW", "speedEnd": "fast CW"}]},
 "Dimmer": {"capability": {"type": "Intensity", "brightnessStart": "bright", "brightnessEnd": "off"}},
 "Shutter": {"capabilities": [
  {"dmxRange": [0, 9], "type": "ShutterStrobe", "shutterEffect": "Closed"},
  {"dmxRange": [10, 19], "type": "ShutterStrobe", "shutterEffect": "Open"},
  {"dmxRange": [20, 120], "type": "ShutterStrobe", "shutterEffect": "Strobe", "speedStart": "2Hz", "speedEnd": "12Hz"},
  {"dmxRange": [121, 255], "type": "ShutterStrobe", "shutterEffect": "Strobe", "randomTiming": true, "speed": "5Hz"}]},
 "Colour": {"capabilities": [
  {"dmxRange": [0, 9], "type": "WheelSlot", "slotNumber": 1},
  {"dmxRange": [10, 19], "type": "WheelSlot", "slotNumber": 2},
  {"dmxRange": [20, 29], "type": "WheelSlot", "slotNumber": 2.5},
  {"dmxRange": [30, 129], "type": "WheelSlot", "slotNumberStart": 1, "slotNumberEnd": 4},
  {"dmxRange": [130, 255], "type": "WheelRotation", "speedStart": "slow CCW", "speedEnd": "fast CCW"}]},
 "Gobo": {"capabilities": [
  {"dmxRange": [0, 99], "type": "WheelSlot", "wheel": "Gobos", "slotNumber": 1},
  {"dmxRange": [100, 255], "type": "WheelSlot", "wheel": "Gobos", "slotNumber": 2}]},
 "Gobo rotation": {"capability": {"type": "WheelSlotRotation", "wheel": "Gobos", "angleStart": "0deg", "angleEnd": "360deg"}},
 "Zoom": {"capability": {"type": "Zoom", "angleStart": "wide", "angleEnd": "narrow"}},
 "Macro": {"capabilities": [{"dmxRange": [0, 9], "type": "NoFunction"},
  {"dmxRange": [10, 255], "type": "Effect", "effectName": "Rainbow"}]},
 "Reset": {"capability": {"type": "Maintenance", "hold": "5s"}}},
"modes": [{"name": "all", "channels": ["Pan", "Pan fine", "Pan fine^2", "Tilt", "Tilt fine", "Dimmer", "Shutter",
  "Colour", "Gobo", "Gobo rotation", "Zoom", "Macro", "Reset", null]},
 {"name": "coarse", "channels": ["Pan", "Spin", null, "Pan fine^2"], "physical": {"focus": {"panMax": 180}}}])json"));
    ASSERT_EQ(type.type.modes.size(), 2u);
    const Mode& mode = type.type.modes[0];
    EXPECT_EQ(mode.footprint, std::vector<int>{14});
    EXPECT_EQ(mode.channels[0].offsets, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(mode.channels[0].max, 0xffffffu);
    EXPECT_EQ(mode.channels[1].initial, 128u << 8);
    ASSERT_EQ(type.type.wheels.size(), 2u);
    EXPECT_NEAR(type.type.wheels[0].slots[1].color.Y, 21.26, 0.05);
    EXPECT_GT(type.type.wheels[0].slots[3].color.x, 0.38f); // warmer than the lamp
    //                     pan      tilt    dim  sh  col  gobo rot zoom
    State state = play(type.type, {0, 0, 0, 255, 255, 51, 70, 15, 150, 64, 0});
    EXPECT_FLOAT_EQ(state.pan_deg, -270.0f);
    EXPECT_FLOAT_EQ(state.tilt_deg, 120.0f);
    const Optics& optics = state.beams[0].optics;
    EXPECT_FLOAT_EQ(optics.dimmer, 0.8f);
    EXPECT_FLOAT_EQ(optics.strobe_hz, 7.0f);
    EXPECT_FLOAT_EQ(optics.color_wheels[0].position, 1.0f);
    EXPECT_FLOAT_EQ(optics.gobo_wheels[0].position, 1.0f);
    EXPECT_NEAR(optics.gobo_wheels[0].gobo_deg, 64.0 / 255.0 * 360.0, 1e-3);
    EXPECT_FLOAT_EQ(optics.zoom_deg, 40.0f);
    const auto colour = [&](std::uint8_t value) {
        return play(type.type, {0, 0, 0, 0, 0, 0, 0, value}).beams[0].optics.color_wheels[0];
    };
    EXPECT_NEAR(colour(25).position, 1.5, 1e-4);
    EXPECT_NEAR(colour(30).position, 0.0, 1e-4);
    EXPECT_NEAR(colour(129).position, 3.0, 1e-3);
    EXPECT_FLOAT_EQ(colour(255).spin_deg_s, -360.0f);
    EXPECT_FLOAT_EQ(play(type.type, {0, 0, 0, 0, 0, 0, 5}).beams[0].optics.shutter_position, 0.0f);
    EXPECT_EQ(play(type.type, {0, 0, 0, 0, 0, 0, 200}).beams[0].optics.strobe, Strobe::random);

    EXPECT_EQ(type.type.modes[1].footprint, std::vector<int>{4});
    EXPECT_EQ(type.type.modes[1].channels[0].offsets, std::vector<int>{0}); // "Pan fine" is not in this mode
    EXPECT_FLOAT_EQ(play(type.type, {255}, 1).pan_deg, 270.0f);
    EXPECT_FALSE(play(type.type, {128, 127}, 1).axes.back().spinning);
    EXPECT_TRUE(says(type, "are not shown: 'Rainbow'", "/availableChannels/Macro"));
    EXPECT_TRUE(says(type, "ignored: Maintenance"));
    EXPECT_TRUE(says(type, "a gobo without a picture", "/wheels/Gobos/slots/2"));
}

const std::string kMatrix =
    R"json("physical": {"dimensions": [1000, 80, 100], "bulb": {"type": "LED", "lumens": 4000},
 "lens": {"degreesMinMax": [25, 25]}},
"matrix": {"pixelCount": [4, 1, 1], "pixelGroups": {"Left": ["1", "2"], "Right": {"x": [">=3"]}, "All": "all",
 "Even": {"x": ["even"]}, "Third": {"x": ["3n"]}}},
"templateChannels": {
 "Red $pixelKey": {"fineChannelAliases": ["Red $pixelKey fine"], "capability": {"type": "ColorIntensity", "color": "Red"}},
 "Blue $pixelKey": {"capability": {"type": "ColorIntensity", "color": "Blue"}}},
"availableChannels": {"Blue 4": {"capability": {"type": "Intensity"}}},
)json";

TEST(ofl, a_matrix_is_spread_out_over_its_pixels) {
    const LoadedType type = loaded(fixture(kMatrix + R"json("modes": [
 {"name": "per pixel", "channels": [{"insert": "matrixChannels", "repeatFor": "eachPixelABC", "channelOrder": "perPixel",
  "templateChannels": ["Red $pixelKey", "Red $pixelKey fine"]}]},
 {"name": "per channel", "channels": [{"insert": "matrixChannels", "repeatFor": ["3", "1"], "channelOrder": "perChannel",
  "templateChannels": ["Red $pixelKey", null, "Blue $pixelKey"]}]},
 {"name": "groups", "channels": ["Red Left", "Red Right", "Blue All", "Red Even", "Red Third", "Blue 4", "Red Nobody"]}])json",
                                           "Pixel Bar"));
    ASSERT_EQ(type.type.modes.size(), 3u);
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{8});
    ASSERT_EQ(type.type.modes[0].beams.size(), 4u);
    EXPECT_EQ(type.type.modes[0].channels[2].offsets, (std::vector<int>{4, 5}));
    const State pixels = play(type.type, {0, 0, 255, 255, 128, 0});
    EXPECT_FLOAT_EQ(level_of(pixels.beams[1].optics, kRed), 1.0f);
    EXPECT_FLOAT_EQ(level_of(pixels.beams[0].optics, kRed), 0.0f);
    EXPECT_NEAR(pixels.beams[3].to_fixture[3].x - pixels.beams[0].to_fixture[3].x, 0.75, 1e-3);

    EXPECT_EQ(type.type.modes[1].footprint, std::vector<int>{6});
    const State ordered = play(type.type, {255, 0, 0, 0, 0, 255}, 1); // Red 3, Red 1, -, -, Blue 3, Blue 1
    EXPECT_FLOAT_EQ(level_of(ordered.beams[2].optics, kRed), 1.0f);
    EXPECT_FLOAT_EQ(level_of(ordered.beams[0].optics, kBlue), 1.0f);
    EXPECT_FLOAT_EQ(level_of(ordered.beams[0].optics, kRed), 0.0f);

    const Mode& groups = type.type.modes[2];
    EXPECT_EQ(groups.footprint, std::vector<int>{7});
    ASSERT_EQ(groups.channels.size(), 6u);
    EXPECT_EQ(groups.channels[0].beams, (std::vector<int>{0, 1}));
    EXPECT_EQ(groups.channels[1].beams, (std::vector<int>{2, 3}));
    EXPECT_EQ(groups.channels[2].beams, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(groups.channels[3].beams, (std::vector<int>{1, 3}));
    EXPECT_EQ(groups.channels[4].beams, std::vector<int>{2});
    EXPECT_EQ(groups.channels[5].functions[0].attribute,
              "Dimmer"); // an available channel goes before a template
    EXPECT_TRUE(says(type, "there is no channel 'Red Nobody'", "/modes/2/channels/6"));
}

TEST(ofl, beams_have_the_names_of_their_pixels) {
    const LoadedType type = loaded(fixture(R"json("matrix": {"pixelKeys": [[["Left", "3", "2"]]]},
"templateChannels": {"Red $pixelKey": {"capability": {"type": "ColorIntensity", "color": "Red"}}},
"modes": [{"name": "m", "channels": ["Red 2", "Red 3", "Red Left"]}])json",
                                           "Other"));
    const Mode& mode = type.type.modes[0];
    std::vector<std::string> names;
    for (const int node : mode.beams) names.push_back(mode.nodes[static_cast<std::size_t>(node)].name);
    EXPECT_EQ(names, (std::vector<std::string>{"Beam Left", "Beam 3", "Beam 2"}));
}

TEST(ofl, pixels_are_repeated_in_the_stated_order) {
    OflReader reader{.name = "t", .gobos = GoboFiles()};
    reader.document = Json::parse(R"json({"matrix": {"pixelKeys": [[["10", "2"], [null, "1"]]]}})json");
    read_ofl_matrix(reader);
    EXPECT_EQ(repeat_keys(reader, Json("eachPixelABC"), ""), (std::vector<std::string>{"1", "2", "10"}));
    EXPECT_EQ(repeat_keys(reader, Json("eachPixelXYZ"), ""), (std::vector<std::string>{"10", "2", "1"}));
    EXPECT_EQ(repeat_keys(reader, Json("eachPixelYXZ"), ""), (std::vector<std::string>{"10", "2", "1"}));
    OflReader cube{.name = "t", .gobos = GoboFiles()};
    cube.document = Json::parse(R"json({"matrix": {"pixelCount": [2, 2, 1]}})json");
    read_ofl_matrix(cube);
    EXPECT_EQ(repeat_keys(cube, Json("eachPixelYXZ"), ""),
              (std::vector<std::string>{"(1, 1)", "(1, 2)", "(2, 1)", "(2, 2)"}));
}

TEST(ofl, switching_channels_and_presets) {
    const LoadedType type = loaded(fixture(R"json("availableChannels": {
 "Choose": {"defaultValue": 0, "capabilities": [
  {"dmxRange": [0, 127], "type": "NoFunction", "switchChannels": {"Value": "Strobe"}},
  {"dmxRange": [128, 255], "type": "NoFunction", "switchChannels": {"Value": "Dimmer"}}]},
 "Strobe": {"capability": {"type": "ShutterStrobe", "shutterEffect": "Strobe", "speedStart": "1Hz", "speedEnd": "20Hz"}},
 "Dimmer": {"capability": {"type": "Intensity"}},
 "Red": {"capability": {"type": "ColorIntensity", "color": "Red"}},
 "Preset": {"capabilities": [{"dmxRange": [0, 9], "type": "NoFunction"},
  {"dmxRange": [10, 255], "type": "ColorPreset", "colors": ["#0000ff"], "comment": "Blue"}]}},
"modes": [{"name": "switch", "channels": ["Choose", "Value"]}, {"name": "presets", "channels": ["Red", "Preset"]},
 {"name": "lonely", "channels": ["Value"]}])json",
                                           "Color Changer"));
    EXPECT_FLOAT_EQ(play(type.type, {0, 255}).beams[0].optics.strobe_hz, 20.0f);
    const Optics dimmed = play(type.type, {200, 51}).beams[0].optics;
    EXPECT_FLOAT_EQ(dimmed.dimmer, 0.2f);
    EXPECT_EQ(dimmed.strobe, Strobe::none);
    EXPECT_FLOAT_EQ(level_of(play(type.type, {255, 0}, 1).beams[0].optics, kRed), 1.0f);
    const Optics preset = play(type.type, {255, 100}, 1).beams[0].optics;
    ASSERT_EQ(preset.emitters.size(), 1u);
    EXPECT_NEAR(preset.emitters[0].color.x, 0.15, 0.001);
    EXPECT_TRUE(says(type, "what switches 'Value' is not in this mode", "/modes/2"));
}

TEST(ofl, faults_are_said_with_their_place) {
    EXPECT_NE(load("{\"name\":\n").error().what.find("line 2"), std::string::npos);
    EXPECT_FALSE(load("[]").ok());
    EXPECT_FALSE(load("{}").ok());
    EXPECT_NE(load(R"json({"redirectTo": "a/b"})json").error().what.find("redirect"), std::string::npos);
    EXPECT_NE(load(std::string(100, '[')).error().what.find("deeper than 32"), std::string::npos);
    std::string many = "{\"a\": [";
    for (int i = 0; i < 200'001; ++i) many += i ? ",0" : "0";
    EXPECT_NE(load(many + "]}").error().what.find("200000 values"), std::string::npos);
    std::string members = "{\"redirectTo\": \"a/b\"";
    for (int i = 1; i < 1024; ++i) members += ", \"" + std::to_string(i) + "\": 0";
    EXPECT_NE(load(members + "}").error().what.find("redirect"), std::string::npos);
    EXPECT_NE(load(members + ", \"x\": 0}").error().what.find("more than 1024 members"), std::string::npos);
    const LoadedType type = loaded(fixture(R"json("availableChannels": {
 "A/B": {"capabilities": [{"dmxRange": [0, 300], "type": "Intensity"}, {"dmxRange": [10, 5], "type": "Intensity"},
  {"dmxRange": [0, 20], "type": "Invented"}, {"dmxRange": [21, 30], "type": "Intensity", "brightness": "loud"}]},
 "Wheel": {"capability": {"type": "WheelSlot", "slotNumber": 3}}, "None": {}, "Odd": 7},
"modes": [{"name": "m", "channels": ["A/B", "Wheel", "None", "Odd", 5, {"insert": "x"}, "Gone"]}, 3])json"));
    ASSERT_EQ(type.type.modes.size(), 1u);
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{6});
    EXPECT_TRUE(
        says(type, "two ascending values from 0 to 255", "/availableChannels/A~1B/capabilities/0/dmxRange"));
    EXPECT_TRUE(says(type, "'Invented' is no capability type"));
    EXPECT_TRUE(says(type, "\"loud\"", "/capabilities/3/brightness"));
    EXPECT_TRUE(says(type, "the wheel 'Wheel' is not described"));
    EXPECT_TRUE(says(type, "neither capability nor capabilities"));
    EXPECT_TRUE(says(type, "expected a mode", "/modes/1"));
    const LoadedType odd = loaded(fixture(R"json("physical": {"dimensions": [-100, 200, 300],
 "lens": {"degreesMinMax": [40, 10]}}, "availableChannels": {"Dim": {"capability": {"type": "Intensity"}}},
"modes": [{"name": "m", "channels": ["Dim"]}])json"));
    EXPECT_TRUE(says(odd, "expected numbers from 0 to 100000 mm", "/physical/dimensions"));
    EXPECT_TRUE(says(odd, "the smaller one first", "/physical/lens/degreesMinMax"));
}

TEST(ofl, truncated_and_hostile_files_never_crash) {
    const std::string text = fixture(kMatrix + R"json("modes": [{"name": "m", "channels": [
 {"insert": "matrixChannels", "repeatFor": "eachPixelXYZ", "channelOrder": "perPixel", "templateChannels": ["Red $pixelKey"]}]}])json");
    for (std::size_t size = 0; size < text.size(); ++size) EXPECT_FALSE(load(text.substr(0, size)).ok());
    EXPECT_TRUE(load(text).ok());
    // A million pixels, and inserts that would make a billion channels.
    std::string inserts;
    for (int i = 0; i < 1000; ++i)
        inserts +=
            std::string(i ? "," : "") + R"json({"insert": "matrixChannels", "repeatFor": "eachPixelXYZ",
 "channelOrder": "perPixel", "templateChannels": ["Red $pixelKey", "Red $pixelKey", "Red $pixelKey"]})json";
    const LoadedType type =
        loaded(fixture(R"json("matrix": {"pixelCount": [1000, 1000, 1]}, "templateChannels": {
 "Red $pixelKey": {"capability": {"type": "ColorIntensity", "color": "Red"}}},
"modes": [{"name": "m", "channels": [)json" +
                       inserts + "]}]"));
    ASSERT_EQ(type.type.modes.size(), 1u);
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{8192});
    EXPECT_LE(type.type.modes[0].beams.size(), 4096u);
    EXPECT_TRUE(says(type, "more than 4096 pixels"));
    EXPECT_TRUE(says(type, "more channels than 8192"));
}

TEST(ofl, what_a_file_holds_decides_not_its_name) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "ofl-maker";
    std::filesystem::create_directories(folder);
    const std::string text = fixture(R"json("availableChannels": {"D": {"capability": {"type": "Intensity"}}},
"modes": [{"name": "m", "channels": ["D"]}])json");
    std::ofstream(folder / "thing.gdtf") << "\xEF\xBB\xBF \n" << text;
    std::ofstream(folder / "thing.txt") << "hello";
    const Result<LoadedType> type = load_type(folder / "thing.gdtf");
    ASSERT_TRUE(type.ok()) << type.error().text();
    EXPECT_EQ(type->type.manufacturer, "Ofl Maker");
    EXPECT_NE(load_type(folder / "thing.txt").error().what.find("expected GDTF"), std::string::npos);
    EXPECT_FALSE(load_type(folder / "absent.qxf").ok());
    EXPECT_TRUE(has_type_extension("a/B.QXF") && has_type_extension("a.json") &&
                !has_type_extension("a.toml"));
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace ghost::fixture
