// SPDX-License-Identifier: Apache-2.0
// What changed between two moments, in words.
#include "book/changes.h"

#include "print/quantities.h"
#include "show/looks.h"
#include "show/show.h"
#include "support/must.h"
#include "support/tiny_gdtf.h"

#include <gtest/gtest.h>
#include <limits>
#include <memory>

namespace ghost::scene {
namespace {

constexpr const char* kWheels =
    R"(<Wheel Name="Gobo"><Slot Name="Open"/><Slot Name="Dots" MediaFileName="dots"/>
    <Slot Name="Congo" MediaFileName="congo"/></Wheel>)";
constexpr const char* kChannels = R"(
<DMXChannel Offset="1" Geometry="Beam"><LogicalChannel Attribute="Dimmer">
  <ChannelFunction Name="Dimmer" Attribute="Dimmer"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="2" Geometry="Beam"><LogicalChannel Attribute="Gobo1">
  <ChannelFunction Name="Gobo" Attribute="Gobo1" Wheel="Gobo">
    <ChannelSet Name="Open" DMXFrom="0/1" WheelSlotIndex="1"/><ChannelSet Name="Dots" DMXFrom="10/1" WheelSlotIndex="2"/>
    <ChannelSet Name="Congo" DMXFrom="20/1" WheelSlotIndex="3"/></ChannelFunction></LogicalChannel></DMXChannel>
<DMXChannel Offset="3" Geometry="Beam"><LogicalChannel Attribute="Zoom">
  <ChannelFunction Name="Zoom" Attribute="Zoom" PhysicalFrom="12" PhysicalTo="63"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="4" Geometry="Beam"><LogicalChannel Attribute="ColorSub_C">
  <ChannelFunction Name="Cyan" Attribute="ColorSub_C"/></LogicalChannel></DMXChannel>
<DMXChannel Offset="5" Geometry="Head"><LogicalChannel Attribute="Pan">
  <ChannelFunction Name="Pan" Attribute="Pan" PhysicalFrom="-270" PhysicalTo="270"/></LogicalChannel></DMXChannel>)";

std::shared_ptr<const fixture::Type> spot() {
    static const auto type = [] {
        fixture::Description description;
        description.wheels = kWheels;
        description.channels = kChannels;
        description.geometries =
            R"(<Geometry Name="Base"><Axis Name="Head"><Beam Name="Beam" LuminousFlux="1000"/></Axis></Geometry>)";
        return std::make_shared<const fixture::Type>(must(fixture::load_xml(description.xml())).type);
    }();
    return type;
}

FixtureValues values(const std::vector<std::uint8_t>& levels) {
    const auto type = spot();
    const fixture::Patch patch{"spot", type.get(), 0, {{1, 1}}};
    fixture::State state = fixture::make_state(patch);
    fixture::step(state, patch, fixture::decode_levels(patch, levels), 5, fixture::Motion::as_commanded);
    return values_of(*type, state);
}

Show show_of(const std::vector<std::string>& names) {
    Show show;
    for (const std::string& name : names) {
        PatchedFixture& fixture = show.fixtures.emplace_back();
        fixture.name = name;
        fixture.type = spot();
    }
    return show;
}

TEST(Changes, are_told_from_decoded_values) {
    // 204 of 255 is 80 %; 60 of 255 of 12 to 63 degrees is 24.
    EXPECT_EQ(change_of(values({0, 0, 0, 0, 128}), values({204, 20, 60, 0, 128})),
              "0 to 80 %, gobo open to slot 3 'Congo', zoom 12 to 24 deg");
    EXPECT_EQ(change_of(values({204, 20, 60, 0, 128}), values({204, 10, 60, 255, 200})),
              "colour open to C 100 %, gobo slot 3 'Congo' to slot 2 'Dots', moves");
}

TEST(Changes, are_none_below_what_is_seen) {
    FixtureValues before = values({204, 0, 60, 0, 128}), after = before;
    after.light_percent += 0.9f;
    after.zoom_deg += 0.4f;
    after.pan_deg -= 0.4f;
    EXPECT_EQ(change_of(before, after), "");
    after.light_percent = before.light_percent - 1.0f;
    EXPECT_EQ(change_of(before, after), "80 to 79 %");
}

