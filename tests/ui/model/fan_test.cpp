// SPDX-License-Identifier: Apache-2.0
// Values of several heads: spread over them in an order, held, and as palettes keep them.
#include "support/must.h"
#include "support/test_window.h"
#include "ui/model/fan.h"
#include "ui/model/head_values.h"
#include "ui/model/palette_values.h"

#include "fixture_files/gdtf/gdtf.h"

namespace ghost::ui {
namespace {

std::vector<float> values(Fan fan, float a, float b, std::size_t count) {
    std::vector<float> all;
    for (std::size_t k = 0; k < count; ++k) all.push_back(fanned(fan, a, b, k, count));
    return all;
}

TEST(Fan, goes_from_the_first_to_the_last) {
    EXPECT_EQ(values(Fan::line, -30, 30, 5), (std::vector<float>{-30, -15, 0, 15, 30}));
    EXPECT_EQ(values(Fan::line, 10, 4, 2), (std::vector<float>{10, 4}));
    EXPECT_EQ(values(Fan::line, 10, 4, 1), (std::vector<float>{10}));
}

TEST(Fan, is_the_same_on_both_sides_and_an_even_number_has_two_in_the_middle) {
    EXPECT_EQ(values(Fan::symmetric, 0, 20, 5), (std::vector<float>{0, 10, 20, 10, 0}));
    EXPECT_EQ(values(Fan::symmetric, 0, 20, 6), (std::vector<float>{0, 10, 20, 20, 10, 0}));
    EXPECT_EQ(values(Fan::symmetric, 3, 20, 2), (std::vector<float>{3, 3}));
    EXPECT_EQ(values(Fan::symmetric, 3, 20, 1), (std::vector<float>{3}));
}

TEST(Fan, opens_from_the_centre_to_both_sides) {
    EXPECT_EQ(values(Fan::centre, 10, 40, 5), (std::vector<float>{-30, -10, 10, 30, 50}));
    EXPECT_EQ(values(Fan::centre, 10, 40, 2), (std::vector<float>{-30, 50}));
    EXPECT_EQ(values(Fan::centre, 10, 40, 1), (std::vector<float>{10}));
    EXPECT_EQ(fanned(Fan::line, glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), 1, 3), glm::vec3(0.5f, 0, 0.5f));
}

TEST(Fan, heads_go_by_the_order_in_which_they_were_selected_by_the_list_or_from_left_to_right) {
    Bench bench;
    bench.open();
    RigNow rig = four_lit();
    std::swap(rig.fixtures[0].light_m.x, rig.fixtures[2].light_m.x);
    bench.link.rig.put(std::move(rig));
    bench.link.on_news();
    settle();
    AppModel& app = bench.app;
    app.select({3});
    app.select({3, 0});
    app.select({3, 0, 1, 2}); // these two at once
    using Heads = std::vector<std::size_t>;
    EXPECT_EQ(heads_in(HeadOrder::selection, app), (Heads{3, 0, 1, 2}));
    EXPECT_EQ(app.current(), 3u) << "the one that was selected first";
    EXPECT_EQ(heads_in(HeadOrder::list, app), (Heads{0, 1, 2, 3}));
    EXPECT_EQ(heads_in(HeadOrder::left_to_right, app), (Heads{2, 1, 0, 3}));
    app.select({0, 1, 2});
    EXPECT_EQ(app.selected_in_order(), (Heads{0, 1, 2}));
    app.select_in_order({2, 7, 0});
    EXPECT_EQ(app.selected_in_order(), (Heads{2, 0})) << "the show has four";
    EXPECT_EQ(app.selection(), (std::set<std::size_t>{0, 2}));
}

struct Spots {
    Spots() {
        Opened opened = four_lamps();
        show = *opened.show;
        const fixture::LoadedType spot = must(fixture::load_gdtf(
            std::filesystem::path(GHOST_SOURCE_DIR) / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
        for (scene::PatchedFixture& fixture : show.fixtures)
            fixture.type = std::make_shared<fixture::Type>(spot.type);
        std::vector<std::uint8_t> bytes(512);
        for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(7 * i + 3);
        levels.set(1, bytes);
    }
    fixture::Patch patch() const { return show.fixtures[0].patch(); }

    scene::Show show;
    fixture::Levels levels;
};

TEST(Hold, the_hand_has_to_the_byte_what_the_desk_sent_and_the_desk_may_go) {
    const Spots spots;
    fixture::Programmer programmer;
    hold(spots.show.fixtures[0], spots.levels, programmer);
    EXPECT_EQ(fixture::levels_by_hand(programmer, spots.patch(), {}),
              fixture::levels_of(spots.patch(), spots.levels));
    EXPECT_TRUE(holds(spots.show.fixtures[0], fixture::Role::pan, programmer));
    give_back(spots.show.fixtures[0], fixture::Role::pan, programmer);
    EXPECT_FALSE(holds(spots.show.fixtures[0], fixture::Role::pan, programmer));
    EXPECT_TRUE(holds(spots.show.fixtures[0], fixture::Role::tilt, programmer));
    // A light by hand opened its shutter: what the desk says of it does not come back.
    fixture::Programmer lit;
    lit.intensity = 0.8f;
    hold(spots.show.fixtures[0], {}, lit);
    EXPECT_EQ(lit.intensity, 0.8f);
    EXPECT_FALSE(holds(spots.show.fixtures[0], fixture::Role::dimmer, lit));
    auto targets = fixture::decode_levels(spots.patch(), fixture::levels_by_hand(lit, spots.patch(), {}));
    fixture::apply(lit, spots.patch(), targets);
    EXPECT_EQ(targets.beams.front().dimmer * targets.beams.front().shutter, 0.8f);
}

// Of a look that was stored as it was seen.
TEST(Hold, what_levels_by_hand_have_is_taken_in_single_channels_and_makes_palettes) {
    const Spots spots;
    const scene::PatchedFixture& spot = spots.show.fixtures[0];
    fixture::Programmer stored;
    stored.levels = fixture::levels_of(spots.patch(), spots.levels);
    const scene::PaletteValues position = palette_values_of(scene::PaletteKind::position, spot, stored);
    EXPECT_FALSE(position.is_empty());
    fixture::Programmer held = stored;
    hold(spot, {}, held);
    EXPECT_TRUE(held.levels.empty());
    EXPECT_TRUE(holds(spot, fixture::Role::pan, held));
    EXPECT_EQ(fixture::levels_by_hand(held, spots.patch(), {}), stored.levels) << "to the byte";
    fixture::Programmer given;
    EXPECT_TRUE(give_values(position, spot, given));
    EXPECT_TRUE(holds(spot, fixture::Role::pan, given));
}

TEST(HeadValues, what_was_asked_for_last_wins_and_nothing_goes_farther_than_the_head) {
    const Spots spots;
    const scene::PatchedFixture& spot = spots.show.fixtures[0];
    fixture::Programmer programmer;
    set_value(spot, "pan", 5000.0f, programmer);
    const fixture::AxisRange reach = *fixture::reach_of(spots.patch(), fixture::Role::pan);
    EXPECT_EQ(programmer.pan_deg, reach.high);
    set_value(spot, "Pan", 0.25f, programmer);
    EXPECT_FALSE(programmer.pan_deg) << "it stood above the channel";
    set_value(spot, "intensity", 1.5f, programmer);
    EXPECT_EQ(programmer.intensity, 1.0f);
    set_value(spot, "colour", 0.5f, programmer);
    EXPECT_FALSE(programmer.colour) << "a number is no colour";
    EXPECT_FALSE(has_value(spot, "Laser"));
    EXPECT_TRUE(has_value(spot, "Iris"));
    const scene::PatchedFixture lamp = four_lamps().show->fixtures[0]; // no type: nothing turns
    EXPECT_FALSE(has_value(lamp, "pan"));
}

TEST(PaletteValues, are_those_of_their_kind_and_come_back_as_they_were) {
    const Spots spots;
    const scene::PatchedFixture& spot = spots.show.fixtures[0];
    fixture::Programmer before;
    before.pan_deg = 20;
    before.tilt_deg = -30;
    before.zoom_deg = 15;
    before.colour = glm::vec3(1, 0.25f, 0);
    before.gobo = 2;
    before.intensity = 1;
    set_value(spot, "Iris", 0.5f, before);
    fixture::Programmer after;
    for (const auto kind : {scene::PaletteKind::position, scene::PaletteKind::colour,
                            scene::PaletteKind::beam, scene::PaletteKind::gobo})
        EXPECT_TRUE(give_values(palette_values_of(kind, spot, before), spot, after));
    before.intensity.reset(); // of no palette
    EXPECT_EQ(after, before);
    const scene::PaletteValues beam = palette_values_of(scene::PaletteKind::beam, spot, before);
    EXPECT_EQ(beam.attributes.size(), 1u);
    EXPECT_FALSE(beam.pan_deg || beam.colour || beam.gobo);
    scene::PaletteValues turns;
    turns.pan_deg = 10;
    fixture::Programmer lamp;
    EXPECT_FALSE(give_values(turns, four_lamps().show->fixtures[0], lamp)) << "it does not turn";
    EXPECT_TRUE(lamp.is_empty());
}

} // namespace
} // namespace ghost::ui
