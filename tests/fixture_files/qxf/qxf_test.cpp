// SPDX-License-Identifier: Apache-2.0
// QLC+ definitions written here, and one of QLC+'s own against our GDTF of that fixture.
#include "fixture_files/qxf/qxf.h"

#include "fixture/decode.h"
#include "fixture_files/load_type.h"
#include "image/ldr.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace ghost::fixture {
namespace {

const std::string kPhysical = R"xml(
 <Physical>
  <Bulb Type="LED" Lumens="4000" ColourTemperature="6500"/>
  <Dimensions Weight="10" Width="300" Height="400" Depth="280"/>
  <Lens Name="Other" DegreesMin="10" DegreesMax="40"/>
  <Focus Type="Head" PanMax="540" TiltMax="270"/>
  <Technical PowerConsumption="150" DmxConnector="5-pin"/>
 </Physical>)xml";

std::string definition(const std::string& inner, const std::string& physical = kPhysical,
                       const std::string& kind = "Moving Head") {
    return R"xml(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE FixtureDefinition>
<FixtureDefinition xmlns="http://www.qlcplus.org/FixtureDefinition">
 <Creator><Name>Q Light Controller Plus</Name><Version>4.12.6</Version><Author>test</Author></Creator>
 <Manufacturer>Maker</Manufacturer>
 <Model>Thing</Model>
 <Type>)xml" +
           kind + "</Type>\n" + inner + physical + "\n</FixtureDefinition>\n";
}

Result<LoadedType> load(const std::string& text) {
    return load_qxf(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), "thing.qxf");
}

LoadedType loaded(const std::string& text) {
    Result<LoadedType> result = load(text);
    EXPECT_TRUE(result.ok()) << result.error().text();
    return result.ok() ? std::move(*result) : LoadedType{};
}

bool says(const LoadedType& type, const std::string& words) {
    return std::any_of(type.messages.begin(), type.messages.end(),
                       [&](const Message& message) { return message.what.find(words) != std::string::npos; });
}

State play(const Type& type, std::vector<std::uint8_t> bytes, int mode = 0) {
    const Patch patch{.name = "test", .type = &type, .mode = mode, .addresses = {{1, 1}}};
    State state = make_state(patch);
    bytes.resize(512);
    Levels levels;
    levels.set(1, bytes);
    step(state, patch, decode(patch, levels), 0.0);
    return state;
}

TEST(qxf, a_moving_head_has_a_body_axes_and_16_bits) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Pan" Preset="PositionPan"/>
 <Channel Name="Pan fine" Preset="PositionPanFine"/>
 <Channel Name="Tilt" Preset="PositionTilt"/>
 <Channel Name="Tilt fine" Preset="PositionTiltFine"/>
 <Channel Name="Dimmer" Preset="IntensityMasterDimmer"/>
 <Channel Name="Zoom" Preset="BeamZoomBigSmall"/>
 <Mode Name="16 bit">
  <Channel Number="0">Pan</Channel>
  <Channel Number="1">Tilt</Channel>
  <Channel Number="2">Tilt fine</Channel>
  <Channel Number="3">Pan fine</Channel>
  <Channel Number="4">Dimmer</Channel>
  <Channel Number="5">Zoom</Channel>
 </Mode>
 <Mode Name="8 bit"><Channel Number="0">Pan</Channel><Channel Number="1">Tilt</Channel></Mode>)xml"));
    EXPECT_EQ(type.type.manufacturer, "Maker");
    EXPECT_EQ(type.type.name, "Thing");
    ASSERT_EQ(type.type.modes.size(), 2u);
    const Mode& mode = type.type.modes[0];
    EXPECT_EQ(mode.footprint, std::vector<int>{6});
    ASSERT_EQ(mode.channels.size(), 4u);
    EXPECT_EQ(mode.channels[0].offsets, (std::vector<int>{0, 3}));
    EXPECT_EQ(mode.channels[1].offsets, (std::vector<int>{1, 2}));
    EXPECT_EQ(mode.channels[0].max, 65535u);
    EXPECT_EQ(mode.axes.size(), 2u);
    ASSERT_EQ(mode.beams.size(), 1u);
    EXPECT_GE(mode.parts.size(), 4u); // base, yoke of three, head
    const Beam& beam = *type.type
                            .geometries[static_cast<std::size_t>(
                                mode.nodes[static_cast<std::size_t>(mode.beams[0])].geometry)]
                            .beam;
    EXPECT_FLOAT_EQ(beam.luminous_flux_lm, 4000.0f);
    EXPECT_FLOAT_EQ(beam.color_temperature_k, 6500.0f);
    EXPECT_FLOAT_EQ(beam.field_angle_deg, 40.0f);

    const State low = play(type.type, {0, 0, 0, 0, 255, 0});
    EXPECT_FLOAT_EQ(low.pan_deg, -270.0f);
    EXPECT_FLOAT_EQ(low.tilt_deg, -135.0f);
    EXPECT_FLOAT_EQ(low.beams[0].optics.zoom_deg, 40.0f);
    EXPECT_FLOAT_EQ(low.beams[0].optics.dimmer, 1.0f);
    const State fine = play(type.type, {128, 255, 255, 64, 0, 255});
    EXPECT_NEAR(fine.pan_deg, -270.0 + 540.0 * (128 * 256 + 64) / 65535.0, 1e-3);
    EXPECT_FLOAT_EQ(fine.tilt_deg, 135.0f);
    EXPECT_FLOAT_EQ(fine.beams[0].optics.zoom_deg, 10.0f);
    EXPECT_FLOAT_EQ(play(type.type, {255, 255}, 1).pan_deg, 270.0f);
    // Without data it hangs straight down.
    const Patch patch{.name = "test", .type = &type.type, .mode = 0, .addresses = {}};
    const State rest = make_state(patch);
    EXPECT_NEAR(rest.pan_deg, 0.0, 0.01);
    EXPECT_NEAR((rest.beams[0].to_fixture * glm::vec4(0, 0, -1, 0)).z, -1.0, 1e-3);
    EXPECT_LT(rest.beams[0].to_fixture[3].z, -0.2f);
}

