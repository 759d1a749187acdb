// SPDX-License-Identifier: Apache-2.0
// The reader on small files made here: what is kept, what is said, and that damage never crashes.
#include "support/tiny_gdtf.h"

#include "base/message_cap.h"

#include "fixture/decode.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

Patch patch_of(const Type& type, std::vector<Address> addresses = {{1, 1}}) {
    return {.name = "test", .type = &type, .mode = 0, .addresses = std::move(addresses)};
}

std::string gobo_png() {
    const std::vector<std::uint8_t> bytes =
        file_bytes("assets/fixtures/src/shared/wheels/fixed_vertical_bars.png");
    return {bytes.begin(), bytes.end()};
}

TEST(gdtf, the_smallest_file_is_kept_without_a_message) {
    const LoadedType file = loaded({});
    EXPECT_TRUE(file.messages.empty());
    EXPECT_EQ(file.type.name, "Tiny");
    ASSERT_EQ(file.type.modes.size(), 1u);
    const Channel& channel = file.type.modes[0].channels.at(0);
    EXPECT_EQ(channel.name, "Beam_Dimmer");
    EXPECT_EQ(channel.functions.at(0).dmx_to, 255u);
    EXPECT_EQ(channel.beams, std::vector<int>{0});
}

TEST(gdtf, no_zip_no_description_no_xml_no_fixture) {
    const std::vector<std::uint8_t> junk{'J', 'K', 3, 4, 0, 0}, cut{'P', 'K', 3, 4, 0, 0};
    EXPECT_NE(load_gdtf(junk, "junk.gdtf").error().text().find("junk.gdtf: expected a zip archive"),
              std::string::npos);
    EXPECT_NE(load_gdtf(cut, "cut.gdtf").error().text().find("cut.gdtf: the archive is cut short"),
              std::string::npos);
    EXPECT_NE(load_gdtf(Bytes{}, "none.gdtf").error().text().find("none.gdtf"), std::string::npos);
    EXPECT_NE(load_gdtf(make_zip({{"a.txt", "x"}}), "a.gdtf").error().text().find("no description.xml"),
              std::string::npos);
    EXPECT_NE(load_xml("<GDTF>\n<FixtureType Name='x'>\n<oops")
                  .error()
                  .text()
                  .find("description.xml:3: not well-formed"),
              std::string::npos);
    EXPECT_NE(load_xml("<GDTF/>").error().text().find("GDTF > FixtureType"), std::string::npos);
    const auto missing = load_gdtf(std::filesystem::path("no/such/file.gdtf"));
    EXPECT_NE(missing.error().text().find("no/such/file.gdtf"), std::string::npos);
}

TEST(gdtf, other_zip_methods_are_refused_by_number) {
    const auto result = load_gdtf(make_zip({{"description.xml", Description{}.xml()}}, 12), "bzip2.gdtf");
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().text().find("method 12"), std::string::npos) << result.error().text();
}

TEST(gdtf, an_entry_that_claims_gigabytes_is_refused) {
    std::vector<std::uint8_t> zip = make_zip({{"description.xml", Description{}.xml()}});
    // The directory's sizes (offsets 20 and 24 of its record) say 3 GB.
    const std::string signature("PK\x01\x02", 4);
    const auto record = std::search(zip.begin(), zip.end(), signature.begin(), signature.end());
    ASSERT_NE(record, zip.end());
    for (const int offset : {23, 27}) *(record + offset) = 0xc0;
    EXPECT_FALSE(load_gdtf(zip, "bomb.gdtf"));
}

TEST(gdtf, every_truncation_and_every_flipped_byte_ends_in_a_value_or_an_error) {
    Description description;
    description.wheels =
        R"(<Wheel Name="G"><Slot Name="Open"/><Slot Name="Bars" MediaFileName="bars"/></Wheel>)";
    std::vector<std::uint8_t> zip =
        make_zip({{"description.xml", description.xml()}, {"wheels/bars.png", "no picture"}});
    std::size_t errors = 0;
    for (std::size_t size = 0; size < zip.size(); ++size)
        errors += load_gdtf(Bytes(zip.data(), size), "cut.gdtf").ok() ? 0 : 1;
    EXPECT_EQ(errors, zip.size()) << "a zip without its end is never taken for whole";
    for (std::size_t i = 0; i < zip.size(); ++i) {
        zip[i] ^= 0x55;
        const auto result = load_gdtf(zip, "flipped.gdtf");
        EXPECT_TRUE(result.ok() || !result.error().what.empty());
        zip[i] ^= 0x55;
    }
    // The checksum catches a change inside of the XML.
    zip[200] ^= 0x01;
    EXPECT_FALSE(load_gdtf(zip, "flipped.gdtf"));
}

