// SPDX-License-Identifier: Apache-2.0
// Palettes, fan, align and hold by action: what they do to the selected heads, what can be undone, and what
// is said where nothing can be done.
#include "show_folder/load_show.h"
#include "support/must.h"
#include "support/test_desk.h"
#include "ui/actions/fan_actions.h"
#include "ui/actions/palette_list.h"
#include "ui/model/palette_values.h"
#include "ui/actions/programmer_actions.h"

#include "fixture_files/gdtf/gdtf.h"

#include <QWidget>

namespace ghost::ui {
namespace {

// Three spots instead of lamps that do nothing.
struct Spots : Desk {
    Spots() {
        add_programmer_actions(actions, app);
        add_fan_actions(actions, app);
        add_palette_actions(actions, palettes);
        open();
        turn_into_spots();
    }
    void turn_into_spots() {
        static const auto spot = std::make_shared<const fixture::Type>(
            must(fixture::load_gdtf(std::filesystem::path(GHOST_SOURCE_DIR) /
                                    "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"))
                .type);
        Opened opened = app.opened();
        auto show = std::make_shared<scene::Show>(*opened.show);
        for (scene::PatchedFixture& fixture : show->fixtures) fixture.type = spot;
        opened.show = std::move(show);
        opened.is_edit = true;
        opened.text = app.request().text;
        link.opened.put(std::move(opened));
        RigNow rig;
        for (int i = 0; i < 3; ++i) {
            FixtureNow now;
            now.light_m.x = static_cast<float>(-i);
            now.pan_deg = static_cast<float>(10 * i);
            rig.fixtures.push_back(now);
        }
        link.rig.put(std::move(rig));
        link.on_news();
        settle();
    }
    std::string error_of(const QString& line) {
        const Result<void> done = actions.run(line);
        return done.ok() ? "" : done.error().text();
    }
    std::vector<float> pans() const {
        std::vector<float> all;
        for (const auto& [index, programmer] : app.look().fixtures)
            all.push_back(programmer.pan_deg.value_or(-999));
        return all;
    }
    const fixture::Programmer& hand(std::size_t index) const { return app.look().fixtures.at(index); }