TEST(qxf, a_colour_wheel_has_the_colours_of_the_file_and_halves) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Colours">
  <Group Byte="0">Colour</Group>
  <Capability Min="0" Max="9" Preset="ColorMacro" Res1="#ffffff">White</Capability>
  <Capability Min="10" Max="19" Preset="ColorMacro" Res1="#ff0000">Red</Capability>
  <Capability Min="20" Max="29" Preset="ColorMacro" Res1="#0000ff">Blue</Capability>
  <Capability Min="30" Max="39" Preset="ColorDoubleMacro" Res1="#ff0000" Res2="#0000ff">Red/Blue</Capability>
  <Capability Min="40" Max="49" Preset="ColorDoubleMacro" Res1="#0000ff" Res2="#ffffff">Blue/White</Capability>
  <Capability Min="128" Max="255" Preset="RotationClockwiseSlowToFast">Turn</Capability>
 </Channel>
 <Channel Name="Old colours">
  <Group Byte="0">Colour</Group>
  <Capability Min="0" Max="127" Color="#00ff00">Grass</Capability>
  <Capability Min="128" Max="255" Color="#00ff00" Color2="#ff0000">Half</Capability>
 </Channel>
 <Mode Name="m"><Channel Number="0">Colours</Channel><Channel Number="1">Old colours</Channel></Mode>)xml"));
    ASSERT_EQ(type.type.wheels.size(), 2u);
    const std::vector<Slot>& slots = type.type.wheels[0].slots;
    ASSERT_EQ(slots.size(), 5u); // the last half is no pair of neighbours: two more
    EXPECT_NEAR(slots[1].color.x, 0.640, 0.001);
    EXPECT_NEAR(slots[1].color.y, 0.330, 0.001);
    EXPECT_NEAR(slots[1].color.Y, 21.26, 0.05);
    EXPECT_NEAR(slots[2].color.x, 0.150, 0.001);
    EXPECT_NEAR(slots[2].color.y, 0.060, 0.001);
    const auto position = [&](std::uint8_t value) {
        return play(type.type, {value, 0}).beams[0].optics.color_wheels[0].position;
    };
    EXPECT_FLOAT_EQ(position(5), 0.0f);
    EXPECT_FLOAT_EQ(position(15), 1.0f);
    EXPECT_FLOAT_EQ(position(29), 2.0f);
    EXPECT_NEAR(position(35), 1.5, 1e-4);
    EXPECT_NEAR(position(45), 3.5, 1e-4);
    const State turning = play(type.type, {255, 0});
    EXPECT_TRUE(turning.beams[0].optics.color_wheels[0].spinning);
    EXPECT_FLOAT_EQ(turning.beams[0].optics.color_wheels[0].spin_deg_s, 360.0f);
    ASSERT_EQ(turning.beams[0].optics.color_wheels.size(), 2u);
    EXPECT_NEAR(play(type.type, {0, 200}).beams[0].optics.color_wheels[1].position, 0.5, 1e-4);
}

