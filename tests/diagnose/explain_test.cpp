// SPDX-License-Identifier: Apache-2.0
// Every verdict about a fixture itself and about where its light goes. Illuminances are worked out by hand
// from lumens, angles and metres.
#include "support/explain_trial.h"

#include "diagnose/explain_parts.h"
#include "diagnose/explain_print.h"
#include "fixture_files/ofl/ofl.h"
#include "show/show.h"

#include <map>
#include <nlohmann/json.hpp>
#include <random>

namespace ghost::scene {
namespace {

using namespace trial;

TEST(explain, LitWithLumensAngleObjectMetresAndLux) {
    Trial trial(type_of(kDimmer + kShutter));
    const Explanation lit = trial.set(1, 255).set(2, 8).explain();
    expect(lit, Visibility::lit, Cause::none, {"lit: ", "of 10000 lm", "beam 20 deg", "hits 'floor' at 6 m"});
    ASSERT_EQ(lit.beams.size(), 1u);
    const BeamFacts& beam = lit.beams[0];
    EXPECT_NEAR(beam.full_lm, 10000, 50);
    EXPECT_NEAR(beam.output_lm, 10000, 50);
    ASSERT_TRUE(beam.hit.has_value());
    // Straight down from 6 m.
    const float peak_cd = peak_candela(make_profile(20, 25, true), 10000);
    EXPECT_NEAR(beam.axis_cd, peak_cd, 0.01f * peak_cd);
    // At 10 m it is as a data sheet has it; nearer, a lens of 5 cm is no point.
    const float apex_m = 0.05f / (std::tan(glm::radians(12.5f)) - 0.05f / kMeasured_m);
    const float expected_lx = 0.01f * peak_cd * std::pow((10.0f + apex_m) / (6.0f + apex_m), 2.0f);
    EXPECT_NEAR(beam.hit->illuminance_lx, expected_lx, 0.005f * expected_lx);
    EXPECT_NEAR(beam.hit->distance_m, 6.0f, 0.02f);
    EXPECT_EQ(lit.channels[0].addresses, "1.001");
    EXPECT_EQ(lit.channels[0].value, "255");
    EXPECT_EQ(lit.channels[0].meaning, "100 %");
    EXPECT_EQ(lit.channels[1].function, "Open");
    EXPECT_EQ(lit.channels[1].range, "8-127");
    EXPECT_EQ(lit.channels[1].why, "8 is in 8-127");
}

TEST(explain, LuxFallWithTheAngleAndTheDimmer) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].rotation_deg = {60, 0, 0}; // the way is twice as long, the light grazes
    const Explanation lit = trial.set(1, 51).explain();
    const float peak_cd = 0.2f * peak_candela(make_profile(20, 25, true), 10000);
    ASSERT_TRUE(lit.beams[0].hit.has_value());
    EXPECT_NEAR(lit.beams[0].output_lm, 2000, 20);
    EXPECT_NEAR(lit.beams[0].hit->distance_m, 12.0f, 0.03f);
    EXPECT_NEAR(lit.beams[0].hit->facing_lx, peak_cd / 144.0f, 0.01f * peak_cd / 144.0f);
    EXPECT_NEAR(lit.beams[0].hit->illuminance_lx, 0.5f * peak_cd / 144.0f, 0.01f * peak_cd / 144.0f);
}

TEST(explain, CorrectionAndMixedColoursHaveTheirOwnShares) {
    Trial cto(type_of(kDimmer + simple("2", "CTO", 6000, 3200)));
    const BeamFacts warm = cto.set(1, 255).set(2, 255).explain().beams.at(0);
    EXPECT_LT(warm.correction, 0.7f);
    EXPECT_NEAR(warm.correction * warm.full_lm, warm.output_lm, 0.01f * warm.full_lm);
    EXPECT_EQ(warm.mix, 1.0f);
    EXPECT_NEAR(warm.rest, 1.0f, 0.01f);
    Trial hsb(type_of(kDimmer + simple("2", "HSB_Hue", 0, 360) + simple("3", "HSB_Saturation") +
                      simple("4", "HSB_Brightness")));
    const BeamFacts blue = hsb.set(1, 255).set(2, 170).set(3, 255).set(4, 255).explain().beams.at(0);
    EXPECT_LT(blue.mix, 0.2f);
    EXPECT_EQ(blue.correction, 1.0f);
    EXPECT_NEAR(blue.rest, 1.0f, 0.01f);
}

