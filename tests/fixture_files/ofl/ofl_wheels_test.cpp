// SPDX-License-Identifier: Apache-2.0
// Open Fixture Library: wheels, gobo pictures, strobes, heads and mirrors.
#include "fixture_files/ofl/private/ofl_reader.h"
#include "support/must.h"
#include "support/tiny_ofl.h"

#include <filesystem>
#include <fstream>

namespace ghost::fixture {
namespace {

const std::string kSvg =
    R"json(<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 8 8'><rect width='4' height='8'/></svg>)json";

Optics optics_of(const LoadedType& type, std::vector<std::uint8_t> bytes) {
    return play(type.type, std::move(bytes)).beams[0].optics;
}

TEST(ofl_wheels, closed_slots_and_apertures_on_a_gobo_wheel) {
    const LoadedType type =
        loaded(fixture(R"json("wheels": {"G": {"slots": [{"type": "Open"}, {"type": "Gobo", "name": "a"},
 {"type": "Closed"}, {"type": "Iris", "openPercent": "10%"}, {"type": "Frost", "frostIntensity": "40%"}]}},
"availableChannels": {"G": {"capabilities": [{"dmxRange": [0, 49], "type": "WheelSlot", "slotNumber": 1},
 {"dmxRange": [50, 99], "type": "WheelSlot", "slotNumber": 2}, {"dmxRange": [100, 149], "type": "WheelSlot", "slotNumber": 3},
 {"dmxRange": [150, 199], "type": "WheelSlot", "slotNumber": 4}, {"dmxRange": [200, 229], "type": "WheelSlot", "slotNumber": 5},
 {"dmxRange": [230, 255], "type": "WheelShake", "slotNumber": 4, "shakeSpeed": "2Hz"}]}},
"modes": [{"name": "m", "channels": ["G"]}])json"));
    EXPECT_FLOAT_EQ(optics_of(type, {0}).shutter_position, 1.0f);
    EXPECT_FLOAT_EQ(optics_of(type, {0}).iris, 1.0f);
    EXPECT_FLOAT_EQ(optics_of(type, {60}).gobo_wheels[0].position, 1.0f);
    EXPECT_FLOAT_EQ(optics_of(type, {120}).shutter_position, 0.0f);
    EXPECT_FLOAT_EQ(optics_of(type, {160}).iris, 0.1f);
    EXPECT_FLOAT_EQ(optics_of(type, {160}).shutter_position, 1.0f);
    EXPECT_FLOAT_EQ(optics_of(type, {210}).frost, 0.4f);
    EXPECT_FLOAT_EQ(optics_of(type, {250}).iris, 0.1f);
    EXPECT_TRUE(says(type, "the shaking of G"));
    const std::vector<ChannelFunction>& functions = type.type.modes[0].channels[0].functions;
    EXPECT_EQ(functions[1].sets.at(0).name, "a");
}