TEST(qxf, shutters_strobe_at_the_stated_rates) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Shutter">
  <Group Byte="0">Shutter</Group>
  <Capability Min="0" Max="9" Preset="ShutterClose">Closed</Capability>
  <Capability Min="10" Max="19" Preset="ShutterOpen">Open</Capability>
  <Capability Min="20" Max="29" Preset="StrobeFrequency" Res1="7.5">7.5 Hz</Capability>
  <Capability Min="30" Max="130" Preset="StrobeFreqRange" Res1="2" Res2="12">Strobe</Capability>
  <Capability Min="131" Max="200" Preset="StrobeRandomSlowToFast">Random</Capability>
  <Capability Min="201" Max="255" Preset="PulseFastToSlow">Pulse</Capability>
 </Channel>
 <Channel Name="Strobe" Preset="ShutterStrobeSlowFast"/>
 <Channel Name="Shutter in words">
  <Group Byte="0">Shutter</Group>
  <Capability Min="0" Max="7">Shutter closed</Capability>
  <Capability Min="8" Max="15">Shutter open</Capability>
  <Capability Min="16" Max="131">Strobe effect 1 Hz - 25 Hz</Capability>
  <Capability Min="132" Max="255">no function</Capability>
 </Channel>
 <Mode Name="preset"><Channel Number="0">Shutter</Channel></Mode>
 <Mode Name="channel preset"><Channel Number="0">Strobe</Channel></Mode>
 <Mode Name="words"><Channel Number="0">Shutter in words</Channel></Mode>)xml"));
    const auto optics = [&](int mode, std::uint8_t value) {
        return play(type.type, {value}, mode).beams[0].optics;
    };
    EXPECT_FLOAT_EQ(optics(0, 0).shutter_position, 0.0f);
    EXPECT_FLOAT_EQ(optics(0, 15).shutter_position, 1.0f);
    EXPECT_EQ(optics(0, 15).strobe, Strobe::none);
    EXPECT_FLOAT_EQ(optics(0, 25).strobe_hz, 7.5f);
    EXPECT_FLOAT_EQ(optics(0, 30).strobe_hz, 2.0f);
    EXPECT_FLOAT_EQ(optics(0, 80).strobe_hz, 7.0f);
    EXPECT_EQ(optics(0, 150).strobe, Strobe::random);
    EXPECT_FLOAT_EQ(optics(0, 255).strobe_hz, 1.0f);
    EXPECT_EQ(optics(1, 0).strobe, Strobe::none);
    EXPECT_FLOAT_EQ(optics(1, 255).strobe_hz, 20.0f);
    EXPECT_FLOAT_EQ(optics(2, 3).shutter_position, 0.0f);
    EXPECT_FLOAT_EQ(optics(2, 131).strobe_hz, 25.0f);
    EXPECT_FLOAT_EQ(optics(2, 200).shutter_position, 1.0f);
}

const std::string kBar = R"xml(
 <Channel Name="Master" Preset="IntensityMasterDimmer"/>
 <Channel Name="Red 1" Preset="IntensityRed"/> <Channel Name="Green 1" Preset="IntensityGreen"/>
 <Channel Name="Blue 1" Preset="IntensityBlue"/>
 <Channel Name="Red 2" Preset="IntensityRed"/> <Channel Name="Green 2" Preset="IntensityGreen"/>
 <Channel Name="Blue 2" Preset="IntensityBlue"/>
 <Channel Name="Macro">
  <Group Byte="0">Colour</Group>
  <Capability Min="0" Max="9">No function</Capability>
  <Capability Min="10" Max="19" Preset="ColorMacro" Res1="#ff8000">Orange</Capability>
  <Capability Min="20" Max="255">Auto program</Capability>
 </Channel>)xml";
const std::string kBarPhysical = R"xml(
 <Physical><Bulb Type="LED" Lumens="2000" ColourTemperature="0"/>
  <Dimensions Weight="1" Width="1000" Height="80" Depth="100"/><Lens Name="Other" DegreesMin="25" DegreesMax="25"/>
  <Focus Type="Fixed" PanMax="0" TiltMax="0"/><Layout Width="2" Height="1"/></Physical>)xml";

TEST(qxf, every_head_is_a_beam_of_its_own) {
    const LoadedType type = loaded(definition(kBar + R"xml(
 <Mode Name="7"><Channel Number="0">Master</Channel>
  <Channel Number="1">Red 1</Channel><Channel Number="2">Green 1</Channel><Channel Number="3">Blue 1</Channel>
  <Channel Number="4">Red 2</Channel><Channel Number="5">Green 2</Channel><Channel Number="6">Blue 2</Channel>
  <Head><Channel>1</Channel><Channel>2</Channel><Channel>3</Channel></Head>
  <Head><Channel>4</Channel><Channel>5</Channel><Channel>6</Channel></Head></Mode>
 <Mode Name="no heads"><Channel Number="0">Red 1</Channel><Channel Number="1">Red 2</Channel></Mode>)xml",
                                              kBarPhysical, "LED Bar (Beams)"));
    ASSERT_EQ(type.type.modes.size(), 2u);
    const Mode& mode = type.type.modes[0];
    ASSERT_EQ(mode.beams.size(), 2u);
    EXPECT_TRUE(mode.axes.empty());
    EXPECT_FLOAT_EQ(type.type
                        .geometries[static_cast<std::size_t>(
                            mode.nodes[static_cast<std::size_t>(mode.beams[0])].geometry)]
                        .beam->luminous_flux_lm,
                    1000.0f);
    const State state = play(type.type, {255, 255, 0, 0, 0, 0, 128});
    EXPECT_NEAR(state.beams[1].to_fixture[3].x - state.beams[0].to_fixture[3].x, 0.5, 1e-4);
    const auto level = [](const BeamState& beam, float x) {
        for (const EmitterLevel& emitter : beam.optics.emitters)
            if (std::abs(emitter.color.x - x) < 0.02f) return emitter.level;
        return -1.0f;
    };
    EXPECT_FLOAT_EQ(level(state.beams[0], 0.69f), 1.0f);
    EXPECT_FLOAT_EQ(level(state.beams[1], 0.69f), 0.0f);
    EXPECT_NEAR(level(state.beams[1], 0.14f), 128.0 / 255.0, 1e-4);
    EXPECT_EQ(type.type.modes[1].beams.size(), 2u);
    EXPECT_TRUE(says(type, "2 beams are taken"));
}