TEST(explain, DimmerAtZero) {
    Trial trial(type_of(kDimmer + kShutter));
    const Explanation dark = trial.set(1, 0).set(2, 0).explain();
    expect(dark, Visibility::dark, Cause::dimmer,
           {"dark because the dimmer on channel 1 (1.001) is at 0", "'Dimmer' (DMX 0-255)"});
    ASSERT_TRUE(find(dark, Cause::shutter)) << "the next obstacle is said, too";
    EXPECT_TRUE(find(dark, Cause::shutter)->blocks);
    expect(trial.set(1, 5).set(2, 8).explain(), Visibility::nearly_dark, Cause::dimmer,
           {"nearly dark (2 % of", "is at 5"});
}

TEST(explain, WhatHandsKeepDarkIsSaidAsTheirs) {
    Trial trial(type_of(kDimmer + kShutter));
    trial.set(1, 230).set(2, 8);
    trial.hands[0].intensity = 0.0f;
    const Explanation dark = trial.explain();
    expect(dark, Visibility::dark, Cause::dimmer, {"dark because hands have it so: its intensity is at 0 %"});
    EXPECT_EQ(dark.channels[0].value, "230") << "the desk's";
    trial.hands[0] = {.levels = {0, 8}}; // as a stored look has it
    expect(trial.explain(), Visibility::dark, Cause::dimmer,
           {"dark because hands have it so: the dimmer on channel 1 (1.001) is at 0 of function 'Dimmer'"});
    trial.hands[0] = {.levels = {255, 0}};
    expect(trial.explain(), Visibility::dark, Cause::shutter,
           {"dark because hands have it so: the shutter function 'Closed' (DMX 0-7) is active on channel 2"});
    trial.set(1, 0);
    trial.hands[0] = {.colour = glm::vec3(1, 0, 0)}; // of what keeps it dark hands hold nothing
    expect(trial.explain(), Visibility::dark, Cause::dimmer,
           {"dark because the dimmer on channel 1 (1.001) is at 0"});
}

TEST(explain, SixteenBitValuesAreCoarseAndFine) {
    Trial trial(type_of(simple("1,2", "Dimmer")));
    const Explanation dark = trial.set(2, 20).explain();
    expect(dark, Visibility::dark, Cause::dimmer,
           {"channel 1-2 (1.001-002) is at 0.20 of function 'Dimmer' (DMX 0-255)"});
    EXPECT_EQ(trial.set(1, 128).explain().channels[0].value, "128.20");
}

TEST(explain, MasterAboveTheCells) {
    const string cells = "<Geometry Name=\"Bar\">" + kBeam + "</Geometry>";
    Trial trial(type_of(
        channel("1", "Dimmer", function("Master", "Dimmer", 0, 0, 1), "Bar") + simple("2", "Dimmer"), cells));
    const Explanation half = trial.set(1, 51).set(2, 255).explain();
    EXPECT_NEAR(half.beams[0].dimmer, 1.0f, 1e-4f);
    EXPECT_NEAR(half.beams[0].master, 0.2f, 1e-4f);
    expect(trial.set(1, 0).explain(), Visibility::dark, Cause::dimmer,
           {"channel 1 (1.001) is at 0", "'Master'"});
}

TEST(explain, ShutterClosed) {
    Trial trial(type_of(kDimmer + kShutter));
    trial.show.fixtures[0].address = 20;
    expect(trial.set(20, 255).set(21, 5).explain(), Visibility::dark, Cause::shutter,
           {"dark because the shutter function 'Closed' (DMX 0-7) is active on channel 2 (1.021), value 5"});
}

