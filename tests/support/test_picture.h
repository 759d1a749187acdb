#pragma once
// SPDX-License-Identifier: Apache-2.0
// For tests of the picture and the mouse in it: a view of four lamps, 320x180 pixels, that is looked at and
// touched as by a person.
#include "support/test_window.h"
#include "ui/picture/overlays.h"
#include "ui/picture/view.h"

#include <QMouseEvent>

namespace ghost::ui {

struct Watched {
    Watched() {
        view.resize(320, 180);
        view.show();
        bench.open();
        scene::Camera camera = bench.app.camera();
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
        const Picture& picture = bench.app.picture();
        return *to_widget(picture_rect(view.size(), picture.camera), picture.camera,
                          bench.app.rig().fixtures[index].light_m);
    }

    Bench bench;
    View view{bench.app, nullptr};
};

} // namespace ghost::ui