TEST(qxf, a_colour_macro_takes_the_place_of_the_emitters_while_it_is_chosen) {
    const LoadedType type = loaded(definition(kBar + R"xml(
 <Mode Name="m"><Channel Number="0">Red 1</Channel><Channel Number="1">Green 1</Channel>
  <Channel Number="2">Blue 1</Channel><Channel Number="3">Macro</Channel></Mode>)xml",
                                              kBarPhysical, "Color Changer"));
    const State mixed = play(type.type, {255, 255, 255, 0});
    EXPECT_EQ(mixed.beams[0].optics.emitters.size(), 3u);
    EXPECT_FLOAT_EQ(mixed.beams[0].optics.dimmer, 1.0f); // no dimmer channel: the colours alone dim
    const State macro = play(type.type, {255, 255, 255, 15});
    ASSERT_EQ(macro.beams[0].optics.emitters.size(), 1u);
    EXPECT_FLOAT_EQ(macro.beams[0].optics.emitters[0].level, 1.0f);
    EXPECT_NEAR(macro.beams[0].optics.emitters[0].color.Y, 36.7, 0.5); // #ff8000
    EXPECT_EQ(play(type.type, {255, 0, 0, 100}).beams[0].optics.emitters.size(), 3u);
    EXPECT_TRUE(says(type, "'Auto program'"));
}

TEST(qxf, switching_channels_follow_the_capability_of_their_mode) {
    const std::string text = definition(R"xml(
 <Channel Name="Mode">
  <Group Byte="0">Effect</Group>
  <Capability Min="0" Max="127">Strobe function</Capability>
  <Capability Min="128" Max="255" Preset="Alias">Dimmer function
   <Alias Mode="short" Channel="Value" With="Dimmer"/></Capability>
 </Channel>
 <Channel Name="Value" Preset="ShutterStrobeSlowFast"/>
 <Channel Name="Dimmer" Preset="IntensityDimmer"/>
 <Mode Name="short"><Channel Number="0">Mode</Channel><Channel Number="1">Value</Channel></Mode>
 <Mode Name="other"><Channel Number="0">Mode</Channel><Channel Number="1">Value</Channel></Mode>)xml");
    const LoadedType type = loaded(text);
    const Optics strobing = play(type.type, {0, 255}).beams[0].optics;
    EXPECT_EQ(strobing.strobe, Strobe::regular);
    EXPECT_FLOAT_EQ(strobing.dimmer, 1.0f);
    const Optics dimmed = play(type.type, {200, 51}).beams[0].optics;
    EXPECT_EQ(dimmed.strobe, Strobe::none);
    EXPECT_FLOAT_EQ(dimmed.dimmer, 0.2f);
    EXPECT_EQ(play(type.type, {200, 51}, 1).beams[0].optics.strobe, Strobe::regular);
}

TEST(qxf, old_definitions_join_bytes_by_group_and_name) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Pan fine (LSB)"><Group Byte="1">Pan</Group><Capability Min="0" Max="255">Fine</Capability></Channel>
 <Channel Name="Pan (MSB)"><Group Byte="0">Pan</Group><Capability Min="0" Max="255">Coarse</Capability></Channel>
 <Channel Name="Iris" ><Group Byte="0">Beam</Group><Capability Min="0" Max="255">Open to closed</Capability></Channel>
 <Channel Name="Lost fine"><Group Byte="1">Tilt</Group><Capability Min="0" Max="255">Fine</Capability></Channel>
 <Mode Name="m"><Channel Number="0">Pan fine (LSB)</Channel><Channel Number="1">Pan (MSB)</Channel>
  <Channel Number="2">Iris</Channel><Channel Number="3">Lost fine</Channel></Mode>)xml"));
    ASSERT_EQ(type.type.modes[0].channels.size(), 2u);
    EXPECT_EQ(type.type.modes[0].channels[0].offsets, (std::vector<int>{1, 0}));
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{4});
    EXPECT_FLOAT_EQ(play(type.type, {0, 0, 0}).beams[0].optics.iris, 1.0f);
    EXPECT_LT(play(type.type, {0, 0, 255}).beams[0].optics.iris, 0.2f);
    EXPECT_TRUE(says(type, "fine channel 'Lost fine' of mode 'm' has no coarse channel"));
}

TEST(qxf, a_wheel_that_stops_the_light) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Gobo"><Group Byte="0">Gobo</Group>
  <Capability Min="0" Max="9">Open</Capability><Capability Min="10" Max="19">Gobo 1</Capability>
  <Capability Min="20" Max="29">Blackout</Capability>
  <Capability Min="30" Max="39">Blackout while moving</Capability></Channel>
 <Channel Name="Shutter"><Group Byte="0">Shutter</Group>
  <Capability Min="0" Max="9" Preset="ShutterClose">Closed</Capability>
  <Capability Min="10" Max="255" Preset="ShutterOpen">Open</Capability></Channel>
 <Mode Name="m"><Channel Number="0">Gobo</Channel><Channel Number="1">Shutter</Channel></Mode>)xml"));
    EXPECT_EQ(play(type.type, {5, 255}).beams[0].optics.shutter, 1.0f);
    EXPECT_EQ(play(type.type, {25, 255}).beams[0].optics.shutter, 0.0f);
    EXPECT_EQ(play(type.type, {35, 255}).beams[0].optics.shutter, 1.0f);
    EXPECT_EQ(play(type.type, {15, 0}).beams[0].optics.shutter, 0.0f);
}