TEST(gdtf, pictures_missing_broken_and_good) {
    Description description;
    description.wheels = R"(<Wheel Name="G"><Slot Name="A" MediaFileName="absent"/>
<Slot Name="B" MediaFileName="broken"/><Slot Name="C" MediaFileName="bars"/><Slot Name="D" MediaFileName="bars.png"/>
<Slot Name="E" MediaFileName="huge"/></Wheel>)";
    std::string huge("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\1\0\0\0\1\0\0\x08\6\0\0\0", 29);
    const std::vector<std::uint8_t> zip = make_zip({{"description.xml", description.xml()},
                                                    {"wheels/bars.png", gobo_png()},
                                                    {"wheels/broken.png", gobo_png().substr(0, 300)},
                                                    {"wheels/huge.png", huge}});
    const auto result = load_gdtf(zip, "wheels.gdtf");
    ASSERT_TRUE(result) << result.error().text();
    const std::vector<Slot>& slots = result->type.wheels.at(0).slots;
    EXPECT_EQ(slots[0].media, -1);
    EXPECT_EQ(slots[1].media, -1);
    ASSERT_GE(slots[2].media, 0);
    EXPECT_GE(slots[3].media, 0);
    EXPECT_EQ(slots[4].media, -1);
    EXPECT_EQ(result->type.media[static_cast<std::size_t>(slots[2].media)].width, 512);
    EXPECT_TRUE(says(*result, {"wheels.gdtf: description.xml:3", "wheels/absent.png is not in the archive"}));
    EXPECT_TRUE(says(*result, {"wheels/broken.png"}));
    EXPECT_TRUE(says(*result, {"wheels/huge.png", "4096 x 4096"}));
    EXPECT_EQ(result->messages.size(), 3u);
}

TEST(gdtf, wrong_values_are_said_with_their_line_and_replaced) {
    Description description;
    description.geometries =
        "<Geometry Name=\"Base\" Model=\"Nope\" Position=\"{1,2}\">\n<Beam Name=\"Beam\" "
        "BeamAngle=\"30\" FieldAngle=\"20\" LuminousFlux=\"lots\" BeamType=\"Spot\"/></Geometry>";
    description.wheels = R"(<Wheel Name="W"><Slot Name="x" Color="-nan(ind),-nan(ind),N"/></Wheel>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"tiny.gdtf: description.xml:3", "Model 'Nope' does not exist"}));
    EXPECT_TRUE(says(file, {"description.xml:3", "Position is not a 4 x 4 matrix"}));
    EXPECT_TRUE(says(file, {"description.xml:4", "LuminousFlux is 'lots'", "taking 10000"}));
    EXPECT_TRUE(says(file, {"description.xml:4", "FieldAngle is smaller than BeamAngle"}));
    EXPECT_TRUE(says(file, {"description.xml:3", "Color is '-nan(ind),-nan(ind),N'"}));
    const Beam& beam = *file.type.geometries.at(1).beam;
    EXPECT_EQ(beam.luminous_flux_lm, 10000.0f);
    EXPECT_EQ(beam.field_angle_deg, 30.0f);
    EXPECT_EQ(beam.beam_type, BeamType::spot);
    EXPECT_EQ(beam.beam_radius_m, 0.05f);
    EXPECT_EQ(beam.color_temperature_k, 6000.0f);
}

