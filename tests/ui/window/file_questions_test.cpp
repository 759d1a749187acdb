// SPDX-License-Identifier: Apache-2.0
// Dialogs that ask for a file: where they begin, and what is said before one is asked for.
#include "support/test_desk.h"
#include "ui/window/window.h"

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QToolBar>

namespace ghost::ui {
namespace {

struct Asking {
    Asking() {
        window.show();
        EXPECT_TRUE(write_file_atomic(file, kShow).ok());
        Report report;
        auto parsed = scene::parse_show(kShow, file, report);
        EXPECT_TRUE(parsed.ok());
        Opened opened;
        opened.show = std::make_shared<const scene::Show>(std::move(parsed->show));
        link.opened.put(std::move(opened));
        link.on_news();
        settle();
        QObject::connect(&closer, &QTimer::timeout, [this] {
            if (auto* const dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                began = dialog->directory().canonicalPath();
                if (answer.isEmpty()) return dialog->reject();
                dialog->findChild<QLineEdit*>("fileNameEdit")->setText(answer);
                // It may ask on its part, for which this timer must be free.
                QMetaObject::invokeMethod(
                    dialog, [dialog] { static_cast<QDialog*>(dialog)->accept(); }, Qt::QueuedConnection);
            }
            if (auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked = box->text();
                answer.clear();
                box->reject();
            }
        });
        closer.start(20);
    }
    // The folder that the dialog of it stood in; empty: no file was asked for.
    QString begin_of(const QString& line) {
        began.clear();
        window.actions().choose(line);
        return began;
    }
    QPushButton* button(const QString& words) {
        for (QPushButton* const one : window.findChildren<QPushButton*>())
            if (one->text() == words) return one;
        return nullptr;
    }
    QToolBar* bar() { return window.findChild<QToolBar*>("notice"); }
    QString notice() {
        const auto* const words = bar()->findChild<QLabel*>();
        return bar()->isVisible() && words ? words->text() : QString();
    }

    QTemporaryDir own, elsewhere;
    QString here = QDir(own.path()).canonicalPath();
    fs::path file = fs::path(own.path().toStdString()) / "show.toml";
    Link link;
    Window window{link, {.remembers = false, .width = 1000, .height = 700}};
    QTimer closer; // the dialogs would wait for ever
    QString began, answer;
    QString asked; // before a file goes
};

TEST(FileQuestion, begins_in_the_folder_of_the_show_that_is_open) {
    Asking in;
    for (const char* const action :
         {"save-as", "open", "add-fixture", "add-model", "save-copy", "save-picture"})
        EXPECT_EQ(in.begin_of(action), in.here) << action;
    EXPECT_EQ(in.begin_of("new"), QFileInfo(in.here).path()) << "beside it: a show in a show is none";
}

TEST(FileQuestion, begins_where_the_same_was_asked_last_but_save_as_stays_with_the_show) {
    Asking in;
    const QString there = QDir(in.elsewhere.path()).canonicalPath();
    ASSERT_TRUE(write_file_atomic(fs::path(there.toStdString()) / "lamp.gdtf", "none").ok());
    for (const auto& [action, name] : {std::pair{"add-fixture", "/lamp.gdtf"}, {"save-as", "/second.toml"}}) {
        in.answer = there + name;
        in.begin_of(action);
        in.answer.clear();
    }
    EXPECT_EQ(in.begin_of("add-fixture"), there);
    EXPECT_EQ(in.begin_of("save-as"), in.here);
    EXPECT_EQ(in.begin_of("open"), in.here);
}

TEST(FileQuestion, a_name_without_its_ending_is_asked_about_as_the_file_that_it_would_be) {
    Asking in;
    const fs::path there = fs::path(in.own.path().toStdString()) / "act2.toml";
    ASSERT_TRUE(write_file_atomic(there, "precious").ok());
    in.answer = in.here + "/act2";
    in.begin_of("save-as");
    EXPECT_TRUE(in.asked.contains("act2.toml")) << in.asked.toStdString();
    EXPECT_EQ(*read_text_file(there, 100), "precious");
}

TEST(FileQuestion, stills_and_films_begin_there_too) {
    Asking in;
    ASSERT_TRUE(in.window.actions().run("panel-export on").ok());
    for (const char* const words : {"Still...", "Film...", "Contact sheet..."}) {
        in.began.clear();
        in.button(words)->click();
        EXPECT_EQ(in.began, in.here) << words;
    }
}

TEST(FileQuestion, what_reads_the_file_of_a_show_that_is_not_saved_says_so_before_one_is_asked_for) {
    Asking in;
    ASSERT_TRUE(in.window.actions().run("panel-export on").ok());
    ASSERT_TRUE(in.window.actions().run("select \"Lamp 1\"").ok());
    ASSERT_TRUE(in.window.actions().run("rename Solo").ok());
    for (const char* const words : {"Still...", "Film...", "Contact sheet...", "Bake"}) {
        in.began.clear();
        in.button(words)->click();
        EXPECT_EQ(in.began, "") << words;
        EXPECT_TRUE(in.notice().contains("save the show first")) << words << in.notice().toStdString();
        ASSERT_FALSE(in.bar()->actions().isEmpty());
        for (QAction* const one : in.bar()->actions())
            if (one->text() == "Close") one->trigger();
        EXPECT_EQ(in.notice(), "");
    }
    in.button("Still...")->click();
    QAction* save = nullptr;
    for (QAction* const one : in.bar()->actions())
        if (one->text() == "Save the show") save = one;
    ASSERT_TRUE(save);
    save->trigger();
    EXPECT_EQ(in.notice(), "");
    EXPECT_FALSE(in.window.isWindowModified());
    in.button("Still...")->click();
    EXPECT_EQ(in.began, in.here);
}

} // namespace
} // namespace ghost::ui
