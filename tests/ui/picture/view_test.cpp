// SPDX-License-Identifier: Apache-2.0
// The picture and the mouse in it, without a screen: what is clicked is selected, what is dragged moves, and
// a picture of another size fills the window until the right one comes.
#include "support/test_picture.h"
#include "ui/picture/overlays.h"

#include "show/camera_moves.h"
#include "show/show.h"

#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QWheelEvent>
#include <QWindow>

namespace ghost::ui {
namespace {

TEST(View, asks_for_pictures_of_its_own_size) {
    Watched watched;
    EXPECT_EQ(watched.bench.app.camera().width, 320);
    EXPECT_EQ(watched.bench.app.camera().height, 180);
    EXPECT_EQ(watched.bench.app.camera().position_m, four_lamps().show->cameras[0].position_m);
}

// Labels of all of them would hide the picture.
TEST(View, of_many_selected_heads_there_are_rings_alone) {
    for (const std::size_t count : {std::size_t{12}, std::size_t{200}}) {
        scene::Show show;
        show.fixtures.resize(count);
        RigNow rig;
        std::set<std::size_t> selection;
        for (std::size_t i = 0; i < count; ++i) {
            show.fixtures[i].name = "Spot " + std::to_string(i);
            FixtureNow now;
            now.light_m = {0.4f * static_cast<float>(i % 20) - 4, 0, 0.4f * static_cast<float>(i / 20)};
            rig.fixtures.push_back(now);
            selection.insert(i);
        }
        scene::Camera camera;
        camera.position_m = {0, -12, 2};
        camera.target_m = {0, 0, 2};
        camera.width = 640;
        camera.height = 360;
        const auto painted = [&](bool names) {
            QImage image(640, 360, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            OverlayChoice choice;
            choice.marks = true;
            choice.names = choice.addresses = names;
            paint_fixtures(painter, {QRectF(0, 0, 640, 360), camera, rig, selection}, show, {}, choice);
            return image;
        };
        EXPECT_EQ(painted(true) == painted(false), count > 40) << count;
    }
}

TEST(View, a_click_selects_the_lamp_and_beside_it_nothing) {
    Watched watched;
    watched.click(watched.lamp(2) + QPointF(3, -2));
    EXPECT_EQ(watched.bench.app.selection(), std::set<std::size_t>{2});
    watched.click(watched.lamp(0), Qt::ControlModifier);
    EXPECT_EQ(watched.bench.app.selection(), (std::set<std::size_t>{0, 2}));
    watched.click(watched.lamp(2), Qt::ControlModifier);
    EXPECT_EQ(watched.bench.app.selection(), std::set<std::size_t>{0});
    watched.click({5, 175});
    EXPECT_TRUE(watched.bench.app.selection().empty());
}

// A mouse that rests on a head asks why it is dark, one that passes or is gone does not.
TEST(View, the_sentence_about_a_head_is_asked_for_where_the_mouse_rests_and_seen_beside_it) {
    Watched watched;
    AppModel& app = watched.bench.app;
    watched.mouse(QEvent::MouseMove, watched.lamp(1), Qt::NoButton);
    watched.mouse(QEvent::MouseMove, {5, 175}, Qt::NoButton);
    wait_ms(250);
    EXPECT_FALSE(app.request().hovered);
    watched.mouse(QEvent::MouseMove, watched.lamp(1), Qt::NoButton);
    for (int i = 0; i < 100 && !app.request().hovered; ++i) wait_ms(25);
    ASSERT_EQ(app.request().hovered, 1u);
    settle();
    const QImage before = watched.view.grab().toImage();
    Explained other;
    other.fixture = 2; // late, of another one
    other.explanation.fixture = app.show()->fixtures[2].name;
    other.explanation.verdict = "dark";
    watched.bench.link.hovered.put(other);
    watched.bench.link.on_news();
    settle();
    EXPECT_FALSE(app.hovered());
    Explained explained;
    explained.fixture = 1;
    explained.explanation.fixture = app.show()->fixtures[1].name;
    explained.explanation.verdict =
        "dark: its shutter is closed, for the function 'Closed' (DMX 3-5) is active on channel 11 (1.055)";
    watched.bench.link.hovered.put(explained);
    watched.bench.link.on_news();
    settle();
    ASSERT_TRUE(app.hovered());
    EXPECT_NE(watched.view.grab().toImage(), before) << "more words beside the lamp";
    watched.mouse(QEvent::MouseMove, {5, 175}, Qt::NoButton);
    EXPECT_FALSE(app.request().hovered);
    EXPECT_FALSE(app.hovered());
    EXPECT_FALSE(app.selection().contains(1)) << "and nothing is selected by it";
}

TEST(View, a_box_selects_all_in_it) {
    Watched watched;
    watched.drag(watched.lamp(1) - QPointF(8, 8), watched.lamp(3) + QPointF(8, 8), Qt::LeftButton,
                 Qt::ControlModifier);
    EXPECT_EQ(watched.bench.app.selection(), (std::set<std::size_t>{1, 2, 3}));
}

TEST(View, a_box_before_the_first_picture_selects_what_will_be_in_it) {
    Bench bench;
    View view(bench.app, nullptr);
    view.resize(320, 180);
    view.show();
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->cameras.front().position_m = {4, -12, 5}; // not where a camera stands by default
    opened.show = std::move(show);
    bench.link.opened.put(std::move(opened)); // no rig and no picture yet
    bench.link.on_news();
    settle();
    ASSERT_FALSE(bench.app.picture().image);
    const auto at = [&](std::size_t index) {
        scene::Camera camera = bench.app.camera();
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
    EXPECT_EQ(bench.app.selection(), (std::set<std::size_t>{1, 2, 3}));
}

TEST(View, another_scale_of_the_display_asks_for_other_pixels) {
    if (!windows_have_the_pixels_of_their_screen()) GTEST_SKIP() << kOnePixel;
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
    EXPECT_EQ(watched.bench.app.camera().width, 640);
    EXPECT_EQ(watched.bench.app.camera().height, 360);
}

TEST(View, drags_and_the_wheel_move_the_camera) {
    Watched watched;
    AppModel& app = watched.bench.app;
    const scene::Camera start = app.camera();
    watched.drag({50, 150}, {100, 150}, Qt::LeftButton);
    EXPECT_EQ(app.camera().target_m, start.target_m);
    EXPECT_GT(glm::distance(app.camera().position_m, start.position_m), 1);
    app.set_camera(start);
    watched.drag({50, 150}, {100, 150}, Qt::RightButton);
    EXPECT_EQ(app.camera().position_m, start.position_m);
    EXPECT_GT(glm::distance(app.camera().target_m, start.target_m), 0.5f);
    app.set_camera(start);
    watched.drag({50, 150}, {100, 120}, Qt::MiddleButton);
    // What was grabbed stays under the hand.
    const auto seen = scene::project(app.camera(), start.target_m);
    EXPECT_NEAR(seen->at.x, 0.5f + 50.0f / 320, 1e-3f);
    EXPECT_NEAR(seen->at.y, 0.5f - 30.0f / 180, 1e-3f);
    app.set_camera(start);
    QWheelEvent wheel({160, 90}, {160, 90}, {}, {0, 120}, {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&watched.view, &wheel);
    EXPECT_LT(glm::distance(app.camera().position_m, start.target_m),
              glm::distance(start.position_m, start.target_m));
    EXPECT_TRUE(app.selection().empty());
}

// Two quick clicks that turn the camera or bring up a menu are no wish to go anywhere.
TEST(View, a_double_click_of_another_button_than_the_left_chooses_nothing) {
    Watched watched;
    AppModel& app = watched.bench.app;
    for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton}) {
        for (const QPointF& at : {watched.lamp(1), QPointF(5, 175)}) {
            const std::uint64_t picks = app.request().pick.number;
            watched.mouse(QEvent::MouseButtonPress, at, button);
            watched.mouse(QEvent::MouseButtonRelease, at, button);
            watched.mouse(QEvent::MouseButtonDblClick, at, button);
            EXPECT_FALSE(app.travels());
            EXPECT_EQ(app.request().pick.number, picks);
            const scene::Camera before = app.camera();
            watched.mouse(QEvent::MouseMove, at + QPointF(20, 0), button);
            EXPECT_NE(app.camera().target_m, before.target_m) << "and its second press drags";
            watched.mouse(QEvent::MouseButtonRelease, at + QPointF(20, 0), button);
            app.set_camera(before);
        }
    }
    watched.mouse(QEvent::MouseButtonDblClick, watched.lamp(1), Qt::LeftButton);
    EXPECT_TRUE(app.travels());
}

TEST(View, a_smaller_picture_fills_the_window) {
    Watched watched;
    scene::Camera coarse = watched.bench.app.camera();
    coarse.width = 80;
    coarse.height = 45;
    watched.bench.show_picture(coarse);
    watched.view.overlays = {.figures = false, .marks = false};
    const QImage shown = watched.view.grab().toImage();
    for (const QPoint at : {QPoint(2, 2), QPoint(317, 2), QPoint(160, 90), QPoint(2, 177), QPoint(317, 177)})
        EXPECT_NEAR(qRed(shown.pixel(at)), 200, 2) << at.x() << " " << at.y();
}

// Where the corners of a camera's own frame, 10 m away, lie in the view.
std::vector<QPointF> corners_of_frame(Watched& watched) {
    const scene::Camera& stored = watched.bench.app.show()->cameras.front();
    const float up_m = 10 * std::tan(glm::radians(stored.fov_y_deg) / 2);
    const float right_m = up_m * static_cast<float>(stored.width) / static_cast<float>(stored.height);
    const Picture& picture = watched.bench.app.picture();
    const QRectF place = picture_rect(watched.view.size(), picture.camera, picture.framed);
    std::vector<QPointF> corners;
    for (const glm::vec2 side : {glm::vec2(-1, 1), glm::vec2(1, -1)})
        corners.push_back(*to_widget(place, picture.camera, {side.x * right_m, 0, 2 + side.y * up_m}));
    return corners;
}

// The camera of a show is as wide as a stage; the window is not.
TEST(View, all_that_a_stored_camera_frames_is_seen_in_a_window_of_any_shape) {
    Watched watched;
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->cameras.front().width = 1024;
    show->cameras.front().height = 300;
    opened.show = std::move(show);
    watched.bench.link.opened.put(std::move(opened));
    watched.bench.link.on_news();
    settle();
    const AppModel& app = watched.bench.app;
    for (const QSize size : {QSize(280, 336), QSize(800, 160), QSize(320, 180)}) {
        watched.view.resize(size);
        wait_ms(300);
        EXPECT_EQ(app.request().frame, glm::ivec2(1024, 300));
        const auto show_at = [&](double share) { // as the engine draws it
            const scene::Camera& whole = app.camera();
            scene::Camera camera = scene::with_frame(whole, app.request().frame);
            camera.height = static_cast<int>(std::lround(share * camera.height));
            camera.width = (camera.height * whole.width + whole.height - 1) / whole.height;
            watched.bench.show_picture(
                camera, {app.request().frame, scene::share_of_frame(whole, app.request().frame)});
        };
        const QRectF frame = frame_rect(size, app.request().frame);
        EXPECT_TRUE(QRectF(QPointF(0, 0), size).adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(frame));
        EXPECT_TRUE(frame.width() > size.width() - 1e-6 || frame.height() > size.height() - 1e-6);
        for (const double share : {0.25, 0.5, 1.0}) {
            show_at(share);
            const auto corners = corners_of_frame(watched);
            for (const auto& [corner, there] :
                 {std::pair(frame.topLeft(), corners[0]), std::pair(frame.bottomRight(), corners[1])})
                EXPECT_LT(QLineF(corner, there).length(), 0.1)
                    << size.width() << "x" << size.height() << " at " << share << ": " << there.x() << " "
                    << there.y();
        }
    }
    watched.view.overlays = {.figures = false, .frame = false};
    const QImage plain = watched.view.grab().toImage();
    watched.view.overlays = {.figures = false};
    EXPECT_NE(watched.view.grab().toImage(), plain) << "the frame is a line";
}

TEST(View, a_picture_of_another_shape_is_shown_whole) {
    Watched watched;
    watched.view.overlays = {.figures = false, .marks = false, .frame = false};
    scene::Camera baked = watched.bench.app.camera();
    baked.width = 640;
    baked.height = 180; // 320x90 of the view
    watched.bench.show_picture(baked);
    const QImage shown = watched.view.grab().toImage();
    for (const QPoint in : {QPoint(2, 90), QPoint(317, 90), QPoint(160, 48), QPoint(160, 131)})
        EXPECT_NEAR(qRed(shown.pixel(in)), 200, 2) << in.x() << " " << in.y();
    for (const QPoint beside : {QPoint(160, 40), QPoint(160, 140), QPoint(2, 2)})
        EXPECT_EQ(qRed(shown.pixel(beside)), 0) << beside.x() << " " << beside.y();
}

// Three of four pixels would be left out by the painter.
TEST(View, a_much_finer_picture_is_averaged) {
    Watched watched;
    watched.view.overlays = {.figures = false, .marks = false, .frame = false};
    scene::Camera fine = watched.bench.app.camera();
    fine.width = 1280;
    fine.height = 720;
    auto stripes = std::make_shared<image::Image8>(fine.width, fine.height, 4);
    for (std::size_t i = 0; i < stripes->samples.size(); ++i)
        stripes->samples[i] = i / 4 % 4 == 1 ? 240 : 0; // every fourth column
    Picture picture;
    picture.image = stripes;
    picture.camera = fine;
    watched.bench.link.picture.put(std::move(picture));
    watched.bench.link.on_news();
    settle();
    const QImage shown = watched.view.grab().toImage();
    for (int x = 20; x < 300; x += 7) EXPECT_NEAR(qRed(shown.pixel(x, 90)), 60, 8) << x;
}

TEST(View, latency_counts_from_the_first_change_that_a_picture_shows) {
    Watched watched;
    (void)watched.view.grab(); // painted
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    for (const std::chrono::milliseconds age :
         {std::chrono::milliseconds(800), std::chrono::milliseconds(5)}) {
        Picture picture = watched.bench.app.picture();
        picture.arrival = now - age;
        watched.bench.link.picture.put(std::move(picture)); // the second before the first is painted
        watched.bench.link.on_news();
        QCoreApplication::sendPostedEvents(&watched.bench.app);
    }
    (void)watched.view.grab();
    EXPECT_GE(watched.view.figures().latency_ms(), 800);
    EXPECT_EQ(watched.bench.app.latency().count(), 1u);
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
    watched.bench.app.select({0});
    EXPECT_NE(watched.view.grab().toImage(), plain);
}

TEST(View, latency_says_nothing_of_packets_while_time_stands_still) {
    Watched watched;
    const auto show_one_of = [&](std::chrono::seconds age) {
        Picture picture = watched.bench.app.picture();
        picture.arrival = std::chrono::steady_clock::now().time_since_epoch() - age;
        watched.bench.link.picture.put(std::move(picture));
        watched.bench.link.on_news();
        settle();
        (void)watched.view.grab();
    };
    const auto words = [&] { return watched.view.figures().lines().join('\n'); };
    show_one_of(std::chrono::seconds(1));
    EXPECT_TRUE(words().contains("packet to window 1")) << words().toStdString();
    watched.bench.app.change_request([](ViewRequest& request) { request.frozen = true; });
    show_one_of(std::chrono::seconds(9));
    EXPECT_TRUE(words().contains("frozen")) << words().toStdString();
    EXPECT_FALSE(words().contains("packet to window 1"));
    EXPECT_EQ(watched.bench.app.latency().count(), 1u);
    watched.bench.app.change_request([](ViewRequest& request) { request.frozen = false; });
    show_one_of(std::chrono::seconds(2));
    EXPECT_TRUE(words().contains("packet to window 2")) << words().toStdString();
}

TEST(View, figures_say_the_pace_while_it_moves_and_rest_when_it_does_not) {
    Watched watched;
    const scene::Camera camera = watched.bench.app.camera();
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

TEST(View, a_window_without_a_show_says_so) {
    Bench bench;
    View view(bench.app, nullptr);
    view.resize(320, 180);
    const QImage shown = view.grab().toImage();
    QImage empty = shown;
    empty.fill(shown.pixelColor(0, 0));
    EXPECT_NE(shown, empty);
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