TEST(explain, ModeMasterIsPartOfWhy) {
    const string late = channel("2", "Shutter1",
                                function("Open", "Shutter1", 0, 1, 1) +
                                    function("Closed", "Shutter1", 0, 0, 0,
                                             "ModeMaster=\"Beam_Dimmer\" ModeFrom=\"0/1\" ModeTo=\"99/1\""));
    Trial trial(type_of(kDimmer + late));
    const Explanation dark = trial.set(1, 80).set(2, 4).explain();
    expect(dark, Visibility::dark, Cause::shutter, {"'Closed'"});
    EXPECT_EQ(dark.channels[1].why, "4 is in 0-255 and channel 1 (1.001) is at 80, needed is 0-99");
    const Explanation lit = trial.set(1, 100).explain();
    expect(lit, Visibility::lit, Cause::none, {});
    EXPECT_EQ(lit.channels[1].why,
              "4 is in 0-255; 'Closed' does not count: channel 1 (1.001) is at 100, needed is 0-99");
}

TEST(explain, AMacroInThePlaceOfTheEmitters) {
    const string file = R"json({"name": "Thing", "categories": ["Other"], "availableChannels": {
 "Red": {"capability": {"type": "ColorIntensity", "color": "Red"}},
 "Macro": {"capabilities": [{"dmxRange": [0, 9], "type": "NoFunction"},
  {"dmxRange": [10, 255], "type": "ColorPreset", "colors": ["#0000ff"]}]}},
 "modes": [{"name": "m", "channels": ["Red", "Macro"]}]})json";
    auto loaded = fixture::load_ofl(Bytes(reinterpret_cast<const std::uint8_t*>(file.data()), file.size()),
                                    "thing.json");
    ASSERT_TRUE(loaded.ok());
    Trial trial(std::make_shared<const fixture::Type>(std::move(loaded->type)));
    EXPECT_EQ(trial.set(1, 200).set(2, 0).explain().channels[0].why, "200 is in 0-255");
    EXPECT_EQ(trial.set(2, 10).explain().channels[0].why,
              "200 is in 0-255; the macro on channel 2 (1.002) is in its place");
}

TEST(explain, StrobeInItsDarkPhase) {
    Trial trial(type_of(kDimmer + kShutter));
    trial.set(1, 255).set(2, 128); // once a second
    trial.dt_s = 0.1;
    trial.steps = 8;
    expect(trial.explain(), Visibility::dark, Cause::strobe,
           {"between two flashes", "'Flash' (DMX 128-255) on channel 2 (1.002), value 128",
            "flashes 1 times a second"});
    trial.steps = 3;
    expect(trial.explain(), Visibility::lit, Cause::none, {});
}

TEST(explain, IrisClosed) {
    Trial trial(type_of(kDimmer + simple("2", "Iris")));
    expect(trial.set(1, 255).set(2, 0).explain(), Visibility::dark, Cause::iris,
           {"the iris is closed to 0 % of the beam's width: channel 2 (1.002) is at 0"});
    const Explanation half = trial.set(2, 128).explain();
    const Profile profile = make_profile(20, 25, true);
    EXPECT_NEAR(half.beams[0].iris, beam_solid_angle(profile, 128 / 255.0f) / beam_solid_angle(profile, 1),
                1e-3f);
}

const string kBlades =
    simple("3", "Blade1A") + simple("4", "Blade1B") + simple("5", "Blade3A") + simple("6", "Blade3B");

TEST(explain, BladesThatCoverAllComeBeforeWhatOnlyDims) {
    Trial trial(type_of(kDimmer + simple("2", "Iris") + kBlades + simple("7", "ColorSub_C") +
                        simple("8", "ColorSub_M") + simple("9", "ColorSub_Y")));
    trial.set(1, 255).set(2, 255);
    for (const int blade : {3, 4, 5, 6}) trial.set(blade, 255);
    expect(trial.explain(), Visibility::dark, Cause::blades,
           {"the framing blades (top 100 % in on channel 3 (1.003) and channel 4 (1.004), bottom 100 %",
            "let only 0 %"});
    // Full flags leave 1.9 %, an iris at 0.1 leaves 1 %: the blades leave nothing.
    for (const int flag : {7, 8, 9}) trial.set(flag, 255);
    const Explanation all = trial.set(2, 26).explain();
    expect(all, Visibility::dark, Cause::blades, {"of what the iris leaves"});
    EXPECT_TRUE(find(all, Cause::colour)->blocks);
    EXPECT_TRUE(find(all, Cause::iris)->blocks);
    // Beside a dimmer at 0 they are the second thing to look at.
    expect(trial.set(1, 0).explain(), Visibility::dark, Cause::dimmer, {});
}

