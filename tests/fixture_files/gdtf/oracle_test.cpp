// SPDX-License-Identifier: Apache-2.0
// 77 GDTF files of other makers against what two other readers and the test suites of three GDTF libraries
// say about them (see the folder's manifest for the licences: they are not ours to ship).
// docs/reference/gdtf.md has the reasons where we differ on purpose.
#include "base/text.h"
#include "fixture/decode.h"
#include "fixture/values.h"
#include "support/gdtf_counts.h"
#include "support/tiny_gdtf.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <numeric>
#include <sstream>

namespace ghost::fixture {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(GHOST_SOURCE_DIR) / "../shared/fixtures";

#define SKIP_WITHOUT_FILES()                                                                                 \
    if (!std::filesystem::exists(kFolder / "gdtf"))                                                          \
    GTEST_SKIP() << "no ../shared/fixtures beside the checkout"

Result<LoadedType> load_named(const std::string& name) {
    return load_gdtf(kFolder / "gdtf" / name);
}

int count_of(const LoadedType& loaded, const std::string& words) {
    return static_cast<int>(
        std::count_if(loaded.messages.begin(), loaded.messages.end(),
                      [&](const Message& message) { return message.what.find(words) != std::string::npos; }));
}

bool has_line(const LoadedType& loaded, int line, const std::string& words) {
    const std::string place = "description.xml:" + std::to_string(line);
    return std::any_of(loaded.messages.begin(), loaded.messages.end(), [&](const Message& message) {
        return message.where.ends_with(place) && message.what.find(words) != std::string::npos;
    });
}

TEST(oracle, every_file_agrees_with_two_other_readings) {
    SKIP_WITHOUT_FILES();
    const nlohmann::json oracle = json_of(kFolder / "oracle.json");
    int files = 0;
    int refused = 0;
    std::size_t refused_modes = 0;
    int modes = 0;
    int comparable = 0;
    int equal = 0;
    int wheels = 0;
    int slots = 0;
    int beams = 0;
    for (const auto& [name, expected] : oracle.items()) {
        ++files;
        const Result<LoadedType> loaded = load_named(name);
        if (!loaded) {
            ++refused;
            // The bzip2 archive has one mode, which Python can read and we refuse.
            if (expected.at("xml").contains("modes")) refused_modes += expected["xml"]["modes"].size();
            continue;
        }
        const Type& type = loaded->type;
        const auto& xml = expected.at("xml");
        const auto& other = expected.at("pygdtf");
        ASSERT_EQ(type.modes.size(), xml.at("modes").size()) << name;
        EXPECT_EQ(type.name, xml.at("Name").get<std::string>()) << name;
        EXPECT_EQ(type.long_name, std::string(trimmed(xml.at("LongName").get<std::string>()))) << name;
        for (std::size_t m = 0; m < type.modes.size(); ++m) {
            const Mode& mode = type.modes[m];
            const auto& second = xml.at("modes")[m];
            const auto& third = other.at("modes")[m];
            ++modes;
            EXPECT_EQ(mode.name, std::string(trimmed(second.at("name").get<std::string>()))) << name;
            const bool agree = third.at("breaks") == second.at("bytes_used");
            comparable += agree;
            const bool same = footprint_of(mode) == second.at("footprint") &&
                              bytes_used(mode) == second.at("bytes_used") &&
                              beams_of(type, mode) == second.at("beams").get<std::size_t>();
            EXPECT_TRUE(same) << name << " " << mode.name << " " << footprint_of(mode) << bytes_used(mode);
            equal += same && agree;
            const auto virtual_channels =
                std::count_if(mode.channels.begin(), mode.channels.end(),
                              [](const Channel& channel) { return channel.offsets.empty(); });
            EXPECT_EQ(static_cast<std::ptrdiff_t>(mode.channels.size()) - virtual_channels,
                      second.at("channel_instances").get<std::ptrdiff_t>())
                << name << " " << mode.name;
            EXPECT_EQ(virtual_channels, second.at("virtual").get<std::ptrdiff_t>())
                << name << " " << mode.name;
            beams += static_cast<int>(beams_of(type, mode));
        }
        ASSERT_EQ(type.wheels.size(), xml.at("wheels").size()) << name;
        for (std::size_t w = 0; w < type.wheels.size(); ++w) {
            const auto& wheel = xml.at("wheels")[w];
            EXPECT_EQ(type.wheels[w].name, wheel.at("name").get<std::string>()) << name;
            EXPECT_EQ(type.wheels[w].slots.size(), wheel.at("slots").get<std::size_t>()) << name;
            std::size_t media = 0;
            std::size_t facets = 0;
            for (const Slot& slot : type.wheels[w].slots) {
                media += !slot.media_file.empty();
                facets += slot.facets.size();
            }
            EXPECT_EQ(media, wheel.at("media").get<std::size_t>()) << name;
            EXPECT_EQ(facets, wheel.at("facets").get<std::size_t>()) << name;
            ++wheels;
            slots += static_cast<int>(type.wheels[w].slots.size());
        }
        const auto& features = xml.at("features");
        EXPECT_EQ(type.emitters.size(), features.at("emitters").get<std::size_t>()) << name;
        EXPECT_EQ(type.filters.size(), features.at("filters").get<std::size_t>()) << name;
        EXPECT_EQ(measurements_of(type), features.at("measurements").get<std::size_t>()) << name;
        EXPECT_EQ(type.dmx_profiles.size(), features.at("dmx_profiles").get<std::size_t>()) << name;
        EXPECT_EQ(type.models.size(), xml.at("models").size()) << name;
    }
    std::printf(
        "  %d files, %d refused; %d modes, %d of %d comparable modes equal; %d wheels with %d slots, %d "
        "beams\n",
        files, refused, modes, equal, comparable, wheels, slots, beams);
    EXPECT_EQ(files, 77);
    EXPECT_EQ(refused, 3);
    EXPECT_EQ(comparable, 225);
    EXPECT_EQ(refused_modes, 1u);
    EXPECT_EQ(equal, comparable);
}

TEST(oracle, dmx_values_and_addresses_of_libmvrgdtf) {
    SKIP_WITHOUT_FILES();
    const nlohmann::json expected = json_of(kFolder / "libmvr_expectations.json");
    int values = 0;
    for (const auto& row : expected.at("dmx_value_conversion")) {
        const std::string text = row[0];
        EXPECT_EQ(parse_dmx(text, row[1].get<int>() / 8), row[2].get<std::uint32_t>()) << row;
        ++values;
    }
    int addresses = 0;
    for (const auto& row : expected.at("dmx_address_conversion")) {
        EXPECT_EQ(parse_dmx_address(row[0].get<std::string>()), row[1].get<int>()) << row;
        ++addresses;
    }
    EXPECT_EQ(values, 32);
    EXPECT_EQ(addresses, 4);
}

// The same faults, line by line; more only where docs/reference/gdtf.md says why.
TEST(oracle, faults_of_libmvrgdtf) {
    SKIP_WITHOUT_FILES();
    const auto hex = load_named("libmvr_BugInDmxWithHex.gdtf");
    ASSERT_TRUE(hex);
    EXPECT_TRUE(has_line(*hex, 367, "'6D6D6D'"));
    EXPECT_TRUE(has_line(*hex, 561, "'1/255'")) << "255 bytes: ours, not theirs";
    EXPECT_EQ(count_of(*hex, "DMXFrom of the channel set"), 2);
    const std::vector<ChannelSet>& sets = hex->type.modes.at(0).channels.at(6).functions.at(3).sets;
    ASSERT_EQ(sets.size(), 2u);
    EXPECT_EQ(sets[0].name, "min Pulse");
    EXPECT_EQ(sets[0].dmx_from, 108u);
    EXPECT_EQ(sets[0].dmx_to, 206u);
    EXPECT_EQ(sets[1].name, "max Pulse");
    EXPECT_EQ(sets[1].dmx_from, 207u);
    EXPECT_EQ(sets[1].dmx_to, 207u);

    const auto jumps = load_named("libmvr_BugInChannelSetDmxJumps.gdtf");
    ASSERT_TRUE(jumps);
    for (const int line : {4091, 4092, 4093, 4094, 4534})
        EXPECT_TRUE(has_line(*jumps, line, "DMXFrom of the channel set"));
    EXPECT_EQ(count_of(*jumps, "DMXFrom of the channel set"), 5);
    EXPECT_EQ(count_of(*jumps, "start at the same DMX value"), 6);

    const auto wrong = load_named("libmvr_WrongDmxValue.gdtf");
    ASSERT_TRUE(wrong);
    EXPECT_EQ(std::count_if(wrong->messages.begin(), wrong->messages.end(),
                            [](const Message& message) { return message.severity == Severity::error; }),
              16);

    const auto broken = load_named("libmvr_XMLBroken.gdtf");
    ASSERT_FALSE(broken) << "half a fixture is not offered";
    EXPECT_NE(broken.error().text().find("description.xml:27: not well-formed"), std::string::npos);

    const auto packed = load_named("libmvr_CrashWhileOpen.gdtf");
    ASSERT_FALSE(packed);
    EXPECT_NE(packed.error().text().find("zip method 12"), std::string::npos);

    const auto frost =
        load_named("libmvr_Robe_lighting_s.r.o.@BMFL_Spot@cannot_assign_0_to_frost_function.gdtf");
    ASSERT_TRUE(frost);
    EXPECT_TRUE(has_line(*frost, 887, "no function of the channel starts at DMX 0"));
    EXPECT_TRUE(has_line(*frost, 1663, "no function of the channel starts at DMX 0"));
    EXPECT_TRUE(has_line(*frost, 1037, "DMXFrom of the channel set"));

    const auto virtual_channel = load_named("libmvr_virtual_channel.gdtf");
    ASSERT_TRUE(virtual_channel);
    EXPECT_EQ(virtual_channel->type.modes.at(0).channels.size(), 3u);
    EXPECT_EQ(virtual_channel->type.modes[0].footprint, std::vector<int>{2});
}

// "1.3 Element 1 -> AbstractElement_Pan", "2.3 Main_XYZ_Y (2/3)": which byte of which channel stands where.
TEST(oracle, channel_layout_of_opengdtf) {
    SKIP_WITHOUT_FILES();
    for (const char* name :
         {"opengdtf_Test@Channel_Layout_Test@v1_first_try.gdtf",
          "opengdtf_Test@Channel_Layout_Test_v1-2@replicated_v1-1_channel_layout_test.gdtf"}) {
        std::ifstream file(kFolder / "expect/opengdtf_expected_channel_layout.md");
        const auto loaded = load_named(name);
        ASSERT_TRUE(loaded) << name;
        const Mode& mode = loaded->type.modes.at(0);
        int lines = 0;
        for (std::string line; std::getline(file, line);) {
            int dmx_break = 0;
            int place = 0;
            int length = 0;
            if (std::sscanf(line.c_str(), "%d.%d%n", &dmx_break, &place, &length) != 2) continue;
            ++lines;
            std::string wanted(trimmed(line.substr(static_cast<std::size_t>(length))));
            int part = 1;
            int parts = 1;
            if (const std::size_t bracket = wanted.find(" ("); bracket != std::string::npos) {
                ASSERT_EQ(std::sscanf(wanted.c_str() + bracket, " (%d/%d)", &part, &parts), 2);
                wanted.resize(bracket);
            }
            std::string found;
            for (const Channel& channel : mode.channels)
                for (std::size_t byte = 0; byte < channel.offsets.size(); ++byte) {
                    if (channel.dmx_break != dmx_break || channel.offsets[byte] != place - 1) continue;
                    found = channel.name;
                    EXPECT_EQ(static_cast<int>(byte) + 1, part) << line;
                    EXPECT_EQ(static_cast<int>(channel.offsets.size()), parts) << line;
                }
            // Theirs names the referenced geometry too, ours the reference.
            const std::size_t arrow = wanted.find(" -> ");
            if (arrow != std::string::npos)
                wanted = wanted.substr(0, arrow) + wanted.substr(wanted.find('_', arrow));
            EXPECT_EQ(found, wanted) << name << ": " << line;
        }
        EXPECT_EQ(lines, 20);
        EXPECT_EQ(mode.footprint, (std::vector<int>{11, 9}));
    }
}

TEST(oracle, problems_of_opengdtf) {
    SKIP_WITHOUT_FILES();
    const auto missing =
        load_named("opengdtf_Test@Channel_Layout_Test@v1_first_try.missing_break_in_geometry_reference.gdtf");
    ASSERT_TRUE(missing);
    EXPECT_TRUE(has_line(*missing, 100, "refers to this channel without a Break 2"));
    EXPECT_EQ(count_of(*missing, "without a Break"), 1);
    const auto clash = load_named("opengdtf_Test@Channel_Layout_Test@v1_first_try.channel_clash.gdtf");
    ASSERT_TRUE(clash);
    EXPECT_EQ(count_of(*clash, "both use byte"), 1);
    const auto whole = load_named("opengdtf_Test@Channel_Layout_Test@v1_first_try.gdtf");
    ASSERT_TRUE(whole);
    EXPECT_EQ(count_of(*whole, "both use byte") + count_of(*whole, "without a Break"), 0);

    // Their list of geometries and of problems, for the files of it that we have.
    std::ifstream file(kFolder / "expect/opengdtf_expected.toml");
    std::stringstream text;
    text << file.rdbuf();
    const std::string toml = text.str();
    int compared = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder / "gdtf")) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("opengdtf_")) continue;
        const std::size_t at = toml.find("filename = \"" + name.substr(9) + "\"");
        if (at == std::string::npos) continue;
        const std::string part = toml.substr(at, toml.find("\n[", at) - at);
        const auto loaded = load_gdtf(entry.path());
        if (part.find("\nerror = ") != std::string::npos) {
            EXPECT_FALSE(loaded) << name;
            ++compared;
            continue;
        }
        ASSERT_TRUE(loaded) << name;
        int duplicates = 0;
        for (std::size_t p = part.find("duplicate Geometry"); p != std::string::npos;
             p = part.find("duplicate Geometry", p + 1))
            ++duplicates;
        EXPECT_EQ(count_of(*loaded, "a second geometry named"), duplicates) << name;
        std::size_t geometries = 0;
        for (std::size_t p = part.find("\n    \"", part.find("geometries = [")); p != std::string::npos;
             p = part.find("\n    \"", p + 1))
            ++geometries;
        EXPECT_EQ(loaded->type.geometries.size() -
                      static_cast<std::size_t>(count_of(*loaded, "taking one of 10000 lm")),
                  geometries)
            << name;
        ++compared;
    }
    EXPECT_GE(compared, 4);
}

