// SPDX-License-Identifier: Apache-2.0
// Windows whose display is gone come to one that is there; those that can be reached stay where they are.
#include "support/test_window.h"
#include "ui/widgets/on_screen.h"
#include "ui/window/window.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QWindow>

namespace ghost::ui {
namespace {

const QRect kFirst(0, 0, 1280, 1024), kSecond(1280, 0, 1920, 1080);

TEST(OnScreen, what_is_seen_stays) {
    for (const QRect& frame : {QRect(100, 100, 900, 600), QRect(1500, 200, 900, 600),
                               QRect(900, 100, 900, 600), QRect(-300, 50, 900, 600), QRect(0, 0, 1280, 1024)})
        EXPECT_EQ(in_reach(frame, {kFirst, kSecond}), frame) << frame.x();
    EXPECT_EQ(in_reach(kSecond, {}), kSecond) << "no display is there to come to";
}

TEST(OnScreen, what_lay_on_a_display_that_is_gone_comes_back_whole) {
    EXPECT_EQ(in_reach(QRect(1500, 200, 900, 600), {kFirst}), QRect(380, 200, 900, 600));
    EXPECT_EQ(in_reach(QRect(1192, 120, 900, 600), {kFirst}), QRect(380, 120, 900, 600))
        << "a window manager leaves a strip of it";
    EXPECT_EQ(in_reach(kSecond, {kFirst}), QRect(0, 0, 1280, 1024)) << "and is made to fit";
    EXPECT_EQ(in_reach(QRect(100, -500, 800, 1000), {kFirst}), QRect(100, 0, 800, 1000))
        << "half of it is seen, but not its title";
    EXPECT_EQ(in_reach(QRect(4000, 200, 900, 600), {kFirst, kSecond}), QRect(380, 200, 900, 600));
}

TEST(OnScreen, what_is_larger_than_its_display_is_made_to_fit) {
    EXPECT_EQ(in_reach(kSecond.translated(-1280, 0), {QRect(0, 0, 1366, 768)}), QRect(0, 0, 1366, 768));
    EXPECT_EQ(in_reach(QRect(0, 0, 1280, 1046), {kFirst}), QRect(0, 0, 1280, 1046)) << "its frame";
    EXPECT_EQ(in_reach(QRect(200, 0, 2000, 1000), {kFirst, kSecond}), QRect(200, 0, 2000, 1000))
        << "over both of them";
}

TEST(OnScreen, windows_and_torn_off_panels_are_moved) {
    QMainWindow window;
    window.setGeometry(1500, 200, 640, 480);
    auto* dock = new QDockWidget("Panel", &window);
    window.addDockWidget(Qt::LeftDockWidgetArea, dock);
    window.show();
    dock->setFloating(true);
    dock->setGeometry(1700, 300, 200, 300);
    QWidget near;
    near.setGeometry(100, 100, 300, 200);
    near.show();
    settle();
    const QRect stays = near.frameGeometry();
    EXPECT_EQ(bring_into_reach({kFirst}), 2);
    settle();
    EXPECT_TRUE(kFirst.contains(window.frameGeometry())) << window.frameGeometry().x();
    EXPECT_EQ(window.size(), QSize(640, 480));
    EXPECT_TRUE(kFirst.contains(dock->frameGeometry())) << dock->frameGeometry().x();
    EXPECT_EQ(near.frameGeometry(), stays);
    EXPECT_EQ(bring_into_reach({kFirst}), 0);
}

TEST(OnScreen, leaving_full_screen_leads_to_a_display_that_is_there) {
    Link link;
    WindowOptions options;
    options.remembers = false;
    Window window(link, options);
    window.show();
    settle();
    window.windowHandle()->setGeometry(4000, 200, 400, 300);
    settle();
    ASSERT_TRUE(window.actions().run("full-screen").ok());
    settle();
    EXPECT_TRUE(window.isFullScreen());
    ASSERT_TRUE(window.actions().run("full-screen").ok());
    wait_ms(600);
    EXPECT_FALSE(window.isFullScreen());
    EXPECT_TRUE(kFirst.united(kSecond).contains(window.frameGeometry())) << window.frameGeometry().x();
}

} // namespace
} // namespace ghost::ui