TEST(Changes, of_focus_turns_blades_and_figures_are_told) {
    const FixtureValues before = values({204, 20, 60, 0, 128});
    const auto told = [&](auto change) {
        FixtureValues after = before;
        change(after);
        return change_of(before, after);
    };
    EXPECT_EQ(told([](FixtureValues& v) { v.focus_percent = 80; }), "focus 50 to 80 %");
    EXPECT_EQ(told([](FixtureValues& v) { v.gobo_deg = 30; }), "gobo turned from 0 to 30 deg");
    EXPECT_EQ(told([](FixtureValues& v) { v.gobo_deg = 360; }), "");
    EXPECT_EQ(told([](FixtureValues& v) { v.gobo_deg_s = 12; }), "gobo turns at 0 to 12 deg/s");
    EXPECT_EQ(told([](FixtureValues& v) { v.effects_deg = 10; }), "effects turned from 0 to 10 deg");
    EXPECT_EQ(told([](FixtureValues& v) { v.effects_deg_s = -10; }), "effects turn at 0 to -10 deg/s");
    EXPECT_EQ(told([](FixtureValues& v) { v.tint_percent = -20; }), "tint 0 to -20 %");
    EXPECT_EQ(told([](FixtureValues& v) { v.blades[2].a = 0.3f; }), "shutters move");
    EXPECT_EQ(told([](FixtureValues& v) { v.shaper_deg = 20; }), "shutters move");
    EXPECT_EQ(told([](FixtureValues& v) { v.figure.emplace(); }), "another figure");
    FixtureValues one = before, other = before;
    one.figure.emplace().deg_s = other.figure.emplace().deg_s = 90;
    other.figure->deg = 45;
    EXPECT_EQ(change_of(one, other), "") << "it turns";
}

TEST(Changes, of_machines_are_told) {
    Show show;
    Mover& truss = show.movers.emplace_back();
    truss.name = "Truss";
    truss.axes.resize(2);
    truss.axes[0].name = "hoist 1";
    truss.axes[1].name = "turn";
    truss.axes[1].is_angle = true;
    using Axes = std::vector<std::vector<float>>;
    const auto changes = changes_of(show, Axes{{0, 0}}, Axes{{-3, 12.5f}});
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].line(), "Truss: hoist 1 from 0 m to -3 m, turn from 0 deg to 12.5 deg");
    EXPECT_TRUE(changes_of(show, Axes{{0, 0}}, Axes{{0.004f, 0.4f}}).empty());
}

TEST(Changes, in_the_dark_are_a_word) {
    const FixtureValues before = values({0, 0, 0, 0, 128});
    EXPECT_EQ(change_of(before, values({0, 20, 0, 0, 200})), "moves in the dark");
    EXPECT_EQ(change_of(before, values({0, 20, 0, 0, 128})), "is set in the dark");
    EXPECT_EQ(change_of(before, before), "");
    EXPECT_EQ(change_of(values({204, 0, 0, 0, 128}), values({0, 20, 60, 0, 200})), "80 to 0 %");
}

TEST(Changes, of_fixtures_that_do_alike_are_one_line_most_light_first) {
    const Show show = show_of({"Wash 1", "Spot 1", "Spot 2", "Spot 3", "Spot 5"});
    const FixtureValues dark = values({0, 0, 0, 0, 128}), full = values({255, 0, 0, 0, 128}),
                        half = values({51, 0, 0, 0, 128}), turned = values({0, 0, 0, 0, 200});
    const auto changes = changes_of(show, {dark, dark, dark, dark, dark}, {half, full, full, full, turned});
    ASSERT_EQ(changes.size(), 3u);
    EXPECT_EQ(changes[0].line(), "Spot 1-3: 0 to 100 %");
    // Marks (U+200E) keep the figures where they are beside names from right to left.
    const BookChange hebrew{{"\u05e4\u05e0\u05e1", "Spot 2", "\u0643\u0634\u0627\u0641"}, "100 to 60 %"};
    EXPECT_EQ(hebrew.line(),
              "\u200e\u05e4\u05e0\u05e1\u200e, Spot 2, \u0643\u0634\u0627\u0641\u200e: 100 to 60 %");
    EXPECT_EQ(changes[1].line(), "Wash 1: 0 to 20 %");
    EXPECT_EQ(changes[2].line(), "Spot 5: moves in the dark");
}

