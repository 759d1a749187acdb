// SPDX-License-Identifier: Apache-2.0
// The show as it is edited in the window: every edit is a step that comes back byte for byte, what is not
// saved outlives the window, and nobody's file is written over.
#include "support/test_desk.h"

#include "ui/actions/patch_actions.h"

#include <random>

#include <fstream>

namespace ghost::ui {
namespace {

TEST(Patch, addresses_follow_one_behind_the_other) {
    Desk desk;
    desk.open();
    desk.app.select({0, 1, 2});
    ASSERT_TRUE(desk.edit.set_address({2, 481}).ok());
    desk.follow();
    const std::vector<std::pair<int, int>> expected{{2, 481}, {2, 497}, {3, 1}};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(std::pair(desk.fixture(i).universe, desk.fixture(i).address), expected[i]) << i;
    EXPECT_TRUE(desk.document.is_changed());
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
    EXPECT_FALSE(desk.document.is_changed());
}

TEST(Patch, copies_get_room_names_and_the_selection) {
    Desk desk;
    desk.open();
    desk.app.select({0, 1});
    desk.app.set_look(
        [&] {
            Look look;
            look.fixtures[2].intensity = 0.5f;
            return look;
        }(),
        "by hand");
    ASSERT_TRUE(desk.edit.duplicate({0, 2, 0}).ok());
    desk.follow();
    ASSERT_EQ(desk.app.show()->fixtures.size(), 5u);
    EXPECT_EQ(desk.fixture(1).name, "Lamp 4");
    EXPECT_EQ(desk.fixture(3).name, "Lamp 5");
    EXPECT_EQ(desk.fixture(1).address, 49) << "behind all that is patched";
    EXPECT_EQ(desk.fixture(3).address, 65);
    EXPECT_EQ(desk.fixture(3).position_m, glm::vec3(-1, 3, 4));
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{1, 3}));
    ASSERT_TRUE(desk.app.look().fixtures.contains(4)) << "Lamp 3 is number 5 now";
    ASSERT_TRUE(desk.edit.remove().ok());
    desk.follow();
    EXPECT_EQ(desk.document.text(), kShow);
    EXPECT_TRUE(desk.app.look().fixtures.contains(2));
    EXPECT_TRUE(desk.app.selection().empty());
}

TEST(Patch, places_are_aligned_and_spread) {
    Desk desk;
    desk.open();
    desk.app.select({0, 1, 2});
    ASSERT_TRUE(desk.edit.align(1).ok());
    desk.follow();
    EXPECT_EQ(desk.fixture(1).position_m, glm::vec3(-1, 0, 4));
    ASSERT_TRUE(desk.edit.distribute().ok());
    desk.follow();
    EXPECT_EQ(desk.fixture(1).position_m, glm::vec3(0, 0, 4));
    desk.app.select({0, 1});
    EXPECT_FALSE(desk.edit.distribute().ok());
}

TEST(Patch, what_cannot_be_done_is_said_and_not_done) {
    Desk desk;
    EXPECT_FALSE(desk.edit.remove().ok()) << "no show";
    desk.open();
    EXPECT_FALSE(desk.edit.remove().ok()) << "nothing selected";
    desk.app.select({0});
    EXPECT_FALSE(desk.edit.set_mode("Stndard").ok());
    EXPECT_FALSE(desk.edit.rename("Lamp 2").ok());
    EXPECT_FALSE(desk.edit.rename("a/b").ok());
    EXPECT_FALSE(desk.edit.add("nothing.gdtf", at(0, 0, 0)).ok());
    EXPECT_FALSE(address_of("0.1").ok());
    EXPECT_FALSE(address_of("1.513").ok());
    EXPECT_FALSE(address_of("1.2.3").ok());
    EXPECT_EQ(desk.document.text(), kShow);
    EXPECT_FALSE(desk.app.undo_stack().canUndo());
}