// Neither alone keeps the light away: an iris that leaves the middle, a blade that covers just that.
TEST(explain, BladesBehindAnIris) {
    Trial trial(type_of(kDimmer + simple("2", "Iris") + kBlades));
    trial.set(1, 255).set(2, 77);
    for (const int blade : {3, 4}) trial.set(blade, 191); // 75 % of the way: below the iris of 0.3
    const Explanation dark = trial.explain();
    expect(dark, Visibility::dark, Cause::blades, {"of what the iris leaves"});
    EXPECT_GT(dark.beams[0].iris, 0.05f);
}

TEST(explain, WidthHitAndLuxAreThoseOfWhatIsLit) {
    Trial trial(type_of(kDimmer + simple("2", "Iris") + kBlades));
    const Explanation open = trial.set(1, 255).set(2, 255).explain();
    EXPECT_NEAR(open.beams[0].beam_deg, 20.0f, 0.01f);
    EXPECT_NEAR(open.beams[0].field_deg, 25.0f, 0.01f);
    const Explanation half = trial.set(2, 128).explain();
    // Half of the tangent of half the field.
    const float half_deg = glm::degrees(2.0f * std::atan(128.0f / 255.0f * std::tan(glm::radians(12.5f))));
    EXPECT_NEAR(half.beams[0].field_deg, half_deg, 0.05f);
    EXPECT_NEAR(half.beams[0].beam_deg, half_deg, 0.05f) << "an iris ends it before it is half as bright";
    EXPECT_NE(half.verdict.find("beam " + explained::number(static_cast<double>(half_deg), 1) + " deg"),
              string::npos)
        << half.verdict;
    // The top blade covers three quarters: what is left is a slice away from the middle.
    trial.set(2, 255).set(3, 191).set(4, 191);
    const Explanation cut = trial.explain();
    expect(cut, Visibility::lit, Cause::none, {"beam 20 deg, cut to "});
    const BeamFacts& beam = cut.beams[0];
    EXPECT_TRUE(beam.is_cut);
    EXPECT_LT(beam.lit_deg.y, 0.4f * beam.field_deg);
    ASSERT_TRUE(beam.hit.has_value());
    EXPECT_GT(std::abs(beam.hit->position_m.y), 0.6f) << "the lit slice of a field of 1.33 m radius";
    EXPECT_LT(std::abs(beam.hit->position_m.x), 0.1f);
    EXPECT_GT(beam.hit->illuminance_lx, 0.2f * open.beams[0].hit->illuminance_lx);
    EXPECT_LT(beam.hit->illuminance_lx, 0.9f * open.beams[0].hit->illuminance_lx);
}

TEST(explain, ProductNamesWhatTakesMostFirst) {
    Trial trial(type_of(kDimmer + simple("2", "Iris") + kBlades));
    const Explanation dim = trial.set(1, 128).set(2, 64).set(3, 130).set(4, 130).explain();
    ASSERT_EQ(dim.cause, Cause::several) << dim.verdict;
    EXPECT_LT(dim.verdict.find("iris"), dim.verdict.find("dimmer")) << dim.verdict;
    const BeamFacts& beam = dim.beams[0];
    EXPECT_NEAR(beam.rest, 1.0f, 0.02f) << "the shares are what they leave together";
}

TEST(explain, ColourFlagsAllFull) {
    Trial trial(
        type_of(kDimmer + simple("2", "ColorSub_C") + simple("3", "ColorSub_M") + simple("4", "ColorSub_Y")));
    const Explanation dark = trial.set(1, 255).set(2, 255).set(3, 255).set(4, 255).explain();
    // 0.03 0.80 0.95, 0.72 0.03 0.80, 0.90 0.75 0.02 of red, green, blue.
    expect(dark, Visibility::nearly_dark, Cause::colour,
           {"nearly dark (1.9 %", "cyan 100 % on channel 2 (1.002), magenta 100 % on channel 3 (1.003) and "
                                  "yellow 100 % on channel 4 (1.004)"});
}

const string kWheels = "<Wheel Name=\"Filters\"><Slot Name=\"Open\" Color=\"0.3127,0.3290,100\"/>"
                       "<Slot Name=\"Black\" Color=\"0.3127,0.3290,0.01\"/></Wheel>";
