// SPDX-License-Identifier: Apache-2.0
// Fixtures hung under trusses in the window: spread evenly under the chosen or the nearest one, in the text
// of the show, undone byte for byte.
#include "support/test_desk.h"

#include "ui/actions/hang_edit.h"
#include "ui/panels/scene_panel.h"

namespace ghost::ui {
namespace {

// Front truss at y 0 of two pieces, back truss at y 8, a tower, and a wall.
struct Stage : Desk {
    Stage() {
        open();
        add_hang_action(actions, app, document);
        Opened opened = app.opened();
        opened.is_edit = false;
        const auto add = [&](const char* name, std::optional<scene::Bar> bar) {
            Object object;
            object.name = name;
            object.instance = opened.objects.size();
            object.bar = bar;
            opened.objects.push_back(object);
        };
        add("front 1", scene::Bar{{-4, 0, 6}, {0, 0, 6}, 0.4f});
        add("front 2", scene::Bar{{0, 0, 6}, {2, 0, 6}, 0.4f});
        add("back", scene::Bar{{-4, 8, 5.5f}, {4, 8, 5.5f}, 0.4f});
        add("tower", std::nullopt);
        add("wall", scene::Bar{{-6, 3, 0}, {6, 3, 0}, 5});
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    std::string complaint(const QString& line) {
        const Result<void> done = actions.run(line);
        catch_up();
        return done.ok() ? "" : done.error().text();
    }
    void place(std::size_t index, const glm::vec3& at_m) {
        app.select({index});
        const Result<void> done = edit.set_position(at_m);
        ASSERT_TRUE(done.ok()) << done.error().text();
        catch_up();
    }
    // What answers here has no stage.
    void catch_up() {
        const std::vector<Object> objects = app.opened().objects;
        follow();
        Opened opened = app.opened();
        opened.objects = objects;
        opened.is_edit = true;
        opened.text = app.request().text;
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }

    QWidget widget;
    Actions actions{widget};
};

TEST(Hang, the_nearest_truss_with_all_its_pieces_takes_them_evenly) {
    Stage stage;
    stage.app.select({0, 1, 2});
    ASSERT_EQ(stage.complaint("hang"), "");
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(stage.fixture(i).position_m, glm::vec3(-3 + 2 * static_cast<float>(i), 0, 6)) << i;
    EXPECT_NE(stage.document.text().find("position_m = [-3, 0, 6]"), std::string::npos)
        << stage.document.text();
    stage.app.undo_stack().undo();
    EXPECT_EQ(stage.document.text(), kShow);
}

TEST(Hang, one_that_is_named_and_one_lamp_alone) {
    Stage stage;
    stage.app.select({1}); // at x -1
    ASSERT_EQ(stage.complaint("hang back"), "");
    EXPECT_EQ(stage.fixture(1).position_m, glm::vec3(-1, 8, 5.5f));
    EXPECT_EQ(stage.fixture(0).position_m, glm::vec3(-3, 0, 4));
}

TEST(Hang, what_is_no_truss_is_said_and_nothing_moves) {
    Stage stage;
    EXPECT_NE(stage.complaint("hang").find("no fixture is selected"), std::string::npos);
    stage.app.select({0});
    EXPECT_NE(stage.complaint("hang tower").find("is no truss or pipe"), std::string::npos);
    EXPECT_NE(stage.complaint("hang wall").find("is no truss or pipe"), std::string::npos);
    EXPECT_NE(stage.complaint("hang pier").find("there is no object 'pier'"), std::string::npos);
    EXPECT_FALSE(hang_under(stage.app, stage.document, 3).ok());
    EXPECT_FALSE(hang_under(stage.app, stage.document, 99).ok());
    EXPECT_EQ(stage.document.text(), kShow);
    EXPECT_FALSE(stage.app.undo_stack().canUndo());
}

TEST(Hang, a_new_lamp_hangs_under_the_truss_above_the_place_that_is_looked_at) {
    Stage stage;
    const std::vector<Object>& objects = stage.app.opened().objects;
    EXPECT_EQ(place_above(objects, {}, {}, {-1, 1, 0}, 3), glm::vec3(-1, 0, 6));
    EXPECT_EQ(place_above(objects, {}, {}, {-1.23456f, 7, 0}, 3), glm::vec3(-1.235f, 8, 5.5f));
    EXPECT_EQ(place_above(objects, {}, {}, {9, 1, 0}, 3), glm::vec3(2, 0, 6)) << "its end, of both pieces";
    EXPECT_EQ(place_above({objects[3], objects[4]}, {}, {}, {-1, 1, 0}, 3), glm::vec3(-1, 1, 3))
        << "neither a tower nor a wall carries it";
    std::vector<Object> floor(1);
    floor[0].bar = scene::Bar{{-4, 1, 0.5f}, {4, 1, 0.5f}, 0.1f};
    EXPECT_EQ(place_above(floor, {}, {}, {-1, 1, 0}, 3), glm::vec3(-1, 1, 3)) << "a rail";
    std::vector<Object> hidden(1, objects[0]);
    hidden[0].shown = false;
    EXPECT_EQ(place_above(hidden, {}, {}, {-1, 1, 0}, 3), glm::vec3(-1, 1, 3));
}

// Lamps of a type without a body count as 0.3 m wide.
TEST(Hang, heads_are_set_beside_those_that_hang_there) {
    Stage stage;
    stage.place(0, {-1, 0, 6}); // the middle of the front truss is taken
    stage.app.select({1});      // it would go there, too
    ASSERT_EQ(stage.complaint("hang"), "");
    EXPECT_EQ(stage.fixture(1).position_m.y, 0);
    EXPECT_NEAR(std::abs(stage.fixture(1).position_m.x + 1), 0.32f, 0.01f) << stage.fixture(1).position_m.x;
    stage.place(1, {-1, 1, 4});

    stage.app.select({1, 2}); // they spread over what is free, left and right of it
    ASSERT_EQ(stage.complaint("hang"), "");
    EXPECT_NEAR(stage.fixture(1).position_m.x, -2.58f, 0.01f);
    EXPECT_NEAR(stage.fixture(2).position_m.x, 0.58f, 0.01f);
    EXPECT_EQ(stage.fixture(0).position_m, glm::vec3(-1, 0, 6)) << "what hangs there stays";
    stage.app.select({1});
    ASSERT_EQ(stage.complaint("hang"), "");
    EXPECT_NEAR(stage.fixture(1).position_m.x, -2.58f, 0.01f) << "once more changes nothing";

    const glm::vec3 above =
        place_above(stage.app.opened().objects, stage.app.show()->fixtures, {}, {-1, 1, 0}, 3);
    EXPECT_NEAR(std::abs(above.x + 1), 0.32f, 0.01f) << "a new one likewise: " << above.x;
}

TEST(Hang, where_there_is_no_room_it_is_said_and_nothing_moves) {
    Stage stage;
    Opened opened = stage.app.opened();
    opened.objects[2].bar = scene::Bar{{-1.2f, 8, 5.5f}, {-0.7f, 8, 5.5f}, 0.1f}; // as long as one is wide
    opened.is_edit = false;
    stage.link.opened.put(std::move(opened));
    stage.link.on_news();
    settle();
    stage.app.select({1});
    ASSERT_EQ(stage.complaint("hang back"), "");
    const std::string before = stage.document.text();
    stage.app.select({0, 2});
    EXPECT_NE(stage.complaint("hang back").find("has no room beside what hangs there for 2 more"),
              std::string::npos);
    EXPECT_EQ(stage.document.text(), before);
}

TEST(Hang, the_scene_panel_offers_it_for_what_lies) {
    Stage stage;
    ScenePanel of_stage(stage.app, nullptr);
    std::optional<std::size_t> asked;
    QObject::connect(&of_stage, &ScenePanel::asks_to_hang, [&](std::size_t object) { asked = object; });
    // It was made after the show was opened.
    stage.link.opened.put([&] {
        Opened opened = stage.app.opened();
        opened.is_edit = false;
        return opened;
    }());
    stage.link.on_news();
    settle();
    QPushButton* hang = nullptr;
    for (auto* button : of_stage.findChildren<QPushButton*>())
        if (button->text().startsWith("Hang")) hang = button;
    ASSERT_NE(hang, nullptr);
    auto* objects = of_stage.findChild<QTreeWidget*>();
    const auto choose = [&](const char* name) {
        objects->setCurrentItem(objects->findItems(name, Qt::MatchExactly | Qt::MatchRecursive).value(0));
    };
    EXPECT_FALSE(hang->isEnabled()) << "nothing is chosen";
    choose("back");
    EXPECT_FALSE(hang->isEnabled()) << "no fixture is selected";
    stage.app.select({0, 2});
    EXPECT_TRUE(hang->isEnabled());
    choose("tower");
    EXPECT_FALSE(hang->isEnabled()) << "a tower stands";
    choose("back");
    hang->click();
    EXPECT_EQ(asked, 2u);
}

} // namespace
} // namespace ghost::ui