TEST(oracle, footprints_of_pygdtf) {
    SKIP_WITHOUT_FILES();
    const auto loaded = [](const char* name) {
        const std::vector<std::uint8_t> bytes = file_bytes((kFolder / "expect" / name).string());
        return load_xml({bytes.begin(), bytes.end()});
    };
    for (const std::string which : {"pygdtf_test1", "pygdtf_test2"}) {
        const nlohmann::json expected = json_of(kFolder / "expect" / (which + ".json"));
        const auto file = loaded((which + ".xml").c_str());
        ASSERT_TRUE(file) << file.error().text();
        ASSERT_EQ(file->type.modes.size(), expected.size());
        for (std::size_t m = 0; m < expected.size(); ++m) {
            const Mode& mode = file->type.modes[m];
            EXPECT_EQ(mode.name, std::string(trimmed(expected[m].at("name").get<std::string>())));
            EXPECT_EQ(std::accumulate(mode.footprint.begin(), mode.footprint.end(), 0),
                      static_cast<int>(expected[m].at("dmx_channels").size()))
                << mode.name;
            EXPECT_EQ(std::count_if(mode.channels.begin(), mode.channels.end(),
                                    [](const Channel& channel) { return channel.offsets.empty(); }),
                      expected[m].at("virtual_channels_count").get<int>())
                << mode.name;
        }
    }
    const auto gaps = loaded("pygdtf_missing_channels.xml");
    ASSERT_TRUE(gaps) << gaps.error().text();
    EXPECT_EQ(gaps->type.modes.at(0).footprint, std::vector<int>{56});
}