// As Debian's definitions of the Robe Pointe, MAC 500, Explorer 575 and Pilot 575 write it, without presets.
TEST(qxf, a_rotating_gobo_wheel_chooses_gobos) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Rotating Gobo wheel"><Group Byte="0">Gobo</Group>
  <Capability Min="0" Max="9">Open</Capability>
  <Capability Min="10" Max="19">Rot. Gobo 1</Capability><Capability Min="20" Max="29">Rot. Gobo 2</Capability>
  <Capability Min="30" Max="39" Preset="ColorMacro" Res1="#ffffff">Gobo3</Capability>
  <Capability Min="40" Max="49">Gobo 2 Rotation (speed on channel 6)</Capability>
  <Capability Min="50" Max="99">Gobo shake 1 from slow to fast</Capability>
  <Capability Min="100" Max="255">Forwards gobo wheel rotation from slow to fast</Capability></Channel>
 <Channel Name="Rotating Gobos 2"><Group Byte="0">Gobo</Group>
  <Capability Min="0" Max="99">Clear</Capability><Capability Min="100" Max="149">1</Capability>
  <Capability Min="150" Max="255">2</Capability></Channel>
 <Channel Name="Gobo Rotation"><Group Byte="0">Gobo</Group>
  <Capability Min="0" Max="127">Gobo index 0-360</Capability>
  <Capability Min="128" Max="255">Gobo rotation clockwise, slow to fast</Capability></Channel>
 <Mode Name="m"><Channel Number="0">Rotating Gobo wheel</Channel><Channel Number="1">Rotating Gobos 2</Channel>
  <Channel Number="2">Gobo Rotation</Channel></Mode>)xml"));
    ASSERT_EQ(type.type.wheels.size(), 2u);
    EXPECT_EQ(type.type.wheels[0].slots.size(), 4u);
    EXPECT_EQ(type.type.wheels[1].slots.size(), 3u);
    const auto wheel = [&](std::vector<std::uint8_t> bytes, std::size_t number) {
        return play(type.type, std::move(bytes)).beams.at(0).optics.gobo_wheels.at(number);
    };
    for (const auto& [value, slot] :
         {std::pair<std::uint8_t, float>{0, 0}, {15, 1}, {25, 2}, {35, 3}, {45, 2}})
        EXPECT_EQ(wheel({value, 0, 0}, 0).position, slot) << int{value};
    EXPECT_GT(wheel({75, 0, 0}, 0).shake_hz, 0.5f);
    EXPECT_EQ(wheel({200, 0, 0}, 0).spinning, true);
    EXPECT_EQ(wheel({0, 120, 0}, 1).position, 1.0f);
    EXPECT_EQ(wheel({0, 200, 0}, 1).position, 2.0f);
    EXPECT_NEAR(wheel({0, 200, 64}, 1).gobo_deg, 181.4f, 1.0f) << "the turning channel is still one";
}

TEST(qxf, frost_without_a_unit_is_graded) {
    const auto frost = [](const std::string& ranges, int value) {
        const LoadedType type =
            loaded(definition("<Channel Name=\"Frost\"><Group Byte=\"0\">Beam</Group>" + ranges +
                              "</Channel><Mode Name=\"m\"><Channel Number=\"0\">Frost</Channel></Mode>"));
        return play(type.type, {static_cast<std::uint8_t>(value)}).beams.at(0).optics.frost;
    };
    const std::string pointe = "<Capability Min=\"0\" Max=\"179\">Frost from 0-100</Capability>"
                               "<Capability Min=\"180\" Max=\"189\">Frost 100%</Capability>"
                               "<Capability Min=\"190\" Max=\"255\">Raming from fast to slow</Capability>";
    EXPECT_EQ(frost(pointe, 0), 0.0f);
    EXPECT_NEAR(frost(pointe, 90), 0.5f, 0.01f);
    EXPECT_EQ(frost(pointe, 185), 1.0f);
    EXPECT_EQ(frost(pointe, 220), 0.0f) << "what is not understood is not full frost";
    const std::string alpha = "<Capability Min=\"0\" Max=\"62\">Frost Excluded</Capability>"
                              "<Capability Min=\"63\" Max=\"125\">Light frost</Capability>"
                              "<Capability Min=\"126\" Max=\"188\">Medium frost</Capability>"
                              "<Capability Min=\"189\" Max=\"255\">Heavy frost</Capability>";
    EXPECT_EQ(frost(alpha, 10), 0.0f);
    EXPECT_NEAR(frost(alpha, 100), 1.0f / 3.0f, 1e-3f);
    EXPECT_NEAR(frost(alpha, 150), 2.0f / 3.0f, 1e-3f);
    EXPECT_EQ(frost(alpha, 255), 1.0f);
    const std::string robin = "<Capability Min=\"0\" Max=\"0\">Open</Capability>"
                              "<Capability Min=\"1\" Max=\"179\">Frost >></Capability>"
                              "<Capability Min=\"180\" Max=\"255\">3200 K correction filter</Capability>";
    EXPECT_NEAR(frost(robin, 90), 0.5f, 0.01f);
    EXPECT_EQ(frost(robin, 200), 0.0f);
}

