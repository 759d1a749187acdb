// SPDX-License-Identifier: Apache-2.0
// Where files leave out what a head needs: light for channels without a name, a place for axes without a
// default.
#include "support/tiny_gdtf.h"

#include "fixture/decode.h"
#include "fixture/programmer.h"

namespace ghost::fixture {
namespace {

float pan_of(const Description& description, const std::vector<std::uint8_t>& dmx) {
    const LoadedType file = loaded(description);
    const Patch patch{.name = "test", .type = &file.type, .mode = 0, .addresses = {{1, 1}}};
    Levels levels;
    if (!dmx.empty()) levels.set(1, dmx);
    return read_channels(patch, levels).at(0).physical;
}

// As Capture 2023 writes all its heads: one body, and a channel for each byte.
TEST(gdtf_at_rest, channels_with_numbers_for_names_get_a_stand_in_that_hands_light) {
    Description description;
    description.geometries = R"(<Geometry Name="Base"/>)";
    const auto numbered = [](int number) {
        const std::string name = "Dimmer" + std::to_string(number);
        return "<DMXChannel Offset='" + std::to_string(number) +
               "' Geometry='Base'><LogicalChannel Attribute='" + name + "'><ChannelFunction Attribute='" +
               name + "'/></LogicalChannel></DMXChannel>";
    };
    description.channels = numbered(1) + numbered(2) + numbered(17);
    const LoadedType head = loaded(description);
    const Mode& mode = head.type.modes.at(0);
    ASSERT_EQ(mode.beams.size(), 1u);
    const int geometry = mode.nodes.at(static_cast<std::size_t>(mode.beams[0])).geometry;
    const Beam& beam = *head.type.geometries.at(static_cast<std::size_t>(geometry)).beam;
    EXPECT_TRUE(beam.is_assumed && beam.is_lit_by_hand);
    EXPECT_TRUE(says(head, {"taking one of 10000 lm and 25 degrees at 'Base', which hands alone light"}));
    const Patch patch{.name = "test", .type = &head.type, .mode = 0, .addresses = {{1, 1}}};
    const std::vector<std::uint8_t> full(512, 255);
    Levels levels;
    levels.set(1, full);
    Targets targets = decode(patch, levels);
    EXPECT_EQ(targets.beams.at(0).dimmer, 0.0f) << "nobody knows which channel dims it";
    apply({.intensity = 0.5f}, patch, targets);
    EXPECT_EQ(targets.beams.at(0).dimmer, 0.5f);

    // One channel alone is the dimmer of a lamp.
    description.channels = numbered(1);
    const LoadedType lamp = loaded(description);
    const Patch alone{.name = "test", .type = &lamp.type, .mode = 0, .addresses = {{1, 1}}};
    EXPECT_EQ(decode(alone, levels).beams.at(0).dimmer, 1.0f);
    EXPECT_EQ(decode(alone, {}).beams.at(0).dimmer, 0.0f);
}

TEST(gdtf_at_rest, a_head_whose_file_names_no_default_rests_in_the_middle_of_its_way) {
    Description description;
    const auto axis = [](const char* name, const char* more) {
        return "<DMXChannel Offset='1,2' Geometry='Beam'><LogicalChannel Attribute='" + std::string(name) +
               "'><ChannelFunction Attribute='" + name + "' PhysicalFrom='-270' PhysicalTo='270' " + more +
               "/></LogicalChannel></DMXChannel>";
    };
    description.channels = axis("Pan", "");
    EXPECT_NEAR(pan_of(description, {}), 0.0f, 0.01f);
    EXPECT_EQ(pan_of(description, {0, 0}), -270.0f) << "a desk that says so";
    description.channels = axis("Pan", "Default='0/1'");
    EXPECT_EQ(pan_of(description, {}), -270.0f) << "the file says so";
}

} // namespace
} // namespace ghost::fixture
