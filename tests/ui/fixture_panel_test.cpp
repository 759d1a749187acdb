// SPDX-License-Identifier: Apache-2.0
// The list of fixtures: searching is no selecting.
#include "test_desk.h"

#include "ui/fixture_panel.h"

#include <QLineEdit>
#include <QTableView>

namespace ghost::ui {
namespace {

TEST(FixturePanel, what_is_searched_away_stays_selected) {
    Desk desk;
    FixturePanel panel(desk.studio, desk.document, nullptr);
    desk.open();
    desk.studio.select({0, 1, 2});
    int selections = 0;
    QObject::connect(&desk.studio, &Studio::selection_changed, [&] { ++selections; });
    auto* search = panel.findChild<QLineEdit*>();
    const auto* table = panel.findChild<QTableView*>();
    search->setText("Lamp 2");
    settle();
    EXPECT_EQ(table->model()->rowCount(), 1);
    EXPECT_EQ(desk.studio.selection(), (std::set<std::size_t>{0, 1, 2}));
    search->clear();
    settle();
    EXPECT_EQ(table->selectionModel()->selectedRows().size(), 3);
    EXPECT_EQ(selections, 0);
}

} // namespace
} // namespace ghost::ui
