// SPDX-License-Identifier: Apache-2.0
// The picture on a second display: it is drawn for the larger window, goes when its display is unplugged, and
// comes back with it.
#include "support/test_window.h"
#include "ui/window/second_display.h"
#include "ui/window/window.h"

#include <QAction>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPixmap>
#include <QScreen>

namespace ghost::ui {
namespace {

struct Displayed {
    Displayed() {
        bench.open();
        bench.app.set_size(320, 180);
        scene::Camera camera = bench.app.camera();
        bench.show_picture(camera);
        QObject::connect(&display, &SecondDisplay::changed, [this](const QString& what) { said = what; });
    }
    ~Displayed() { display.close(); }
    PictureWindow* window() const {
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (auto* found = qobject_cast<PictureWindow*>(widget)) return found;
        return nullptr;
    }
    static void wait_ms(int ms) {
        QElapsedTimer clock;
        clock.start();
        while (clock.elapsed() < ms) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    }

    Bench bench;
    SecondDisplay display{bench.app};
    QString said;
};

TEST(SecondDisplay, a_window_of_its_own_shows_the_picture_and_sets_its_size) {
    Displayed displayed;
    ASSERT_TRUE(displayed.display.open("window", nullptr).ok());
    ASSERT_TRUE(displayed.window());
    displayed.wait_ms(300);
    EXPECT_EQ(displayed.bench.app.camera().width, 960);
    const QImage shown = displayed.window()->grab().toImage();
    EXPECT_EQ(shown.pixelColor(shown.width() / 2, shown.height() / 2).red(), 200)
        << "the picture of the bench is red";
    displayed.window()->close();
    settle();
    EXPECT_FALSE(displayed.display.is_open());
    EXPECT_EQ(displayed.bench.app.camera().width, 320) << "the size of the view again";
}

TEST(SecondDisplay, an_unplugged_display_takes_the_window_along_and_brings_it_back) {
    Displayed displayed;
    QScreen* const screen = QGuiApplication::primaryScreen();
    ASSERT_TRUE(displayed.display.open(screen->name().isEmpty() ? "1" : screen->name(), nullptr).ok());
    ASSERT_TRUE(displayed.window());
    EXPECT_EQ(displayed.window()->geometry().size(), screen->geometry().size());
    Q_EMIT qGuiApp->screenRemoved(screen);
    EXPECT_EQ(displayed.window(), nullptr);
    EXPECT_FALSE(displayed.display.is_open());
    EXPECT_TRUE(displayed.said.contains("is gone")) << displayed.said.toStdString();
    if (!screen->name().isEmpty()) {
        EXPECT_TRUE(displayed.display.waits());
        Q_EMIT qGuiApp->screenAdded(screen);
        EXPECT_TRUE(displayed.window());
    }
    displayed.display.close();
    EXPECT_FALSE(displayed.display.waits());
}

TEST(SecondDisplay, a_window_of_its_own_is_one_also_after_a_display) {
    Displayed displayed;
    ASSERT_TRUE(displayed.display.open("1", nullptr).ok());
    ASSERT_TRUE(displayed.window()->isFullScreen());
    ASSERT_TRUE(displayed.display.open("window", nullptr).ok());
    settle();
    ASSERT_TRUE(displayed.window());
    EXPECT_TRUE(displayed.window()->isVisible());
    EXPECT_FALSE(displayed.window()->isFullScreen());
    EXPECT_FALSE(displayed.window()->windowFlags() & Qt::FramelessWindowHint);
    EXPECT_NE(displayed.window()->cursor().shape(), Qt::BlankCursor);
    EXPECT_EQ(displayed.window()->size(), QSize(960, 540));
    EXPECT_EQ(displayed.display.words(), "a window of its own");
}

TEST(SecondDisplay, without_a_name_it_is_the_one_where_the_window_is_not) {
    if (!windows_have_the_pixels_of_their_screen()) GTEST_SKIP() << kOnePixel;
    Displayed displayed;
    const QList<QScreen*> screens = QGuiApplication::screens();
    ASSERT_EQ(screens.size(), 2);
    ASSERT_TRUE(displayed.display.open("", screens[0]).ok());
    EXPECT_EQ(displayed.display.words(), "second");
    displayed.wait_ms(300);
    const QSize pixels = screens[1]->size() * screens[1]->devicePixelRatio();
    EXPECT_EQ(displayed.bench.app.camera().width, pixels.width()) << "all that the display has";
    EXPECT_EQ(displayed.bench.app.camera().height, pixels.height());
}

void press_in(QWidget& widget, int key, const QString& text = QString(), Qt::KeyboardModifiers held = {}) {
    QKeyEvent event(QEvent::KeyPress, key, held, text);
    QCoreApplication::sendEvent(&widget, &event);
    settle();
}

TEST(SecondDisplay, keys_that_reach_it_are_those_of_the_window_and_esc_lets_go_before_it_closes) {
    Link link;
    Window window{link, {.remembers = false, .width = 900, .height = 600}};
    window.show();
    link.opened.put(four_lamps());
    link.on_news();
    settle();
    ASSERT_TRUE(window.actions().run("second-display window").ok());
    PictureWindow* picture = nullptr;
    for (QWidget* const one : QApplication::topLevelWidgets())
        if (auto* const found = qobject_cast<PictureWindow*>(one)) picture = found;
    ASSERT_TRUE(picture);
    ASSERT_TRUE(window.actions().item("second-display")->isChecked());
    press_in(*picture, Qt::Key_B, "b");
    EXPECT_TRUE(window.app().request().black_out);
    press_in(*picture, Qt::Key_B, "B", Qt::ShiftModifier);
    EXPECT_TRUE(window.app().request().black_out) << "another key";
    window.app().set_exposure(6, false);
    press_in(*picture, Qt::Key_Plus, "+", Qt::ShiftModifier); // as keyboards have it above =
    EXPECT_LT(window.app().camera().ev100, 6);
    window.app().select({1});
    press_in(*picture, Qt::Key_Escape);
    EXPECT_TRUE(window.app().selection().empty());
    ASSERT_TRUE(picture->isVisible());
    press_in(*picture, Qt::Key_Escape);
    EXPECT_FALSE(window.actions().item("second-display")->isChecked());
    ASSERT_TRUE(window.actions().run("second-display window").ok());
    for (QWidget* const one : QApplication::topLevelWidgets())
        if (auto* const found = qobject_cast<PictureWindow*>(one)) picture = found;
    press_in(*picture, Qt::Key_F11, QString(), Qt::ShiftModifier);
    EXPECT_FALSE(window.actions().item("second-display")->isChecked()) << "it is what closes it, too";
}

TEST(SecondDisplay, what_is_not_there_is_a_sentence) {
    Displayed displayed;
    const Result<void> seventh = displayed.display.open("7", nullptr);
    ASSERT_FALSE(seventh.ok());
    EXPECT_NE(seventh.error().text().find("there are 1 (first"), std::string::npos) << seventh.error().text();
}

} // namespace
} // namespace ghost::ui