TEST(ofl_wheels, an_iris_behind_another_one_rules_by_the_smaller) {
    const LoadedType type = loaded(
        fixture(R"json("wheels": {"I": {"slots": [{"type": "Open"}, {"type": "Iris", "openPercent": "25%"}]}},
"availableChannels": {"I": {"capabilities": [{"dmxRange": [0, 99], "type": "WheelSlot", "slotNumber": 1},
 {"dmxRange": [100, 255], "type": "WheelSlot", "slotNumber": 2}]}, "Iris": {"capability": {"type": "Iris"}}},
"modes": [{"name": "m", "channels": ["I", "Iris"]}])json"));
    EXPECT_FLOAT_EQ(optics_of(type, {0, 255}).iris, 1.0f);
    EXPECT_FLOAT_EQ(optics_of(type, {255, 255}).iris, 0.25f);
    EXPECT_FLOAT_EQ(optics_of(type, {255, 0}).iris, 0.1f);
}

std::string with_gobo(const std::string& resource) {
    return fixture(
        R"json("wheels": {"G": {"slots": [{"type": "Open"}, {"type": "Gobo", "resource": )json" + resource +
        R"json(}]}}, "availableChannels": {"G": {"capability": {"type": "WheelSlot", "slotNumber": 2}}},
"modes": [{"name": "m", "channels": ["G"]}])json");
}

TEST(ofl_wheels, gobos_lie_in_the_librarys_folder_of_resources_too) {
    const std::filesystem::path root = std::filesystem::path(testing::TempDir()) / "ofl-library";
    std::filesystem::create_directories(root / "fixtures" / "maker");
    std::filesystem::create_directories(root / "resources" / "gobos" / "aliases");
    std::ofstream(root / "resources" / "gobos" / "half.svg") << kSvg;
    std::ofstream(root / "resources" / "gobos" / "aliases" / "other.json")
        << R"json({"Folder/g1.svg": "half", "Folder/g2.svg": "absent"})json";
    std::ofstream(root / "resources" / "gobos" / "aliases" / "broken.json") << "{";
    std::ofstream(root / "fixtures" / "manufacturers.json") << R"json({"maker": {"name": "The MAKER"}})json";
    const std::filesystem::path file = root / "fixtures" / "maker" / "thing.json";
    const auto media = [&](const std::string& resource) {
        std::ofstream(file) << with_gobo(resource);
        LoadedType type = must(load_ofl(file));
        EXPECT_EQ(type.type.manufacturer, "The MAKER");
        return type;
    };
    for (const char* known : {R"json("gobos/half")json", R"json("gobos/aliases/other/Folder/g1.svg")json"}) {
        const LoadedType type = media(known);
        ASSERT_EQ(type.type.media.size(), 1u) << known;
        EXPECT_EQ(type.type.wheels[0].slots[1].media, 0);
        EXPECT_FALSE(says(type, "the slots stay open"));
    }
    for (const char* unknown :
         {R"json("gobos/aliases/other/Folder/g2.svg")json", R"json("gobos/aliases/other/g3.svg")json",
          R"json("gobos/aliases/../x.svg")json", R"json("gobos/aliases/none/x.svg")json",
          R"json("gobos/../half")json"}) {
        const LoadedType type = media(unknown);
        EXPECT_TRUE(type.type.media.empty()) << unknown;
        EXPECT_TRUE(says(type, "gobo pictures")) << unknown;
    }
    EXPECT_TRUE(says(media(R"json("gobos/aliases/broken/x.svg")json"), "is not JSON"));
    std::filesystem::remove_all(root);
}

TEST(ofl_wheels, gobos_may_be_embedded) {
    const LoadedType drawn =
        loaded(with_gobo(R"json({"key": "half", "type": "gobos", "image": {"mimeType": "image/svg+xml",
 "extension": "svg", "encoding": "utf8", "data": ")json" +
                         kSvg + R"json("}})json"));
    ASSERT_EQ(drawn.type.media.size(), 1u);
    EXPECT_EQ(drawn.type.wheels[0].slots[1].media_file, "half");
    const LoadedType packed =
        loaded(with_gobo(R"json({"key": "half", "image": {"extension": "svg", "encoding": "base64",
 "data": "PHN2ZyB4bWxucz0naHR0cDovL3d3dy53My5vcmcvMjAwMC9zdmcnIHZpZXdCb3g9JzAgMCA4IDgnPjxyZWN0IHdpZHRoPSc0JyBoZWlnaHQ9JzgnLz48L3N2Zz4="}})json"));
    ASSERT_EQ(packed.type.media.size(), 1u);
    EXPECT_EQ(packed.type.media[0].rgba, drawn.type.media[0].rgba);
    for (const char* bad :
         {R"json("encoding": "base64", "data": "%%%")json", R"json("encoding": "rot13", "data": "x")json",
          R"json("encoding": "utf8", "data": 7)json", R"json("encoding": "utf8", "data": "<svg")json"}) {
        const LoadedType type = loaded(
            with_gobo(R"json({"key": "half", "image": {"extension": "svg", )json" + std::string(bad) + "}}"));
        EXPECT_TRUE(type.type.media.empty()) << bad;
        EXPECT_FALSE(type.messages.empty()) << bad;
    }
}

const std::string kRateChannel = R"json("S": {"capabilities": [
 {"dmxRange": [0, 99], "type": "ShutterStrobe", "shutterEffect": "Closed"},
 {"dmxRange": [100, 199], "type": "StrobeSpeed", "speedStart": "1Hz", "speedEnd": "10Hz"},
 {"dmxRange": [200, 229], "type": "ShutterStrobe", "shutterEffect": "Open"})json";

TEST(ofl_wheels, a_rate_among_shutter_effects_is_a_strobe) {
    const LoadedType type = loaded(fixture(R"json("availableChannels": {)json" + kRateChannel + R"json(,
 {"dmxRange": [230, 255], "type": "ShutterStrobe", "shutterEffect": "RampUp", "speed": "4Hz"}]}},
"modes": [{"name": "m", "channels": ["S"]}])json"));
    EXPECT_FLOAT_EQ(optics_of(type, {0}).shutter_position, 0.0f);
    EXPECT_EQ(optics_of(type, {199}).strobe, Strobe::regular);
    EXPECT_FLOAT_EQ(optics_of(type, {199}).strobe_hz, 10.0f);
    EXPECT_EQ(optics_of(type, {210}).strobe, Strobe::none);
    EXPECT_EQ(optics_of(type, {255}).strobe, Strobe::pulse_open);
}

TEST(ofl_wheels, an_effect_without_a_rate_waits_for_the_channel_that_has_one) {
    const LoadedType type = loaded(fixture(R"json("availableChannels": {"K": {"capabilities": [
 {"dmxRange": [0, 99], "type": "ShutterStrobe", "shutterEffect": "Strobe"},
 {"dmxRange": [100, 199], "type": "ShutterStrobe", "shutterEffect": "Pulse"},
 {"dmxRange": [200, 255], "type": "NoFunction"}]}, )json" +
                                           kRateChannel + R"json(]}},
