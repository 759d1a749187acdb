// SPDX-License-Identifier: Apache-2.0
// Looks in the window: stored, recalled, faded, undone, and never lost to a file that cannot be read.
#include "support/test_window.h"
#include "ui/model/look_fade.h"
#include "ui/model/looks.h"
#include "ui/window/window.h"

#include "disk/files.h"
#include "fixture_files/gdtf/gdtf.h"
#include "show/show.h"

#include <QTemporaryDir>

#include <fstream>

namespace ghost::ui {
namespace {

struct LookBench : Bench {
    LookBench() {
        Opened opened = four_lamps();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->folder = folder.path().toStdString();
        opened.show = show;
        link.opened.put(std::move(opened));
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    void set(std::size_t lamp, float intensity) {
        Look look = app.look();
        look.fixtures[lamp].intensity = intensity;
        app.set_look(look, "intensity");
    }
    std::filesystem::path file() const {
        return std::filesystem::path(folder.path().toStdString()) / "looks.toml";
    }
    std::string text() const {
        const auto text = read_text_file(file(), 1 << 20);
        return text.ok() ? *text : "";
    }

    QTemporaryDir folder;
    Looks looks{app};
    LookBench& read() { // the looks came after the show
        link.opened.put([&] {
            Opened again = app.opened();
            again.is_edit = again.again = false;
            return again;
        }());
        link.rig.put(four_lit());
        link.on_news();
        settle();
        return *this;
    }
};

TEST(UiLooks, what_a_browser_recalls_is_said_to_all_and_can_be_undone) {
    LookBench bench;
    bench.read();
    bench.link.looks.also_for_second(true);
    bench.set(0, 0.5f);
    ASSERT_TRUE(bench.looks.store("Verse").ok());
    auto said = bench.link.looks.take_second();
    ASSERT_TRUE(said && said->looks);
    ASSERT_EQ(said->looks->size(), 1u);
    EXPECT_EQ(said->current, "Verse");
    EXPECT_TRUE(bench.link.looks.take()) << "the engine draws small pictures of them";
    bench.set(0, 0.25f);
    EXPECT_EQ(bench.link.looks.take_second()->current, "") << "a hand has changed it";
    bench.link.look_call.put({"nowhere", -1});
    bench.link.on_news();
    settle();
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 0.25f) << "there is no such look";
    bench.link.look_call.put({"Verse", 0});
    bench.link.on_news();
    settle();
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 0.5f);
    EXPECT_EQ(bench.link.looks.take_second()->current, "Verse");
    bench.app.undo_stack().undo();
    settle();
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 0.25f);
    EXPECT_EQ(bench.link.looks.take_second()->current, "");
}

TEST(UiLooks, what_is_stored_is_recalled_by_another_window) {
    LookBench bench;
    bench.read();
    bench.set(1, 0.25f);
    ASSERT_TRUE(bench.looks.store("Verse").ok());
    EXPECT_EQ(bench.looks.current(), "Verse");
    bench.set(1, 1.0f);
    EXPECT_EQ(bench.looks.current(), "") << "something was changed since";
    bench.read();
    ASSERT_EQ(bench.looks.all().size(), 1u);
    EXPECT_TRUE(bench.app.look().is_empty());
    ASSERT_TRUE(bench.looks.recall("Verse").ok());
    EXPECT_EQ(bench.app.look().fixtures.at(1).intensity, 0.25f);
    EXPECT_NE(bench.looks.recall("Vers").error().text().find("did you mean 'Verse'"), std::string::npos);
}

TEST(UiLooks, a_file_that_cannot_be_read_is_not_taken_for_none) {
    LookBench bench;
    bench.read();
    const std::string large(scene::kMostLooksBytes + 1, '#');
    ASSERT_TRUE(write_file_atomic(bench.file(), large).ok());
    bench.set(0, 0.5f);
    EXPECT_FALSE(bench.looks.store("A").ok());
    EXPECT_EQ(std::filesystem::file_size(bench.file()), large.size()) << "another program's, and still whole";
}

TEST(UiLooks, one_that_fades_is_there_at_once_where_it_is_recalled_without_seconds) {
    LookBench bench;
    bench.read();
    bench.set(0, 0.5f);
    ASSERT_TRUE(bench.looks.store("A").ok());
    bench.app.set_look({}, "release all");
    ASSERT_TRUE(bench.looks.recall("A", 60).ok());
    ASSERT_TRUE(bench.app.fades());
    ASSERT_TRUE(bench.looks.recall("A", 60).ok());
    EXPECT_TRUE(bench.app.fades());
    ASSERT_TRUE(bench.looks.recall("A", 0).ok());
    EXPECT_FALSE(bench.app.fades());
    EXPECT_EQ(bench.app.request().look.fixtures.at(0).intensity, 0.5f);
}