// As Terbly's V1000P has it: a white lamp behind flags, and two channels called ColorAdd_B.
TEST(gdtf, one_additive_colour_beside_flags_is_no_emitter) {
    const auto lamp = [](const std::string& attributes) {
        Description description;
        description.channels.clear();
        int offset = 0;
        std::string rest = attributes;
        while (!rest.empty()) {
            const std::string one = rest.substr(0, rest.find(' '));
            rest.erase(0, one.size() + 1);
            description.channels += "<DMXChannel Offset=\"" + std::to_string(++offset) +
                                    "\" Geometry=\"Beam\"><LogicalChannel Attribute=\"" + one +
                                    "\"><ChannelFunction Name=\"F\" Attribute=\"" + one +
                                    "\"/></LogicalChannel></DMXChannel>";
        }
        return loaded(description);
    };
    const LoadedType white = lamp("Dimmer ColorSub_C ColorSub_M ColorSub_Y ColorAdd_B ColorAdd_B");
    EXPECT_TRUE(says(white, {"ColorAdd_B is the only additive colour"}));
    EXPECT_TRUE(decode(patch_of(white.type), {}).beams.at(0).emitters.empty());
    const LoadedType led = lamp("Dimmer ColorSub_C ColorAdd_R ColorAdd_G ColorAdd_B");
    EXPECT_EQ(decode(patch_of(led.type), {}).beams.at(0).emitters.size(), 3u);
    const LoadedType blue = lamp("Dimmer ColorAdd_B");
    EXPECT_EQ(decode(patch_of(blue.type), {}).beams.at(0).emitters.size(), 1u) << "an LED of one colour";
}

TEST(gdtf, odd_angles_become_usable_ones) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"><Beam Name="Beam" BeamAngle="360" FieldAngle="25"/>
        <Beam Name="B2" BeamAngle="0" FieldAngle="50"/><Beam Name="B3" BeamAngle="0" FieldAngle="0" ColorTemperature="0"/></Geometry>)";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.messages.size(), 5u);
    EXPECT_TRUE(says(file, {"a beam of more than 160 degrees is drawn with so many"}));
    EXPECT_EQ(file.type.geometries[1].beam->field_angle_deg, 360.0f);
    EXPECT_FLOAT_EQ(file.type.geometries[2].beam->beam_angle_deg, 30.0f);
    EXPECT_EQ(file.type.geometries[3].beam->field_angle_deg, 25.0f);
    EXPECT_EQ(file.type.geometries[3].beam->color_temperature_k, 6000.0f);
    EXPECT_EQ(decode(patch_of(file.type), {}).beams.at(0).zoom_deg, 160.0f);
}

TEST(gdtf, a_mode_without_a_beam_is_said) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"/>)";
    description.channels = "";
    EXPECT_TRUE(
        says(loaded(description), {"description.xml:4", "no Beam or Laser geometry in mode 'Standard'"}));
}

TEST(gdtf, offsets_out_of_order_give_a_24_bit_value) {
    Description description;
    description.channels = R"(<DMXChannel Offset="4,3,5" Geometry="Beam"><LogicalChannel Attribute="Dimmer">
        <ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.type.modes[0].footprint, std::vector<int>{5});
    const std::vector<std::uint8_t> dmx{9, 9, 0x34, 0x12, 0x56};
    Levels levels;
    levels.set(1, dmx);
    const ChannelReading reading = read_channels(patch_of(file.type), levels).at(0);
    EXPECT_EQ(reading.raw, 0x123456u);
    EXPECT_FLOAT_EQ(reading.physical, static_cast<float>(0x123456) / static_cast<float>(0xffffff));
}

TEST(gdtf, a_short_universe_leaves_the_default) {
    const LoadedType file = loaded({});
    const std::vector<std::uint8_t> dmx{};
    Levels levels;
    levels.set(1, dmx);
    EXPECT_FALSE(read_channels(patch_of(file.type), levels).at(0).received);
}

