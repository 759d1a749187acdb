// SPDX-License-Identifier: Apache-2.0
// Edits of haze, wind and hazers as text: what was asked for is there, the rest is the same byte for byte,
// and what cannot be edited is refused.
#include "show/show.h"
#include "show_file/air_edit.h"
#include "show_file/show_edit.h"
#include "show_file/show_toml.h"
#include "show_folder/load_show.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

const std::string kBefore = R"(# Club
[[camera]]
name = "house"

[haze]
preset = "haze" # as on Friday
intensity = 2
)";
const std::string kHazers = R"(
# left
[[hazer]]
position_m = [-2, 0, 0.5] # behind the riser

# right
[[hazer]]
position_m = [2, 0, 0.5]
rate = 5
)";
const std::string kAfter = "\n# the end\n[attenuation]\nlinear = 0.1\nquadratic = 0\n";
const std::string kText = kBefore + kHazers + kAfter;

Show read(const std::string& text) {
    Report report;
    return must(parse_show(text, "show.toml", report)).show;
}

// text with `from` as `to`.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(AirEdit, wind_and_clouds_are_written_below_haze) {
    const auto edited = edit_haze(kText, {.unevenness = 0.5f, .wind_m_s = glm::vec3(0.25f, -1, 0)});
    ASSERT_TRUE(edited.ok()) << edited.error().text();
    EXPECT_EQ(*edited,
              with(kText, "intensity = 2\n", "intensity = 2\nunevenness = 0.5\nwind_m_s = [0.25, -1, 0]\n"));
    const HazeMedium haze = read(*edited).haze;
    EXPECT_EQ(haze.unevenness, 0.5f);
    EXPECT_EQ(haze.wind_m_s, glm::vec3(0.25f, -1, 0));
    EXPECT_FLOAT_EQ(haze.extinction_per_m, 0.045f) << "the preset stays, and its intensity";
}

TEST(AirEdit, how_thick_it_is_is_said_once) {
    const auto number = edit_haze(kText, {.extinction_per_m = 0.03f});
    ASSERT_TRUE(number.ok()) << number.error().text();
    EXPECT_FLOAT_EQ(read(*number).haze.extinction_per_m, 0.03f);
    EXPECT_EQ(number->find("preset"), std::string::npos);
    EXPECT_EQ(number->find("intensity"), std::string::npos);
    const auto preset = edit_haze(*number, {.preset = "fog"});
    ASSERT_TRUE(preset.ok()) << preset.error().text();
    EXPECT_FLOAT_EQ(read(*preset).haze.extinction_per_m, 0.18f);
    EXPECT_EQ(preset->find("extinction_per_m"), std::string::npos);
    const auto made = edit_haze("[[camera]]\nname = \"a\"\n", {.preset = "hint"});
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(*made, "[[camera]]\nname = \"a\"\n\n[haze]\npreset = \"hint\"\n");
}

TEST(AirEdit, a_hazer_is_moved_where_it_stands_and_taken_away) {
    const std::vector<Hazer> hazers = read(kText).hazers;
    ASSERT_EQ(hazers.size(), 2u);
    const auto moved = edit_hazer(kText, hazers, 0, {.position_m = glm::vec3(1, 2, 0), .reach_m = 4.0f});
    ASSERT_TRUE(moved.ok()) << moved.error().text();
    EXPECT_EQ(*moved, with(kText, "[-2, 0, 0.5] # behind the riser\n",
                           "[1, 2, 0] # behind the riser\nreach_m = 4\n"));
    const auto removed = remove_hazer(*moved, hazers, 0);
    ASSERT_TRUE(removed.ok()) << removed.error().text();
    const Show left = read(*removed);
    ASSERT_EQ(left.hazers.size(), 1u);
    EXPECT_EQ(left.hazers[0].position_m, glm::vec3(2, 0, 0.5f));
    EXPECT_EQ(left.attenuation.linear, 0.1f);
    EXPECT_NE(removed->find("# right"), std::string::npos);
}