TEST(UiLooks, any_sequence_of_changes_is_undone_to_the_same_bytes) {
    LookBench bench;
    bench.read();
    const std::string first = bench.text();
    bench.set(0, 0.5f);
    ASSERT_TRUE(bench.looks.store("A").ok());
    const std::string one = bench.text();
    bench.set(2, 0.75f);
    ASSERT_TRUE(bench.looks.store("B").ok());
    ASSERT_TRUE(bench.looks.set_fade("B", 4).ok());
    ASSERT_TRUE(bench.looks.rename("A", "C").ok());
    EXPECT_FALSE(bench.looks.rename("B", "C").ok());
    EXPECT_FALSE(bench.looks.rename("B", " ").ok());
    ASSERT_TRUE(bench.looks.remove("B").ok());
    const std::string last = bench.text();
    QUndoStack& undo = bench.app.undo_stack();
    for (int i = 0; i < 5; ++i) undo.undo(); // remove, rename, fade, store B, lamp 3
    EXPECT_EQ(bench.text(), one);
    undo.undo();
    EXPECT_TRUE(bench.looks.all().empty());
    while (undo.canRedo()) undo.redo();
    EXPECT_EQ(bench.text(), last);
    EXPECT_TRUE(first.empty());
}

TEST(UiLooks, a_file_with_mistakes_is_not_written_over) {
    LookBench bench;
    const std::string damaged = "[[look]]\nname = \"A\"\nsmoke = \"thick\"\n";
    ASSERT_TRUE(write_file_atomic(bench.file(), damaged).ok());
    QString said;
    QObject::connect(&bench.app, &AppModel::failed, [&](const QString& what) { said = what; });
    bench.read();
    EXPECT_TRUE(said.contains("looks.toml:3")) << said.toStdString();
    bench.set(0, 1);
    const Result<void> stored = bench.looks.store("B");
    ASSERT_FALSE(stored.ok());
    EXPECT_NE(stored.error().text().find("looks.toml:3"), std::string::npos);
    EXPECT_EQ(bench.text(), damaged);

    ASSERT_TRUE(write_file_atomic(bench.file(), std::string("[[look]]\nname = \"A\"\n")).ok());
    ASSERT_FALSE(bench.looks.store("B").ok()) << "is read again first";
    EXPECT_EQ(bench.looks.all().size(), 1u);
    EXPECT_TRUE(bench.looks.store("B").ok());
    EXPECT_EQ(bench.looks.all().size(), 2u);
}

TEST(UiLooks, more_than_can_be_read_again_is_not_written) {
    LookBench bench;
    bench.read();
    bench.set(0, 1);
    ASSERT_TRUE(bench.looks.store("A").ok());
    const std::string before = bench.text();
    Look look = bench.app.look();
    for (std::size_t lamp = 0; lamp < 4; ++lamp) look.fixtures[lamp].levels.assign(1'200'000, 200);
    bench.app.set_look(look, "levels");
    const Result<void> stored = bench.looks.store("B");
    ASSERT_FALSE(stored.ok());
    EXPECT_NE(stored.error().text().find("at most 16 are read again"), std::string::npos)
        << stored.error().text();
    EXPECT_EQ(bench.text(), before);
    EXPECT_EQ(bench.looks.all().size(), 1u);
}

TEST(UiLooks, what_another_program_wrote_is_not_written_over) {
    LookBench bench;
    bench.read();
    bench.set(0, 1);
    ASSERT_TRUE(bench.looks.store("Mine").ok());
    ASSERT_TRUE(write_file_atomic(bench.file(), std::string("[[look]]\nname = \"Theirs\"\n")).ok());
    EXPECT_FALSE(bench.looks.store("More").ok());
    ASSERT_TRUE(bench.looks.store("More").ok());
    ASSERT_EQ(bench.looks.all().size(), 2u);
    EXPECT_EQ(bench.looks.all()[0].name, "Theirs");
}

