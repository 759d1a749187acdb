// SPDX-License-Identifier: Apache-2.0
// What the window says of an edit that it refuses, of a show that it may not change, and of what can be
// undone.
#include "support/test_desk.h"
#include "ui/widgets/toast.h"
#include "ui/window/window.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

namespace ghost::ui {
namespace {

struct Refused {
    explicit Refused(const std::string& where = "") : folder(where) {
        if (folder.empty()) folder = own.path().toStdString();
        file = fs::path(folder) / "show.toml";
        const bool is_there = fs::exists(file) || write_file_atomic(file, kShow).ok();
        EXPECT_TRUE(is_there);
        window.show();
        Report report;
        auto parsed = scene::parse_show(*read_text_file(file, 1 << 20), file, report);
        EXPECT_TRUE(parsed.ok());
        Opened opened;
        opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
    }
    void choose(const QString& line) {
        window.actions().choose(line);
        settle();
    }
    QString notice() {
        auto* const bar = window.findChild<QToolBar*>("notice");
        const auto* const words = bar->findChild<QLabel*>();
        return bar->isVisible() && words ? words->text() : QString();
    }
    QString text(const char* action) { return window.actions().item(action)->text(); }

    QTemporaryDir own;
    std::string folder;
    fs::path file;
    Link link;
    Window window{link, {.remembers = false, .width = 1000, .height = 700}};
};

TEST(Refused, an_edit_that_is_refused_is_said_over_the_picture_until_something_is_done) {
    Refused in;
    in.choose("select \"Lamp 1\"");
    in.choose("rename \"Lamp 2\"");
    EXPECT_EQ(in.notice(), "Not done: another fixture is called 'Lamp 2'");
    in.choose("rename Solo");
    EXPECT_EQ(in.notice(), "");
    // What is no edit is in the status line alone.
    in.choose("camera nowhere");
    EXPECT_EQ(in.notice(), "");
    EXPECT_TRUE(in.window.statusBar()->currentMessage().contains("nowhere"));
}

QPushButton* button_called(const Window& window, const QString& words) {
    for (QPushButton* const one : window.findChildren<QPushButton*>())
        if (one->text() == words) return one;
    return nullptr;
}

TEST(Refused, what_hands_set_is_stored_only_where_they_set_something_and_the_words_are_those_of_the_window) {
    Refused in;
    QPushButton* const store = button_called(in.window, "Store programmer");
    ASSERT_TRUE(store);
    EXPECT_FALSE(store->isEnabled());
    EXPECT_TRUE(store->toolTip().contains("Nothing is set by hand")) << store->toolTip().toStdString();
    in.choose("look-store Verse");
    EXPECT_EQ(in.notice(),
              "Not done: nothing is set by hand; 'Store what is seen' in Looks stores what a desk "
              "or recording does");
    EXPECT_FALSE(in.window.statusBar()->currentMessage().contains("look-"))
        << in.window.statusBar()->currentMessage().toStdString();
    in.choose("select \"Lamp 1\"");
    in.choose("intensity 1");
    EXPECT_TRUE(store->isEnabled());
    EXPECT_EQ(store->toolTip(), "As a new look");
    in.choose("look-store Verse");
    QPushButton* const update = button_called(in.window, "Update");
    EXPECT_TRUE(update->isEnabled());
    in.choose("release-all");
    EXPECT_FALSE(store->isEnabled());
    EXPECT_FALSE(update->isEnabled());
    // Smoke by hand is part of a look, too.
    in.choose("smoke 2");
    EXPECT_TRUE(store->isEnabled());
}

TEST(Refused, what_waits_for_an_answer_is_not_pushed_away) {
    Refused first;
    Refused second(first.folder);
    const QString held = second.notice();
    ASSERT_TRUE(held.contains("Another window has this show open")) << held.toStdString();
    second.choose("select \"Lamp 1\"");
    second.choose("rename Solo");
    EXPECT_EQ(second.notice(), held);
    const Toast* const toast = second.window.findChild<Toast*>();
    ASSERT_TRUE(toast->isVisible());
    EXPECT_TRUE(toast->words().contains("is open in another window")) << toast->words().toStdString();
}

TEST(Title, a_show_that_is_read_only_is_called_so) {
    Refused first;
    EXPECT_FALSE(first.window.windowTitle().contains("read only"));
    Refused second(first.folder);
    EXPECT_TRUE(second.window.windowTitle().contains("(read only)"))
        << second.window.windowTitle().toStdString();
    second.choose("take-over");
    EXPECT_FALSE(second.window.windowTitle().contains("read only"));
    wait_ms(1300);
    EXPECT_TRUE(first.window.windowTitle().contains("(read only)"));
}

TEST(Title, a_window_that_is_closed_leaves_the_show_to_others_while_its_program_ends) {
    Refused first;
    ASSERT_TRUE(first.window.close());
    Refused second(first.folder);
    EXPECT_FALSE(second.window.windowTitle().contains("read only"))
        << second.window.windowTitle().toStdString();
}

TEST(Title, a_plot_that_is_opened_as_it_is_cannot_be_written) {
    Link link;
    Window window{link, {.remembers = false, .width = 900, .height = 600}};
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->file = show->plot_file = "nowhere/tour.mvr";
    opened.show = show;
    link.opened.put(std::move(opened));
    link.on_news();
    settle();
    EXPECT_TRUE(window.windowTitle().contains("(read only)")) << window.windowTitle().toStdString();
}

TEST(UndoWords, the_menu_says_what_undo_and_redo_would_do) {
    Refused in;
    EXPECT_EQ(in.text("undo"), "Undo");
    in.choose("select \"Lamp 1\"");
    in.choose("rename \"Black & white\"");
    EXPECT_EQ(in.text("undo"), "Undo: Rename of 'Lamp 1'");
    EXPECT_EQ(in.text("redo"), "Redo");
    in.choose("place 1 2 3");
    EXPECT_EQ(in.text("undo"), "Undo: Position of 'Black && white'");
    in.choose("undo");
    EXPECT_EQ(in.text("undo"), "Undo: Rename of 'Lamp 1'");
    EXPECT_EQ(in.text("redo"), "Redo: Position of 'Black && white'");
    in.choose("select-all");
    in.choose("move 1 0 0");
    EXPECT_EQ(in.text("undo"), "Undo: Move of 3 fixtures");
}

TEST(UndoWords, the_button_of_what_was_done_is_grey_while_something_else_was_done_last) {
    Refused in;
    in.choose("select \"Lamp 1\"");
    in.choose("duplicate");
    const Toast* const toast = in.window.findChild<Toast*>();
    const auto* const undo = toast->findChild<QToolButton*>("undo");
    ASSERT_EQ(toast->words(), "1 fixture duplicated");
    EXPECT_TRUE(undo->isEnabled());
    in.choose("smoke 2");
    ASSERT_EQ(toast->words(), "1 fixture duplicated");
    EXPECT_FALSE(undo->isEnabled()) << "it would take the smoke";
    in.choose("undo");
    EXPECT_TRUE(undo->isEnabled());
    in.choose("undo");
    in.choose("smoke 2");
    EXPECT_FALSE(undo->isEnabled()) << "another step in its place";
}

TEST(UndoWords, the_line_about_an_edit_takes_back_that_edit_or_nothing) {
    Refused in;
    in.link.messages.put({});
    in.link.on_news();
    settle();
    in.choose("select \"Lamp 1\"");
    in.choose("duplicate");
    in.choose("smoke 2");
    Opened read = in.window.app().opened(); // a minute later
    read.text = in.window.app().request().text;
    in.link.opened.put(std::move(read));
    in.link.messages.put({{Severity::error, "show.toml:40", "nobody has this file"}});
    in.link.on_news();
    settle();
    ASSERT_TRUE(in.notice().startsWith("Since this edit: ")) << in.notice().toStdString();
    const QAction* undo = nullptr;
    for (const QAction* const one : in.window.findChild<QToolBar*>("notice")->actions())
        if (one->text() == "Undo") undo = one;
    ASSERT_TRUE(undo);
    EXPECT_FALSE(undo->isEnabled()) << "it would take the smoke";
    in.choose("undo");
    EXPECT_TRUE(undo->isEnabled());
}

} // namespace
} // namespace ghost::ui