// Zeros of a desk that does not know it would turn it to its stops.
TEST(Patch, a_new_one_gets_an_address_in_a_universe_that_nobody_sends) {
    Desk desk;
    desk.open();
    const fs::path file = fs::path(GHOST_SOURCE_DIR) / "assets/fixtures/Vari-Lite@VL2500_Spot.gdtf";
    ASSERT_TRUE(desk.edit.add(file, at(1, 2, 5)).ok());
    desk.follow();
    EXPECT_EQ(std::pair(desk.fixture(3).universe, desk.fixture(3).address), std::pair(1, 49))
        << "none is sent";
    desk.app.undo_stack().undo();
    desk.follow();
    RigNow rig;
    rig.universes.at(1);
    rig.universes.at(2);
    desk.link.rig.put(std::move(rig));
    desk.link.on_news();
    settle();
    ASSERT_TRUE(desk.edit.add(file, at(1, 2, 5)).ok());
    desk.follow();
    EXPECT_EQ(std::pair(desk.fixture(3).universe, desk.fixture(3).address), std::pair(3, 1));
    EXPECT_EQ(desk.fixture(3).position_m, glm::vec3(1, 2, 5));
}

TEST(Patch, a_model_becomes_the_stage_and_a_plot_the_plot) {
    Desk desk;
    QTemporaryDir elsewhere;
    const fs::path model = fs::path(elsewhere.path().toStdString()) / "club.glb",
                   plot = fs::path(elsewhere.path().toStdString()) / "tour.mvr";
    ASSERT_TRUE(write_file_atomic(model, std::string("a model")).ok());
    ASSERT_TRUE(write_file_atomic(plot, std::string("a plot")).ok());
    EXPECT_FALSE(desk.edit.set_stage(model).ok()) << "no show";
    desk.open();
    EXPECT_FALSE(desk.edit.set_stage(model.string() + "x").ok());
    ASSERT_TRUE(desk.edit.set_stage(model).ok());
    EXPECT_NE(desk.document.text().find("stage = \"club.glb\" # not opened here"), std::string::npos);
    EXPECT_EQ(*read_text_file(fs::path(desk.folder) / "club.glb", 100), "a model");
    ASSERT_TRUE(desk.edit.set_plot(plot).ok());
    EXPECT_NE(desk.document.text().find("plot = \"tour.mvr\""), std::string::npos);
    desk.app.undo_stack().undo();
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
    // What lies there is not written over.
    ASSERT_TRUE(write_file_atomic(model, std::string("another model")).ok());
    EXPECT_FALSE(desk.edit.set_stage(model).ok());
    EXPECT_EQ(*read_text_file(fs::path(desk.folder) / "club.glb", 100), "a model");
}

// Done by the window as soon as it does anything.
template <class F>
void meanwhile(Desk& desk, F f) {
    QMetaObject::invokeMethod(&desk.app, std::move(f), Qt::QueuedConnection);
}

TEST(Patch, the_window_goes_on_while_a_file_is_read_and_copied) {
    Desk desk;
    desk.open();
    QTemporaryDir elsewhere;
    const fs::path model = fs::path(elsewhere.path().toStdString()) / "club.glb";
    ASSERT_TRUE(write_file_atomic(model, std::string("a model")).ok());
    bool goes_on = false;
    meanwhile(desk, [&] { goes_on = true; });
    ASSERT_TRUE(desk.edit.add_model(model, {0, 0, 0}).ok());
    EXPECT_TRUE(goes_on);
    const fs::path lamp = fs::path(GHOST_SOURCE_DIR) / "assets/fixtures/Ghostlight@LED_Par.gdtf";
    // What is done meanwhile stays.
    meanwhile(desk, [&] {
        desk.app.select({0});
        EXPECT_TRUE(desk.edit.rename("Front").ok());
    });
    std::shared_ptr<const fixture::Type> made;
    ASSERT_TRUE(desk.edit
                    .add(lamp,
                         [&](const scene::PatchedFixture& one) {
                             made = one.type;
                             return glm::vec3(0, 0, 5);
                         })
                    .ok());
    EXPECT_EQ(desk.fixture(0).name, "Front");
    EXPECT_EQ(desk.fixture(3).type, made) << "it is not read once more to be shown";
    desk.app.undo_stack().undo();
    desk.app.undo_stack().redo();
    EXPECT_EQ(desk.fixture(3).type, made);
}

