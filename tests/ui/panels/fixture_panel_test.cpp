// SPDX-License-Identifier: Apache-2.0
// The list of fixtures: searching is no selecting.
#include "support/test_desk.h"

#include "image/colour.h"
#include "ui/panels/fixture_panel.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPointer>
#include <QTableView>

namespace ghost::ui {
namespace {

TEST(FixturePanel, what_is_searched_away_stays_selected) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    desk.app.select({0, 1, 2});
    int selections = 0;
    QObject::connect(&desk.app, &AppModel::selection_changed, [&] { ++selections; });
    auto* search = panel.findChild<QLineEdit*>();
    const auto* table = panel.findChild<QTableView*>();
    search->setText("Lamp 2");
    settle();
    EXPECT_EQ(table->model()->rowCount(), 1);
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{0, 1, 2}));
    search->clear();
    settle();
    EXPECT_EQ(table->selectionModel()->selectedRows().size(), 3);
    EXPECT_EQ(selections, 0);
}

TEST(FixturePanel, enter_in_the_search_selects_what_it_found) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    desk.app.select({0});
    auto* search = panel.findChild<QLineEdit*>();
    search->setText("none of them");
    Q_EMIT search->returnPressed();
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{0})) << "nothing was found";
    search->setText("Lamp");
    Q_EMIT search->returnPressed();
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{0, 1, 2}));
    search->setText("017");
    Q_EMIT search->returnPressed();
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{1}));
}

TEST(FixturePanel, what_is_chosen_with_ctrl_comes_beside_what_is_searched_away) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    panel.resize(600, 300);
    panel.show();
    settle();
    desk.app.select({0, 2});
    panel.findChild<QLineEdit*>()->setText("Lamp 2");
    settle();
    auto* table = panel.findChild<QTableView*>();
    ASSERT_EQ(table->model()->rowCount(), 1);
    const auto click = [&](Qt::KeyboardModifiers keys) {
        const QPointF at = table->visualRect(table->model()->index(0, FixtureList::name)).center();
        for (const auto& [type, held] :
             {std::pair{QEvent::MouseButtonPress, Qt::MouseButtons(Qt::LeftButton)},
              {QEvent::MouseButtonRelease, Qt::MouseButtons(Qt::NoButton)}}) {
            QMouseEvent event(type, at, table->viewport()->mapToGlobal(at), Qt::LeftButton, held, keys);
            QCoreApplication::sendEvent(table->viewport(), &event);
        }
        settle();
    };
    click(Qt::ControlModifier);
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{0, 1, 2}));
    click(Qt::ControlModifier);
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{0, 2})) << "and goes alone";
    click(Qt::NoModifier);
    EXPECT_EQ(desk.app.selection(), std::set<std::size_t>{1}) << "a plain click is a new choice";
}

TEST(FixturePanel, a_group_that_was_chosen_is_not_in_another_show) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    auto* const groups = panel.findChild<QComboBox*>();
    ASSERT_GT(groups->count(), 1);
    groups->setCurrentIndex(1);
    Q_EMIT groups->activated(1);
    desk.app.select({0});
    ASSERT_TRUE(desk.edit.set_address({2, 101}).ok());
    desk.follow();
    EXPECT_EQ(groups->currentIndex(), 1) << "an edit is no other show";
    desk.open();
    EXPECT_EQ(groups->currentIndex(), 0);
}

// What heads do comes after the show, and from a show that is opened again all of it anew.
TEST(FixturePanel, rows_by_light_are_in_order_again_after_the_show_was_opened_again) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    auto* table = panel.findChild<QTableView*>();
    table->sortByColumn(FixtureList::level, Qt::DescendingOrder);
    const auto light = [&](std::vector<float> dimmers) {
        RigNow rig;
        for (const float dimmer : dimmers) {
            FixtureNow now;
            now.dimmer = dimmer;
            rig.fixtures.push_back(now);
        }
        desk.link.rig.put(std::move(rig));
        desk.link.on_news();
        settle();
    };
    const auto names = [&] {
        QStringList all;
        for (int row = 0; row < table->model()->rowCount(); ++row)
            all << table->model()->index(row, FixtureList::name).data().toString();
        return all.join(", ").toStdString();
    };
    light({0.1f, 0.9f, 0.5f});
    EXPECT_EQ(names(), "Lamp 2, Lamp 3, Lamp 1");
    desk.open();
    light({0.8f, 0.1f, 0.3f});
    EXPECT_EQ(names(), "Lamp 1, Lamp 3, Lamp 2");
}