TEST(oracle, physical_values_of_pygdtf) {
    SKIP_WITHOUT_FILES();
    const nlohmann::json expected = json_of(kFolder / "expect/pygdtf_physical_values.json");
    const auto loaded = load_named("pygdtf_LED_PAR_64_RGBW_v0.3.gdtf");
    ASSERT_TRUE(loaded);
    const Patch patch{.name = "par", .type = &loaded->type, .mode = 0, .addresses = {{1, 1}}};
    const Mode& mode = loaded->type.modes.at(0);
    int compared = 0;
    for (int value = 0; value < 256; ++value) {
        const std::vector<std::uint8_t> dmx(512, static_cast<std::uint8_t>(value));
        Levels levels;
        levels.set(1, dmx);
        const std::vector<ChannelReading> readings = read_channels(patch, levels);
        for (std::size_t c = 0; c < mode.channels.size(); ++c) {
            const Channel& channel = mode.channels[c];
            if (!expected.contains(channel.name)) continue;
            const auto& logical = expected.at(channel.name).at(channel.logical.at(0).attribute);
            const auto& function = logical.at(channel.functions.at(0).name);
            ASSERT_EQ(function.at("dmx")[static_cast<std::size_t>(value)], value);
            EXPECT_NEAR(readings[c].physical,
                        function.at("function")[static_cast<std::size_t>(value)].get<float>(), 1e-6)
                << channel.name << " " << value;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 5 * 256);
}

#undef SKIP_WITHOUT_FILES

} // namespace
} // namespace ghost::fixture