TEST(AirEdit, hazers_are_added_up_to_the_most_there_can_be) {
    std::string text = kText;
    Hazer hazer;
    hazer.position_m = {0, 3, 0.25f};
    for (int i = 0; i < 6; ++i) {
        const auto added = add_hazer(text, hazer);
        ASSERT_TRUE(added.ok()) << added.error().text();
        text = *added;
    }
    const Show show = read(text);
    ASSERT_EQ(show.hazers.size(), 8u);
    EXPECT_EQ(show.hazers[7].position_m, hazer.position_m);
    EXPECT_EQ(show.hazers[7].rate, Hazer{}.rate);
    EXPECT_LT(text.rfind("[[hazer]]"), text.find("# the end"));
    const auto ninth = add_hazer(text, hazer);
    ASSERT_FALSE(ninth.ok());
    EXPECT_NE(ninth.error().text().find("has 8 hazers"), std::string::npos) << ninth.error().text();
}

TEST(AirEdit, where_one_could_not_be_read_none_is_changed) {
    const std::string text = with(kText, "position_m = [-2, 0, 0.5]", "position_m = \"left\"");
    const std::vector<Hazer> hazers = read(text).hazers;
    ASSERT_EQ(hazers.size(), 1u) << "the right one, which is the second of the file";
    const auto moved = edit_hazer(text, hazers, 0, {.rate = 1.0f});
    ASSERT_FALSE(moved.ok());
    EXPECT_NE(moved.error().text().find("cannot be read"), std::string::npos);
    EXPECT_FALSE(remove_hazer(text, hazers, 0).ok());
    EXPECT_FALSE(edit_hazer(kText, read(kText).hazers, 2, {.rate = 1.0f}).ok());
    const std::string odd = "hazer = [1, { position_m = [0, 0, 0] }]\n[[camera]]\nname = \"a\"\n";
    EXPECT_FALSE(edit_hazer(odd, {Hazer{}}, 0, {.rate = 1.0f}).ok());
}

TEST(AirEdit, how_light_bounces_is_written_where_it_stands_or_in_a_table_of_its_own) {
    const auto made = edit_bounce(kText, BounceDetail::normal);
    ASSERT_TRUE(made.ok()) << made.error().text();
    EXPECT_EQ(*made, kText + "\n[light]\nbounce = \"normal\"\n");
    EXPECT_EQ(read(*made).bounce, BounceDetail::normal);
    const std::string commented = with(*made, "\"normal\"", "\"normal\" # for the band");
    const auto changed = edit_bounce(commented, BounceDetail::fine);
    ASSERT_TRUE(changed.ok()) << changed.error().text();
    EXPECT_EQ(*changed, with(commented, "\"normal\"", "\"fine\""));
    EXPECT_TRUE(differ_in_fixtures_air_and_cues_only(kText, *changed));
    const auto preview = preview_edit(read(kText), *changed);
    ASSERT_TRUE(preview.ok());
    EXPECT_EQ(preview->bounce, BounceDetail::fine);
    EXPECT_FALSE(edit_bounce("light = 1\n", BounceDetail::fine).ok());
}

TEST(AirEdit, a_preview_has_the_air_and_is_quick) {
    const Show before = read(kText);
    const auto edited = edit_haze(kText, {.wind_m_s = glm::vec3(1, 0, 0)});
    const auto removed = remove_hazer(*edited, before.hazers, 1);
    ASSERT_TRUE(removed.ok());
    const auto preview = preview_edit(before, *removed);
    ASSERT_TRUE(preview.ok());
    EXPECT_EQ(preview->haze.wind_m_s, glm::vec3(1, 0, 0));
    EXPECT_EQ(preview->hazers.size(), 1u);
    EXPECT_TRUE(differ_in_fixtures_air_and_cues_only(kText, *removed));
    EXPECT_FALSE(differ_in_fixtures_air_and_cues_only(kText, with(kText, "linear = 0.1", "linear = 0.2")));
}

} // namespace
} // namespace ghost::scene
