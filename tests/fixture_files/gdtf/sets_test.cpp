// SPDX-License-Identifier: Apache-2.0
// Physical values that channel sets leave open, ranges that functions leave open, and mode masters.
#include "support/tiny_channels.h"

#include <string>

namespace ghost::fixture {
namespace {

using tiny::channel;
using tiny::function;
using tiny::physical;
using tiny::set;
using tiny::Tiny;

const std::string kDefaultRange = "PhysicalFrom=\"0\" PhysicalTo=\"1\"";

std::string from(int dmx, const std::string& more = kDefaultRange) {
    return "DMXFrom=\"" + std::to_string(dmx) + "/1\" " + more;
}

// As Robe's irises have it: "Open" and "Closed" have values, what lies between has none.
TEST(Sets, WhatLiesBetweenTwoStatedSetsLeadsFromOneToTheOther) {
    const std::string sets = set(0, "Open", 0, physical(1)) + set(1, "") + set(180, "Closed", 0, physical(0));
    const Tiny tiny(channel(1, function("Iris", kDefaultRange, sets)));
    EXPECT_FLOAT_EQ(tiny.at({0}).iris, 1.0f);
    EXPECT_NEAR(tiny.at({1}).iris, 1.0f, 0.01f);
    EXPECT_NEAR(tiny.at({90}).iris, 0.5f, 0.01f);
    EXPECT_NEAR(tiny.at({179}).iris, 0.0f, 0.01f);
    EXPECT_FLOAT_EQ(tiny.at({255}).iris, 0.0f);
    const ChannelFunction& iris = tiny.loaded.type.modes.at(0).channels.at(0).functions.at(0);
    EXPECT_EQ(iris.physical_from, 1.0f) << "the range is that of the sets";
    EXPECT_EQ(iris.physical_to, 0.0f);

    const Tiny white(channel(1, function("CTC", "PhysicalFrom=\"8000\" PhysicalTo=\"2700\"",
                                         set(0, "8000K", 0, physical(8000)) + set(1, "") +
                                             set(64, "5600K", 0, physical(5600)) + set(65, "") +
                                             set(128, "2700K", 0, physical(2700)))));
    EXPECT_NEAR(white.at({63}).cct_k, 5637.5f, 1.0f);
    EXPECT_FLOAT_EQ(white.at({64}).cct_k, 5600.0f);
    EXPECT_NEAR(white.at({127}).cct_k, 2745.3f, 1.0f);
}

// A turn either way goes through what lies straight from end to end; and so do names between two alike.
TEST(Sets, TheLineHoldsWhereTwoStatedSetsSayLess) {
    const std::string turns = set(0, "No rotation", 0, physical(0)) + set(1, "Fast to slow") +
                              set(128, "No rotation", 0, physical(0)) + set(129, "Slow to fast");
    const Tiny tiny(channel(1, function("Prism1PosRotate", "PhysicalFrom=\"-30\" PhysicalTo=\"30\"", turns)));
    EXPECT_EQ(tiny.at({0}).prisms.at(0).deg_s, 0.0f);
    EXPECT_NEAR(tiny.at({1}).prisms.at(0).deg_s, -30.0f, 0.5f);
    const std::string frosts =
        set(0, "Open", 0, physical(0)) + set(1, "Frost in") + set(200, "Open", 0, physical(0));
    EXPECT_NEAR(Tiny(channel(1, function("Frost1", kDefaultRange, frosts))).at({100}).frost, 100.0f / 255.0f,
                0.01f);
}

// Hz of the sets under a function without a range: half a flash a second, no strobe of ten.
TEST(Sets, RatesThatSetsStateAreBelieved) {
    const std::string stated = set(0, "Fast to slow 1/2", 0, "PhysicalFrom=\"0.504\" PhysicalTo=\"0.36\"") +
                               set(128, "Fast to slow 2/2", 0, "PhysicalFrom=\"0.36\" PhysicalTo=\"0.1\"");
    const Tiny tiny(channel(1, function("Shutter1StrobePulseClose", kDefaultRange, stated)));
    EXPECT_FLOAT_EQ(tiny.at({0}).strobe_hz, 0.504f);
    EXPECT_FLOAT_EQ(tiny.at({255}).strobe_hz, 0.1f);
    const std::string ends =
        set(0, "slow", 0, physical(0.1f)) + set(1, "") + set(223, "fast", 0, physical(10));
    const Tiny random(channel(1, function("Shutter1StrobeRandom", kDefaultRange, ends)));
    EXPECT_FLOAT_EQ(random.at({0}).strobe_hz, 0.1f);
    EXPECT_NEAR(random.at({112}).strobe_hz, 5.05f, 0.1f);
    EXPECT_FLOAT_EQ(random.at({255}).strobe_hz, 10.0f);
    // The default, written out, says nothing still: slow to fast.
    const std::string unsaid = set(0, "slow", 0, physical(0)) + set(1, "") + set(255, "fast", 0, physical(1));
    const Tiny guessed(channel(1, function("Shutter1Strobe", kDefaultRange, unsaid)));
    EXPECT_FLOAT_EQ(guessed.at({0}).strobe_hz, 1.0f);
    EXPECT_FLOAT_EQ(guessed.at({255}).strobe_hz, 20.0f);
}

TEST(Sets, AShutterThatIsOnlyOpenIsOpen) {
    const Tiny tiny(channel(
        1, function("Shutter1", from(0), set(0, "Closed", 0, physical(0)) + set(32, "Open", 0, physical(1))) +
               "<ChannelFunction Name=\"Shutter 3\" Attribute=\"Shutter1\" " + from(160) + ">" +
               set(160, "open") + "</ChannelFunction>"));
    EXPECT_EQ(tiny.at({0}).shutter_position, 0.0f);
    EXPECT_EQ(tiny.at({160}).shutter_position, 1.0f);
    EXPECT_EQ(tiny.at({175}).shutter_position, 1.0f);
    EXPECT_EQ(tiny.at({255}).shutter_position, 1.0f);
    const Tiny par(channel(1, function("Shutter1", kDefaultRange, set(0, "LED OFF") + set(32, "LED ON"))));
    EXPECT_EQ(par.at({31}).shutter_position, 0.0f);
    EXPECT_EQ(par.at({32}).shutter_position, 1.0f);
    const Tiny ramp(channel(1, function("Shutter1", kDefaultRange, set(0, "Opening") + set(200, ""))));
    EXPECT_NEAR(ramp.at({100}).shutter_position, 100.0f / 255.0f, 0.01f);
}

// As Robe's BMFL Spot has it: the master is a function, the range is 0..0.
TEST(Sets, AMasterThatIsAFunctionIsAllOfIt) {
    const std::string wheels = "<Wheel Name=\"Gobos\"><Slot Name=\"Open\"/><Slot Name=\"Dots\"/></Wheel>";
    const std::string select =
        "<DMXChannel Offset=\"1\" Geometry=\"Beam\"><LogicalChannel Attribute=\"Gobo1\">" +
        function("Gobo1", from(0, "Wheel=\"Gobos\""), set(0, "Open", 1) + set(16, "Dots", 2)) +
        function("Gobo1SelectSpin", from(32, "Wheel=\"Gobos\""), set(32, "Dots turning", 2, physical(0))) +
        "</LogicalChannel></DMXChannel>";
    const auto master = [](const std::string& name, const std::string& range) {
        return "DMXFrom=\"0/1\" ModeMaster=\"Beam_Gobo1.Gobo1." + name + "\" " + range;
    };
    const std::string none = "ModeFrom=\"0/1\" ModeTo=\"0/1\" ";
    const Tiny tiny(
        select +
            channel(
                2,
                function("Gobo1Pos", master("Gobo1", none + "PhysicalFrom=\"0\" PhysicalTo=\"360\""), "") +
                    function("Gobo1PosRotate",
                             master("Gobo1SelectSpin", none + "PhysicalFrom=\"30\" PhysicalTo=\"30\""), "")),
        wheels);
    EXPECT_NEAR(tiny.at({20, 64}).gobo_wheels.at(0).gobo_deg, 64.0f / 255.0f * 360.0f, 0.1f);
    EXPECT_TRUE(tiny.at({40, 64}).gobo_wheels.at(0).rotating);
    EXPECT_EQ(tiny.at({40, 64}).gobo_wheels.at(0).gobo_deg_s, 30.0f);
    // One that counts for the rest of the same function: then 0 is meant.
    const Tiny literal(
        select +
            channel(
                2, function("Gobo1Pos", master("Gobo1", none + "PhysicalFrom=\"90\" PhysicalTo=\"90\""), "") +
                       function("NoFeature", master("Gobo1", "ModeFrom=\"1/1\" ModeTo=\"31/1\""), "")),
        wheels);
    EXPECT_EQ(literal.at({0, 64}).gobo_wheels.at(0).gobo_deg, 90.0f);
    EXPECT_EQ(literal.at({20, 64}).gobo_wheels.at(0).gobo_deg, 0.0f);
}

} // namespace
} // namespace ghost::fixture