TEST(Changes, of_many_are_german_where_that_is_asked_for) {
    const BookChange change{{"A", "C", "E", "G", "I", "K", "M", "O", "Q", "S", "U", "W", "Y", "Z1x"}, "0"};
    EXPECT_NE(change.line({Language::german}).find("weitere"), std::string::npos)
        << change.line({Language::german});
}

TEST(Changes, of_a_fixture_without_a_file_are_none) {
    Show show = show_of({"Spot 1"});
    show.fixtures[0].type = nullptr;
    EXPECT_TRUE(changes_of(show, {FixtureValues{}}, {FixtureValues{}}).empty());
    EXPECT_TRUE(changes_of(Show{}, std::vector<FixtureValues>{}, std::vector<FixtureValues>{}).empty());
}

TEST(Changes, of_the_air_are_told) {
    Show show;
    show.ambient_lux = 1.5f;
    SceneLook look;
    look.smoke = 1.5f;
    look.ambient_lux = 3.0f;
    const auto changes = changes_of(show, SceneLook{}, look);
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0].line(), "haze 100 to 150 %");
    EXPECT_EQ(changes[1].line(), "even light 1.5 to 3 lx");
    look = {};
    look.shadows = false;
    look.attenuation = glm::vec3(1, 0, 1);
    const auto others = changes_of(show, SceneLook{}, look);
    ASSERT_EQ(others.size(), 2u);
    EXPECT_EQ(others[0].line(), "light falls off otherwise with distance");
    EXPECT_EQ(others[1].line(), "shadows off");
}

TEST(Values, name_a_gel_that_a_hand_put_in) {
    const auto type = spot();
    const fixture::Patch patch{"spot", type.get(), 0, {{1, 1}}};
    fixture::Programmer programmer;
    programmer.gel = glm::vec3(1, 1, 1);
    EXPECT_EQ(values_of(*type, fixture::make_state(patch), &programmer).colour, "gel #ffffff");
}

TEST(Values, count_the_lumens_of_all_beams) {
    EXPECT_FLOAT_EQ(full_lm(*spot(), spot()->modes[0]), 1000);
}

TEST(Quantities, are_short) {
    EXPECT_EQ(number_text(12.0f, 1), "12");
    EXPECT_EQ(number_text(12.46f, 1), "12.5");
    EXPECT_EQ(number_text(100.0f, 0), "100");
    EXPECT_EQ(number_text(-0.01f, 1), "0");
    EXPECT_EQ(number_text(std::numeric_limits<float>::quiet_NaN(), 1), "?");
    EXPECT_EQ(address_text(3, 101), "3.101");
    EXPECT_EQ(address_text(3, 0), "not patched");
}

TEST(Names, that_count_on_are_one_piece) {
    EXPECT_EQ(names_text({"Spot 1", "Spot 2", "Spot 3", "Spot 5", "Wash"}), "Spot 1-3, Spot 5, Wash");
    EXPECT_EQ(names_text({"S 09", "S 10"}), "S 09-10");
    EXPECT_EQ(names_text({"S 9", "S 010"}), "S 9, S 010");
    EXPECT_EQ(names_text({"1", "2"}), "1-2");
    EXPECT_EQ(names_text({"Spot 1", "Spot 1"}), "Spot 1, Spot 1");
    EXPECT_EQ(names_text({}), "");
    std::vector<std::string> many;
    for (int i = 0; i < 30; ++i) many.push_back("n" + std::to_string(2 * i));
    EXPECT_TRUE(names_text(many).ends_with("n22 and 18 more")) << names_text(many);
    // Longer than any number.
    const std::string digits(10'000, '7');
    EXPECT_EQ(names_text({digits, digits}), digits + ", " + digits);
}

} // namespace
} // namespace ghost::scene