TEST(UiLooks, a_look_from_outside_is_seen_by_itself_and_is_a_step) {
    LookBench bench;
    bench.read();
    ASSERT_TRUE(write_file_atomic(bench.file(), std::string("[[look]]\nname = \"Theirs\"\n")).ok());
    for (int i = 0; i < 200 && bench.looks.all().empty(); ++i) wait_ms(25);
    ASSERT_EQ(bench.looks.all().size(), 1u);
    EXPECT_EQ(bench.looks.all()[0].name, "Theirs");
    // Another file in its place, and one that was written as it stands.
    ASSERT_TRUE(write_file_atomic(bench.file(), std::string("[[look]]\nname = \"Second\"\n")).ok());
    for (int i = 0; i < 200 && bench.looks.all()[0].name != "Second"; ++i) wait_ms(25);
    EXPECT_EQ(bench.looks.all()[0].name, "Second");
    EXPECT_EQ(bench.app.undo_stack().count(), 2);
    bench.app.undo_stack().undo();
    EXPECT_NE(bench.text().find("Theirs"), std::string::npos);
    // What is in the file and not here is not undone away.
    {
        std::ofstream file(bench.file());
        file << "[[look]]\nname = \"Third\"\n";
    }
    bench.app.undo_stack().undo();
    EXPECT_NE(bench.text().find("Third"), std::string::npos);
}

TEST(UiLooks, what_is_seen_is_stored_whole_and_hands_win) {
    LookBench bench;
    auto show = std::make_shared<scene::Show>(*bench.app.show());
    const auto spot = fixture::load_gdtf(std::filesystem::path("assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"));
    ASSERT_TRUE(spot.ok());
    for (std::size_t i = 0; i < show->fixtures.size(); ++i) {
        show->fixtures[i].type = std::make_shared<fixture::Type>(spot->type);
        show->fixtures[i].universe = 1;
        show->fixtures[i].address = static_cast<int>(1 + 50 * i);
    }
    Opened opened = bench.app.opened();
    opened.show = show;
    bench.link.opened.put(std::move(opened));
    RigNow rig = four_lit();
    auto levels = std::make_shared<dmx::Levels>();
    for (std::size_t i = 0; i < levels->size(); ++i) (*levels)[i] = static_cast<std::uint8_t>(i % 251);
    rig.universes.at(1).levels = levels;
    bench.link.rig.put(rig);
    bench.link.on_news();
    settle();
    bench.app.select({1, 2});
    bench.set(2, 0.25f);
    ASSERT_TRUE(bench.looks.store_as_it_shines("Seen").ok());
    const auto& fixtures = bench.looks.all()[0].fixtures;
    ASSERT_EQ(fixtures.size(), 2u);
    const fixture::Programmer second = fixtures.at(show->fixtures[1].name); // the list changes
    ASSERT_EQ(second.levels.size(), fixture::level_count(show->fixtures[1].patch().mode_of()));
    for (std::size_t k = 0; k < second.levels.size(); ++k) EXPECT_EQ(second.levels[k], (50 + k) % 251);
    EXPECT_FALSE(second.intensity);
    EXPECT_EQ(fixtures.at(show->fixtures[2].name).intensity, 0.25f);
    EXPECT_EQ(bench.looks.current(), "") << "hands hold something else";
    EXPECT_EQ(bench.looks.meant(), "Seen") << "of a cue that is added now";
    ASSERT_TRUE(bench.looks.rename("Seen", "Chorus").ok()) << "as its name is typed once it is there";
    EXPECT_EQ(bench.looks.meant(), "Chorus");
    bench.set(2, 0.5f);
    EXPECT_EQ(bench.looks.meant(), "");
    ASSERT_TRUE(bench.looks.recall("Chorus", 0).ok());
    EXPECT_EQ(bench.app.request().look.fixtures.at(1), second);
}

TEST(UiLooks, a_fade_goes_from_what_is_there_to_the_look_and_is_one_step) {
    LookBench bench;
    bench.read();
    bench.set(0, 1);
    ASSERT_TRUE(bench.looks.store("Full").ok());
    bench.app.set_look({}, "release");
    const int steps = bench.app.undo_stack().count();
    ASSERT_TRUE(bench.looks.recall("Full", 0.4).ok());
    EXPECT_EQ(bench.app.look().fixtures.at(0).intensity, 1.0f) << "that is what is meant";
    float before = -1;
    int between = 0;
    while (bench.app.fades()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const auto& fixtures = bench.app.request().look.fixtures;
        const float now = fixtures.at(0).intensity.value();
        EXPECT_GE(now, before);
        before = now;
        between += now > 0.05f && now < 0.95f ? 1 : 0;
    }
    EXPECT_GT(between, 1);
    EXPECT_EQ(bench.app.request().look, bench.app.look());
    EXPECT_EQ(bench.app.undo_stack().count(), steps + 1);
}

