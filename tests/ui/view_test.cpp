// SPDX-License-Identifier: Apache-2.0
// The picture and the mouse in it, without a screen: what is clicked is selected, what is dragged moves, and
// a picture of another size fills the window until the right one comes.
#include "test_window.h"
#include "ui/overlays.h"
#include "ui/view.h"

#include "scene/camera_moves.h"

#include <QMouseEvent>
#include <QScreen>
#include <QWheelEvent>
#include <QWindow>

namespace ghost::ui {
namespace {

struct Watched {
    Watched() {
        view.resize(320, 180);
        view.show();
        bench.open();
        scene::Camera camera = bench.studio.camera();
        camera.width = 320;
        camera.height = 180;
        bench.show_picture(camera);
    }
    void mouse(QEvent::Type type, const QPointF& at, Qt::MouseButton button,
               Qt::KeyboardModifiers keys = {}) {
        QMouseEvent event(type, at, view.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button), keys);
        QCoreApplication::sendEvent(&view, &event);
    }
    void click(const QPointF& at, Qt::KeyboardModifiers keys = {}) {
        mouse(QEvent::MouseButtonPress, at, Qt::LeftButton, keys);
        mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton, keys);
    }
    void drag(const QPointF& from, const QPointF& to, Qt::MouseButton button,
              Qt::KeyboardModifiers keys = {}) {
        mouse(QEvent::MouseButtonPress, from, button, keys);
        mouse(QEvent::MouseMove, (from + to) / 2, button, keys);
        mouse(QEvent::MouseMove, to, button, keys);
        mouse(QEvent::MouseButtonRelease, to, button, keys);
    }
    QPointF lamp(std::size_t index) {
        const Picture& picture = bench.studio.picture();
        return *to_widget(picture_rect(view.size(), picture.camera), picture.camera,
                          bench.studio.rig().fixtures[index].light_m);
    }

    Bench bench;
    View view{bench.studio, nullptr};
};

TEST(View, asks_for_pictures_of_its_own_size) {
    Watched watched;
    EXPECT_EQ(watched.bench.studio.camera().width, 320);
    EXPECT_EQ(watched.bench.studio.camera().height, 180);
    EXPECT_EQ(watched.bench.studio.camera().position_m, four_lamps().show->cameras[0].position_m);
}

TEST(View, a_click_selects_the_lamp_and_beside_it_nothing) {
    Watched watched;
    watched.click(watched.lamp(2) + QPointF(3, -2));
    EXPECT_EQ(watched.bench.studio.selection(), std::set<std::size_t>{2});
    watched.click(watched.lamp(0), Qt::ControlModifier);
    EXPECT_EQ(watched.bench.studio.selection(), (std::set<std::size_t>{0, 2}));
    watched.click(watched.lamp(2), Qt::ControlModifier);
    EXPECT_EQ(watched.bench.studio.selection(), std::set<std::size_t>{0});
    watched.click({5, 175});
    EXPECT_TRUE(watched.bench.studio.selection().empty());
}

TEST(View, a_box_selects_all_in_it) {
    Watched watched;
    watched.drag(watched.lamp(1) - QPointF(8, 8), watched.lamp(3) + QPointF(8, 8), Qt::LeftButton,
                 Qt::ControlModifier);
    EXPECT_EQ(watched.bench.studio.selection(), (std::set<std::size_t>{1, 2, 3}));
}

TEST(View, a_box_before_the_first_picture_selects_what_will_be_in_it) {
    Bench bench;
    View view(bench.studio, nullptr);
    view.resize(320, 180);
    view.show();
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->cameras.front().position_m = {4, -12, 5}; // not where a camera stands by default
    opened.show = std::move(show);
    bench.link.opened.put(std::move(opened)); // no rig and no picture yet
    bench.link.on_news();
    settle();
    ASSERT_FALSE(bench.studio.picture().image);
    const auto at = [&](std::size_t index) {
        scene::Camera camera = bench.studio.camera();
        return *to_widget(picture_rect(view.size(), camera), camera,
                          four_lamps().show->fixtures[index].position_m);
    };
    const auto mouse = [&](QEvent::Type type, const QPointF& place) {
        QMouseEvent event(
            type, place, view.mapToGlobal(place), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
            type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::ControlModifier);
        QCoreApplication::sendEvent(&view, &event);
    };
    const QPointF from = at(1) - QPointF(8, 8), to = at(3) + QPointF(8, 8);
    mouse(QEvent::MouseButtonPress, from);
    mouse(QEvent::MouseMove, (from + to) / 2);
    mouse(QEvent::MouseMove, to);
    const QImage shown = view.grab().toImage();
    EXPECT_GT(qRed(shown.pixel(((from + to) / 2).toPoint())),
              qBlue(shown.pixel(((from + to) / 2).toPoint())) + 10)
        << "the box is seen while it is drawn";
    mouse(QEvent::MouseButtonRelease, to);
    EXPECT_EQ(bench.studio.selection(), (std::set<std::size_t>{1, 2, 3}));
}