TEST(qxf, a_mode_may_have_its_own_body) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Pan" Preset="PositionPan"/> <Channel Name="Tilt" Preset="PositionTilt"/>
 <Channel Name="Gobo"><Group Byte="0">Gobo</Group>
  <Capability Min="0" Max="9">Open</Capability><Capability Min="10" Max="19">Gobo 1</Capability>
  <Capability Min="20" Max="29" Preset="GoboShakeMacro">Gobo 1 shake</Capability></Channel>
 <Channel Name="Prism"><Group Byte="0">Prism</Group>
  <Capability Min="0" Max="99" Preset="PrismEffectOff">Off</Capability>
  <Capability Min="100" Max="255" Preset="PrismEffectOn" Res1="5">On</Capability></Channel>
 <Mode Name="head"><Channel Number="0">Pan</Channel><Channel Number="1">Tilt</Channel></Mode>
 <Mode Name="mirror"><Channel Number="0">Pan</Channel><Channel Number="1">Tilt</Channel>
  <Channel Number="2">Gobo</Channel><Channel Number="3">Prism</Channel>
  <Physical><Focus Type="Mirror" PanMax="180" TiltMax="90"/></Physical></Mode>)xml"));
    ASSERT_EQ(type.type.modes.size(), 2u);
    EXPECT_FLOAT_EQ(play(type.type, {255, 255}).pan_deg, 270.0f);
    const State mirror = play(type.type, {255, 0, 15, 200}, 1);
    EXPECT_FLOAT_EQ(mirror.pan_deg, 90.0f);
    EXPECT_FLOAT_EQ(mirror.tilt_deg, -45.0f);
    EXPECT_LT(mirror.beams[0].to_fixture[3].y, -0.1f); // before the body
    const auto prism = std::find_if(type.type.wheels.begin(), type.type.wheels.end(),
                                    [](const Wheel& wheel) { return wheel.name == "Prism"; });
    ASSERT_NE(prism, type.type.wheels.end());
    ASSERT_EQ(prism->slots.size(), 2u);
    EXPECT_EQ(prism->slots[1].facets.size(), 5u);
    const auto gobo = std::find_if(type.type.wheels.begin(), type.type.wheels.end(),
                                   [](const Wheel& wheel) { return wheel.name == "Gobo"; });
    ASSERT_NE(gobo, type.type.wheels.end());
    EXPECT_EQ(gobo->slots.size(), 2u); // the shaken gobo is the same slot
    EXPECT_FLOAT_EQ(mirror.beams[0].optics.gobo_wheels[0].position, 1.0f);
}

TEST(qxf, gobo_pictures_are_read_beside_the_file_and_nowhere_else) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "qxf_gobos";
    std::filesystem::create_directories(folder / "fixtures" / "Maker");
    std::filesystem::create_directories(folder / "gobos" / "Others");
    image::Image8 picture;
    picture.width = picture.height = 4;
    picture.channels = 4;
    picture.samples.assign(64, 200);
    ASSERT_TRUE(image::write_png(folder / "gobos" / "Others" / "leaf.png", picture).ok());
    ASSERT_TRUE(image::write_png(folder / "secret.png", picture).ok());
    std::ofstream(folder / "gobos" / "Others" / "drawn.svg")
        << "<svg viewBox='0 0 80 80'><circle cx='40' cy='40' r='20'/></svg>";
    const std::string text = definition(R"xml(
 <Channel Name="Gobo"><Group Byte="0">Gobo</Group>
  <Capability Min="0" Max="9" Preset="GoboMacro" Res1="Others/open.svg">Open</Capability>
  <Capability Min="10" Max="19" Preset="GoboMacro" Res1="Others/leaf.png">Leaf</Capability>
  <Capability Min="20" Max="29" Preset="GoboMacro" Res1="../secret.png">Secret</Capability>
  <Capability Min="30" Max="39" Preset="GoboMacro" Res1="Others/drawn.svg">Drawn</Capability>
  <Capability Min="40" Max="49" Preset="GoboMacro" Res1="Others/gone.svg">Gone</Capability></Channel>
 <Mode Name="m"><Channel Number="0">Gobo</Channel></Mode>)xml");
    const std::filesystem::path file = folder / "fixtures" / "Maker" / "thing.qxf";
    std::ofstream(file) << text;
    const Result<LoadedType> type = load_type(file);
    ASSERT_TRUE(type.ok());
    ASSERT_EQ(type->type.wheels.size(), 1u);
    const std::vector<Slot>& slots = type->type.wheels[0].slots;
    ASSERT_EQ(slots.size(), 5u);
    EXPECT_EQ(slots[0].media, -1);
    ASSERT_EQ(slots[1].media, 0);
    EXPECT_EQ(type->type.media[0].width, 4);
    EXPECT_EQ(slots[2].media, -1);
    ASSERT_EQ(slots[3].media, 1);
    EXPECT_EQ(type->type.media[1].rgba.at(4 * (256 * 128 + 128)), 0) << "black in the middle";
    EXPECT_EQ(type->type.media[1].rgba.at(4 * (256 * 128 + 25)), 255) << "nothing is drawn there";
    EXPECT_TRUE(says(*type, "plain path below the fixture's folder"));
    EXPECT_TRUE(says(*type, "neither in nor beside the fixture's folder"));
    std::filesystem::remove_all(folder);
}