TEST(gdtf, references_become_one_channel_per_instance) {
    Description description;
    description.geometries = R"(<Geometry Name="Base">
<GeometryReference Name="Left" Geometry="Cell" Position="{1,0,0,-1}{0,1,0,0}{0,0,1,0}{0,0,0,1}"><Break DMXOffset="1"/></GeometryReference>
<GeometryReference Name="Right" Geometry="Cell" Position="{1,0,0,1}{0,1,0,0}{0,0,1,0}{0,0,0,1}"><Break DMXOffset="4"/></GeometryReference>
<GeometryReference Name="Odd" Geometry="Cell"><Break DMXBreak="2" DMXOffset="1"/></GeometryReference>
<GeometryReference Name="Ghost" Geometry="Nothing"/></Geometry><Beam Name="Cell"/>)";
    description.channels = R"(<DMXChannel Offset="2" Geometry="Cell"><LogicalChannel Attribute="Dimmer">
        <ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    const Mode& mode = file.type.modes.at(0);
    ASSERT_EQ(mode.channels.size(), 2u);
    EXPECT_EQ(mode.channels[0].name, "Left_Dimmer");
    EXPECT_EQ(mode.channels[0].offsets, std::vector<int>{1});
    EXPECT_EQ(mode.channels[1].offsets, std::vector<int>{4});
    EXPECT_EQ(mode.beams.size(), 3u);
    EXPECT_TRUE(says(file, {"'Odd' refers to this channel without a Break 1"}));
    EXPECT_TRUE(says(file, {"'Ghost'", "'Nothing'"}));
    const std::vector<std::uint8_t> dmx{0, 255, 0, 0, 51};
    Levels levels;
    levels.set(1, dmx);
    const Patch patch = patch_of(file.type);
    State state = make_state(patch);
    step(state, patch, decode(patch, levels), 0.0);
    EXPECT_EQ(state.beams[0].optics.dimmer, 1.0f);
    EXPECT_FLOAT_EQ(state.beams[1].optics.dimmer, 0.2f);
    EXPECT_EQ(state.beams[0].to_fixture[3].x, -1.0f);
    EXPECT_EQ(state.beams[1].to_fixture[3].x, 1.0f);
}

TEST(gdtf, overwrite_takes_the_last_break_of_the_reference) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"><GeometryReference Name="R" Geometry="Cell">
<Break DMXBreak="1" DMXOffset="3"/><Break DMXBreak="2" DMXOffset="7"/></GeometryReference></Geometry><Beam Name="Cell"/>)";
    description.channels =
        R"(<DMXChannel DMXBreak="Overwrite" Offset="1" Geometry="Cell"><LogicalChannel Attribute="Dimmer">
        <ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.type.modes[0].channels.at(0).dmx_break, 2);
    EXPECT_EQ(file.type.modes[0].channels[0].offsets, std::vector<int>{6});
    EXPECT_EQ(file.type.modes[0].footprint, (std::vector<int>{0, 7}));
}

TEST(gdtf, a_reference_to_itself_ends) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"><GeometryReference Name="R1" Geometry="Base"/>
        <GeometryReference Name="R2" Geometry="Base"/><Beam Name="Beam"/></Geometry>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"the reference 'R1' leads back to 'Base', which it is part of"}));
    EXPECT_EQ(file.type.modes.at(0).nodes.size(), 2u);
    EXPECT_EQ(file.type.modes[0].beams.size(), 1u);
}

TEST(gdtf, deep_trees_end) {
    Description description;
    std::string deep;
    for (int i = 0; i < 5000; ++i) deep += "<Geometry Name='g'>";
    for (int i = 0; i < 5000; ++i) deep += "</Geometry>";
    description.geometries = "<Geometry Name='Base'><Beam Name='Beam'/>" + deep + "</Geometry>";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"nest deeper than 64"}));
    EXPECT_EQ(file.messages.back().where, "tiny.gdtf: description.xml:3");
}

TEST(gdtf, mode_masters_choose_between_functions_of_the_same_range) {
    Description description;
    description.channels = R"(<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Control1">
        <ChannelFunction Name="Low" Attribute="Control1" DMXFrom="0/1"/>
        <ChannelFunction Name="High" Attribute="Control1" DMXFrom="128/1"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="2,3" Geometry="Beam"><LogicalChannel Attribute="Zoom">
        <ChannelFunction Name="Iris" Attribute="Iris" DMXFrom="0/1" ModeMaster="Beam_Control1" ModeFrom="0/1" ModeTo="99/1"/>
        <ChannelFunction Name="Zoom" Attribute="Zoom" DMXFrom="0/1" PhysicalFrom="10" PhysicalTo="50" ModeMaster="Beam_Control1.Control1.High" ModeFrom="128/1" ModeTo="255/1"/>
        <ChannelFunction Name="Lost" Attribute="Frost1" DMXFrom="0/1" ModeMaster="Beam_Nothing" ModeFrom="0/1" ModeTo="1/1"/>
        </LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"ModeMaster 'Beam_Nothing' does not exist"}));
    const Channel& channel = file.type.modes.at(0).channels.at(1);
    EXPECT_EQ(channel.functions[0].dmx_to, 65535u) << "another master does not end a function";
    const auto function_at = [&](std::uint8_t control) {
        const std::vector<std::uint8_t> dmx{control, 255, 255};
        Levels levels;
        levels.set(1, dmx);
        const ChannelReading reading = read_channels(patch_of(file.type), levels).at(1);
        return channel.functions.at(static_cast<std::size_t>(reading.function)).name;
    };
    EXPECT_EQ(function_at(0), "Iris");
    EXPECT_EQ(function_at(99), "Iris");
    EXPECT_EQ(function_at(110), "Lost") << "no master allows: the one without a (known) master counts";
    EXPECT_EQ(function_at(128), "Zoom");
}

