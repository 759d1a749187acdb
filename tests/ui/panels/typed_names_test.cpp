// SPDX-License-Identifier: Apache-2.0
// What is being typed in the lists of cues and looks stays there while the show goes on.
#include "support/test_desk.h"
#include "ui/actions/look_actions.h"
#include "ui/panels/cue_panel.h"
#include "ui/panels/look_panel.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>

namespace ghost::ui {
namespace {

struct TypingDesk : Desk {
    TypingDesk() {
        std::string text = kShow;
        for (const char* const name : {"A", "B"})
            text += std::string("[[cue]]\nname = \"") + name + "\"\nlook = \"Blue\"\n";
        EXPECT_TRUE(write_file_atomic(file, text).ok());
        EXPECT_TRUE(
            write_file_atomic(file.parent_path() / "looks.toml",
                              "[[look]]\nname = \"Blue\"\n[[look.fixture]]\nname = \"Lamp 1\"\nintensity "
                              "= 0.25\n[[look]]\nname = \"Red\"\n")
                .ok());
        open();
        add_cue_actions(actions, cues);
        add_look_actions(actions, app, looks);
        for (QWidget* const panel : std::initializer_list<QWidget*>{&cue_panel, &look_panel}) {
            panel->resize(900, 400);
            panel->show();
        }
        settle();
    }
    static void type(QWidget& widget, const QString& text) {
        for (const QChar letter : text) {
            QKeyEvent event(QEvent::KeyPress, 0, Qt::NoModifier, QString(letter));
            QCoreApplication::sendEvent(&widget, &event);
        }
    }
    static void enter(QWidget& widget) {
        QKeyEvent event(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
        QCoreApplication::sendEvent(&widget, &event);
        settle();
    }

    Looks looks{app};
    CueList cues{app, document, looks};
    QWidget widget;
    Actions actions{widget};
    CuePanel cue_panel{app, cues, looks, actions, nullptr};
    LookPanel look_panel{app, looks, actions, nullptr};
};

TEST(CuePanel, a_note_that_is_typed_stays_when_a_cue_comes_by) {
    TypingDesk desk;
    constexpr int kNotes = 9;
    QTableWidget& table = *desk.cue_panel.table();
    table.setCurrentCell(1, kNotes);
    table.editItem(table.item(1, kNotes));
    settle();
    QPointer<QLineEdit> field = table.findChild<QLineEdit*>();
    ASSERT_TRUE(field);
    desk.type(*field, "when she ");
    ASSERT_TRUE(desk.cues.go().ok());
    ASSERT_TRUE(desk.cues.go().ok()); // the one of the note
    settle();
    ASSERT_TRUE(field) << "it was closed";
    EXPECT_EQ(field->text(), "when she ");
    desk.type(*field, "\"turns\"");
    desk.enter(*field);
    EXPECT_EQ(desk.cues.all()[1].notes, "when she \"turns\"");
    EXPECT_EQ(table.currentColumn(), kNotes) << "F2 goes on there";
    EXPECT_EQ(table.item(1, 1)->foreground().color(), table.item(1, kNotes)->foreground().color());
    EXPECT_NE(table.item(0, 1)->foreground(), table.item(1, 1)->foreground()) << "the called one is marked";
}

TEST(CuePanel, what_is_added_after_an_undone_recall_is_no_cue_of_that_look) {
    TypingDesk desk;
    const auto add = [&] {
        for (QPushButton* const button : desk.cue_panel.findChildren<QPushButton*>())
            if (button->text() == "Add") button->click();
        desk.follow();
        return desk.cues.all().back().look;
    };
    ASSERT_TRUE(desk.looks.recall("Blue", 4).ok());
    EXPECT_EQ(add(), "Blue");
    desk.app.undo_stack().undo(); // the cue
    desk.app.undo_stack().undo(); // the recall
    ASSERT_TRUE(desk.app.look().is_empty());
    EXPECT_EQ(add(), "") << "neither that one nor one without values";
    EXPECT_EQ(desk.cues.all().size(), 3u);
    ASSERT_TRUE(desk.looks.recall("Red", 0).ok());
    EXPECT_EQ(add(), "Red") << "it was asked for";
}

TEST(CuePanel, a_cue_stays_chosen_where_it_goes_and_one_that_is_added_is) {
    TypingDesk desk;
    const auto press = [&](const char* text) {
        for (QPushButton* const button : desk.cue_panel.findChildren<QPushButton*>())
            if (button->text() == text) button->click();
        desk.follow();
    };
    QTableWidget& table = *desk.cue_panel.table();
    ASSERT_TRUE(desk.looks.recall("Red", 0).ok());
    press("Add");
    ASSERT_EQ(desk.cues.all().size(), 3u);
    EXPECT_EQ(table.currentRow(), 2);
    const std::string added = desk.cues.all()[2].name;
    press("Up");
    EXPECT_EQ(table.currentRow(), 1);
    press("Up");
    EXPECT_EQ(table.currentRow(), 0);
    EXPECT_EQ(desk.cues.all()[0].name, added) << "Up twice takes it to the top";
    press("Down");
    EXPECT_EQ(table.currentRow(), 1);
    EXPECT_EQ(desk.cues.all()[1].name, added);
}

TEST(LookPanel, a_name_that_is_typed_stays_when_a_look_is_recalled) {
    TypingDesk desk;
    QListWidget& list = *desk.look_panel.list();
    ASSERT_EQ(list.count(), 2);
    list.setCurrentRow(1);
    list.editItem(list.item(1));
    settle();
    QPointer<QLineEdit> field = list.findChild<QLineEdit*>();
    ASSERT_TRUE(field);
    field->selectAll();
    desk.type(*field, "Sun");
    for (const char* const name : {"Blue", "Red"}) {
        ASSERT_TRUE(desk.looks.recall(name, 0).ok());
        settle();
    }
    ASSERT_TRUE(field) << "it was closed";
    EXPECT_EQ(field->text(), "Sun");
    desk.enter(*field);
    EXPECT_EQ(desk.looks.all()[1].name, "Sun");
    EXPECT_EQ(list.item(1)->text(), "Sun");
}

} // namespace
} // namespace ghost::ui
