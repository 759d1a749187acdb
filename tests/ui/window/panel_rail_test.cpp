// SPDX-License-Identifier: Apache-2.0
// How much of the window the picture has, and the rail of buttons that gives it to it where the window has
// few logical pixels.
#include "support/test_window.h"
#include "ui/window/window.h"

#include <QKeyEvent>
#include <QSettings>
#include <QToolButton>

namespace ghost::ui {
namespace {

struct Sized {
    explicit Sized(QSize size, bool remembers = false)
        : window(link, {.remembers = remembers, .width = size.width(), .height = size.height()}) {
        window.show();
        settle();
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    double share() const {
        const QSize picture = window.centralWidget()->size();
        return static_cast<double>(picture.width()) * picture.height() / (window.width() * window.height());
    }
    QToolBar& rail() { return *window.findChild<QToolBar*>("rail"); }
    QToolButton& button(const QString& panel) {
        for (QToolButton* const one : rail().findChildren<QToolButton*>())
            if (one->defaultAction() == window.actions().item("panel-" + panel)) return *one;
        throw std::runtime_error(panel.toStdString());
    }
    QStringList panels() const {
        QStringList names;
        for (const QDockWidget* const one : window.findChildren<QDockWidget*>())
            if (one->isVisible() && !one->visibleRegion().isEmpty()) names << one->objectName();
        names.sort();
        return names;
    }
    void run(const QString& line) {
        const Result<void> done = window.actions().run(line);
        ASSERT_TRUE(done.ok()) << done.error().text();
        settle();
    }
    void press(int key) {
        QWidget* const at = window.focusWidget() ? window.focusWidget() : &window;
        for (const QEvent::Type type : {QEvent::ShortcutOverride, QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent event(type, key, Qt::NoModifier);
            QApplication::sendEvent(at, &event);
        }
        settle();
    }

    Link link;
    Window window;
};

// Layouts have logical pixels, so a display at scale 2 is one of half the size.
TEST(Share, the_picture_has_most_of_the_window_on_every_display_at_every_scale) {
    struct Display {
        QSize size;
        double least;
    };
    for (const Display& display : {Display{{1366, 768}, 0.60}, {{1920, 1080}, 0.70}, {{2560, 1440}, 0.75}})
        for (const double scale : {1.0, 1.5, 2.0}) {
            const Sized in((QSizeF(display.size) / scale).toSize());
            EXPECT_GE(in.share(), display.least) << display.size.width() << " at scale " << scale;
            ::testing::Test::RecordProperty(
                QString("share_%1_%2").arg(display.size.width()).arg(scale).toStdString(),
                QString::number(in.share(), 'f', 3).toStdString());
            EXPECT_EQ(in.window.width(), qRound(display.size.width() / scale)) << "no panel makes it wider";
        }
}

TEST(PanelRail, stands_in_narrow_windows_alone) {
    EXPECT_TRUE(Sized({900, 600}).rail().isVisible());
    Sized wide({1366, 768});
    EXPECT_FALSE(wide.rail().isVisible());
    EXPECT_EQ(wide.panels(), (QStringList{"fixtures", "programmer"}));
}

TEST(PanelRail, opens_one_panel_at_a_time_and_gives_the_room_back) {
    Sized in({900, 600});
    const double alone = in.share();
    EXPECT_EQ(in.panels(), QStringList());
    in.button("programmer").click();
    settle();
    EXPECT_EQ(in.panels(), QStringList{"programmer"});
    EXPECT_TRUE(in.button("programmer").isChecked());
    EXPECT_GT(in.share(), 0.5) << "the picture is still the larger part";
    in.button("fixtures").click();
    settle();
    EXPECT_EQ(in.panels(), QStringList{"fixtures"});
    in.button("network").click();
    settle();
    EXPECT_EQ(in.panels(), QStringList{"network"}) << "also of those below the picture";
    in.button("network").click();
    settle();
    EXPECT_EQ(in.panels(), QStringList());
    EXPECT_DOUBLE_EQ(in.share(), alone);
    in.run("panel-scene on");
    EXPECT_EQ(in.panels(), QStringList{"scene"}) << "commands and keys do the same";
    EXPECT_TRUE(in.button("scene").isChecked());
}

TEST(PanelRail, esc_closes_the_panel_before_it_clears_the_selection) {
    Sized in({900, 600});
    in.run("select *");
    in.run("panel-programmer on");
    in.press(Qt::Key_Escape);
    EXPECT_EQ(in.panels(), QStringList());
    EXPECT_EQ(in.window.app().selection().size(), 4u);
    EXPECT_EQ(in.window.focusWidget(), in.window.centralWidget());
    QKeyEvent second(QEvent::ShortcutOverride, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(in.window.centralWidget(), &second);
    EXPECT_FALSE(second.isAccepted()) << "the key of 'Select nothing' again";
}

TEST(PanelRail, every_button_is_reached_by_keys_and_says_what_it_opens) {
    Sized in({900, 600});
    const QList<QToolButton*> all = in.rail().findChildren<QToolButton*>();
    int buttons = 0;
    for (const QToolButton* const one : all) {
        if (!one->defaultAction()) continue; // Qt's own, for what finds no room
        ++buttons;
        EXPECT_TRUE(one->focusPolicy() & Qt::TabFocus);
        EXPECT_FALSE(one->icon().isNull());
        EXPECT_TRUE(one->toolTip().startsWith(one->defaultAction()->text())) << one->toolTip().toStdString();
        EXPECT_TRUE(one->isVisible()) << one->toolTip().toStdString();
    }
    EXPECT_EQ(buttons, 11);
    EXPECT_TRUE(in.button("fixtures").toolTip().endsWith("(Ctrl+1)"));
}

TEST(PanelRail, a_window_that_becomes_wide_has_its_panels_again) {
    Sized in({1366, 768});
    in.run("panel-scene on");
    const QStringList before = in.panels();
    in.window.resize(900, 600);
    settle();
    EXPECT_EQ(in.panels(), QStringList());
    EXPECT_TRUE(in.rail().isVisible());
    in.window.resize(1366, 768);
    settle();
    EXPECT_EQ(in.panels(), before);
    EXPECT_FALSE(in.rail().isVisible());
}

TEST(PanelRail, a_layout_that_was_left_narrow_has_its_columns_in_a_wide_window) {
    QTemporaryDir home;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, home.path());
    Sized({900, 600}, true).window.close();
    EXPECT_EQ(Sized({900, 600}, true).panels(), QStringList());
    EXPECT_TRUE(Sized({1500, 800}, true).panels().contains("fixtures"));
}

TEST(PanelRail, full_screen_is_without_it_and_gives_it_back) {
    Sized in({900, 600});
    in.run("panel-looks on");
    in.run("full-screen on");
    EXPECT_FALSE(in.rail().isVisible());
    EXPECT_EQ(in.panels(), QStringList());
    in.run("full-screen off");
    EXPECT_TRUE(in.rail().isVisible());
    EXPECT_EQ(in.panels(), QStringList{"looks"});
}

TEST(FullScreen, a_show_that_opens_in_it_has_panels_and_transport_afterwards) {
    Link link;
    Window window(link, {.remembers = false, .width = 1366, .height = 768});
    window.show();
    settle();
    const auto panels = [&] {
        QStringList names;
        for (const QDockWidget* const one : window.findChildren<QDockWidget*>())
            if (one->isVisible() && !one->visibleRegion().isEmpty()) names << one->objectName();
        names.sort();
        return names;
    };
    const auto run = [&](const QString& line) {
        EXPECT_TRUE(window.actions().run(line).ok());
        settle();
    };
    const QToolBar* const transport = window.findChild<QToolBar*>("transport");
    run("full-screen on");
    link.opened.put(four_lamps());
    link.rig.put(four_lit());
    link.on_news();
    settle();
    EXPECT_EQ(panels(), QStringList()) << "the picture alone";
    EXPECT_FALSE(transport->isVisible());
    run("full-screen off");
    EXPECT_EQ(panels(), (QStringList{"fixtures", "programmer"}));
    EXPECT_TRUE(transport->isVisible());
}

TEST(FullScreen, esc_leaves_it_when_there_is_nothing_else_to_let_go_of) {
    Sized in({1366, 768});
    in.run("select *");
    in.run("full-screen on");
    const auto esc = [&] {
        in.window.actions().item("select-none")->trigger();
        settle();
    };
    esc();
    EXPECT_TRUE(in.window.isFullScreen()) << "the selection first";
    EXPECT_TRUE(in.window.app().selection().empty());
    in.run("select-none");
    EXPECT_TRUE(in.window.isFullScreen()) << "a script asks for nothing but what it says";
    esc();
    EXPECT_FALSE(in.window.isFullScreen());
    EXPECT_EQ(in.panels(), (QStringList{"fixtures", "programmer"}));
    esc();
    EXPECT_FALSE(in.window.isFullScreen()) << "and does not come back to it";
}

} // namespace
} // namespace ghost::ui
