// SPDX-License-Identifier: Apache-2.0
// Our own GDTF files, and a bar of pixels with references and two breaks, against a second reading by
// tools/read_fixtures.py, which shares nothing with ours: every channel, function and set.
#include "support/gdtf_counts.h"
#include "support/must.h"
#include "support/tiny_gdtf.h"

namespace ghost::fixture {
namespace {

using ChannelPlace = std::pair<int, std::vector<int>>; // break, bytes from 1

// By place: what is referred to several times stands in no order that both readings share.
std::map<ChannelPlace, const Channel*> channels_by_place(const Mode& mode) {
    std::map<ChannelPlace, const Channel*> result;
    for (const Channel& channel : mode.channels) {
        ChannelPlace place{channel.dmx_break, channel.offsets};
        for (int& byte : place.second) ++byte;
        EXPECT_TRUE(result.emplace(place, &channel).second) << channel.name << ": a second one there";
    }
    return result;
}

void expect_functions(const Channel& channel, const nlohmann::json& functions) {
    ASSERT_EQ(channel.functions.size(), functions.size());
    for (std::size_t f = 0; f < functions.size(); ++f) {
        const ChannelFunction& function = channel.functions[f];
        const auto& expected = functions[f];
        const std::string name = expected.at("name");
        EXPECT_EQ(function.name, name);
        EXPECT_EQ(function.attribute, expected.at("attribute").get<std::string>()) << name;
        EXPECT_EQ(function.dmx_from, expected.at("from").get<std::uint32_t>()) << name;
        EXPECT_EQ(function.dmx_to, expected.at("to").get<std::uint32_t>()) << name;
        EXPECT_EQ(function.dmx_default, expected.at("default").get<std::uint32_t>()) << name;
        EXPECT_FLOAT_EQ(function.physical_from, expected.at("physical")[0].get<float>()) << name;
        EXPECT_FLOAT_EQ(function.physical_to, expected.at("physical")[1].get<float>()) << name;
        const auto& sets = expected.at("sets");
        ASSERT_EQ(function.sets.size(), sets.size()) << name;
        for (std::size_t s = 0; s < sets.size(); ++s) {
            EXPECT_EQ(function.sets[s].name, sets[s][0].get<std::string>()) << name;
            EXPECT_EQ(function.sets[s].dmx_from, sets[s][1].get<std::uint32_t>()) << name;
        }
    }
}

TEST(own_files, agree_with_a_second_reading) {
    const std::filesystem::path root = GHOST_SOURCE_DIR;
    const nlohmann::json oracle = json_of(root / "tests/references/fixtures.json");
    ASSERT_EQ(oracle.size(), 6u);
    for (const auto& [name, expected] : oracle.items()) {
        SCOPED_TRACE(name);
        const std::vector<std::uint8_t> bytes = file_bytes((root / name).string());
        const LoadedType file =
            must(name.ends_with(".xml") ? load_xml({bytes.begin(), bytes.end()}) : load_gdtf(root / name));
        const Type& type = file.type;
        EXPECT_EQ(type.name, expected.at("name").get<std::string>());
        EXPECT_EQ(type.manufacturer, expected.at("manufacturer").get<std::string>());
        EXPECT_EQ(type.emitters.size(), expected.at("emitters").get<std::size_t>());
        EXPECT_EQ(type.filters.size(), expected.at("filters").get<std::size_t>());
        EXPECT_EQ(measurements_of(type), expected.at("measurements").get<std::size_t>());
        EXPECT_EQ(type.dmx_profiles.size(), expected.at("dmx_profiles").get<std::size_t>());
        EXPECT_EQ(type.models.size(), expected.at("models").get<std::size_t>());
        ASSERT_EQ(type.wheels.size(), expected.at("wheels").size());
        for (std::size_t w = 0; w < type.wheels.size(); ++w) {
            const auto& wheel = expected["wheels"][w];
            EXPECT_EQ(type.wheels[w].name, wheel.at("name").get<std::string>());
            nlohmann::json slots = nlohmann::json::array();
            std::size_t media = 0, facets = 0;
            for (const Slot& slot : type.wheels[w].slots) {
                slots.push_back(slot.name);
                media += !slot.media_file.empty();
                facets += slot.facets.size();
            }
            EXPECT_EQ(slots, wheel.at("slots"));
            EXPECT_EQ(media, wheel.at("media").get<std::size_t>());
            EXPECT_EQ(facets, wheel.at("facets").get<std::size_t>());
        }
        ASSERT_EQ(type.modes.size(), expected.at("modes").size());
        for (std::size_t m = 0; m < type.modes.size(); ++m) {
            const Mode& mode = type.modes[m];
            const auto& second = expected["modes"][m];
            EXPECT_EQ(mode.name, second.at("name").get<std::string>());
            EXPECT_EQ(footprint_of(mode), second.at("footprint"));
            EXPECT_EQ(beams_of(type, mode), second.at("beams").get<std::size_t>());
            const auto channels = channels_by_place(mode);
            ASSERT_EQ(channels.size(), second.at("channels").size());
            for (const auto& channel : second["channels"]) {
                const auto found =
                    channels.find({channel.at("break"), channel.at("bytes").get<std::vector<int>>()});
                ASSERT_NE(found, channels.end()) << channel;
                expect_functions(*found->second, channel.at("functions"));
            }
        }
    }
}

} // namespace
} // namespace ghost::fixture