TEST(Patch, a_file_that_was_for_another_show_is_none_of_this_one) {
    Desk desk;
    desk.open();
    const fs::path lamp = fs::path(GHOST_SOURCE_DIR) / "assets/fixtures/Ghostlight@LED_Par.gdtf";
    const fs::path second = fs::path(desk.folder) / "second.toml";
    ASSERT_TRUE(write_file_atomic(second, kShow).ok());
    meanwhile(desk, [&] {
        Opened opened = desk.app.opened();
        auto show = std::make_shared<scene::Show>(*opened.show);
        show->file = second;
        opened.show = std::move(show);
        desk.link.opened.put(std::move(opened));
        desk.link.on_news();
        settle();
    });
    const Result<void> done = desk.edit.add(lamp, at(0, 0, 5));
    ASSERT_FALSE(done.ok());
    EXPECT_NE(done.error().text().find("another show was opened meanwhile"), std::string::npos);
    EXPECT_EQ(desk.app.show()->fixtures.size(), 3u);
    EXPECT_EQ(desk.document.text(), kShow);
}

TEST(Patch, the_picture_as_it_is_seen_becomes_a_camera) {
    Desk desk;
    desk.open();
    scene::Camera camera = desk.app.camera();
    camera.position_m = {1, -7, 3};
    desk.app.set_camera(camera);
    ASSERT_TRUE(desk.edit.keep_camera("").ok());
    EXPECT_NE(desk.document.text().find("name = \"Camera 2\"\nposition_m = [1, -7, 3]"), std::string::npos)
        << desk.document.text();
    ASSERT_TRUE(desk.edit.keep_camera("").ok()); // before the show was opened anew with the first
    EXPECT_NE(desk.document.text().find("name = \"Camera 3\""), std::string::npos) << desk.document.text();
    desk.app.undo_stack().undo();
    desk.follow();
    EXPECT_EQ(desk.app.show()->cameras.size(), 2u);
    EXPECT_FALSE(desk.edit.keep_camera("front").ok());
    EXPECT_FALSE(desk.edit.keep_camera("a/b").ok());
    desk.app.undo_stack().undo();
    EXPECT_EQ(desk.document.text(), kShow);
}

// So that it shows the same when it is called, in a window of any shape.
TEST(Patch, a_kept_camera_has_the_frame_that_was_seen) {
    Desk desk;
    desk.open();
    desk.app.set_size(800, 450);
    ASSERT_TRUE(desk.edit.keep_camera("free").ok());
    desk.follow();
    const auto size_of_last = [&] {
        const scene::Camera& last = desk.app.show()->cameras.back();
        return glm::ivec2(last.width, last.height);
    };
    EXPECT_EQ(size_of_last(), glm::ivec2(800, 450)) << "without a frame all of the view is seen";
    scene::Camera house = desk.app.camera();
    house.fov_y_deg = 23.4f;
    house.width = 1024;
    house.height = 300;
    desk.app.cut_to(house);
    ASSERT_TRUE(desk.edit.keep_camera("wide").ok());
    desk.follow();
    EXPECT_EQ(size_of_last(), glm::ivec2(1024, 300));
    EXPECT_EQ(desk.app.show()->cameras.back().fov_y_deg, 23.4f);
    desk.app.cut_to(desk.app.show()->cameras.back());
    EXPECT_EQ(desk.app.request().frame, glm::ivec2(1024, 300));
    // Where a mover carries it, the kept one stands where that has it now.
    house.mover = 0;
    desk.app.cut_to(house);
    Picture picture;
    picture.image = std::make_shared<image::Image8>(8, 8, 4);
    picture.camera = house;
    picture.camera.position_m = {0, -9, 7};
    desk.link.picture.put(std::move(picture));
    desk.link.on_news();
    settle();
    ASSERT_TRUE(desk.edit.keep_camera("on the crane").ok());
    desk.follow();
    EXPECT_EQ(desk.app.show()->cameras.back().position_m, glm::vec3(0, -9, 7));
}

TEST(Patch, any_sequence_comes_back_to_the_same_bytes) {
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
        Desk desk;
        desk.open();
        std::vector<std::string> texts{desk.document.text()};
        for (int step = 0; step < 25; ++step) {
            const std::size_t count = desk.app.show()->fixtures.size();
            std::set<std::size_t> chosen;
            for (std::size_t i = 0; i < count; ++i)
                if (random() % 2) chosen.insert(i);
            desk.app.select(chosen);
            switch (random() % 6) {
            case 0:
                (void)desk.edit.set_address(
                    {1 + static_cast<int>(random() % 4), 1 + static_cast<int>(random() % 400)});
                break;
            case 1:
                (void)desk.edit.move_by({0.25f, 0, -1});
                break;
            case 2:
                if (count < 20) (void)desk.edit.duplicate({1, 0, 0});
                break;
            case 3:
                if (chosen.size() < count) (void)desk.edit.remove();
                break;
            case 4:
                (void)desk.edit.rename("Name");
                break;
            default:
                (void)desk.edit.set_mode(random() % 2 ? "Short" : "Standard");
            }
            desk.follow();
            if (desk.document.text() != texts.back()) texts.push_back(desk.document.text());
        }
        QUndoStack& stack = desk.app.undo_stack();
        ASSERT_EQ(static_cast<std::size_t>(stack.count()) + 1, texts.size());
        for (std::size_t i = texts.size() - 1; i > 0; --i) {
            ASSERT_EQ(desk.document.text(), texts[i]);
            stack.undo();
        }
        ASSERT_EQ(desk.document.text(), kShow);
        while (stack.canRedo()) stack.redo();
        ASSERT_EQ(desk.document.text(), texts.back());
    }
}