TEST(gdtf, the_first_of_two_functions_at_one_place_counts) {
    Description description;
    description.channels = R"(<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Zoom">
        <ChannelFunction Name="Zoom" Attribute="Zoom" DMXFrom="0/1" PhysicalFrom="50" PhysicalTo="10"/>
        <ChannelFunction Name="NoFeature" DMXFrom="0/1"/>
        <ChannelFunction Name="Rest" DMXFrom="200/1"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"'Zoom' and 'NoFeature' start at the same DMX value"}));
    const std::vector<std::uint8_t> dmx{0};
    Levels levels;
    levels.set(1, dmx);
    EXPECT_EQ(decode(patch_of(file.type), levels).beams.at(0).zoom_deg, 50.0f);
    EXPECT_EQ(file.type.modes[0].channels[0].functions[0].dmx_to, 199u);
}

TEST(gdtf, channel_sets_that_jump_back_are_left_out) {
    Description description;
    description.channels = R"(<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Zoom">
        <ChannelFunction Name="Zoom" Attribute="Zoom" DMXFrom="0/1" PhysicalFrom="0" PhysicalTo="255">
        <ChannelSet Name="a" DMXFrom="108/1"/><ChannelSet Name="hex" DMXFrom="6D6D6D"/><ChannelSet Name="back" DMXFrom="5/1"/>
        <ChannelSet Name="b" DMXFrom="207/1" PhysicalFrom="77" PhysicalTo="77"/></ChannelFunction></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"'6D6D6D'"}));
    EXPECT_TRUE(says(file, {"'5/1'"}));
    const std::vector<ChannelSet>& sets = file.type.modes[0].channels[0].functions[0].sets;
    ASSERT_EQ(sets.size(), 2u);
    EXPECT_EQ(sets[0].dmx_from, 108u);
    EXPECT_EQ(sets[0].dmx_to, 206u);
    const auto physical_at = [&](std::uint8_t raw) {
        const std::vector<std::uint8_t> dmx{raw};
        Levels levels;
        levels.set(1, dmx);
        return read_channels(patch_of(file.type), levels).at(0).physical;
    };
    EXPECT_FLOAT_EQ(physical_at(10), 10.0f);
    EXPECT_FLOAT_EQ(physical_at(150), 150.0f) << "a set without physical values keeps those of its function";
    EXPECT_FLOAT_EQ(physical_at(255), 77.0f);
}

TEST(gdtf, old_files_keep_their_default_on_the_channel) {
    Description description;
    description.channels =
        R"(<DMXChannel Offset="1,2" Default="128/1" Geometry="Beam"><LogicalChannel Attribute="Pan">
        <ChannelFunction Attribute="Pan"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_EQ(file.type.modes[0].channels[0].initial, 0x8080u);
    EXPECT_TRUE(says(file, {"Pan has no physical range, taking -270 to 270"}));
}

TEST(gdtf, a_zoom_without_degrees_leaves_the_beam_as_it_is) {
    Description description;
    description.channels =
        R"(<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Zoom"><ChannelFunction Attribute="Zoom" PhysicalFrom="0.0" PhysicalTo="1.0"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"Zoom has no physical range: the beam keeps its"}));
    for (const std::uint8_t raw : std::vector<std::uint8_t>{0, 128, 255}) {
        const std::vector<std::uint8_t> dmx{raw};
        Levels levels;
        levels.set(1, dmx);
        const int beam =
            file.type.modes[0].nodes[static_cast<std::size_t>(file.type.modes[0].beams[0])].geometry;
        EXPECT_FLOAT_EQ(decode(patch_of(file.type), levels).beams.at(0).zoom_deg,
                        file.type.geometries[static_cast<std::size_t>(beam)].beam->field_angle_deg);
    }
}