const string kWheelChannel =
    channel("2", "Color1",
            function("Select", "Color1", 0, 0, 1, "Wheel=\"Filters\"",
                     "<ChannelSet Name=\"Open\" DMXFrom=\"0/1\" WheelSlotIndex=\"1\"/>"
                     "<ChannelSet Name=\"Between\" DMXFrom=\"1/1\"/>"
                     "<ChannelSet Name=\"Black\" DMXFrom=\"100/1\" WheelSlotIndex=\"2\"/>"));

TEST(explain, WheelSlotThatLetsNothingThrough) {
    Trial trial(type_of(kDimmer + kWheelChannel, kBeam, kWheels));
    const Explanation dark = trial.set(1, 255).set(2, 100).explain();
    expect(dark, Visibility::dark, Cause::colour,
           {"'Black' of 'Filters' on channel 2 (1.002), value 100 lets only 0.01 % of the light through"});
    EXPECT_EQ(dark.channels[1].slot, 2);
    EXPECT_EQ(dark.channels[1].meaning, "slot 2 'Black' of 'Filters'");
    const Explanation between = trial.set(2, 50).explain();
    expect(between, Visibility::lit, Cause::none, {});
    ASSERT_EQ(between.beams[0].wheels.size(), 1u);
    EXPECT_EQ(between.beams[0].wheels[0].next, "Black");
    EXPECT_NEAR(between.beams[0].wheels[0].fraction, 0.5f, 0.1f) << "half of the gate";
}

TEST(explain, DarkGobo) {
    // The picture cannot be in this archive: it is put into the type.
    string wheels = kWheels, select = kWheelChannel;
    for (std::size_t at; (at = select.find("Color1")) != string::npos;) select.replace(at, 6, "Gobo1");
    fixture::Type type = *type_of(kDimmer + select, kBeam, wheels);
    fixture::Media media;
    media.file = "wheels/black.png";
    media.width = media.height = 64;
    media.rgba.assign(64 * 64 * 4, 0);
    for (std::size_t k = 3; k < media.rgba.size(); k += 4) media.rgba[k] = 255;
    type.media.push_back(media);
    type.wheels[0].slots[1].media = 0;
    Trial trial(std::make_shared<const fixture::Type>(type));
    expect(
        trial.set(1, 255).set(2, 100).explain(), Visibility::dark, Cause::gobo,
        {"gobo wheel 'Filters' stands at 'Black' and lets only 0 % of the light through (channel 2 (1.002), "
         "value 100)"});
    const Explanation between = trial.set(2, 85).explain();
    EXPECT_EQ(between.cause, Cause::gobo);
    EXPECT_NE(between.verdict.find("stands between 'Open' and 'Black' and lets only"), string::npos)
        << between.verdict;
}

TEST(explain, ZoomThatIsNoAngle) {
    Trial trial(type_of(kDimmer + simple("2", "Zoom", 0, 0.9f)));
    const Explanation thin = trial.set(1, 255).set(2, 51).explain();
    expect(thin, Visibility::unseen, Cause::zoom,
           {"the zoom on channel 2 (1.002) is at 51", "0.18 deg", "no angle of a lamp"});
    Trial wide(type_of(kDimmer + simple("2", "Zoom", 10, 400)));
    const Explanation flood = wide.set(1, 255).set(2, 255).explain();
    expect(flood, Visibility::lit, Cause::none, {});
    ASSERT_TRUE(find(flood, Cause::zoom)) << "said, but it shines";
    EXPECT_NE(find(flood, Cause::zoom)->text.find("drawn is a field of 160 deg"), string::npos);
}

TEST(explain, LedNeedsColour) {
    Trial trial(
        type_of(kDimmer + simple("2", "ColorAdd_R") + simple("3", "ColorAdd_G") + simple("4", "ColorAdd_B")));
    expect(trial.set(1, 255).explain(), Visibility::dark, Cause::emitters,
           {"all its colours are at 0", "LED needs colour",
            "channel 2 (1.002), channel 3 (1.003) and channel 4 (1.004)"});
    expect(trial.set(3, 255).explain(), Visibility::lit, Cause::none, {});
}