"modes": [{"name": "m", "channels": ["K", "S"]}, {"name": "lonely", "channels": ["K"]}])json"));
    EXPECT_EQ(optics_of(type, {0, 210}).strobe, Strobe::none);
    EXPECT_FLOAT_EQ(optics_of(type, {0, 210}).shutter_position, 1.0f);
    EXPECT_EQ(optics_of(type, {0, 199}).strobe, Strobe::regular);
    EXPECT_FLOAT_EQ(optics_of(type, {0, 199}).strobe_hz, 10.0f);
    EXPECT_EQ(optics_of(type, {150, 199}).strobe, Strobe::pulse);
    EXPECT_EQ(optics_of(type, {255, 199}).strobe, Strobe::regular);
    EXPECT_FLOAT_EQ(play(type.type, {0}, 1).beams[0].optics.strobe_hz, 5.0f); // nobody says how fast
}

const std::string kAxis =
    R"json(": {"capability": {"type": "Tilt", "angleStart": "0deg", "angleEnd": "100deg"}})json";

TEST(ofl_wheels, a_tilt_for_all_heads_is_no_head) {
    const LoadedType type = loaded(fixture(R"json("availableChannels": {"Tilt All": {"capabilities": [
 {"dmxRange": [0, 55], "type": "NoFunction"}, {"dmxRange": [56, 255], "type": "Tilt", "angleStart": "0deg", "angleEnd": "100deg"}]},
 "Master Tilt)json" + kAxis + ", \"Tilt 1" +
                                           kAxis + ", \"Tilt 2" + kAxis + R"json(},
"modes": [{"name": "rests", "channels": ["Tilt All", "Tilt 1", "Tilt 2"]},
 {"name": "never rests", "channels": ["Master Tilt", "Tilt 1", "Tilt 2"]},
 {"name": "one", "channels": ["Tilt All", "Tilt 1"]}])json"));
    const auto tilts = [&](std::vector<std::uint8_t> bytes, int mode) {
        std::vector<float> degrees;
        for (const AxisState& axis : play(type.type, std::move(bytes), mode).axes)
            degrees.push_back(static_cast<float>(axis.motor.position));
        return degrees;
    };
    EXPECT_EQ(tilts({0, 0, 255}, 0), (std::vector<float>{-50, 50}));
    EXPECT_EQ(tilts({255, 0, 0}, 0), (std::vector<float>{50, 50}));
    EXPECT_EQ(tilts({255, 0, 255}, 1), (std::vector<float>{-50, 50}));
    EXPECT_TRUE(says(type, "'Master Tilt' has no value at which it rests", "/modes/1"));
    EXPECT_EQ(type.type.modes[0].beams.size(), 2u);
    EXPECT_EQ(type.type.modes[2].beams.size(), 2u); // beside a single one it is a head like that one
}

TEST(ofl_wheels, scanners_have_mirrors) {
    const std::string members =
        R"json("availableChannels": {"Pan": {"capability": {"type": "Pan"}}, "Tilt": {"capability": {"type": "Tilt"}}},
"modes": [{"name": "m", "channels": ["Pan", "Tilt"]}])json";
    const auto has_mirror = [](const LoadedType& type) {
        return std::any_of(type.type.geometries.begin(), type.type.geometries.end(),
                           [](const Geometry& geometry) { return geometry.name == "Mirror"; });
    };
    const LoadedType scanner = loaded(fixture(members, "Scanner"));
    EXPECT_TRUE(has_mirror(scanner));
    EXPECT_FLOAT_EQ(play(scanner.type, {255, 255}).pan_deg, 90.0f);
    EXPECT_FLOAT_EQ(play(scanner.type, {255, 255}).tilt_deg, 45.0f);
    EXPECT_TRUE(has_mirror(loaded(fixture(members, "Barrel Scanner"))));
    EXPECT_FALSE(has_mirror(loaded(fixture(members))));
    EXPECT_FALSE(has_mirror(loaded(fixture(kPhysical + members, "Scanner")))); // its focus is a head
}

TEST(ofl_wheels, files_of_before_schema_8_are_said_once) {
    const LoadedType type = loaded(fixture(R"json("availableChannels": {"Dimmer": {"type": "Intensity"},
 "Strobe": {"type": "Strobe", "capabilities": [{"range": [0, 9], "name": "Open"}, {"range": [10, 255], "name": "Fast"}]}},
"modes": [{"name": "m", "channels": ["Dimmer", "Strobe", "Gone"]}])json"));
    ASSERT_EQ(type.messages.size(), 1u);
    EXPECT_NE(type.messages[0].what.find("schema 7 or older"), std::string::npos);
    EXPECT_EQ(type.type.modes[0].footprint, std::vector<int>{3});
}

} // namespace
} // namespace ghost::fixture