    QWidget widget;
    Actions actions{widget};
    PaletteList palettes{app, document};
};

TEST(Fan, spreads_in_the_chosen_order_as_one_step) {
    Spots spots;
    EXPECT_NE(spots.error_of("fan pan -30 30").find("no fixture is selected"), std::string::npos);
    spots.app.select_in_order({2, 0, 1});
    EXPECT_EQ(spots.error_of("fan pan -30 30"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{0, 30, -30}));
    spots.app.undo_stack().undo();
    EXPECT_TRUE(spots.app.look().is_empty());
    EXPECT_EQ(spots.error_of("fan pan -30 30 line list"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{-30, 0, 30}));
    EXPECT_EQ(spots.error_of("fan pan -30 30 line left-to-right"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{30, 0, -30}));
    EXPECT_EQ(spots.error_of("fan pan 5 20 centre list"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{-15, 5, 25}));
    EXPECT_EQ(spots.error_of("fan pan 5 20 symmetric list"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{5, 20, 5}));
    EXPECT_EQ(spots.error_of("fan Iris 0 1 line list"), "");
    const auto iris = [&](std::size_t index) { return spots.hand(index).channels.begin()->second; };
    EXPECT_EQ(iris(0), 0.0f);
    EXPECT_EQ(iris(1), 0.5f);
    EXPECT_EQ(iris(2), 1.0f);
}

TEST(Fan, between_what_the_ends_have_and_colours_too) {
    Spots spots;
    spots.app.select({0, 1, 2});
    EXPECT_EQ(spots.error_of("fan pan between list"), ""); // 0, 10, 20 as they stand
    EXPECT_EQ(spots.pans(), (std::vector<float>{0, 10, 20}));
    EXPECT_EQ(spots.error_of("fan colour #ff0000 #0000ff"), "");
    EXPECT_EQ(spots.hand(0).colour, filter_from(QColor("#ff0000")));
    EXPECT_EQ(spots.hand(2).colour, filter_from(QColor("#0000ff")));
    const glm::vec3 middle = *spots.hand(1).colour;
    EXPECT_EQ(std::max({middle.x, middle.y, middle.z}), 1.0f);
    EXPECT_GT(std::min(middle.x, middle.z), 0.4f);
}

TEST(Fan, what_cannot_be_done_is_said) {
    Spots spots;
    spots.app.select({0, 1});
    EXPECT_NE(spots.error_of("fan Iriss 0 1").find("did you mean 'Iris'"), std::string::npos);
    EXPECT_NE(spots.error_of("fan pan 0 x").find("'x' is no number of degrees"), std::string::npos);
    EXPECT_NE(spots.error_of("fan pan 0").find("needs a number of degrees"), std::string::npos);
    EXPECT_NE(spots.error_of("fan pan 0 1 round").find("none of line, symmetric and centre"),
              std::string::npos);
    EXPECT_NE(spots.error_of("fan pan 0 1 line top").find("none of selection, list and left-to-right"),
              std::string::npos);
    EXPECT_NE(spots.error_of("fan colour #f00 #00f centre").find("colours go from one"), std::string::npos);
    EXPECT_NE(spots.error_of("fan colour red blueish").find("'blueish' is no colour"), std::string::npos);
    EXPECT_NE(spots.error_of("fan colour between").find("dark"), std::string::npos);
    EXPECT_TRUE(spots.app.look().is_empty());
}

TEST(Align, all_get_the_value_of_the_first_or_the_last) {
    Spots spots;
    spots.app.select_in_order({1, 0, 2});
    EXPECT_EQ(spots.error_of("align-values first pan"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{10, 10, 10}));
    spots.app.undo_stack().undo();
    EXPECT_EQ(spots.error_of("align-values last pan"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{20, 20, 20}));
    spots.app.undo_stack().undo();
    EXPECT_NE(spots.error_of("align-values first").find("nothing of 'Lamp 2' is set by hand"),
              std::string::npos);
    spots.app.select({1});
    EXPECT_EQ(spots.error_of("tilt 33"), "");
    EXPECT_EQ(spots.error_of("parameter Iris 0.4"), "");
    spots.app.select_in_order({0, 2, 1});
    EXPECT_EQ(spots.error_of("align-values last all"), "");
    EXPECT_EQ(spots.hand(0), spots.hand(1));
    EXPECT_EQ(spots.hand(2), spots.hand(1));
    EXPECT_NE(spots.error_of("align-values middle").find("neither first nor last"), std::string::npos);
}

TEST(Hold, is_one_step_and_says_where_there_is_nothing_left_to_hold) {
    Spots spots;
    EXPECT_NE(spots.error_of("hold").find("no fixture is selected"), std::string::npos);
    spots.app.select({0, 2});
    EXPECT_EQ(spots.error_of("hold"), "");
    EXPECT_GT(spots.hand(0).channels.size(), 10u);
    EXPECT_FALSE(spots.app.look().fixtures.contains(1));
    EXPECT_NE(spots.error_of("hold").find("the hand's already"), std::string::npos);
    spots.app.undo_stack().undo();
    EXPECT_TRUE(spots.app.look().is_empty());
}

// As a look that was stored as it was seen gives them.
TEST(Levels, that_hands_hold_are_held_aligned_and_kept_as_any_other_value) {
    Spots spots;
    Look look;
    const fixture::Patch patch = spots.app.show()->fixtures[0].patch();
    look.fixtures[0].levels.assign(fixture::level_count(patch.mode_of()), 77);
    spots.app.set_look(look, "look");
    spots.app.select_in_order({0, 2});
    EXPECT_EQ(spots.error_of("palette-store position Stored"), "");
    spots.turn_into_spots(); // the edit was read
    EXPECT_EQ(spots.error_of("align-values first all"), "");
    EXPECT_GT(spots.hand(2).channels.size(), 10u);
    spots.app.undo_stack().undo();
    EXPECT_EQ(spots.error_of("hold"), "");
    EXPECT_TRUE(spots.hand(0).levels.empty());
    EXPECT_GT(spots.hand(0).channels.size(), 10u);
}

TEST(PaletteList, what_hands_set_is_kept_given_renamed_and_removed) {
    Spots spots;
    const std::string before = spots.document.text();
    spots.app.select({0, 1});
    EXPECT_NE(spots.error_of("palette-store colour Amber").find("nothing of colour is set by hand"),
              std::string::npos);
    EXPECT_EQ(spots.error_of("colour #ff8000"), "");
    EXPECT_EQ(spots.error_of("palette-store colour Amber"), "");
    ASSERT_EQ(spots.palettes.all().size(), 1u);
    EXPECT_TRUE(spots.palettes.all()[0].fixtures.empty()) << "both have the same: any head may have it";
    EXPECT_EQ(spots.error_of("fan pan -20 20"), "");
    EXPECT_EQ(spots.error_of("palette-store position Drums"), "");
    EXPECT_EQ(spots.palettes.all()[1].fixtures.size(), 2u);
    EXPECT_TRUE(spots.document.is_changed());

    EXPECT_EQ(spots.error_of("release-all"), "");
    spots.turn_into_spots();
    spots.app.select({0, 1, 2});
    EXPECT_EQ(spots.error_of("palette Drums"), "");
    EXPECT_EQ(spots.pans(), (std::vector<float>{-20, 20})) << "the third is not of it";
    EXPECT_EQ(spots.error_of("palette Amber"), "");
    EXPECT_EQ(spots.hand(2).colour, filter_from(QColor("#ff8000")));

    EXPECT_EQ(spots.error_of("palette-rename Amber \"Warm one\""), "");
    EXPECT_NE(spots.error_of("palette-rename Drums \"Warm one\"").find("another palette"), std::string::npos);
    EXPECT_NE(spots.error_of("palette Amber").find("there is no palette 'Amber'"), std::string::npos);
    EXPECT_EQ(spots.error_of("palette-remove Drums"), "");
    EXPECT_EQ(spots.palettes.all().size(), 1u);
    EXPECT_NE(spots.error_of("palette-store sound X").find("none of position, colour, beam and gobo"),
              std::string::npos);
    EXPECT_NE(spots.error_of("palette-store colour \" x\"").find("no name of a palette"), std::string::npos);
    while (spots.app.undo_stack().canUndo()) spots.app.undo_stack().undo();
    EXPECT_EQ(spots.document.text(), before);
}

TEST(PaletteList, under_a_name_that_is_there_the_values_are_others) {
    Spots spots;
    spots.app.select({0});
    EXPECT_EQ(spots.error_of("zoom 10"), "");
    EXPECT_EQ(spots.error_of("palette-store beam Tight"), "");
    EXPECT_EQ(spots.error_of("zoom 8"), "");
    EXPECT_EQ(spots.error_of("palette-store beam Tight"), "");
    ASSERT_EQ(spots.palettes.all().size(), 1u);
    EXPECT_EQ(spots.palettes.all()[0].values.zoom_deg, 8.0f);
    spots.app.undo_stack().undo();
    EXPECT_EQ(spots.palettes.all()[0].values.zoom_deg, 10.0f);
}

TEST(PaletteList, an_update_leaves_what_the_palette_has_of_other_heads) {
    Spots spots;
    spots.app.select({0, 1, 2});
    EXPECT_EQ(spots.error_of("fan pan -20 20 line list"), "");
    EXPECT_EQ(spots.error_of("palette-store position Singer"), "");
    const auto of = [&](const char* name) { return spots.palettes.all().at(0).fixtures.at(name).pan_deg; };
    const auto update = [&](std::set<std::size_t> heads, const QString& values) {
        spots.turn_into_spots(); // the edit was read
        spots.app.select(std::move(heads));
        EXPECT_EQ(spots.error_of(values), "");
        EXPECT_EQ(spots.error_of("palette-store position Singer"), "");
    };
    update({1}, "pan 5");
    EXPECT_EQ(of("Lamp 1"), -20.0f);
    EXPECT_EQ(of("Lamp 2"), 5.0f);
    EXPECT_EQ(of("Lamp 3"), 20.0f);
    EXPECT_TRUE(spots.palettes.all()[0].values.is_empty()) << "no head that it was not stored of has it";
    update({0, 1}, "pan 7");
    EXPECT_EQ(of("Lamp 1"), 7.0f);
    EXPECT_EQ(of("Lamp 3"), 20.0f);
    spots.app.set_look({}, "given back");
    update({2}, "tilt 40"); // alone
    EXPECT_EQ(of("Lamp 3"), 20.0f);
    EXPECT_EQ(spots.palettes.all()[0].fixtures.at("Lamp 3").tilt_deg, 40.0f);
    EXPECT_FALSE(spots.palettes.all()[0].fixtures.at("Lamp 2").tilt_deg);
    EXPECT_EQ(spots.app.undo_stack().undoText(), "Palette 'Singer' stored: tilt");
}

TEST(PaletteValues, of_a_colour_and_its_channels_what_was_said_last_is_meant) {
    const scene::PaletteValues amber{.colour = glm::vec3(1, 0.5f, 0)},
        cyan{.attributes = {{"ColorSub_C", 1.0f}}};
    EXPECT_EQ(merged(amber, cyan), cyan);
    EXPECT_EQ(merged(cyan, amber), amber);
    const scene::PaletteValues third{.gobo = 3, .attributes = {{"Gobo1Pos", 0.2f}}};
    EXPECT_EQ(merged(third, {.attributes = {{"Gobo1Pos", 0.5f}}}),
              (scene::PaletteValues{.gobo = 3, .attributes = {{"Gobo1Pos", 0.5f}}}));
    EXPECT_FALSE(merged(third, {.attributes = {{"Gobo1", 0.5f}}}).gobo);
}

TEST(PaletteList, one_for_any_head_stays_so_for_those_that_are_not_selected) {
    Spots spots;
    spots.app.select({0});
    EXPECT_EQ(spots.error_of("pan 10"), "");
    EXPECT_EQ(spots.error_of("palette-store position Left"), "");
    spots.turn_into_spots();
    spots.app.select({0, 1});
    EXPECT_EQ(spots.error_of("fan pan 11 12 line list"), "");
    EXPECT_EQ(spots.error_of("palette-store position Left"), "");
    EXPECT_EQ(spots.palettes.all().at(0).fixtures.size(), 2u);
    EXPECT_EQ(spots.palettes.all()[0].values.pan_deg, 10.0f);
    spots.turn_into_spots();
    EXPECT_EQ(spots.error_of("colour #ff8000"), "");
    EXPECT_EQ(spots.error_of("palette-store colour Left"), "");
    EXPECT_TRUE(spots.palettes.all()[0].fixtures.empty()) << "of another kind it is another palette";
    EXPECT_FALSE(spots.palettes.all()[0].values.pan_deg);
}

TEST(PaletteList, one_that_no_head_has_anything_of_says_so) {
    Spots spots;
    spots.app.select({0});
    EXPECT_EQ(spots.error_of("pan 10"), "");
    EXPECT_EQ(spots.error_of("palette-store position Left"), "");
    spots.follow(); // lamps again, which do not turn
    EXPECT_NE(spots.error_of("palette Left").find("no selected fixture has anything of the palette 'Left'"),
              std::string::npos);
}

} // namespace
} // namespace ghost::ui
