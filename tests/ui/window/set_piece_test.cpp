// SPDX-License-Identifier: Apache-2.0
// Set pieces: chosen by a double click, dragged over the floor by their cross, moved by name and by keys,
// undone byte for byte.
#include "support/test_desk.h"
#include "support/test_picture.h"

#include "show_file/show_toml.h"
#include "ui/actions/can_do.h"
#include "ui/actions/object_edit.h"
#include "ui/panel_parts/stage_tree.h"
#include "ui/window/window.h"

namespace ghost::ui {
namespace {

Object object_at(const char* name, const glm::vec3& centre_m, std::size_t instance) {
    Object object;
    object.name = name;
    object.instance = instance;
    object.centre_m = centre_m;
    return object;
}

struct SetPieces : Desk {
    SetPieces() {
        open();
        add_object_actions(actions, app, document);
        Opened opened = app.opened();
        opened.is_edit = false;
        opened.objects = {object_at("riser", {0, 2, 0.3f}, 0), object_at("riser", {0, 2.1f, 0.4f}, 3),
                          object_at("chair", {1, 2, 0}, 1), object_at("chair", {2.2f, 2, 0}, 2)};
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    std::string complaint(const QString& line) {
        const Result<void> done = actions.run(line);
        settle();
        return done.ok() ? "" : done.error().text();
    }

    QWidget widget;
    Actions actions{widget};
};

TEST(SetPiece, is_moved_by_name_and_undone_byte_for_byte) {
    SetPieces stage;
    ASSERT_EQ(stage.complaint("move-object 0.5 -1 0 riser"), "");
    EXPECT_EQ(stage.document.text(), kShow + "\n[[object]]\nname = \"riser\"\nmove_m = [0.5, -1, 0]\n");
    stage.app.undo_stack().undo();
    EXPECT_EQ(stage.document.text(), kShow);
}

TEST(SetPiece, keys_move_the_chosen_one_from_where_it_is_or_the_selected_fixtures) {
    SetPieces stage;
    EXPECT_NE(stage.complaint("nudge-left").find("no object of the stage is chosen"), std::string::npos);
    ASSERT_EQ(stage.complaint("choose-object riser"), "");
    ASSERT_EQ(stage.complaint("nudge-left"), "");
    EXPECT_NE(stage.document.text().find("move_m = [-0.1, 0, 0]"), std::string::npos);
    stage.app.undo_stack().undo();
    stage.app.select({0});
    ASSERT_EQ(stage.complaint("nudge-up-stage"), "");
    EXPECT_NE(stage.document.text().find("position_m = [-3, 0.1, 4]"), std::string::npos)
        << stage.document.text();
}

TEST(SetPiece, one_of_several_with_one_name_stays_and_the_sentence_says_why) {
    SetPieces stage;
    EXPECT_NE(stage.complaint("move-object 1 0 0 chair").find("2 objects are called 'chair'"),
              std::string::npos);
    EXPECT_NE(stage.complaint("move-object 1 0 0 rizer").find("did you mean 'riser'"), std::string::npos);
    EXPECT_EQ(stage.document.text(), kShow);
}

// A camera at (0, -10, 2) that looks along Y, 320x180 pixels.
TEST(SetPiece, its_cross_drags_it_over_the_floor_in_steps_of_a_decimetre) {
    Watched watched;
    Opened opened = four_lamps();
    opened.objects = {object_at("riser", {0, 0, 0.5f}, 0)};
    watched.bench.link.opened.put(std::move(opened));
    watched.bench.link.on_news();
    settle();
    glm::vec3 moved(0);
    std::size_t object = 99;
    watched.view.on_move_object = [&](std::size_t which, const glm::vec3& by_m) {
        object = which;
        moved = by_m;
    };
    const auto at = to_widget(QRectF(0, 0, 320, 180), watched.bench.app.picture().camera, {0, 0, 0.5f});
    const auto there =
        to_widget(QRectF(0, 0, 320, 180), watched.bench.app.picture().camera, {1.23f, 0, 0.5f});
    ASSERT_TRUE(at && there);
    watched.drag(*at, *there, Qt::LeftButton);
    EXPECT_EQ(object, 99u) << "it is not chosen";
    watched.bench.app.cut_to(watched.bench.app.picture().camera);
    watched.bench.app.mark(0);
    watched.drag(*at, *there, Qt::LeftButton);
    EXPECT_EQ(object, 0u);
    EXPECT_NEAR(moved.x, 1.2f, 1e-4f);
    EXPECT_NEAR(moved.y, 0, 1e-4f);
    EXPECT_EQ(moved.z, 0);
    watched.drag(*at, *there, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NEAR(moved.x, 1.23f, 0.011f) << "freely";
}

TEST(SetPiece, a_double_click_chooses_what_the_engine_meets_there) {
    Watched watched;
    Opened opened = four_lamps();
    opened.objects = {object_at("chair", {0, 0, 0}, 0), object_at("chair", {3, 0, 0}, 1)};
    watched.bench.link.opened.put(std::move(opened));
    watched.bench.link.on_news();
    settle();
    watched.mouse(QEvent::MouseButtonDblClick, {300, 170}, Qt::LeftButton);
    Picked picked;
    picked.number = watched.bench.app.request().pick.number;
    picked.hit = true;
    picked.at_m = {2.9f, 0, 0.2f};
    picked.object = "chair";
    watched.bench.link.picked.put(picked);
    watched.bench.link.on_news();
    settle();
    EXPECT_EQ(watched.bench.app.marked(), 1u);
}

TEST(SetPiece, a_double_click_keeps_the_heads_that_its_first_click_let_go_of) {
    Watched watched;
    watched.bench.open();
    AppModel& app = watched.bench.app;
    app.select_in_order({2, 0});
    const QPointF beside(300, 170);
    watched.mouse(QEvent::MouseButtonPress, beside, Qt::LeftButton);
    watched.mouse(QEvent::MouseButtonRelease, beside, Qt::LeftButton);
    EXPECT_TRUE(app.selection().empty()) << "a click lets go of them";
    EXPECT_EQ(app.request().pick.beside, 0);
    watched.mouse(QEvent::MouseButtonDblClick, beside, Qt::LeftButton);
    watched.mouse(QEvent::MouseButtonRelease, beside, Qt::LeftButton);
    EXPECT_EQ(app.selected_in_order(), (std::vector<std::size_t>{2, 0}));
    // Eight pixels, of which 180 are 40 degrees; less of an angle beside the middle.
    EXPECT_NEAR(app.request().pick.beside, 0.024f, 0.002f);
}

TEST(SetPiece, escape_lets_go_of_it_first_and_of_the_fixtures_then) {
    Link link;
    Window window(link, {.remembers = false, .width = 900, .height = 600});
    window.show();
    link.opened.put(four_lamps());
    link.rig.put(four_lit());
    link.on_news();
    settle();
    window.app().select({0, 1});
    window.actions().choose("choose-object Wall");
    ASSERT_EQ(window.app().marked(), std::optional<std::size_t>(1));
    auto* const tree = window.findChild<StageTree*>();
    EXPECT_EQ(tree->object(), std::optional<std::size_t>(1));
    window.actions().item("select-none")->trigger();
    EXPECT_EQ(window.app().marked(), std::nullopt);
    EXPECT_EQ(tree->object(), std::nullopt);
    EXPECT_TRUE(tree->findChild<QTreeWidget*>()->selectedItems().isEmpty());
    EXPECT_EQ(window.app().selection().size(), 2u);
    window.actions().item("select-none")->trigger();
    EXPECT_TRUE(window.app().selection().empty());
    // A script says once what it wants; the menu has it for an object alone, too.
    window.app().select({0});
    window.app().mark(0);
    ASSERT_TRUE(window.actions().run("select-none").ok());
    EXPECT_EQ(window.app().marked(), std::nullopt);
    EXPECT_TRUE(window.app().selection().empty());
    const ShowDocument document(window.app());
    EXPECT_FALSE(can_do("select-none", window.app(), document));
    window.app().mark(0);
    EXPECT_TRUE(can_do("select-none", window.app(), document));
}

} // namespace
} // namespace ghost::ui