TEST(explain, LampOffAndLampOfNoLumens) {
    const string control =
        channel("2", "Control1",
                function("Nothing", "Control1", 0, 0, 1) + function("Lamp off", "Control1", 165, 0, 1) +
                    function("Reserved", "Control1", 172, 0, 1) + function("Reset", "Control1", 200, 0, 1));
    Trial trial(type_of(kDimmer + control));
    const Explanation told = trial.set(1, 255).set(2, 168).explain();
    ASSERT_TRUE(find(told, Cause::lamp));
    EXPECT_NE(find(told, Cause::lamp)
                  ->text.find("the lamp is told to go off: function 'Lamp off' (DMX 165-171) on channel 2 "
                              "(1.002), value 168"),
              string::npos);
    EXPECT_EQ(find(trial.set(2, 0).explain(), Cause::lamp), nullptr);
    const Explanation reset = trial.set(2, 210).explain();
    ASSERT_TRUE(find(reset, Cause::lamp));
    EXPECT_FALSE(find(reset, Cause::lamp)->blocks);
    EXPECT_NE(find(reset, Cause::lamp)->text.find("it is told to reset itself: function 'Reset'"),
              string::npos);
    string unlit = kBeam;
    unlit.replace(unlit.find("10000"), 5, "0");
    expect(Trial(type_of(kDimmer, unlit)).set(1, 255).explain(), Visibility::dark, Cause::lamp, {"0 lumens"});
}

TEST(explain, LampPutOutByItsChannel) {
    const string control =
        channel("2", "LampControl",
                function("Lamp on", "LampControl", 0, 0, 1) + function("Lamp off", "LampControl", 128, 0, 1));
    for (const char* lamp : {"Discharge", "Tungsten", "LED"}) {
        string beam = kBeam;
        beam.insert(beam.find("BeamType"), "LampType=\"" + string(lamp) + "\" ");
        Trial trial(type_of(kDimmer + control, beam));
        trial.set(1, 255).set(2, 200);
        trial.steps = 150; // held for 5 s
        expect(trial.explain(), Visibility::dark, Cause::lamp,
               {"the lamp is told to go off: function 'Lamp off' (DMX 128-255) on channel 2 (1.002), value "
                "200"});
        expect(trial.set(1, 0).explain(), Visibility::dark, Cause::dimmer, {"channel 1 (1.001) is at 0"});
    }
}

TEST(explain, VirtualDimmerIsTheDesksWork) {
    Trial trial(
        type_of(channel("None", "Dimmer", function("Dimmer", "Dimmer", 0, 0, 1)) + simple("1", "ColorAdd_R") +
                    simple("2", "ColorAdd_B"),
                kBeam, "",
                "<Relations><Relation Name=\"a\" Master=\"Beam_Dimmer\" "
                "Follower=\"Beam_ColorAdd_R.ColorAdd_R.ColorAdd_R\" "
                "Type=\"Multiply\"/><Relation Name=\"b\" Master=\"Beam_Dimmer\" "
                "Follower=\"Beam_ColorAdd_B.ColorAdd_B.ColorAdd_B\" Type=\"Multiply\"/></Relations>"));
    const Explanation dark = trial.set(9, 1).explain();
    expect(dark, Visibility::dark, Cause::emitters, {"all its colours are at 0"});
    ASSERT_TRUE(find(dark, Cause::dimmer));
    EXPECT_EQ(find(dark, Cause::dimmer)->text, "its dimmer is the virtual channel 'Beam_Dimmer': it has no "
                                               "DMX channel, the desk works it into channel 1 (1.001) "
                                               "and channel 2 (1.002)");
}

TEST(explain, NoBeamGeometry) {
    fixture::Type type = *type_of(kDimmer);
    type.modes[0].beams.clear();
    for (fixture::Channel& one : type.modes[0].channels) one.beams.clear();
    expect(Trial(std::make_shared<const fixture::Type>(type)).set(1, 255).explain(), Visibility::dark,
           Cause::no_beam, {"mode 'Standard' has no Beam geometry"});
}

TEST(explain, SeveralThingsTogether) {
    Trial trial(type_of(kDimmer + simple("2", "Iris")));
    expect(trial.set(1, 26).set(2, 70).explain(), Visibility::nearly_dark, Cause::several,
           {"dimmer 10 %", " x ", "iris", "of 10000 lm"});
}

