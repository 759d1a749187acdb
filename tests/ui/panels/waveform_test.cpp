// SPDX-License-Identifier: Apache-2.0
// The recording below the picture: which button goes to a place of it.
#include "support/test_window.h"
#include "ui/panel_parts/waveform.h"

#include <QMouseEvent>

namespace ghost::ui {
namespace {

TEST(Waveform, the_left_button_goes_there_and_no_other) {
    Bench bench;
    bench.open();
    RigNow rig = four_lit();
    rig.recording_s = 60;
    bench.link.rig.put(std::move(rig));
    bench.link.on_news();
    settle();
    Waveform waveform(bench.app, nullptr);
    waveform.resize(600, 30);
    const auto click = [&](Qt::MouseButton button, Qt::KeyboardModifiers with) {
        for (const auto& [type, held] : {std::pair{QEvent::MouseButtonPress, Qt::MouseButtons(button)},
                                         {QEvent::MouseButtonRelease, {}}}) {
            QMouseEvent event(type, QPointF(300, 10), QPointF(300, 10), button, held, with);
            QCoreApplication::sendEvent(&waveform, &event);
        }
    };
    bench.app.change_request([](ViewRequest& request) {
        request.transport.loop_from_s = 10;
        request.transport.loop_to_s = 20;
    });
    const Transport before = bench.app.request().transport;
    for (const Qt::MouseButton button : {Qt::RightButton, Qt::MiddleButton})
        for (const auto with : {Qt::NoModifier, Qt::ShiftModifier}) {
            click(button, with);
            EXPECT_EQ(bench.app.request().transport, before);
        }
    click(Qt::LeftButton, Qt::NoModifier);
    EXPECT_EQ(bench.app.request().transport.seeks, before.seeks + 1);
    EXPECT_NEAR(bench.app.request().transport.at_s, 30, 0.1);
}

} // namespace
} // namespace ghost::ui