TEST(Patch, what_is_not_saved_waits_for_the_next_window) {
    QTemporaryDir place;
    std::string edited;
    {
        Desk desk(place.path().toStdString());
        desk.open();
        desk.app.select({1});
        ASSERT_TRUE(desk.edit.rename("Changed").ok());
        edited = desk.document.text();
    } // closed
    Desk desk(place.path().toStdString());
    EXPECT_EQ(desk.on_disk(), kShow);
    desk.open();
    EXPECT_TRUE(desk.document.has_draft());
    EXPECT_FALSE(desk.draft.isEmpty());
    desk.app.select({0});
    EXPECT_FALSE(desk.edit.rename("Too early").ok()) << "it would write over what waits";
    ASSERT_TRUE(desk.document.take_draft().ok());
    EXPECT_EQ(desk.document.text(), edited);
    desk.follow();
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_EQ(desk.on_disk(), edited);
    EXPECT_FALSE(fs::exists(fs::path(desk.folder) / ".ghost" / "draft.toml"));
}

// Half a second is not over when another show is opened in the same window.
TEST(Patch, another_show_does_not_cost_what_was_typed_just_before) {
    Desk desk;
    desk.open();
    desk.app.select({1});
    ASSERT_TRUE(desk.edit.rename("Typed just now").ok());
    QTemporaryDir elsewhere;
    const fs::path other = fs::path(elsewhere.path().toStdString()) / "show.toml", first = desk.file;
    ASSERT_TRUE(write_file_atomic(other, kShow).ok());
    desk.file = other;
    desk.app.open(other.string());
    desk.open();
    EXPECT_EQ(desk.document.text(), kShow);
    EXPECT_FALSE(fs::exists(other.parent_path() / ".ghost" / "draft.toml"));
    desk.file = first;
    desk.app.open(first.string());
    desk.open();
    EXPECT_TRUE(desk.document.has_draft());
    ASSERT_TRUE(desk.document.take_draft().ok());
    EXPECT_NE(desk.document.text().find("Typed just now"), std::string::npos);
}

TEST(Patch, a_show_that_is_renamed_is_said_and_not_made_again) {
    QTemporaryDir place;
    const fs::path folder = fs::path(place.path().toStdString()) / "show",
                   renamed = fs::path(place.path().toStdString()) / "renamed";
    fs::create_directory(folder);
    Desk desk(folder.string());
    desk.open();
    QString said;
    QObject::connect(&desk.document, &ShowDocument::found_gone, [&](const QString& words) { said = words; });
    fs::rename(folder, renamed);
    wait_ms(3200);
    EXPECT_TRUE(said.contains("The show folder is gone")) << said.toStdString();
    EXPECT_TRUE(desk.document.waits_for_answer());
    desk.app.select({1});
    ASSERT_TRUE(desk.edit.rename("Changed").ok());
    wait_ms(700);
    EXPECT_FALSE(desk.document.save(false).ok());
    EXPECT_FALSE(fs::exists(folder)) << "another one in its place";
    fs::rename(renamed, folder);
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_EQ(desk.on_disk(), desk.document.text());
    EXPECT_FALSE(desk.document.waits_for_answer());
    // The file alone: saving writes it again.
    said.clear();
    fs::remove(desk.file);
    wait_ms(3200);
    EXPECT_TRUE(said.contains("The show file is gone")) << said.toStdString();
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_EQ(desk.on_disk(), desk.document.text());
    EXPECT_FALSE(desk.document.waits_for_answer());
}