TEST(qxf, a_smoke_machine_gives_no_light) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Fog"><Group Byte="0">Intensity</Group><Capability Min="0" Max="255">Output</Capability></Channel>
 <Mode Name="m"><Channel Number="0">Fog</Channel></Mode>)xml",
                                              kBarPhysical, "Smoke"));
    EXPECT_TRUE(type.type.modes[0].beams.empty());
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{1});
    EXPECT_TRUE(play(type.type, {255}).beams.empty());
}

TEST(qxf, faults_are_said_with_their_line) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Dimmer" Preset="IntensityDimmer"/>
 <Channel Name="Bad"><Group Byte="0">Colour</Group>
  <Capability Min="300" Max="310">Red</Capability>
  <Capability Min="0" Max="20" Preset="ColorMacro" Res1="#ff0000">Red</Capability>
  <Capability Min="10" Max="30" Preset="ColorMacro" Res1="#00ff00">Green</Capability></Channel>
 <Channel Name="Odd" Preset="NoSuchPreset"/>
 <Mode Name="m"><Channel Number="0">Dimmer</Channel><Channel Number="3">Bad</Channel>
  <Channel Number="1">Missing</Channel><Channel Number="3">Dimmer</Channel><Channel Number="99999">Dimmer</Channel>
  <Head><Channel>77</Channel></Head></Mode>)xml"));
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{4});
    EXPECT_TRUE(says(type, "expected 0 to 255"));
    EXPECT_TRUE(says(type, "only what lies above is kept"));
    EXPECT_TRUE(says(type, "'NoSuchPreset'"));
    EXPECT_TRUE(says(type, "'Missing' that is not described"));
    EXPECT_TRUE(says(type, "a second channel 3"));
    EXPECT_TRUE(says(type, "'99999', expected 0 to 2047"));
    EXPECT_TRUE(says(type, "a head has a channel '77'"));
    const auto odd = std::find_if(type.messages.begin(), type.messages.end(), [](const Message& message) {
        return message.what.find("'NoSuchPreset'") != std::string::npos;
    });
    EXPECT_EQ(odd->where, "thing.qxf:14");
    EXPECT_FALSE(load("").ok());
    EXPECT_FALSE(load("<a/>").ok());
    EXPECT_NE(load("<FixtureDefinition>\n<Channel").error().where.find("thing.qxf:"), std::string::npos);
    EXPECT_TRUE(says(loaded("<FixtureDefinition/>"), "has no Mode"));
}

TEST(qxf, truncated_files_never_crash) {
    const std::string text = definition(kBar + R"xml(
 <Mode Name="m"><Channel Number="0">Master</Channel><Channel Number="1">Macro</Channel></Mode>)xml");
    int opened = 0;
    for (std::size_t size = 0; size <= text.size(); ++size) opened += load(text.substr(0, size)).ok();
    EXPECT_GE(opened, 1);
    EXPECT_LT(opened, 4);
}

TEST(qxf, hostile_counts_stay_bounded) {
    std::string channels;
    std::string mode;
    int described = 0;
    for (int i = 0; i < 2000 && channels.size() < 7'000'000; ++i, ++described) {
        channels += "<Channel Name=\"c" + std::to_string(i) + "\"><Group Byte=\"0\">Colour</Group>";
        for (int k = 0; k < 256; k += 2)
            channels += "<Capability Min=\"" + std::to_string(k) + "\" Max=\"" + std::to_string(k) +
                        "\" Preset=\"ColorMacro\" Res1=\"#ff00" + (k % 4 ? "11" : "22") + "\"/>";
        channels += "</Channel>";
    }
    for (int i = 0; i < described; ++i)
        mode += "<Channel Number=\"" + std::to_string(i) + "\">c" + std::to_string(i) + "</Channel>";
    const LoadedType type =
        loaded("<FixtureDefinition>" + channels + "<Mode Name=\"m\">" + mode + "</Mode></FixtureDefinition>");
    std::size_t functions = 0;
    for (const Mode& made : type.type.modes)
        for (const Channel& channel : made.channels) functions += channel.functions.size();
    EXPECT_LE(functions, 65536u);
    EXPECT_TRUE(says(type, "more than 65536 functions"));
}

