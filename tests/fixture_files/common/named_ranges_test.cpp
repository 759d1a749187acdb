// SPDX-License-Identifier: Apache-2.0
// Names of channel sets against their numbers; wheels of which only the slots say what they do; the levels
// that show what a fixture's channels do.
#include "fixture/decode.h"
#include "fixture/programmer.h"
#include "fixture/sweep.h"
#include "support/tiny_channels.h"

#include <algorithm>
#include <cmath>

namespace ghost::fixture {
namespace {

using tiny::channel;
using tiny::function;
using tiny::physical;
using tiny::set;
using tiny::Tiny;

TEST(NamedRanges, AnIrisIsOpenWhereItIsCalledSo) {
    const Tiny tiny(channel(
        1, function("Iris", "PhysicalFrom=\"0\" PhysicalTo=\"1\"",
                    set(0, "Open", 0, physical(0)) + set(1, "") + set(250, "Closed", 0, physical(1)))));
    EXPECT_FLOAT_EQ(tiny.at({0}).iris, 1.0f);
    EXPECT_NEAR(tiny.at({125}).iris, 0.5f, 0.02f);
    EXPECT_FLOAT_EQ(tiny.at({255}).iris, 0.0f);
    EXPECT_TRUE(says(tiny.loaded, {"iris is named open", "1 function"}));
    // As most files have it: nothing is touched.
    const Tiny usual(channel(1, function("Iris", "PhysicalFrom=\"1\" PhysicalTo=\"0\"",
                                         set(0, "Open") + set(1, "") + set(250, "Closed"))));
    EXPECT_FLOAT_EQ(usual.at({0}).iris, 1.0f);
    EXPECT_FLOAT_EQ(usual.at({255}).iris, 0.0f);
    EXPECT_FALSE(says(usual.loaded, {"iris is named"}));
}

TEST(NamedRanges, AnIrisBelowClosedIsSaid) {
    const Tiny tiny(channel(1, function("Iris", "PhysicalFrom=\"1\" PhysicalTo=\"-0.5\"", "")));
    EXPECT_FLOAT_EQ(tiny.at({0}).iris, 1.0f);
    EXPECT_FLOAT_EQ(tiny.at({255}).iris, 0.0f);
    EXPECT_TRUE(says(tiny.loaded, {"iris goes below 0", "1 function"}));
    const Tiny in_a_set(channel(1, function("Iris", "", set(0, "Wide", 0, physical(30)))));
    EXPECT_TRUE(says(in_a_set.loaded, {"iris goes below 0 or above 1"}));
    EXPECT_FALSE(
        says(Tiny(channel(1, function("Iris", "", set(0, "Open") + set(9, "")))).loaded, {"iris goes"}));
}

TEST(NamedRanges, AFocusIsFarWhereItIsCalledSo) {
    const Tiny tiny(channel(
        1, function("Focus1", "PhysicalFrom=\"0\" PhysicalTo=\"1\"",
                    set(0, "Focus far") + set(1, "Focus from far to near") + set(255, "Focus near"))));
    EXPECT_GT(tiny.at({0}).focus, 0.99f);
    EXPECT_LT(tiny.at({255}).focus, 0.01f);
    const Tiny unnamed(channel(
        1, function("Focus1", "PhysicalFrom=\"0\" PhysicalTo=\"1\"", set(0, "min") + set(255, "max"))));
    EXPECT_LT(unnamed.at({0}).focus, 0.01f);
}

TEST(NamedRanges, KelvinInTheNamesCount) {
    const Tiny tiny(channel(
        1, function("CTC", "PhysicalFrom=\"0\" PhysicalTo=\"1\"",
                    set(0, "off") + set(1, "8000 K") + set(2, "7978 K -> 2722 K") + set(255, "2700K"))));
    EXPECT_FLOAT_EQ(tiny.at({0}).cct_k, 0.0f);
    EXPECT_FLOAT_EQ(tiny.at({1}).cct_k, 8000.0f);
    EXPECT_NEAR(tiny.at({128}).cct_k, 5360.0f, 30.0f);
    EXPECT_FLOAT_EQ(tiny.at({255}).cct_k, 2700.0f);
    EXPECT_TRUE(says(tiny.loaded, {"named in kelvin"}));
}

// As Fiilex has it: two settings, not a way between them.
TEST(NamedRanges, TemperaturesThatNobodyStatesAreSettings) {
    const std::string range = "PhysicalFrom=\"3200\" PhysicalTo=\"6500\"";
    const Tiny tiny(channel(1, function("CTC", range, set(0, "3200K") + set(100, "6500K"))));
    EXPECT_FLOAT_EQ(tiny.at({99}).cct_k, 3200.0f);
    EXPECT_FLOAT_EQ(tiny.at({100}).cct_k, 6500.0f);
    EXPECT_TRUE(says(tiny.loaded, {"named in kelvin", "1 function"}));
    const Tiny way(channel(1, function("CTC", range, set(0, "3200K") + set(255, "6500K"))));
    EXPECT_NEAR(way.at({128}).cct_k, 4856.0f, 30.0f) << "the ends of a way";
    const Tiny stated(
        channel(1, function("CTC", range,
                            set(0, "3200K", 0, physical(3000)) + set(100, "6500K", 0, physical(5000)))));
    EXPECT_FLOAT_EQ(stated.at({100}).cct_k, 5000.0f) << "a file that states its values is believed";
}

// As Robe's chart has it.
TEST(NamedRanges, AFrostGoesByItsPerCents) {
    const std::string sets = set(0, "Open") + set(1, "Light Frost from 0% to 100% - Light frost") +
                             set(51, "100% Light Frost - Light frost") +
                             set(54, "Pulse closing from slow to fast");
    const Tiny tiny(channel(1, function("Frost1", "PhysicalFrom=\"0\" PhysicalTo=\"1\"", sets)));
    EXPECT_FLOAT_EQ(tiny.at({0}).frost, 0.0f);
    EXPECT_NEAR(tiny.at({25}).frost, 0.48f, 0.01f);
    EXPECT_FLOAT_EQ(tiny.at({50}).frost, 1.0f);
    EXPECT_FLOAT_EQ(tiny.at({53}).frost, 1.0f);
    EXPECT_FLOAT_EQ(tiny.at({100}).frost, 0.5f);
    EXPECT_TRUE(says(tiny.loaded, {"frost", "per cent", "1 function"}));
    const Tiny stated(
        channel(1, function("Frost1", "PhysicalFrom=\"0\" PhysicalTo=\"1\"",
                            set(0, "Open", 0, physical(0)) + set(51, "100%", 0, physical(0.7f)))));
    EXPECT_FLOAT_EQ(stated.at({60}).frost, 0.7f);
}

TEST(NamedRanges, NoRotationStandsStill) {
    const std::string sets = set(0, "Prism no rotation 0") + set(1, "Forwards fast") +
                             set(2, "Forwards from fast to slow") + set(128, "No rotation") +
                             set(129, "Backwards from slow to fast");
    const Tiny tiny(channel(1, function("Prism1", "", "")) +
                    channel(2, function("Prism1PosRotate", "PhysicalFrom=\"-30\" PhysicalTo=\"30\"", sets)));
    EXPECT_EQ(tiny.at({255, 0}).prisms.at(0).deg_s, 0.0f);
    EXPECT_NEAR(tiny.at({255, 1}).prisms.at(0).deg_s, -30.0f, 0.5f);
    EXPECT_EQ(tiny.at({255, 128}).prisms.at(0).deg_s, 0.0f);
    EXPECT_FLOAT_EQ(tiny.at({255, 255}).prisms.at(0).deg_s, 30.0f);
    EXPECT_TRUE(says(tiny.loaded, {"rotation", "says that there is none", "1 function"}));
    // Straight from end to end is what a program writes, no statement; another number is one.
    const std::string range = "PhysicalFrom=\"-56\" PhysicalTo=\"56\"";
    const Tiny written(
        channel(1, function("Prism1PosRotate", range,
                            set(0, "No rotation", 0, physical(-56)) + set(1, "Fast to slow"))));
    EXPECT_EQ(written.at({0}).prisms.at(0).deg_s, 0.0f);
    const Tiny stated(channel(1, function("Prism1PosRotate", range,
                                          set(0, "No rotation", 0, physical(-3)) + set(1, "Fast to slow"))));
    EXPECT_EQ(stated.at({0}).prisms.at(0).deg_s, -3.0f);
}

TEST(NamedRanges, APulseThatTakesSecondsIsNoRate) {
    const std::string sets = set(0, "Slow to fast 1/2", 0, "PhysicalFrom=\"80\" PhysicalTo=\"8\"") +
                             set(128, "Slow to fast 2/2", 0, "PhysicalFrom=\"8\" PhysicalTo=\"0.5\"");
    const Tiny tiny(channel(1, function("IrisPulseOpen", "PhysicalFrom=\"0.1\" PhysicalTo=\"3\"", sets)));
    EXPECT_FLOAT_EQ(tiny.at({0}).iris_hz, 1.0f / 80.0f);
    EXPECT_FLOAT_EQ(tiny.at({255}).iris_hz, 2.0f);
    EXPECT_TRUE(says(tiny.loaded, {"seconds of a pulse", "1 function"}));
    const Tiny rate(channel(1, function("IrisPulseOpen", "PhysicalFrom=\"0.1\" PhysicalTo=\"3\"",
                                        set(0, "Slow to fast", 0, "PhysicalFrom=\"0.1\" PhysicalTo=\"3\""))));
    EXPECT_FLOAT_EQ(rate.at({255}).iris_hz, 3.0f);
}

TEST(NamedRanges, AnAnimationWheelMovesIn) {
    const std::string wheels =
        "<Wheel Name=\"Animation\"><Slot Name=\"Open\"/><Slot Name=\"Waves\"/></Wheel>";
    const Tiny tiny(
        channel(1, function("AnimationWheel1Pos", "PhysicalFrom=\"0\" PhysicalTo=\"1\" Wheel=\"Animation\"",
                            set(0, "Open", 1) + set(20, "Proportional indexing min", 2) + set(21, "") +
                                set(127, "Proportional indexing max", 2) + set(128, "Ramping", 2))),
        wheels);
    EXPECT_FLOAT_EQ(tiny.at({0}).animations.at(0).in, 0.0f);
    EXPECT_FLOAT_EQ(tiny.at({20}).animations.at(0).in, 0.0f);
    EXPECT_NEAR(tiny.at({74}).animations.at(0).in, 0.5f, 0.02f);
    EXPECT_FLOAT_EQ(tiny.at({127}).animations.at(0).in, 1.0f);
    EXPECT_FLOAT_EQ(tiny.at({200}).animations.at(0).in, 1.0f);
}

const char* const kEffects =
    "<Wheel Name=\"Prisms\"><Slot Name=\"Open\"/><Slot Name=\"3\"><Facet/><Facet/><Facet/></Slot></Wheel>"
    "<Wheel Name=\"Effects\"><Slot Name=\"Open\"/><Slot Name=\"Heavy frost\"/>"
    "<Slot Name=\"Bars\"><Facet/><Facet/></Slot><Slot Name=\"Light frost\"/><Slot Name=\"Mystery\"/></Wheel>";

TEST(SlotMeanings, AnEffectGlassIsWhatItsSlotHolds) {
    const std::string sets =
        set(0, "", 1) + set(50, "", 2) + set(100, "", 3) + set(150, "", 4) + set(200, "", 5);
    const Tiny tiny(
        channel(1, function("Effects1", "Wheel=\"Effects\"", sets)) +
            channel(2, function("Effects1Pos", "PhysicalFrom=\"0\" PhysicalTo=\"360\"", "")) +
            channel(3, function("Prism1", "Wheel=\"Prisms\"", set(0, "Open", 1) + set(128, "3", 2))),
        kEffects);
    const Optics open = tiny.at({10, 90, 0});
    EXPECT_EQ(open.frost, 0.0f);
    ASSERT_EQ(open.prisms.size(), 2u);
    EXPECT_EQ(open.prisms[1].number, 2); // behind the file's own
    EXPECT_EQ(open.prisms[1].in, 0.0f);
    const Optics heavy = tiny.at({60, 90, 0});
    EXPECT_EQ(heavy.frost, 1.0f);
    EXPECT_FLOAT_EQ(heavy.frost_full_deg, 8.0f);
    EXPECT_EQ(heavy.prisms[1].in, 0.0f);
    const Optics bars = tiny.at({110, 90, 0});
    EXPECT_EQ(bars.frost, 0.0f);
    EXPECT_EQ(bars.prisms[1].in, 1.0f);
    EXPECT_EQ(bars.prisms[1].slot, 2);
    EXPECT_NEAR(bars.prisms[1].deg, 90.0f / 255.0f * 360.0f, 0.1f);
    EXPECT_EQ(bars.prisms[0].in, 0.0f);
    const Optics light = tiny.at({160, 90, 255});
    EXPECT_FLOAT_EQ(light.frost_full_deg, 1.0f);
    EXPECT_EQ(light.prisms[0].in, 1.0f);
    const Optics nothing = tiny.at({255, 90, 0});
    EXPECT_EQ(nothing.frost, 0.0f);
    EXPECT_EQ(nothing.prisms[1].in, 0.0f);
}

TEST(SlotMeanings, WithoutAWheelEffectsDoNothing) {
    const Tiny tiny(channel(1, function("Effects1", "", set(0, "Off") + set(10, "Pattern 1"))));
    EXPECT_TRUE(tiny.at({200}).prisms.empty());
    EXPECT_TRUE(tiny.at({200}).gobo_wheels.empty());
}

TEST(SlotMeanings, AFrostWheelTakesTheFrostOfItsSlot) {
    const Tiny tiny(
        channel(1, function("Frost1", "PhysicalFrom=\"0\" PhysicalTo=\"1\" Wheel=\"Frost\"",
                            set(0, "Open", 1) + set(80, "Light Frost", 2) + set(160, "Heavy Frost", 3))),
        "<Wheel Name=\"Frost\"><Slot Name=\"Open\"/><Slot Name=\"Light Frost\"/><Slot Name=\"Heavy "
        "Frost\"/></Wheel>");
    EXPECT_EQ(tiny.at({10}).frost, 0.0f);
    EXPECT_EQ(tiny.at({100}).frost, 1.0f);
    EXPECT_FLOAT_EQ(tiny.at({100}).frost_full_deg, 1.0f);
    EXPECT_FLOAT_EQ(tiny.at({200}).frost_full_deg, 8.0f);
}

TEST(SlotMeanings, ACorrectionWheelIsAWheelOfColours) {
    const std::string sets = set(0, "Open", 1, physical(0)) + set(128, "3000K", 2, physical(0));
    const Tiny tiny(
        channel(1, function("CTO", "PhysicalFrom=\"0\" PhysicalTo=\"1\" Wheel=\"CTO\"", sets)),
        "<Wheel Name=\"CTO\"><Slot Name=\"Open\"/><Slot Name=\"3000K\" Color=\"0.37,0.355,67\"/></Wheel>");
    ASSERT_EQ(tiny.at({0}).color_wheels.size(), 1u);
    EXPECT_EQ(tiny.at({0}).color_wheels[0].position, 0.0f);
    EXPECT_EQ(tiny.at({200}).color_wheels[0].position, 1.0f);
}

// At rest it shines; each channel is tried at its ends, and with what it needs to be seen.
TEST(Sweep, TriesEachChannelWithWhatItNeeds) {
    const Tiny tiny(
        channel(1, function("Dimmer", "PhysicalFrom=\"0\" PhysicalTo=\"1\"", "")) +
            channel(2, function("Shutter1", "PhysicalFrom=\"0\" PhysicalTo=\"1\"",
                                set(0, "Closed") + set(200, "Open"))) +
            channel(3, function("Prism1", "Wheel=\"Prisms\"", set(0, "Open", 1) + set(128, "3", 2))) +
            channel(4, function("Prism1Pos", "PhysicalFrom=\"0\" PhysicalTo=\"360\"", "")) +
            channel(5, function("Control1", "", "")),
        kEffects);
    const Sweep sweep = sweep_of(tiny.patch, 16);
    const Optics rest = tiny.at(sweep.rest);
    EXPECT_EQ(rest.dimmer, 1.0f);
    EXPECT_EQ(rest.shutter, 1.0f);
    ASSERT_EQ(sweep.channels.size(), 5u);
    EXPECT_EQ(tiny.at(sweep.channels[0].trials.front().levels).dimmer, 0.0f);
    EXPECT_EQ(tiny.at(sweep.channels[0].trials.back().levels).dimmer, 1.0f);
    ASSERT_EQ(sweep.channels[2].trials.size(), 2u);
    EXPECT_EQ(tiny.at(sweep.channels[2].trials[1].levels).prisms.at(0).in, 1.0f);
    EXPECT_EQ(sweep.channels[2].trials[1].caption, "191: 3");
    for (const Trial& trial : sweep.channels[3].trials)
        EXPECT_EQ(tiny.at(trial.levels).prisms.at(0).in, 1.0f);
    EXPECT_TRUE(sweep.channels[4].trials.empty());
    EXPECT_NE(sweep.channels[4].title.find("not drawn: Control1"), std::string::npos);
    EXPECT_LE(sweep_of(tiny.patch, 2).channels[0].trials.size(), 2u);
}

} // namespace
} // namespace ghost::fixture