TEST(Patch, a_copy_goes_elsewhere_and_the_show_stays_unsaved) {
    Desk desk;
    desk.open();
    desk.app.select({1});
    ASSERT_TRUE(desk.edit.rename("Mine").ok());
    QTemporaryDir elsewhere;
    const fs::path copy = fs::path(elsewhere.path().toStdString()) / "show.toml";
    ASSERT_TRUE(desk.document.save_copy(copy).ok());
    EXPECT_EQ(*read_text_file(copy, 1 << 20), desk.document.text());
    EXPECT_EQ(desk.on_disk(), kShow);
    EXPECT_TRUE(desk.document.is_changed());
    EXPECT_FALSE(desk.document.save_copy(desk.file).ok()) << "that is what saving is for";
    EXPECT_FALSE(desk.document.save_copy(copy.parent_path() / "nowhere" / "show.toml").ok());
}

TEST(Patch, dropped_changes_are_gone) {
    QTemporaryDir place;
    {
        Desk desk(place.path().toStdString());
        desk.open();
        desk.app.select({1});
        ASSERT_TRUE(desk.edit.rename("Changed").ok());
    }
    {
        Desk desk(place.path().toStdString());
        desk.open();
        ASSERT_TRUE(desk.document.drop_draft().ok());
        EXPECT_EQ(desk.document.text(), kShow);
    }
    Desk desk(place.path().toStdString());
    desk.open();
    EXPECT_FALSE(desk.document.has_draft());
}

TEST(Patch, a_file_that_others_change_is_followed_and_never_written_over) {
    Desk desk;
    desk.open();
    const std::string by_hand = kShow + "[haze]\npreset = \"fog\"\n";
    ASSERT_TRUE(write_file_atomic(desk.file, by_hand).ok());
    for (int i = 0; i < 100 && desk.document.text() != by_hand; ++i) wait_ms(20);
    ASSERT_EQ(desk.document.text(), by_hand) << "nothing was unsaved, so it is taken";
    desk.follow();
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.rename("Mine").ok());
    ASSERT_TRUE(write_file_atomic(desk.file, kShow).ok());
    const auto refused = desk.document.save(false);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(desk.on_disk(), kShow);
    ASSERT_TRUE(desk.document.save(true).ok());
    EXPECT_NE(desk.on_disk().find("Mine"), std::string::npos);
    EXPECT_NE(desk.on_disk().find("fog"), std::string::npos);
}

TEST(Patch, what_is_written_by_hand_and_wrong_is_not_written_over_and_taken_once_it_is_right) {
    Desk desk;
    desk.open();
    QString said;
    QObject::connect(&desk.document, &ShowDocument::found_changed_outside,
                     [&](const QString& words) { said = words; });
    const std::string broken = kShow + "broken = [\n";
    ASSERT_TRUE(write_file_atomic(desk.file, broken).ok());
    for (int i = 0; i < 100 && said.isEmpty(); ++i) wait_ms(20);
    EXPECT_TRUE(said.contains("cannot be taken")) << said.toStdString();
    EXPECT_FALSE(said.contains("not saved"));
    EXPECT_FALSE(desk.document.is_changed()) << "nothing was changed here";
    EXPECT_FALSE(desk.document.save(false).ok());
    EXPECT_EQ(desk.on_disk(), broken);
    const std::string mended = kShow + "[haze]\npreset = \"fog\"\n";
    ASSERT_TRUE(write_file_atomic(desk.file, mended).ok());
    for (int i = 0; i < 100 && desk.document.text() != mended; ++i) wait_ms(20);
    EXPECT_EQ(desk.document.text(), mended);
    EXPECT_FALSE(desk.document.is_changed_outside());
}

TEST(Patch, an_editor_that_takes_the_file_away_first_is_followed) {
    Desk desk;
    desk.open();
    for (const char* preset : {"fog", "light haze"}) {
        const std::string by_hand = kShow + "[haze]\npreset = \"" + preset + "\"\n";
        fs::rename(desk.file, fs::path(desk.file).concat("~"));
        wait_ms(100);
        std::ofstream(desk.file) << by_hand;
        for (int i = 0; i < 100 && desk.document.text() != by_hand; ++i) wait_ms(20);
        EXPECT_EQ(desk.document.text(), by_hand);
        desk.follow();
    }
}

