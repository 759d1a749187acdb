// SPDX-License-Identifier: Apache-2.0
// Edits of palettes as text: what was asked for is there, the rest is the same byte for byte.
#include "show/show.h"
#include "show_file/palette_edit.h"
#include "show_file/show_edit.h"
#include "show_file/show_toml.h"
#include "support/must.h"

#include <gtest/gtest.h>

namespace ghost::scene {
namespace {

const std::string kBeforePalettes = "# Club\n[[camera]]\nname = \"house\"\n";
const std::string kPalettes = R"(
# warm
[[palette]] # for the ballads
name = "Amber" # as gel 21
kind = "colour"
colour_rec2020 = [1, 0.5, 0]

[[palette]]
name = "Drums"
kind = "position"
[[palette.fixture]]
name = "Spot 1"
pan_deg = 12.5
)";
const std::string kAfterPalettes = "\n# the end\n[attenuation]\nlinear = 0.1\nquadratic = 0\n";
const std::string kPaletteText = kBeforePalettes + kPalettes + kAfterPalettes;

std::vector<Palette> palettes_in(const std::string& text) {
    Report report;
    return must(parse_show(text, "show.toml", report)).show.palettes;
}

Palette drums() {
    Palette palette;
    palette.name = "Drums";
    palette.fixtures["Spot 1"].pan_deg = -3;
    palette.fixtures["Spot 1"].attributes["PanRotate"] = 0.5f;
    palette.fixtures["Spot \"2\""].tilt_deg = 40;
    return palette;
}

TEST(PaletteEdit, a_new_one_stands_behind_the_last_and_is_read_as_it_was_kept) {
    Palette palette = drums();
    palette.name = "Singer";
    const std::string edited = must(add_palette(kPaletteText, palette));
    EXPECT_TRUE(edited.starts_with(kBeforePalettes + kPalettes + "\n[[palette]]\nname = \"Singer\"\n"))
        << edited;
    EXPECT_TRUE(edited.ends_with(kAfterPalettes));
    const std::vector<Palette> after = palettes_in(edited);
    ASSERT_EQ(after.size(), 3u);
    EXPECT_EQ(after[2].kind, PaletteKind::position);
    EXPECT_EQ(after[2].fixtures, palette.fixtures);
    EXPECT_TRUE(after[2].values.is_empty());
    EXPECT_TRUE(differ_in_fixtures_air_and_cues_only(kPaletteText, edited)) << "the show is not opened anew";
    // The first one of a show, and lines that end as the others do.
    const std::string windows = must(add_palette("[[camera]]\r\nname = \"house\"\r\n", palette));
    EXPECT_EQ(windows.find("[[palette]]\r\nname = \"Singer\"\r\n") != std::string::npos, true) << windows;
    EXPECT_EQ(palettes_in(windows).front().fixtures, palette.fixtures);
}

TEST(PaletteEdit, other_values_take_the_place_of_the_block_alone) {
    const std::string edited = must(replace_palette(kPaletteText, palettes_in(kPaletteText), 1, drums()));
    EXPECT_TRUE(edited.starts_with(kBeforePalettes +
                                   kPalettes.substr(0, kPalettes.find("[[palette]]\nname = \"Drums\""))));
    EXPECT_TRUE(edited.ends_with(kAfterPalettes));
    EXPECT_EQ(palettes_in(edited)[1].fixtures, drums().fixtures);
}

TEST(PaletteEdit, a_name_and_nothing_else_changes_and_one_goes_with_its_heads) {
    std::string expected = kPaletteText;
    expected.replace(expected.find("Amber"), 5, "Warm \\\"w\\\"");
    EXPECT_EQ(must(rename_palette(kPaletteText, palettes_in(kPaletteText), 0, "Warm \"w\"")), expected);
    const std::string removed = must(remove_palette(kPaletteText, palettes_in(kPaletteText), 1));
    EXPECT_EQ(removed.find("palette.fixture"), std::string::npos) << removed;
    EXPECT_EQ(palettes_in(removed).size(), 1u);
    EXPECT_TRUE(removed.ends_with(kAfterPalettes.substr(1)));
}

TEST(PaletteEdit, what_cannot_be_counted_is_refused) {
    const std::string damaged = "[[palette]]\nname = \"A\"\n" + kPaletteText;
    const Result<std::string> refused = remove_palette(damaged, palettes_in(damaged), 0);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().text().find("cannot be read"), std::string::npos);
    EXPECT_FALSE(remove_palette(kPaletteText, palettes_in(kPaletteText), 2).ok());
    const std::string inlined = "palette = [{ name = \"A\", kind = \"gobo\", gobo = 1 }]\n" + kBeforePalettes;
    EXPECT_FALSE(replace_palette(inlined, palettes_in(inlined), 0, drums()).ok());
}

} // namespace
} // namespace ghost::scene
