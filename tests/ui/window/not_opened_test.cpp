// SPDX-License-Identifier: Apache-2.0
// A show that cannot be opened while another one is: the window says so in red where people look, with a way
// on, and keeps it in Messages until a show opens.
#include "show/show.h"
#include "support/test_window.h"
#include "ui/panels/message_panel.h"
#include "ui/window/private/notice_bar.h"
#include "ui/window/window.h"

#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTreeWidget>

namespace ghost::ui {
namespace {

struct Failing {
    Failing() {
        window.show();
        settle();
    }
    void open_one() {
        link.opened.put(four_lamps());
        link.on_news();
        settle();
    }
    void fail(const Error& error) {
        window.app().open(error.where);
        link.not_opened.put({error, window.app().request().opens});
        link.on_news();
        settle();
    }
    QString words_of_bar() const {
        const auto labels = bar->findChildren<QLabel*>();
        return labels.isEmpty() ? QString() : labels.first()->text();
    }
    QAction* button(const QString& text) const {
        for (QAction* const one : bar->actions())
            if (one->text() == text) return one;
        return nullptr;
    }
    QString first_message() const {
        const auto* list = window.findChild<MessagePanel*>()->findChild<QTreeWidget*>();
        return list->topLevelItemCount() > 0 ? list->topLevelItem(0)->text(1) : QString();
    }