// Two readings of one fixture: QLC+'s, and ours in GDTF, which was written from it.
TEST(qxf, the_vl2500_wash_agrees_with_our_own_gdtf) {
    const std::filesystem::path file = "/usr/share/qlcplus/fixtures/Vari-Lite/Vari-Lite-VL2500-Wash.qxf";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "QLC+ definitions are not installed (qlcplus-data)";
    const Result<LoadedType> qxf = load_type(file);
    const Result<LoadedType> gdtf =
        load_type(std::filesystem::path(GHOST_SOURCE_DIR) / "assets/fixtures/Vari-Lite@VL2500_Wash.gdtf");
    ASSERT_TRUE(qxf.ok() && gdtf.ok());
    EXPECT_EQ(qxf->type.modes[0].footprint, gdtf->type.modes[0].footprint);
    const auto beam_of = [](const Type& type) {
        const Mode& mode = type.modes[0];
        return *type.geometries[static_cast<std::size_t>(
                                    mode.nodes[static_cast<std::size_t>(mode.beams[0])].geometry)]
                    .beam;
    };
    EXPECT_FLOAT_EQ(beam_of(qxf->type).color_temperature_k, beam_of(gdtf->type).color_temperature_k);
    EXPECT_FLOAT_EQ(beam_of(qxf->type).field_angle_deg, beam_of(gdtf->type).field_angle_deg);
    EXPECT_NEAR(beam_of(qxf->type).luminous_flux_lm, beam_of(gdtf->type).luminous_flux_lm, 1000.0);
    EXPECT_NEAR(beam_of(qxf->type).beam_radius_m, beam_of(gdtf->type).beam_radius_m, 0.02);
    // dimmer, pan, tilt, CMY, diffuser, strobe; the colour wheel (9) and the times (12-14) QLC+ does not
    // describe.
    for (const std::vector<std::uint8_t>& bytes :
         {std::vector<std::uint8_t>{255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
          std::vector<std::uint8_t>{128, 200, 17, 60, 99, 255, 128, 64, 0, 100, 200},
          std::vector<std::uint8_t>{30, 255, 255, 255, 255, 1, 2, 3, 0, 255, 255}}) {
        const State a = play(qxf->type, bytes);
        const State b = play(gdtf->type, bytes);
        EXPECT_NEAR(a.pan_deg, b.pan_deg, 1e-3);
        EXPECT_NEAR(a.tilt_deg, b.tilt_deg, 1e-3);
        const Optics& x = a.beams[0].optics;
        const Optics& y = b.beams[0].optics;
        EXPECT_FLOAT_EQ(x.dimmer, y.dimmer);
        EXPECT_FLOAT_EQ(x.cyan, y.cyan);
        EXPECT_FLOAT_EQ(x.magenta, y.magenta);
        EXPECT_FLOAT_EQ(x.yellow, y.yellow);
        EXPECT_NEAR(x.zoom_deg, y.zoom_deg, 1e-3);
        EXPECT_EQ(x.strobe, y.strobe);
        EXPECT_NEAR(x.strobe_hz, y.strobe_hz, 1e-3);
        const glm::vec4 down(0, 0, -1, 0);
        EXPECT_LT(glm::length(a.beams[0].to_fixture * down - b.beams[0].to_fixture * down), 1e-4f);
    }
    EXPECT_TRUE(says(*qxf, "channel 'Color Wheel': 2 of 2 ranges are not shown"));
}

// "No function" of an endless pan, a strobe by its preset, "light1 on", a hue without a saturation.
TEST(qxf, what_says_nothing_leaves_the_say_to_others) {
    const LoadedType type = loaded(definition(R"xml(
 <Channel Name="Pan" Preset="PositionPan"/>
 <Channel Name="Pan continuous rotation"><Group Byte="0">Pan</Group>
  <Capability Min="0" Max="127">no function</Capability>
  <Capability Min="128" Max="255">Forwards Pan rotation from fast to slow</Capability></Channel>
 <Channel Name="Strobe" Preset="ShutterStrobeFastSlow"/>
 <Channel Name="Light1"><Group Byte="0">Intensity</Group>
  <Capability Min="0" Max="127">light1 off</Capability><Capability Min="128" Max="255">light1 on</Capability></Channel>
 <Mode Name="m"><Channel Number="0">Pan</Channel><Channel Number="1">Pan continuous rotation</Channel>
  <Channel Number="2">Strobe</Channel><Channel Number="3">Light1</Channel></Mode>)xml"));
    EXPECT_FLOAT_EQ(play(type.type, {255, 0, 0, 255}).pan_deg, 270.0f);
    EXPECT_TRUE(play(type.type, {255, 200, 0, 255}).axes.at(0).spinning);
    EXPECT_GT(play(type.type, {0, 0, 10, 128}).beams[0].optics.strobe_hz,
              play(type.type, {0, 0, 250, 128}).beams[0].optics.strobe_hz);
    EXPECT_EQ(play(type.type, {0, 0, 0, 127}).beams[0].optics.dimmer, 0.0f);
    EXPECT_EQ(play(type.type, {0, 0, 0, 128}).beams[0].optics.dimmer, 1.0f);
}

} // namespace
} // namespace ghost::fixture