// Of names that are too long the end is seen, which tells lamps of one kind apart.
TEST(FixturePanel, names_that_do_not_fit_lose_their_middle) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    desk.app.select({0, 1});
    ASSERT_TRUE(desk.edit.rename("Robe ColorWash 2500 AT Standard 1").ok());
    desk.follow();
    desk.app.select({});
    panel.resize(320, 300);
    panel.show();
    settle();
    auto* table = panel.findChild<QTableView*>();
    table->setAlternatingRowColors(false);
    const auto name = [&](int row) {
        const QRect cell = table->visualRect(table->model()->index(row, FixtureList::name));
        return table->viewport()->grab(cell).toImage();
    };
    ASSERT_LT(table->columnWidth(FixtureList::name),
              table->fontMetrics().horizontalAdvance(table->model()->index(0, 0).data().toString()));
    EXPECT_NE(name(0), name(1)) << "1 is not 2";
}

// The first of its clicks alone leaves one row selected.
TEST(FixturePanel, a_double_click_edits_all_that_were_selected) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    panel.resize(600, 300);
    panel.show();
    settle();
    desk.app.select({0, 1, 2});
    auto* table = panel.findChild<QTableView*>();
    const QPointF at = table->visualRect(table->model()->index(1, FixtureList::patch)).center();
    const auto send = [&](QEvent::Type type, Qt::MouseButtons held) {
        QMouseEvent event(type, at, table->viewport()->mapToGlobal(at), Qt::LeftButton, held, Qt::NoModifier);
        QCoreApplication::sendEvent(table->viewport(), &event);
    };
    send(QEvent::MouseButtonPress, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, Qt::NoButton);
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{1})) << "a click is a choice";
    send(QEvent::MouseButtonDblClick, Qt::LeftButton);
    EXPECT_EQ(desk.app.selection(), (std::set<std::size_t>{0, 1, 2}));
    auto* field = table->findChild<QLineEdit*>();
    ASSERT_NE(field, nullptr);
    field->setText("4.101");
    QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
    QCoreApplication::sendEvent(field, &enter);
    settle();
    for (const scene::PatchedFixture& fixture : desk.app.show()->fixtures)
        EXPECT_EQ(fixture.universe, 4) << fixture.name;
}

// What stood there is a value as well, once somebody has typed it.
TEST(FixturePanel, the_value_of_the_first_is_typed_for_all_and_a_cell_that_is_left_changes_nothing) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    panel.resize(600, 300);
    panel.show();
    settle();
    auto* table = panel.findChild<QTableView*>();
    const auto enter = [&](int column, const QString& keys) {
        desk.app.select({0, 1, 2});
        table->edit(table->model()->index(0, column));
        const QPointer<QLineEdit> field = table->findChild<QLineEdit*>();
        ASSERT_TRUE(field);
        field->selectAll();
        for (const QChar letter : keys) {
            QKeyEvent typed(QEvent::KeyPress, 0, Qt::NoModifier, QString(letter));
            QCoreApplication::sendEvent(field, &typed);
        }
        QKeyEvent end(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
        QCoreApplication::sendEvent(field, &end);
        settle();
        delete field; // the next one is another
    };
    enter(FixtureList::x, "");
    EXPECT_EQ(desk.document.text(), kShow);
    enter(FixtureList::x, "-3");
    for (const scene::PatchedFixture& fixture : desk.app.show()->fixtures)
        EXPECT_EQ(fixture.position_m.x, -3) << fixture.name;
    EXPECT_EQ(desk.app.undo_stack().count(), 1);
}

// The mark of a chosen row covers all but the colour of the light.
TEST(FixturePanel, a_chosen_row_still_shows_its_colour) {
    Desk desk;
    FixturePanel panel(desk.app, desk.document, nullptr);
    desk.open();
    panel.resize(600, 300);
    panel.show();
    settle();
    auto* table = panel.findChild<QTableView*>();
    const auto has_green = [&] {
        const QModelIndex cell = table->model()->index(0, FixtureList::colour);
        const QImage picture = table->viewport()->grab(table->visualRect(cell)).toImage();
        return picture.pixelColor(picture.rect().center()) == QColor(0, 255, 0);
    };
    EXPECT_FALSE(has_green()) << "dark";
    RigNow rig;
    rig.fixtures.resize(3);
    rig.fixtures[0].candela = 1000;
    rig.fixtures[0].colour = image::rec709_to_rec2020({0, 1, 0});
    desk.link.rig.put(rig);
    desk.link.on_news();
    settle();
    EXPECT_TRUE(has_green());
    desk.app.select({0});
    EXPECT_TRUE(has_green());
}

} // namespace
} // namespace ghost::ui
