// SPDX-License-Identifier: Apache-2.0
// Palettes as a show file has them: values of their kind, heads with their own, and what is said of mistakes.
#include "show/show.h"
#include "show_file/show_toml.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

const std::string kWithSpot = R"([show]
stage = "none.glb"
[[camera]]
name = "house"
position_m = [0, -5, 2]
target_m = [0, 0, 2]
[[fixture]]
name = "Spot 1"
gdtf = "spot.gdtf"
address = 1
position_m = [0, 0, 4]
)";

struct Read {
    explicit Read(const std::string& text) {
        show = must(parse_show(kWithSpot + text, "show.toml", report)).show;
    }
    std::string said(std::size_t index) const {
        return index < report.messages.size()
                   ? report.messages[index].where + ": " + report.messages[index].what
                   : "";
    }
    Report report;
    Show show;
};

TEST(Palettes, each_kind_has_its_values_and_heads_may_have_their_own) {
    const Read read(R"(
[[palette]]
name = "Drums"
kind = "position"
[[palette.fixture]]
name = "Spot 1"
pan_deg = 12.5
tilt_deg = -40
[[palette]]
name = "Amber"
kind = "colour"
colour_rec2020 = [1, 0.5, 0]
attributes = { Color1 = 0.25 }
[[palette]]
name = "Tight"
kind = "beam"
zoom_deg = 8
[[palette]]
name = "Leaves"
kind = "gobo"
gobo = 3
)");
    EXPECT_TRUE(read.report.messages.empty()) << read.said(0);
    const std::vector<Palette>& palettes = read.show.palettes;
    ASSERT_EQ(palettes.size(), 4u);
    EXPECT_EQ(palettes[0].kind, PaletteKind::position);
    EXPECT_TRUE(palettes[0].values.is_empty());
    EXPECT_EQ(palettes[0].fixtures.at("Spot 1").pan_deg, 12.5f);
    EXPECT_EQ(palettes[0].fixtures.at("Spot 1").tilt_deg, -40.0f);
    EXPECT_EQ(palettes[1].values.colour, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(palettes[1].values.attributes.at("Color1"), 0.25f);
    EXPECT_EQ(palettes[2].values.zoom_deg, 8.0f);
    EXPECT_EQ(palettes[3].values.gobo, 3);
    EXPECT_EQ(*find_palette(palettes, "Tight"), 2u);
    EXPECT_NE(find_palette(palettes, "Ambr").error().text().find("did you mean 'Amber'"), std::string::npos);
}

TEST(Palettes, mistakes_are_said_with_their_lines_and_the_rest_is_kept) {
    Read read(R"(
[[palette]]
name = "A"
kind = "colours"
[[palette]]
kind = "beam"
[[palette]]
name = "B"
kind = "beam"
pan_deg = 4
zoom_deg = 181
attributes = { Iris = 2, Focus1 = 0.5 }
[[palette]]
name = "B"
kind = "gobo"
gobo = 1
[[palette]]
name = "C"
kind = "position"
[[palette.fixture]]
name = "Spot 9"
pan_deg = 1
)");
    ASSERT_EQ(read.show.palettes.size(), 2u);
    EXPECT_EQ(read.show.palettes[0].name, "B");
    EXPECT_EQ(read.show.palettes[0].values.attributes.size(), 1u);
    ASSERT_EQ(read.report.messages.size(), 6u);
    EXPECT_NE(read.said(0).find("show.toml:15: [[palette]] kind is 'colours', expected position, colour"),
              std::string::npos)
        << read.said(0);
    EXPECT_NE(read.said(1).find("show.toml:16: [[palette]] name is missing"), std::string::npos)
        << read.said(1);
    EXPECT_NE(read.said(2).find("zoom_deg"), std::string::npos) << read.said(2);
    EXPECT_NE(read.said(3).find("[[palette]] attributes Iris"), std::string::npos) << read.said(3);
    EXPECT_NE(read.said(4).find("unknown key 'pan_deg'"), std::string::npos) << read.said(4);
    EXPECT_NE(read.said(5).find("is that of another palette"), std::string::npos) << read.said(5);
    check_palettes(read.show, read.report);
    ASSERT_EQ(read.report.messages.size(), 7u);
    EXPECT_NE(read.said(6).find("'C' has values for fixtures that the show does not have: 'Spot 9'"),
              std::string::npos)
        << read.said(6);
}

TEST(Palettes, too_many_are_left_out_and_said) {
    std::string text;
    for (int i = 0; i < 1001; ++i)
        text += "[[palette]]\nname = \"" + std::to_string(i) + "\"\nkind = \"gobo\"\ngobo = 1\n";
    const Read read(text);
    EXPECT_EQ(read.show.palettes.size(), 1000u);
    ASSERT_EQ(read.report.messages.size(), 1u);
    EXPECT_NE(read.said(0).find("more than 1000 entries"), std::string::npos) << read.said(0);
}

} // namespace
} // namespace ghost::scene
