// SPDX-License-Identifier: Apache-2.0
// Open Fixture Library: which light a channel is for, and what preset colours do beside it.
#include "support/tiny_ofl.h"

namespace ghost::fixture {
namespace {

// Channels of one capability each: "Red 1" -> a red emitter, "Dimmer" -> brightness.
std::string channel(const std::string& key) {
    const std::string color = key.find("ed") != std::string::npos     ? "Red"
                              : key.find("lue") != std::string::npos  ? "Blue"
                              : key.find("reen") != std::string::npos ? "Green"
                                                                      : "";
    return "\"" + key + R"json(": {"capability": {"type": )json" +
           (color.empty() ? R"json("Intensity"}})json"
                          : R"json("ColorIntensity", "color": ")json" + color + R"json("}})json");
}

std::string channels(const std::vector<std::string>& keys, const std::string& more = "") {
    std::string text = R"json("availableChannels": {)json" + more;
    std::string list;
    for (const std::string& key : keys) {
        const bool known = more.find("\"" + key + "\": {") != std::string::npos;
        if (!known) text += (text.ends_with('{') ? "" : ", ") + channel(key);
        list += (list.empty() ? "\"" : ", \"") + key + "\"";
    }
    return text + R"json(}, "modes": [{"name": "m", "channels": [)json" + list + "]}]";
}

float lit(const State& state, std::size_t beam) {
    const Optics& optics = state.beams[beam].optics;
    float level = optics.emitters.empty() ? 1.0f : 0.0f;
    for (const EmitterLevel& emitter : optics.emitters) level = std::max(level, emitter.level);
    return level * optics.dimmer * optics.shutter_position;
}

TEST(ofl_colours, a_switched_channel_lights_the_pixels_of_its_target) {
    const LoadedType type = loaded(fixture(R"json("matrix": {"pixelCount": [3, 1, 1]}, "availableChannels": {
 "P": {"defaultValue": 0, "capabilities": [
  {"dmxRange": [0, 99], "type": "NoFunction", "switchChannels": {"A": "Red 1"}},
  {"dmxRange": [100, 199], "type": "NoFunction", "switchChannels": {"A": "Speed"}},
  {"dmxRange": [200, 255], "type": "NoFunction", "switchChannels": {"A": "Red 3"}}]},
 "Speed": {"capability": {"type": "EffectSpeed", "speed": "fast"}}},
"templateChannels": {"Red $pixelKey": {"capability": {"type": "ColorIntensity", "color": "Red"}}},
"modes": [{"name": "m", "channels": ["P", "A", "Red 2"]}, {"name": "alone", "channels": ["P", "A"]}])json",
                                           "Other"));
    for (const int mode : {0, 1}) {
        const auto reds = [&](std::uint8_t program, std::uint8_t value) {
            std::vector<float> levels;
            for (const BeamState& beam : play(type.type, {program, value}, mode).beams)
                levels.push_back(std::max(level_of(beam.optics, kRed), 0.0f));
            return levels;
        };
        EXPECT_EQ(reds(0, 255), (std::vector<float>{1, 0, 0})) << mode;
        EXPECT_EQ(reds(150, 255), (std::vector<float>{0, 0, 0})) << mode;
        EXPECT_EQ(reds(255, 255), (std::vector<float>{0, 0, 1})) << mode;
    }
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{3});
}

TEST(ofl_colours, a_switched_axis_turns_the_head) {
    const LoadedType type = loaded(fixture(R"json("availableChannels": {
 "P": {"defaultValue": 0, "capabilities": [
  {"dmxRange": [0, 127], "type": "NoFunction", "switchChannels": {"A": "Tilt"}},
  {"dmxRange": [128, 255], "type": "NoFunction", "switchChannels": {"A": "Dimmer"}}]},
 "Tilt": {"capability": {"type": "Tilt", "angleStart": "0deg", "angleEnd": "100deg"}},
 "Dimmer": {"capability": {"type": "Intensity"}}},
"modes": [{"name": "m", "channels": ["P", "A"]}])json"));
    EXPECT_FLOAT_EQ(play(type.type, {0, 255}).tilt_deg, 50.0f);
}

TEST(ofl_colours, another_light_in_the_same_place_is_said_and_not_shown) {
    const LoadedType type =
        loaded(fixture(channels({"Beam dimmer", "Beam red", "Aura dimmer", "Aura red", "Aura shutter"},
                                R"json("Aura shutter": {"capabilities": [
 {"dmxRange": [0, 9], "type": "ShutterStrobe", "shutterEffect": "Closed"},
 {"dmxRange": [10, 255], "type": "ShutterStrobe", "shutterEffect": "Open"}]})json")));
    ASSERT_EQ(type.type.modes[0].beams.size(), 1u);
    EXPECT_FLOAT_EQ(lit(play(type.type, {255, 255}), 0), 1.0f);
    EXPECT_FLOAT_EQ(lit(play(type.type, {255, 0, 255, 255, 255}), 0), 0.0f);
    EXPECT_TRUE(says(type, "a second light whose place and brightness are not in the file is not shown: "
                           "'Aura dimmer', 'Aura red', 'Aura shutter'"));
    // The one without a name of its own is the fixture's.
    const LoadedType ring = loaded(fixture(channels({"Ring Red", "Red", "Dimmer"})));
    EXPECT_FLOAT_EQ(lit(play(ring.type, {0, 255, 255}), 0), 1.0f);
    EXPECT_FLOAT_EQ(lit(play(ring.type, {255, 0, 255}), 0), 0.0f);
}