TEST(Patch, where_nothing_can_be_written_it_is_said) {
    Desk desk;
    desk.open();
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.rename("Mine").ok());
    fs::remove(desk.file);
    fs::create_directory(desk.file); // as good as a full disk, also for root
    EXPECT_FALSE(desk.document.save(true).ok());
    EXPECT_TRUE(desk.document.is_changed());
    wait_ms(700);
    EXPECT_TRUE(fs::exists(fs::path(desk.folder) / ".ghost" / "draft.toml"));
}

// A file where a folder is wanted is what a full disk is, for a test that runs as root.
TEST(ShowDocument, where_its_disk_takes_no_draft_another_place_has_it) {
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    const QTemporaryDir place;
    {
        Desk desk(place.path().toStdString());
        ASSERT_TRUE(write_file_atomic(fs::path(desk.folder) / ".ghost", "full").ok());
        desk.open();
        desk.app.select({0});
        ASSERT_TRUE(desk.edit.set_address({2, 101}).ok());
        EXPECT_TRUE(desk.document.keep().ok());
        EXPECT_FALSE(desk.document.waits_for_answer());
    }
    Desk desk(place.path().toStdString());
    desk.open();
    ASSERT_TRUE(desk.document.has_draft());
    ASSERT_TRUE(desk.document.take_draft().ok());
    EXPECT_NE(desk.document.text().find("101"), std::string::npos);
    ASSERT_TRUE(desk.document.save(false).ok());
    EXPECT_TRUE(fs::is_empty(fs::path(home.path().toStdString()) / "ghostlight" / "drafts"));
    qunsetenv("XDG_DATA_HOME");
}

TEST(ShowDocument, what_can_be_kept_nowhere_is_said_until_it_is_saved_somewhere) {
    const QTemporaryDir home;
    ASSERT_TRUE(write_file_atomic(fs::path(home.path().toStdString()) / "ghostlight", "full").ok());
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    {
        Desk desk;
        ASSERT_TRUE(write_file_atomic(fs::path(desk.folder) / ".ghost", "full").ok());
        QStringList said;
        QObject::connect(&desk.document, &ShowDocument::keep_failed,
                         [&](const QString& words) { said << words; });
        desk.open();
        EXPECT_TRUE(desk.document.keep().ok()) << "nothing is changed";
        desk.app.select({0});
        ASSERT_TRUE(desk.edit.set_address({2, 101}).ok());
        wait_ms(700);
        ASSERT_EQ(said.size(), 1) << "by itself, half a second later";
        EXPECT_TRUE(said[0].contains("cannot be kept")) << said[0].toStdString();
        EXPECT_TRUE(desk.document.waits_for_answer());
        EXPECT_FALSE(desk.document.keep().ok());
        const fs::path copy = fs::path(home.path().toStdString()) / "copy.toml";
        ASSERT_TRUE(desk.document.save_copy(copy).ok());
        EXPECT_TRUE(desk.document.keep().ok()) << "it lies in the copy";
        ASSERT_TRUE(desk.edit.set_address({2, 102}).ok());
        EXPECT_FALSE(desk.document.keep().ok()) << "but what came later does not";
        ASSERT_TRUE(desk.document.save(false).ok());
        EXPECT_FALSE(desk.document.waits_for_answer());
    }
    qunsetenv("XDG_DATA_HOME");
}

// A newer plot of the show came in while it was edited: what was opened is of the text before.
TEST(ShowDocument, an_edit_outlives_a_show_that_was_opened_beside_it) {
    Desk desk;
    desk.open();
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.duplicate({1, 0, 0}).ok());
    const std::string edited = desk.document.text();
    Opened older = desk.app.opened();
    Report report;
    auto parsed = scene::parse_show(kShow, desk.file, report);
    ASSERT_TRUE(parsed.ok());
    older.show = std::make_shared<const scene::Show>(std::move(parsed->show));
    older.is_edit = false;
    older.again = true;
    older.text = nullptr;
    desk.link.opened.put(std::move(older));
    desk.link.on_news();
    settle();
    EXPECT_EQ(desk.document.text(), edited);
    ASSERT_EQ(desk.app.show()->fixtures.size(), 4u) << "numbers of fixtures are those of the text";
    desk.app.select({3});
    ASSERT_TRUE(desk.edit.remove().ok());
    EXPECT_EQ(desk.document.text().find("Lamp 3"), std::string::npos) << desk.document.text();
}

} // namespace
} // namespace ghost::ui