TEST(explain, InsideAnObjectAndRightBehindOne) {
    Trial inside(type_of(kDimmer));
    hang(inside.stage, "crate", box({0.5f, 0.5f, 0.5f}), {0, 0, 6});
    expect(inside.set(1, 255).explain(), Visibility::unseen, Cause::hidden,
           {"its lens is inside of 'crate'"});
    Trial behind(type_of(kDimmer));
    hang(behind.stage, "pipe", box({0.5f, 0.02f, 0.02f}), {0, 0, 5.9f});
    const Explanation blocked = behind.set(1, 255).explain();
    expect(blocked, Visibility::unseen, Cause::hidden,
           {"'pipe' is right before its lens (8 cm) and stops the light"});
    Trial below(type_of(kDimmer));
    hang(below.stage, "table", box({0.5f, 0.5f, 0.02f}), {0, 0, 1});
    expect(below.set(1, 255).explain(), Visibility::lit, Cause::none, {"hits 'table' at 5 m"});
}

TEST(explain, PointsAwayFromEverything) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].rotation_deg = {150, 0, 0};
    const Explanation dry = trial.set(1, 255).explain();
    expect(dry, Visibility::unseen, Cause::away,
           {"not seen because it points 60 degrees upwards and away from everything", "no haze"});
    trial.show.haze.extinction_per_m = 0.02f;
    const Explanation hazy = trial.explain();
    expect(hazy, Visibility::lit, Cause::none, {"hits nothing: it leaves the stage 60 degrees upwards"});
    EXPECT_TRUE(find(hazy, Cause::away));
    // The middle misses the floor's edge, the rest does not.
    trial.show.fixtures[0].rotation_deg = {75, 0, 0};
    EXPECT_EQ(trial.explain().beams[0].edge_object, "floor");
    trial.has_stage = false;
    expect(trial.explain(), Visibility::lit, Cause::none, {"what it hits is not known"});
}

TEST(explain, FaintNextToTheBrightest) {
    Trial trial;
    string candle = kBeam;
    candle.replace(candle.find("10000"), 5, "20");
    trial.add("Candle", type_of(kDimmer, candle), 1);
    trial.add("Beacon", type_of(kDimmer), 2);
    expect(trial.set(1, 255).set(2, 255).explain(0), Visibility::unseen, Cause::faint,
           {"it gives 20 lm, less than 1 % of the brightest fixture"});
    expect(trial.explain(1), Visibility::lit, Cause::none, {});
    expect(trial.set(2, 0).explain(0), Visibility::lit, Cause::none, {});
}

TEST(explain, FixtureThatRunsIntoTheNextUniverse) {
    Trial trial(type_of(
        kDimmer + channel("2", "Shutter1",
                          function("Closed", "Shutter1", 0, 0, 0) + function("Open", "Shutter1", 8, 1, 1))));
    trial.show.fixtures[0].address = 512;
    const Explanation dark = trial.set(512, 255).explain();
    // The shutter is at its default in the universe that is not there, and that is closed.
    expect(dark, Visibility::dark, Cause::never_received,
           {"universe 2 is not in the recording", "channel 2 (2.001), default 0"});
}

TEST(explain, SummaryGroupsTheDark) {
    Trial trial;
    for (int k = 0; k < 5; ++k) trial.add("Lamp " + std::to_string(k), type_of(kDimmer), 1 + k);
    trial.show.fixtures[3].universe = trial.show.fixtures[4].universe = 3;
    trial.set(1, 255).set(2, 255).set(3, 0);
    EXPECT_EQ(summary_of(trial.all()),
              "3 of 5 dark: 2 because their universe 3 never arrived, 1 because their dimmer is at 0");
    EXPECT_EQ(summary_of({trial.explain(0)}), "all 1 lit");
    EXPECT_EQ(summary_of({}), "the show has no fixtures");
}