TEST(UiLooks, what_is_let_go_fades_to_what_the_desk_asks_for) {
    Look from, to;
    from.fixtures[0] = {.intensity = 1.0f, .pan_deg = 90.0f, .gobo = 3};
    from.scene.smoke = 3;
    FixtureNow now;
    now.asked = {.intensity = 0.2f, .pan_deg = 10.0f};
    const scene::Show show;
    const Look half = faded(from, to, show, {.fixtures = {now}}, 0.5f);
    EXPECT_FLOAT_EQ(*half.fixtures.at(0).intensity, 0.6f);
    EXPECT_FLOAT_EQ(*half.fixtures.at(0).pan_deg, 50.0f);
    EXPECT_FALSE(half.fixtures.at(0).gobo);
    EXPECT_FLOAT_EQ(*half.scene.smoke, 2.0f);
    EXPECT_EQ(faded(from, to, show, {.fixtures = {now}}, 1), to);
}

TEST(UiLooks, a_head_that_is_left_dark_fades_from_and_to_dark_and_not_by_its_file) {
    FixtureNow now;
    now.asked = {.intensity = 1.0f}; // by its file
    now.is_dark_without_hands = true;
    const scene::Show show;
    const auto share = [&](const Look& from, const Look& to, float at) {
        return faded(from, to, show, {.fixtures = {now}}, at).fixtures.at(0).intensity.value_or(-1);
    };
    Look half, red;
    half.fixtures[0] = {.intensity = 0.5f};
    red.fixtures[0] = {.colour = glm::vec3(1, 0, 0)};
    EXPECT_FLOAT_EQ(share({}, half, 0), 0);
    EXPECT_FLOAT_EQ(share({}, half, 0.5f), 0.25f);
    EXPECT_FLOAT_EQ(share(half, {}, 0.8f), 0.1f);
    EXPECT_FLOAT_EQ(share({}, red, 0.25f), 0) << "a colour lights nothing";
    EXPECT_FLOAT_EQ(share(half, red, 0.8f), 0.1f);
    EXPECT_EQ(faded({}, red, show, {.fixtures = {now}}, 0.25f).fixtures.at(0).colour, glm::vec3(1, 0, 0))
        << "what was dark has no colour to come from";
    EXPECT_EQ(faded(half, {}, show, {.fixtures = {now}}, 1), Look{});
}

TEST(UiLooks, what_a_hand_does_during_a_fade_is_there_at_once) {
    LookBench bench;
    bench.read();
    bench.set(0, 1);
    bench.set(1, 1);
    ASSERT_TRUE(bench.looks.store("Both").ok());
    bench.app.set_look({}, "release");
    ASSERT_TRUE(bench.looks.recall("Both", 100).ok());
    bench.set(1, 0.5f);
    ASSERT_TRUE(bench.app.fades());
    EXPECT_EQ(bench.app.request().look.fixtures.at(1).intensity, 0.5f);
    EXPECT_LT(bench.app.request().look.fixtures.at(0).intensity.value_or(1), 0.1f);
    EXPECT_FALSE(bench.app.is_settled());
}

TEST(UiLooks, solo_leaves_the_selected_ones_alone_and_is_a_step) {
    LookBench bench;
    bench.read();
    bench.set(0, 0.5f);
    Look look = bench.app.look();
    look.solo = {0};
    bench.app.set_look(look, "solo");
    EXPECT_EQ(bench.app.request().look.fixtures.at(0).intensity, 0.5f);
    for (const std::size_t dark : {1u, 2u, 3u})
        EXPECT_EQ(bench.app.request().look.fixtures.at(dark).intensity, 0.0f);
    EXPECT_EQ(bench.app.look().fixtures.size(), 1u) << "solo is not what hands set";
    bench.app.undo_stack().undo();
    EXPECT_EQ(bench.app.request().look.fixtures.size(), 1u);
}

TEST(UiLooks, exposure_set_during_a_travel_stays) {
    LookBench bench;
    bench.read();
    bench.app.travel_to(bench.app.show()->cameras[1], 100);
    bench.app.set_exposure(3, false);
    while (bench.app.travels()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    EXPECT_EQ(bench.app.camera().ev100, 3.0f);
    EXPECT_EQ(bench.app.camera().position_m, bench.app.show()->cameras[1].position_m);
}

} // namespace
} // namespace ghost::ui
