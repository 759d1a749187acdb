// SPDX-License-Identifier: Apache-2.0
// A window comes back where it was closed. (With frames of a window manager: window_place_test.py.)
#include "support/test_window.h"
#include "ui/widgets/window_place.h"

#include <functional>

namespace ghost::ui {
namespace {

struct Kept {
    QTemporaryDir folder;
    QSettings settings{folder.filePath("kept.ini"), QSettings::IniFormat};

    // Where it is once it is shown.
    QRect start(const std::function<void(QWidget&)>& change = {}) {
        QWidget window;
        WindowPlace place(window);
        window.resize(1280, 1024);
        window.setWindowState(Qt::WindowMaximized);
        (void)place.put_back(settings);
        window.show();
        settle();
        if (change) change(window);
        settle();
        const QRect stood = window.geometry();
        place.keep(settings);
        return stood;
    }
};

TEST(WindowPlace, a_window_at_the_upper_edge_stays_there) {
    Kept kept;
    const QRect first = kept.start([](QWidget& window) {
        window.showNormal();
        window.setGeometry(120, 0, 900, 600);
    });
    ASSERT_LT(first.top(), 20) << "Qt without a display draws a frame of 2";
    for (int start = 0; start < 3; ++start) EXPECT_EQ(kept.start(), first) << start;
}

TEST(WindowPlace, one_as_large_as_the_display_stays_so_and_goes_back_to_where_it_was) {
    Kept kept;
    const QRect normal = kept.start([](QWidget& window) {
        window.showNormal();
        window.setGeometry(50, 40, 700, 500);
    });
    const QRect large = kept.start([](QWidget& window) { window.showMaximized(); });
    ASSERT_GT(large.width(), 1200);
    for (int start = 0; start < 3; ++start) EXPECT_EQ(kept.start(), large) << start;
    EXPECT_EQ(kept.settings.value("place").toRect(), normal);
}

TEST(WindowPlace, what_no_display_shows_any_more_comes_to_one_that_is_there) {
    Kept kept;
    kept.settings.setValue("place", QRect(9000, 9000, 600, 400));
    kept.settings.setValue("maximized", false);
    const QRect stands = kept.start();
    EXPECT_EQ(stands.size(), QSize(600, 400));
    bool is_seen = false;
    for (const QScreen* const screen : QGuiApplication::screens())
        is_seen = is_seen || screen->availableGeometry().contains(stands);
    EXPECT_TRUE(is_seen) << stands.x() << " " << stands.y();
}

TEST(WindowPlace, one_of_a_larger_display_is_as_large_as_that_which_is_there) {
    Kept kept;
    kept.settings.setValue("place", QRect(0, 0, 1700, 1200)); // more than half of it is on the first
    kept.settings.setValue("maximized", false);
    const QRect stands = kept.start();
    EXPECT_TRUE(QGuiApplication::screens().front()->availableGeometry().contains(stands))
        << stands.width() << " " << stands.height();
    EXPECT_GT(stands.width(), 1200);
}

TEST(WindowPlace, where_nothing_is_kept_the_window_stays_as_it_begins) {
    QTemporaryDir folder;
    const QSettings none(folder.filePath("none.ini"), QSettings::IniFormat);
    QWidget window;
    WindowPlace place(window);
    EXPECT_FALSE(place.put_back(none));
}

} // namespace
} // namespace ghost::ui
