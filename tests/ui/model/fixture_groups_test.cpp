// SPDX-License-Identifier: Apache-2.0
// Groups in the list of fixtures, those that are dark with their reasons, and substitutes for what a plot's
// files do not say.
#include "support/test_desk.h"
#include "ui/model/fixture_groups.h"
#include "ui/panels/fixture_panel.h"

#include "show_file/substitute_edit.h"

#include <QComboBox>

namespace ghost::ui {
namespace {

TEST(FixtureGroups, a_group_alone_is_listed_and_the_number_of_chosen_ones_stands_above) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    desk.app.select({0, 1});
    auto* const title = panel.findChild<QLabel*>();
    EXPECT_EQ(title->text(), "3 fixtures, 2 selected");
    auto* const group = panel.findChild<QComboBox*>();
    ASSERT_EQ(group->count(), 2) << "all, and one type";
    EXPECT_TRUE(group->itemText(1).startsWith("Type: ")) << group->itemText(1).toStdString();
}

TEST(FixtureGroups, what_hangs_under_one_truss_belongs_together) {
    const Opened opened = four_lamps(); // at x -3, -1, 1, 3, 4 m high
    std::vector<Object> objects(2);
    objects[0].name = "truss left";
    objects[0].bar = scene::Bar{{-4, 0, 4.3f}, {-0.5f, 0, 4.3f}, 0.3f, 0.3f};
    objects[1].name = "truss far";
    objects[1].bar = scene::Bar{{-4, 9, 4.3f}, {4, 9, 4.3f}, 0.3f, 0.3f};
    bool found = false;
    for (const FixtureGroup& one : groups_of(*opened.show, objects)) {
        EXPECT_NE(one.title, "Under: truss far");
        if (one.title != "Under: truss left") continue;
        found = true;
        EXPECT_EQ(one.fixtures, (std::set<std::size_t>{0, 1}));
    }
    EXPECT_TRUE(found);
}

TEST(FixtureGroups, dark_ones_are_listed_by_reasons_the_most_frequent_first) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    auto* const dark = panel.findChild<QToolButton*>();
    dark->click();
    EXPECT_TRUE(desk.app.request().explains_all);
    desk.link.verdicts.put({{scene::Visibility::dark, scene::Cause::not_patched, "has no address"},
                            {scene::Visibility::lit, scene::Cause::none, ""},
                            {scene::Visibility::dark, scene::Cause::dimmer, "the dimmer is at 0"}});
    desk.link.on_news();
    settle();
    auto* const group = panel.findChild<QComboBox*>();
    ASSERT_EQ(group->count(), 3);
    EXPECT_EQ(group->itemText(0), "Dark: 2");
    const auto* table = panel.table()->model();
    EXPECT_EQ(table->rowCount(), 2);
    group->setCurrentIndex(group->findText("the dimmer is at 0 (1)"));
    Q_EMIT group->activated(group->currentIndex());
    EXPECT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->index(0, 0).data().toString(), "Lamp 3");
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.remove().ok());
    ASSERT_EQ(table->rowCount(), 1) << "while the edit is read";
    EXPECT_EQ(table->index(0, 0).data().toString(), "Lamp 3");
    desk.app.undo_stack().undo();
    dark->click();
    EXPECT_FALSE(desk.app.request().explains_all);
    EXPECT_EQ(table->rowCount(), 3);
}

TEST(Substitute, an_entry_is_added_then_changed_and_the_rest_stays) {
    const auto once =
        scene::set_substitute("# mine\n[show]\nplot = \"a.mvr\" # tour\n", "Robe@Spot.gdtf", "x.gdtf");
    ASSERT_TRUE(once.ok()) << once.error().text();
    EXPECT_TRUE(once->starts_with("# mine\n[show]\nplot = \"a.mvr\" # tour\n")) << *once;
    EXPECT_NE(once->find("for = \"Robe@Spot.gdtf\"\ngdtf = \"x.gdtf\""), std::string::npos) << *once;
    const auto twice = scene::set_substitute(*once, "Robe@Spot.gdtf", "y.gdtf");
    ASSERT_TRUE(twice.ok());
    EXPECT_EQ(twice->find("x.gdtf"), std::string::npos) << *twice;
    EXPECT_EQ(twice->size(), once->size());
}

TEST(Substitute, heads_of_a_plot_without_a_beam_are_counted_by_their_file) {
    scene::Show show;
    for (int i = 0; i < 3; ++i) {
        scene::PatchedFixture fixture;
        fixture.uuid = i < 2 ? "u" + std::to_string(i) : ""; // the third is none of a plot
        fixture.gdtf = "Stub@Head.gdtf";
        fixture.type = lamp(); // no beam at all
        show.fixtures.push_back(fixture);
    }
    const auto groups = without_optics(show);
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].title, "Stub@Head.gdtf");
    EXPECT_EQ(groups[0].fixtures, (std::set<std::size_t>{0, 1}));
}

} // namespace
} // namespace ghost::ui