    Link link;
    Window window{link, WindowOptions{.remembers = false, .width = 900, .height = 600}};
    NoticeBar* bar = window.findChild<NoticeBar*>();
};

TEST(NotOpened, errors_that_a_show_was_opened_with_are_said_and_later_ones_are_not) {
    Failing failing;
    failing.open_one();
    const auto say = [&](const std::string& what) {
        failing.link.messages.put(
            {{Severity::warning, "show.toml:3", "unknown key"}, {Severity::error, "stage.glb", what}});
        failing.link.on_news();
        settle();
    };
    say("no such file");
    EXPECT_TRUE(failing.bar->isVisible());
    EXPECT_TRUE(failing.words_of_bar().contains("stage.glb: no such file"))
        << failing.words_of_bar().toStdString();
    failing.button("Close")->trigger();
    settle();
    say("a cable is out");
    EXPECT_FALSE(failing.bar->isVisible()) << "the show was open already";
    failing.window.app().open("another");
    failing.open_one();
    say("no such file");
    EXPECT_TRUE(failing.bar->isVisible()) << "of this one, too";
}

TEST(NotOpened, a_show_that_fails_beside_an_open_one_is_said_in_the_bar_and_stays_in_messages) {
    QTemporaryDir folder;
    const QString file = folder.filePath("show.toml");
    QFile(file).open(QIODevice::WriteOnly);
    Failing failing;
    failing.open_one();
    ASSERT_FALSE(failing.bar->isVisible());
    failing.fail({"is not TOML: a quotation mark is missing", file.toStdString() + ":6"});
    EXPECT_TRUE(failing.bar->isVisible());
    EXPECT_TRUE(failing.words_of_bar().contains("show.toml:6: is not TOML: a quotation mark is missing"))
        << failing.words_of_bar().toStdString();
    EXPECT_TRUE(failing.words_of_bar().contains("What was open stays open"));
    EXPECT_FALSE(failing.bar->styleSheet().isEmpty()) << "red";
    EXPECT_TRUE(failing.button("Open the file"));
    EXPECT_TRUE(failing.first_message().contains("a quotation mark is missing"));
    // An edit of the open show takes neither away.
    Opened edit = four_lamps();
    edit.is_edit = true;
    failing.link.opened.put(std::move(edit));
    failing.link.on_news();
    settle();
    EXPECT_TRUE(failing.bar->isVisible());
    failing.button("Close")->trigger();
    settle();
    EXPECT_FALSE(failing.bar->isVisible());
    EXPECT_TRUE(failing.first_message().contains("a quotation mark is missing")) << "until a show opens";
    failing.window.app().open("another");
    failing.open_one();
    EXPECT_FALSE(failing.first_message().contains("quotation mark"));
}

// A mistyped key would else be found by who looks into Messages.
TEST(NotOpened, a_key_of_the_show_file_that_is_ignored_is_said_and_other_warnings_are_not) {
    Failing failing;
    const auto open_with = [&](const std::string& where, const std::string& what) {
        failing.window.app().open("show " + what);
        failing.open_one();
        failing.link.messages.put({{Severity::warning, where, what}});
        failing.link.on_news();
        settle();
    };
    open_with("test/show.toml:12", "fixture 'a' is not patched");
    EXPECT_FALSE(failing.bar->isVisible()) << "many a show has such";
    open_with("Spot.gdtf: description.xml", "unknown key 'x'");
    EXPECT_FALSE(failing.bar->isVisible()) << "of somebody else's file";
    open_with("test/show.toml:14", "[[camera]] unknown key 'fov_x', did you mean 'fov_y_deg'?");
    EXPECT_TRUE(failing.bar->isVisible());
    EXPECT_TRUE(failing.words_of_bar().contains("ignored")) << failing.words_of_bar().toStdString();
    EXPECT_TRUE(failing.words_of_bar().contains("show.toml:14: [[camera]] unknown key 'fov_x'"));
    EXPECT_TRUE(failing.bar->styleSheet().isEmpty()) << "no fault";
    ASSERT_TRUE(failing.button("All messages"));
    failing.button("Close")->trigger();
    settle();
    EXPECT_FALSE(failing.bar->isVisible());
}

TEST(NotOpened, the_bar_lies_on_the_picture_and_moves_nothing) {
    Failing failing;
    failing.open_one();
    failing.window.resize(1366, 768);
    settle();
    const QWidget& picture = *failing.window.centralWidget();
    const QRect before = picture.geometry();
    const auto panels = [&] {
        QList<QRect> all;
        for (const QDockWidget* const one : failing.window.findChildren<QDockWidget*>())
            all << one->geometry();
        return all;
    };
    const QList<QRect> panels_before = panels();
    failing.fail(
        {"is not TOML: a quotation mark is missing, and this goes on for more than one line in a narrow "
         "place, as what is said of a file does now and then, so that it has to be wrapped somewhere",
         "/nowhere/show.toml:6"});
    ASSERT_TRUE(failing.bar->isVisible());
    EXPECT_EQ(picture.geometry(), before);
    EXPECT_EQ(panels(), panels_before);
    EXPECT_EQ(failing.bar->parentWidget(), &picture);
    EXPECT_EQ(failing.bar->width(), picture.width());
    failing.window.actions().choose("panel-network on");
    failing.window.resize(1000, 700);
    settle();
    EXPECT_EQ(failing.bar->width(), picture.width()) << "it goes with it";
    // A drag on it does not turn the picture.
    const scene::Camera camera = failing.window.app().camera();
    const QPointF from(20, 5);
    for (const auto& [type, at] : {std::pair{QEvent::MouseButtonPress, from},
                                   {QEvent::MouseMove, from + QPointF(80, 0)},
                                   {QEvent::MouseButtonRelease, from + QPointF(80, 0)}}) {
        QMouseEvent event(type, at, failing.bar->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(failing.bar, &event);
    }
    EXPECT_EQ(failing.window.app().camera().position_m, camera.position_m);
}

// A bar that is higher than its words hides more of the picture.
TEST(NotOpened, the_bar_is_no_higher_than_its_words_need) {
    Failing failing;
    failing.open_one();
    failing.window.resize(1366, 768);
    settle();
    const std::string words = "description.xml: 'Gobo 2 Index' and 'Gobo 2 Rotation' both say what a slot is";
    for (const int times : {1, 2, 5}) {
        std::string all = words;
        for (int k = 1; k < times; ++k) all += ", " + words;
        failing.fail({all, "/nowhere/show" + std::to_string(times) + ".toml"});
        const auto* label = failing.bar->findChildren<QLabel*>().last();
        const int line_px = label->fontMetrics().lineSpacing();
        EXPECT_LE(failing.bar->height(), label->heightForWidth(label->width()) + 3 * line_px) << times;
        EXPECT_GE(label->height(), label->heightForWidth(label->width())) << times << ": all of it is seen";
    }
}

TEST(NotOpened, a_camera_that_sees_nothing_is_said_when_nothing_else_is) {
    Failing failing;
    failing.open_one();
    failing.fail({"no such file or folder", "/nowhere/show.toml"});
    const auto look_at = [&](const UnseenStage& unseen) {
        failing.link.unseen_stage.put(unseen);
        failing.link.on_news();
        settle();
    };
    const auto close = [&] {
        failing.button("Close")->trigger();
        settle();
    };
    look_at({true, "Wall"});
    EXPECT_TRUE(failing.bar->words().contains("Not opened")) << "which waits for somebody";
    close();
    EXPECT_TRUE(failing.bar->words().contains("behind 'Wall'"));
    EXPECT_TRUE(failing.bar->styleSheet().isEmpty()) << "no fault";
    failing.fail({"no such file or folder", "/nowhere/show.toml"}); // before it, and then it is there again
    close();
    EXPECT_TRUE(failing.bar->words().contains("behind 'Wall'"));
    close();
    EXPECT_EQ(failing.bar->words(), "");
    failing.fail({"no such file or folder", "/nowhere/show.toml"});
    close();
    EXPECT_EQ(failing.bar->words(), "") << "somebody closed it";
    look_at({true, "Curtain"});
    EXPECT_TRUE(failing.bar->words().contains("behind 'Curtain'"));
    look_at({});
    EXPECT_EQ(failing.bar->words(), "");
}

TEST(NotOpened, without_a_file_there_is_nothing_to_open_and_the_next_show_takes_the_line_away) {
    Failing failing;
    failing.fail({"no such file or folder", "/nowhere/show.toml"});
    EXPECT_TRUE(failing.bar->isVisible());
    EXPECT_FALSE(failing.button("Open the file"));
    EXPECT_FALSE(failing.words_of_bar().contains("stays open"));
    failing.window.app().open("another");
    failing.open_one();
    EXPECT_FALSE(failing.bar->isVisible());
}

} // namespace
} // namespace ghost::ui
