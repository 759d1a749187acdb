#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests of the window: Qt without a screen, a show of four lamps made here, and an engine that is only
// the other end of the link.

#include "show/show.h"
#include "ui/model/app_model.h"

#include <QApplication>
#include <QCoreApplication>
#include <QEventLoop>
#include <QFile>
#include <QScreen>
#include <QTemporaryDir>
#include <QTimer>
#include <QWidget>
#include <QWindow>

#include <gtest/gtest.h>

#include <memory>

namespace ghost::ui {

// One for the test binary, with two displays of which the second has two pixels to one; what they would show
// is drawn into memory. It ends with the tests and not with the process: by then Qt's own objects are gone.
class Application : public testing::Environment {
public:
    void SetUp() override {
        const QString displays = folder_.filePath("displays.json");
        QFile file(displays);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(R"({"screens": [
            {"name": "first", "x": 0, "y": 0, "width": 1280, "height": 1024, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1},
            {"name": "second", "x": 1280, "y": 0, "width": 1920, "height": 1080, "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 2}]})");
        file.close();
        ASSERT_TRUE(qputenv("QT_QPA_PLATFORM", ("offscreen:configfile=" + displays).toUtf8()));
        one_ = std::make_unique<QApplication>(argc_, argv_);
    }
    void TearDown() override { one_.reset(); }

private:
    QTemporaryDir folder_;
    int argc_ = 1;
    char name_[8] = "test_ui";
    char* argv_[2] = {name_, nullptr};
    std::unique_ptr<QApplication> one_;
};
inline testing::Environment* const kApplication = testing::AddGlobalTestEnvironment(new Application);

// Qt's platform without a display gives its windows one pixel a point on every screen, from some version on.
inline constexpr const char* kOnePixel = "this Qt's offscreen windows have one pixel a point on every screen";
inline bool windows_have_the_pixels_of_their_screen() {
    QScreen* const fine = QGuiApplication::screens().at(1);
    QWidget window;
    window.setGeometry(QRect(fine->geometry().topLeft(), QSize(10, 10)));
    window.show();
    window.windowHandle()->setScreen(fine);
    QCoreApplication::processEvents();
    return window.devicePixelRatioF() == fine->devicePixelRatio();
}

// What is posted is done, until nothing is.
inline void settle() {
    for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
}

inline void wait_ms(int time) {
    QEventLoop loop;
    QTimer::singleShot(time, &loop, &QEventLoop::quit);
    loop.exec();
}

inline Opened four_lamps() {
    auto show = std::make_shared<scene::Show>();
    show->name = "Test";
    show->file = "test/show.toml";
    scene::Camera front;
    front.name = "front";
    front.position_m = {0, -10, 2};
    front.target_m = {0, 0, 2};
    scene::Camera side = front;
    side.name = "side";
    side.position_m = {-10, 0, 3};
    show->cameras = {front, side};
    for (int i = 0; i < 4; ++i) {
        scene::PatchedFixture fixture;
        fixture.name = "Lamp " + std::to_string(i + 1);
        fixture.universe = 1;
        fixture.address = 1 + 16 * i;
        fixture.position_m = {-3.0f + 2.0f * static_cast<float>(i), 0, 4};
        show->fixtures.push_back(fixture);
    }
    Opened opened;
    opened.show = std::move(show);
    opened.objects = {{"Floor", 0, 0}, {"Wall", 1, 1}};
    opened.materials.resize(2);
    opened.materials[0].name = "wood";
    opened.materials[1].name = "paint";
    return opened;
}

inline RigNow four_lit() {
    RigNow rig;
    for (const scene::PatchedFixture& fixture : four_lamps().show->fixtures) {
        FixtureNow now;
        now.light_m = fixture.position_m;
        now.candela = 1000;
        now.colour = {1, 1, 1};
        now.dimmer = 1;
        now.asked.intensity = 0.0f; // hands light them
        rig.fixtures.push_back(now);
    }
    return rig;
}

// The other end: what the window asked for last, and news for it.
struct Bench {
    Link link;
    AppModel app{link};

    void open() {
        link.opened.put(four_lamps());
        link.rig.put(four_lit());
        link.on_news();
        settle();
    }
    void show_picture(const scene::Camera& camera, const Framed& framed = {}) {
        Picture picture;
        auto image = std::make_shared<image::Image8>(camera.width, camera.height, 4);
        for (std::size_t i = 0; i < image->samples.size(); i += 4) image->samples[i] = 200; // red
        picture.image = image;
        picture.camera = camera;
        picture.framed = framed;
        link.picture.put(std::move(picture));
        link.on_news();
        settle();
    }
};

} // namespace ghost::ui
