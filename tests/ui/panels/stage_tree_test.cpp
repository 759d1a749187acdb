// SPDX-License-Identifier: Apache-2.0
// The objects of the stage in the scene panel: layers and groups, their boxes, the search; and that nothing
// but a person hides or shows one.
#include "support/test_desk.h"

#include "ui/panels/scene_panel.h"

namespace ghost::ui {
namespace {

// A plot's layer with three chairs and a table, and two trusses and a floor of the model.
struct Hall : Desk {
    Hall() {
        open();
        show(kNames);
    }
    using Names = std::vector<std::pair<const char*, const char*>>; // layer, object
    inline static const Names kNames = {{"", "truss_1"},      {"", "truss_2"},      {"", "floor"},
                                        {"Seats", "chair 1"}, {"Seats", "chair 2"}, {"Seats", "chair 3"},
                                        {"Seats", "table"}};
    void show(const Names& names) {
        Opened opened = app.opened();
        opened.is_edit = false;
        opened.objects.clear();
        for (const auto& [layer, name] : names) {
            Object object;
            object.name = name;
            object.layer = layer;
            object.instance = 10 + opened.objects.size();
            opened.objects.push_back(object);
        }
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    QTreeWidgetItem* item(const char* name) {
        return tree->findItems(name, Qt::MatchExactly | Qt::MatchRecursive).value(0);
    }
    Qt::CheckState box(const char* name) { return item(name)->checkState(0); }
    const std::map<std::size_t, bool>& by_hand() { return app.look().shown; }

    ScenePanel panel{app, nullptr};
    QTreeWidget* tree = panel.findChild<QTreeWidget*>();
    QLineEdit* search = panel.findChild<StageTree*>()->findChild<QLineEdit*>();
};

TEST(StageTree, layers_and_groups_hold_what_they_name) {
    Hall hall;
    ASSERT_NE(hall.item("Seats (4)"), nullptr);
    ASSERT_NE(hall.item("chair (3)"), nullptr);
    EXPECT_EQ(hall.item("chair (3)")->parent(), hall.item("Seats (4)"));
    EXPECT_EQ(hall.item("chair 2")->parent(), hall.item("chair (3)"));
    EXPECT_EQ(hall.item("table")->parent(), hall.item("Seats (4)"));
    EXPECT_EQ(hall.item("truss_2")->parent(), hall.item("truss (2)"));
    EXPECT_EQ(hall.item("floor")->parent(), nullptr);
    for (const auto& [name, stem] : {std::pair{"truss_front_12", "truss_front"},
                                     {"Cube.003", "Cube"},
                                     {"Deck #4", "Deck"},
                                     {"12", "12"},
                                     {"wall", "wall"},
                                     {"", ""},
                                     {"_7", "_7"}})
        EXPECT_EQ(without_number(name), stem);
}

TEST(StageTree, a_box_is_that_of_all_in_it_and_one_step) {
    Hall hall;
    hall.item("chair 1")->setCheckState(0, Qt::Unchecked);
    EXPECT_EQ(hall.by_hand(), (std::map<std::size_t, bool>{{13, false}}));
    EXPECT_EQ(hall.box("chair (3)"), Qt::PartiallyChecked);
    EXPECT_EQ(hall.box("Seats (4)"), Qt::PartiallyChecked);
    EXPECT_EQ(hall.box("truss (2)"), Qt::Checked);
    hall.item("Seats (4)")->setCheckState(0, Qt::Unchecked);
    EXPECT_EQ(hall.by_hand().size(), 4u);
    EXPECT_EQ(hall.box("table"), Qt::Unchecked);
    hall.app.undo_stack().undo();
    EXPECT_EQ(hall.by_hand(), (std::map<std::size_t, bool>{{13, false}}));
    EXPECT_EQ(hall.box("table"), Qt::Checked);
    hall.app.undo_stack().undo();
    EXPECT_TRUE(hall.by_hand().empty());
    EXPECT_EQ(hall.box("chair 1"), Qt::Checked);
    hall.item("floor")->setSelected(true);
    hall.item("truss_1")->setSelected(true);
    hall.item("floor")->setCheckState(0, Qt::Unchecked); // and so the other that is selected
    EXPECT_EQ(hall.by_hand(), (std::map<std::size_t, bool>{{10, false}, {12, false}}));
}

TEST(StageTree, an_edit_of_the_patch_hides_nothing) {
    Hall hall;
    hall.tree->setCurrentItem(hall.item("chair 2"));
    EXPECT_EQ(hall.app.marked(), 4u);
    hall.app.select({0});
    const int steps = hall.app.undo_stack().count();
    ASSERT_TRUE(hall.edit.set_address({2, 101}).ok());
    hall.follow();
    EXPECT_TRUE(hall.by_hand().empty());
    EXPECT_EQ(hall.app.undo_stack().count(), steps + 1);
    hall.app.undo_stack().undo();
    hall.follow();
    EXPECT_EQ(hall.document.text(), kShow);
    EXPECT_TRUE(hall.by_hand().empty());
}

TEST(StageTree, several_that_are_selected_stay_so_while_an_edit_is_read) {
    Hall hall;
    hall.tree->setCurrentItem(hall.item("chair 1"));
    hall.item("table")->setSelected(true);
    hall.item("floor")->setSelected(true);
    Opened opened = hall.app.opened();
    opened.is_edit = true;
    hall.link.opened.put(opened);
    hall.link.on_news();
    settle();
    EXPECT_EQ(hall.tree->selectedItems().size(), 3);
    opened.objects.back().name = "desk";
    hall.link.opened.put(opened);
    hall.link.on_news();
    settle();
    EXPECT_EQ(hall.item("table"), nullptr);
    EXPECT_NE(hall.item("desk"), nullptr) << "another stage is listed";
}

TEST(StageTree, a_show_with_fewer_objects_takes_the_place_of_one_with_more) {
    Hall hall;
    hall.tree->setCurrentItem(hall.item("table"));
    hall.show({{"", "floor"}});
    EXPECT_EQ(hall.tree->topLevelItemCount(), 1);
    hall.tree->setCurrentItem(hall.item("floor"));
    hall.show({});
    EXPECT_EQ(hall.tree->topLevelItemCount(), 0);
    EXPECT_EQ(hall.app.marked(), std::nullopt);
    hall.show(Hall::kNames);
    EXPECT_TRUE(hall.by_hand().empty());
}

TEST(StageTree, the_search_leaves_what_fits_with_what_it_stands_in) {
    Hall hall;
    hall.search->setText("CHAIR 2");
    EXPECT_FALSE(hall.item("chair 2")->isHidden());
    EXPECT_FALSE(hall.item("Seats (4)")->isHidden());
    EXPECT_TRUE(hall.item("Seats (4)")->isExpanded());
    for (const char* const other : {"chair 1", "table", "floor", "truss (2)"})
        EXPECT_TRUE(hall.item(other)->isHidden()) << other;
    hall.search->setText("seats");
    EXPECT_FALSE(hall.item("table")->isHidden());
    hall.search->clear();
    for (const char* const other : {"chair 1", "table", "floor", "truss (2)"})
        EXPECT_FALSE(hall.item(other)->isHidden()) << other;
}

} // namespace
} // namespace ghost::ui
