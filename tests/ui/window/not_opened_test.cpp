// SPDX-License-Identifier: Apache-2.0
// A show that cannot be opened while another one is: the window says so in red where people look, with a way
// on, and keeps it in Messages until a show opens.
#include "show/show.h"
#include "support/test_window.h"
#include "ui/panels/message_panel.h"
#include "ui/window/private/notice_bar.h"
#include "ui/window/window.h"

#include <QLabel>
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
        link.not_opened.put(error);
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

// A bar that is higher than its words pushes all panels down, and up again.
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
