// SPDX-License-Identifier: Apache-2.0
// The wheel over what has a value, with and without the focus.
#include "support/test_window.h"

#include "ui/widgets/wheel_guard.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSlider>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace ghost::ui {
namespace {

bool turn_wheel(QWidget& over) {
    const QPointF middle = over.rect().center();
    QWheelEvent event(middle, over.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&over, &event);
    return event.isAccepted();
}

TEST(WheelGuard, what_has_no_focus_keeps_its_value) {
    WheelGuard guard;
    qApp->installEventFilter(&guard);
    QWidget panel;
    auto* layout = new QVBoxLayout(&panel);
    auto *first = new QSlider(Qt::Horizontal), *slider = new QSlider(Qt::Horizontal);
    auto* number = new QDoubleSpinBox;
    auto* list = new QComboBox;
    list->addItems({"open", "gobo 1", "gobo 2"});
    list->setCurrentIndex(1);
    number->setValue(50);
    slider->setValue(50);
    for (QWidget* one : std::initializer_list<QWidget*>{first, slider, number, list}) layout->addWidget(one);
    panel.show();
    panel.activateWindow();
    settle();
    first->setFocus();
    for (QWidget* one : std::initializer_list<QWidget*>{slider, number, list}) {
        EXPECT_FALSE(turn_wheel(*one)) << one->metaObject()->className();
        EXPECT_FALSE(one->hasFocus()) << one->metaObject()->className();
        EXPECT_NE(one->focusPolicy(), Qt::WheelFocus);
    }
    EXPECT_EQ(slider->value(), 50);
    EXPECT_EQ(number->value(), 50);
    EXPECT_EQ(list->currentIndex(), 1);
    ASSERT_TRUE(panel.isActiveWindow());
    slider->setFocus();
    EXPECT_TRUE(turn_wheel(*slider));
    EXPECT_NE(slider->value(), 50);
}

} // namespace
} // namespace ghost::ui