TEST(explain, WordsAndJsonAreTheSameFacts) {
    Trial trial(type_of(kDimmer + kShutter));
    const Explanation dark = trial.set(1, 255).set(2, 3).explain();
    const string words = words_of(dark, trial.reception);
    EXPECT_EQ(words.find("Lamp: dark because the shutter function 'Closed' (DMX 0-7) is active on channel 2 "
                         "(1.002), value 3\n"),
              0u)
        << words;
    for (const char* part :
         {"recording test.show", "1: received", "1.001 to 1.002, 2 channels", "Test Tiny, mode 'Standard'",
          "dimmer 100 % x master 100 % x shutter 0 %", "= 0 of 10000 lm", "hits      'floor' 6 m"})
        EXPECT_NE(words.find(part), string::npos) << part << "\n" << words;
    const auto json = nlohmann::json::parse(json_of(dark, trial.reception));
    EXPECT_EQ(json["verdict"], dark.verdict);
    EXPECT_EQ(json["state"], "dark");
    EXPECT_EQ(json["cause"], "shutter");
    EXPECT_EQ(json["channels"][1]["addresses"][0], "1.2");
    EXPECT_EQ(json["channels"][1]["function"], "Closed");
    EXPECT_EQ(json["channels"][1]["dmx"], "0-7");
    EXPECT_EQ(json["beams"][0]["hit"]["object"], "floor");
    EXPECT_EQ(json["beams"][0]["shares"]["shutter"], 0);
    EXPECT_EQ(json["findings"][0]["channels"][0], "Beam_Shutter1");
    const auto all = nlohmann::json::parse(json_of(std::vector<Explanation>{dark}, trial.reception));
    EXPECT_EQ(all["counts"]["dark"], 1);
    EXPECT_EQ(all["fixtures"][0]["fixture"], "Lamp");
}

TEST(explain, NamesCannotMoveTheCursor) {
    Trial trial(type_of(kDimmer));
    trial.show.fixtures[0].name = "La\033[2Jmp\n";
    const Explanation dark = trial.explain();
    EXPECT_EQ(words_of(dark, trial.reception).find('\033'), string::npos);
    EXPECT_EQ(line_of(dark).find('\n'), string::npos);
    trial.show.fixtures[0].name = "La\xff";
    EXPECT_TRUE(nlohmann::json::accept(json_of(trial.explain(), trial.reception)));
}

// Whatever the desk sends to a real fixture: it is dark if and only if something is to blame, the parts make
// up the whole, and nothing crashes.
TEST(explain, EveryDarkLampHasAReason) {
    auto loaded = fixture::load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
    ASSERT_TRUE(loaded.ok());
    Trial trial;
    trial.add("Spot", std::make_shared<const fixture::Type>(std::move(loaded->type)), 1);
    const GoboStack gobos = build_gobos(trial.show, trial.report);
    std::mt19937 random(7);
    std::map<Visibility, int> seen;
    for (int round = 0; round < 300; ++round) {
        dmx::Levels levels{};
        for (std::size_t k = 0; k < 22; ++k)
            levels[k] = static_cast<std::uint8_t>(random() % 4 ? random() % 256 : random() % 2 * 255);
        dmx::Universes universes;
        universes.at(1).levels = std::make_shared<const dmx::Levels>(levels);
        Rig rig(trial.show);
        rig.step(universes, 1.0 / 30);
        ExplainInput input{trial.show, trial.report, rig, gobos, universes, trial.reception};
        const Explanation explanation = Explainer(input).explain(0);
        ++seen[explanation.visibility];
        const BeamFacts& beam = explanation.beams.at(0);
        const bool dim = beam.output_lm < 0.025f * beam.full_lm;
        EXPECT_EQ(dim, explanation.visibility <= Visibility::dark &&
                           explanation.visibility >= Visibility::nearly_dark);
        EXPECT_EQ(dim, explanation.cause != Cause::none) << explanation.verdict;
        const float product = beam.lamp * beam.dimmer * beam.master * beam.shutter * beam.strobe *
                              beam.colour * beam.emitters * beam.iris * beam.gobo * beam.rest;
        EXPECT_NEAR(product, beam.output_lm / beam.full_lm, 2e-3f);
        EXPECT_FALSE(words_of(explanation, trial.reception).empty());
    }
    EXPECT_GT(seen[Visibility::lit], 10);
    EXPECT_GT(seen[Visibility::dark], 20);
}

} // namespace
} // namespace ghost::scene