TEST(ofl_colours, numbered_lights_without_a_matrix_stand_side_by_side) {
    const LoadedType type = loaded(fixture(
        channels({"Master Dimmer", "Dimmer 1", "Red 1", "Dimmer 2", "Red 2", "Red All"}), "Pixel Bar"));
    ASSERT_EQ(type.type.modes[0].beams.size(), 2u);
    const State first = play(type.type, {255, 255, 255, 0, 255});
    EXPECT_FLOAT_EQ(lit(first, 0), 1.0f);
    EXPECT_FLOAT_EQ(lit(first, 1), 0.0f);
    EXPECT_GT(first.beams[1].to_fixture[3].x, first.beams[0].to_fixture[3].x);
    EXPECT_EQ(type.type.modes[0].nodes[static_cast<std::size_t>(type.type.modes[0].beams[1])].name, "Beam 2");
    EXPECT_FLOAT_EQ(lit(play(type.type, {51, 255, 0, 255, 0, 255}), 1), 0.2f); // the masters are for both
}

TEST(ofl_colours, a_master_dimmer_beside_a_dimmer_multiplies) {
    for (const char* master : {"Master Dimmer", "Dimmer All", "RGB Dimmer"}) {
        const LoadedType type = loaded(fixture(channels({master, "Dimmer", "Red"})));
        ASSERT_EQ(type.type.modes[0].beams.size(), 1u) << master;
        EXPECT_FLOAT_EQ(lit(play(type.type, {51, 255, 255}), 0), 0.2f) << master;
        EXPECT_FLOAT_EQ(lit(play(type.type, {255, 51, 255}), 0), 0.2f) << master;
        EXPECT_FALSE(says(type, "a second light")) << master;
    }
}

const std::string kGreenPreset =
    R"json("Preset 1": {"capabilities": [{"dmxRange": [0, 9], "type": "NoFunction"},
 {"dmxRange": [10, 255], "type": "ColorPreset", "colors": ["#00ff00"]}]})json";
const std::string kBluePreset =
    R"json("Preset 2": {"capabilities": [{"dmxRange": [0, 0], "type": "ColorPreset",
 "colors": ["#000000"]}, {"dmxRange": [1, 255], "type": "ColorPreset", "colors": ["#0000ff"], "comment": "Blue"}]})json";

TEST(ofl_colours, a_black_preset_at_zero_leaves_the_emitters_alone) {
    const LoadedType type = loaded(fixture(channels({"Red", "Preset 2"}, kBluePreset)));
    const Optics red = play(type.type, {255, 0}).beams[0].optics;
    EXPECT_TRUE(red.color_wheels.empty());
    EXPECT_FLOAT_EQ(level_of(red, kRed), 1.0f);
    const Optics blue = play(type.type, {255, 1}).beams[0].optics;
    ASSERT_EQ(blue.emitters.size(), 1u);
    EXPECT_NEAR(blue.emitters[0].color.x, 0.15, 0.001);
}

TEST(ofl_colours, the_last_of_several_presets_takes_the_place_of_all_other_light) {
    const LoadedType type = loaded(fixture(
        channels({"Red", "Green", "Blue", "Preset 1", "Preset 2"}, kGreenPreset + ", " + kBluePreset)));
    const auto only = [&](std::uint8_t first, std::uint8_t second) {
        const Optics optics = play(type.type, {255, 0, 0, first, second}).beams[0].optics;
        return optics.emitters.size() == 1 ? optics.emitters[0].color.x : -1.0f;
    };
    EXPECT_NEAR(only(100, 0), 0.30, 0.001);
    EXPECT_NEAR(only(0, 100), 0.15, 0.001);
    EXPECT_NEAR(only(100, 100), 0.15, 0.001);
    const Optics rest = play(type.type, {255, 0, 0, 0, 0}).beams[0].optics;
    EXPECT_EQ(rest.emitters.size(), 3u);
    EXPECT_FLOAT_EQ(level_of(rest, kRed), 1.0f);
}

TEST(ofl_colours, presets_alone_are_a_wheel_with_an_open_slot) {
    const LoadedType type = loaded(fixture(channels({"Preset 1"}, kGreenPreset)));
    ASSERT_EQ(type.type.wheels.size(), 1u);
    ASSERT_EQ(type.type.wheels[0].slots.size(), 2u);
    EXPECT_EQ(type.type.wheels[0].slots[0].name, "Open");
    EXPECT_FLOAT_EQ(type.type.wheels[0].slots[0].color.Y, 100.0f);
    EXPECT_FLOAT_EQ(play(type.type, {0}).beams[0].optics.color_wheels[0].position, 0.0f);
    EXPECT_FLOAT_EQ(play(type.type, {10}).beams[0].optics.color_wheels[0].position, 1.0f);
}

TEST(ofl_colours, hue_and_saturation_are_known_by_their_names) {
    const std::string generic = R"json(": {"capability": {"type": "Generic"}})json";
    const LoadedType type =
        loaded(fixture(channels({"Hue 1", "Saturation 1", "Intensity 1", "Magic"},
                                "\"Hue 1" + generic + ", \"Saturation 1" + generic + ", \"Magic" + generic)));
    const Optics blue = play(type.type, {170, 255, 255}).beams[0].optics;
    EXPECT_TRUE(blue.has_mix);
    EXPECT_NEAR(blue.mix.x, 0.15, 0.002);
    EXPECT_FLOAT_EQ(blue.dimmer, 1.0f);
    EXPECT_FALSE(play(type.type, {170, 0, 255}).beams[0].optics.has_mix);
    EXPECT_TRUE(says(type, "channels of type Generic, which says nothing, are not shown: 'Magic'"));
}

} // namespace
} // namespace ghost::fixture