TEST(View, another_scale_of_the_display_asks_for_other_pixels) {
    Watched watched;
    QScreen* const fine = QGuiApplication::screens().at(1);
    ASSERT_EQ(fine->devicePixelRatio(), 2);
    wait_ms(300); // it rests
    watched.view.windowHandle()->setScreen(fine);
    settle();
    ASSERT_EQ(watched.view.devicePixelRatioF(), 2);
    ASSERT_EQ(watched.view.size(), QSize(320, 180)) << "the window keeps its size";
    watched.view.update();
    wait_ms(400);
    EXPECT_EQ(watched.bench.studio.camera().width, 640);
    EXPECT_EQ(watched.bench.studio.camera().height, 360);
}

TEST(View, drags_and_the_wheel_move_the_camera) {
    Watched watched;
    Studio& studio = watched.bench.studio;
    const scene::Camera start = studio.camera();
    watched.drag({50, 150}, {100, 150}, Qt::LeftButton);
    EXPECT_EQ(studio.camera().target_m, start.target_m);
    EXPECT_GT(glm::distance(studio.camera().position_m, start.position_m), 1);
    studio.set_camera(start);
    watched.drag({50, 150}, {100, 150}, Qt::RightButton);
    EXPECT_EQ(studio.camera().position_m, start.position_m);
    EXPECT_GT(glm::distance(studio.camera().target_m, start.target_m), 0.5f);
    studio.set_camera(start);
    watched.drag({50, 150}, {100, 120}, Qt::MiddleButton);
    // What was grabbed stays under the hand.
    const auto seen = scene::project(studio.camera(), start.target_m);
    EXPECT_NEAR(seen->at.x, 0.5f + 50.0f / 320, 1e-3f);
    EXPECT_NEAR(seen->at.y, 0.5f - 30.0f / 180, 1e-3f);
    studio.set_camera(start);
    QWheelEvent wheel({160, 90}, {160, 90}, {}, {0, 120}, {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&watched.view, &wheel);
    EXPECT_LT(glm::distance(studio.camera().position_m, start.target_m),
              glm::distance(start.position_m, start.target_m));
    EXPECT_TRUE(studio.selection().empty());
}

TEST(View, a_smaller_picture_fills_the_window) {
    Watched watched;
    scene::Camera coarse = watched.bench.studio.camera();
    coarse.width = 80;
    coarse.height = 45;
    watched.bench.show_picture(coarse);
    watched.view.overlays = {.figures = false, .marks = false};
    const QImage shown = watched.view.grab().toImage();
    for (const QPoint at : {QPoint(2, 2), QPoint(317, 2), QPoint(160, 90), QPoint(2, 177), QPoint(317, 177)})
        EXPECT_NEAR(qRed(shown.pixel(at)), 200, 2) << at.x() << " " << at.y();
}

TEST(View, overlays_are_seen_and_go_away) {
    Watched watched;
    watched.view.overlays = {.figures = false};
    const QImage plain = watched.view.grab().toImage();
    watched.view.overlays = {.figures = false, .names = true};
    EXPECT_NE(watched.view.grab().toImage(), plain);
    watched.view.overlays = {.figures = false, .aims = true};
    EXPECT_NE(watched.view.grab().toImage(), plain);
    watched.view.overlays = {.figures = true};
    EXPECT_NE(watched.view.grab().toImage(), plain);
    watched.view.overlays = {.figures = false};
    EXPECT_EQ(watched.view.grab().toImage(), plain);
    watched.bench.studio.select({0});
    EXPECT_NE(watched.view.grab().toImage(), plain);
}

TEST(View, figures_say_the_pace_while_it_moves_and_rest_when_it_does_not) {
    Watched watched;
    const scene::Camera camera = watched.bench.studio.camera();
    for (int i = 0; i < 30; ++i) {
        wait_ms(50);
        watched.bench.show_picture(camera);
    }
    const Figures& figures = watched.view.figures();
    EXPECT_TRUE(figures.lines().front().contains("pictures/s")) << figures.lines().front().toStdString();
    EXPECT_GT(figures.pictures_per_s(), 2);
    EXPECT_LE(figures.pictures_per_s(), 20);
    wait_ms(figures.rest_ms() + 50);
    EXPECT_TRUE(figures.lines().front().startsWith("at rest")) << figures.lines().front().toStdString();
    watched.bench.show_picture(camera);
    EXPECT_FALSE(figures.lines().front().contains("pictures/s")) << "the rest was no frame";
}

TEST(View, a_window_without_a_show_says_what_to_do) {
    Bench bench;
    View view(bench.studio, nullptr);
    view.resize(320, 180);
    const QImage bare = view.grab().toImage();
    view.hint = "Drop a show here";
    EXPECT_NE(view.grab().toImage(), bare);
}

TEST(View, nothing_is_too_small_or_too_far) {
    scene::Camera camera;
    camera.width = camera.height = 1;
    const RigNow rig = four_lit();
    for (const QSizeF size : {QSizeF(0, 0), QSizeF(1, 1), QSizeF(16000, 9000)}) {
        const QRectF rect = picture_rect(size, camera);
        fixture_at(rect, camera, rig, {0, 0});
        fixtures_in(rect, camera, rig, rect);
        EXPECT_EQ(rect.height(), size.height());
    }
    EXPECT_FALSE(to_widget({0, 0, 100, 100}, camera, camera.position_m));
}

} // namespace
} // namespace ghost::ui