TEST(gdtf, a_virtual_dimmer_does_not_darken) {
    Description description;
    description.channels = R"(<DMXChannel Offset="None" Geometry="Beam"><LogicalChannel Attribute="Dimmer">
        <ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="ColorAdd_R"><ChannelFunction Attribute="ColorAdd_R"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    const std::vector<std::uint8_t> dmx{255};
    Levels levels;
    levels.set(1, dmx);
    const Optics optics = decode(patch_of(file.type), levels).beams.at(0);
    EXPECT_EQ(optics.dimmer, 1.0f);
    ASSERT_EQ(optics.emitters.size(), 1u);
    EXPECT_EQ(optics.emitters[0].level, 1.0f);
    EXPECT_FLOAT_EQ(optics.emitters[0].color.x, 0.69f);
}

TEST(gdtf, dimmers_multiply_down_the_tree) {
    Description description;
    description.channels =
        R"(<DMXChannel Offset="1" Geometry="Base"><LogicalChannel Attribute="Dimmer"><ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="2" Geometry="Beam"><LogicalChannel Attribute="Dimmer"><ChannelFunction Attribute="Dimmer"/></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    const std::vector<std::uint8_t> dmx{51, 102};
    Levels levels;
    levels.set(1, dmx);
    EXPECT_NEAR(decode(patch_of(file.type), levels).beams.at(0).dimmer, 0.08f, 1e-6f);
}

TEST(gdtf, overlapping_bytes_and_a_lost_mode_geometry_are_said) {
    Description description;
    description.mode_geometry = "Geometry=\"Bas\"";
    description.channels += R"(<DMXChannel Offset="1,2" Geometry="Beam"><LogicalChannel Attribute="Zoom">
        <ChannelFunction Attribute="Zoom"/></LogicalChannel></DMXChannel><DMXChannel Offset="3" Geometry="Elsewhere"/>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"'Bas' is no top-level geometry, taking 'Base'"}));
    EXPECT_TRUE(says(file, {"'Beam_Dimmer' and 'Beam_Zoom' both use byte 1 of break 1"}));
    EXPECT_TRUE(says(file, {"geometry 'Elsewhere' is not in this mode's tree"}));
}

TEST(gdtf, slots_beyond_the_wheel_are_said) {
    Description description;
    description.wheels =
        R"(<Wheel Name="W"><Slot Name="Open"/><Slot Name="Red" Color="0.6,0.3,20"/></Wheel>)";
    description.channels = R"(<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Color1">
        <ChannelFunction Attribute="Color1" Wheel="W"><ChannelSet DMXFrom="0/1" WheelSlotIndex="1"/>
        <ChannelSet DMXFrom="100/1" WheelSlotIndex="2"/><ChannelSet DMXFrom="200/1" WheelSlotIndex="9"/>
        </ChannelFunction></LogicalChannel></DMXChannel>)";
    const LoadedType file = loaded(description);
    EXPECT_TRUE(says(file, {"WheelSlotIndex is '9', the wheel 'W' has 2 slots"}));
    const std::vector<ChannelSet>& sets = file.type.modes[0].channels[0].functions[0].sets;
    EXPECT_EQ(sets[1].slot, 1);
    EXPECT_EQ(sets[2].slot, -1);
}

TEST(gdtf, messages_are_limited_and_counted) {
    Description description;
    for (int i = 0; i < 2000; ++i) description.wheels += "<Slot Color='x'/>";
    description.wheels = "<Wheel Name='W'>" + description.wheels + "</Wheel>";
    const LoadedType file = loaded(description);
    ASSERT_EQ(file.messages.size(), kMaxMessages + 1);
    EXPECT_NE(file.messages[0].what.find("(and 1500 more of this kind)"), std::string::npos)
        << file.messages[0].what;
    EXPECT_NE(
        file.messages.back().what.find("1500 more messages are not listed, but the first of each kind: 1500 "
                                       "repairs"),
        std::string::npos)
        << file.messages.back().what;
    // What comes after a thousand repairs is said when it is of another kind: limits, losses.
    description.models = "<Model Name='M' File='gone'/>";
    EXPECT_TRUE(says(loaded(description), {"gone"}));
}

} // namespace
} // namespace ghost::fixture
