// SPDX-License-Identifier: Apache-2.0
// Space and Return where a button has the focus.
#include "ui/widgets/popup_keys.h"

#include <QApplication>
#include <QCheckBox>
#include <QCoreApplication>
#include <QFocusEvent>
#include <QMouseEvent>
#include <QPushButton>

#include <gtest/gtest.h>

namespace ghost::ui {
namespace {

struct Pressed {
    explicit Pressed(QAbstractButton& watched) : button(watched) {
        qApp->installEventFilter(&keys);
        QObject::connect(&button, &QAbstractButton::clicked, [this] { ++count; });
    }
    ~Pressed() { qApp->removeEventFilter(&keys); }

    void reach(Qt::FocusReason reason) {
        QFocusEvent event(QEvent::FocusIn, reason);
        QCoreApplication::sendEvent(&button, &event);
    }
    // Qt asks first whether the button wants the key, else it is the window's.
    bool press(int key) {
        QKeyEvent asks(QEvent::ShortcutOverride, key, Qt::NoModifier);
        asks.ignore();
        QCoreApplication::sendEvent(&button, &asks);
        if (!asks.isAccepted()) return false;
        for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent event(type, key, Qt::NoModifier);
            QCoreApplication::sendEvent(&button, &event);
        }
        return true;
    }

    QAbstractButton& button;
    PopupKeys keys;
    int count = 0;
};

TEST(PopupKeys, a_button_that_tab_reached_is_pressed_by_space_and_return) {
    QPushButton button("Add");
    Pressed pressed(button);
    for (const Qt::FocusReason reason : {Qt::TabFocusReason, Qt::BacktabFocusReason}) {
        pressed.count = 0;
        pressed.reach(reason);
        EXPECT_TRUE(pressed.press(Qt::Key_Space));
        EXPECT_EQ(pressed.count, 1);
        EXPECT_TRUE(pressed.press(Qt::Key_Return));
        EXPECT_EQ(pressed.count, 2);
        EXPECT_FALSE(pressed.press(Qt::Key_B)) << "the window's";
    }
}

// Qt itself hands the focus over here, which more than the button hears of.
TEST(PopupKeys, a_button_of_a_window_is_pressed_by_space_once_it_has_the_focus) {
    QWidget window;
    QPushButton first("Add", &window), second("Remove", &window);
    window.show();
    QApplication::setActiveWindow(&window);
    first.setFocus(Qt::MouseFocusReason);
    Pressed pressed(second);
    second.setFocus(Qt::TabFocusReason);
    ASSERT_EQ(QApplication::focusWidget(), &second);
    EXPECT_TRUE(pressed.press(Qt::Key_Space));
    EXPECT_EQ(pressed.count, 1);
    EXPECT_TRUE(pressed.press(Qt::Key_Return));
    EXPECT_EQ(pressed.count, 2);
}

TEST(PopupKeys, space_is_the_windows_where_the_mouse_pressed_a_button) {
    QPushButton button("Go");
    Pressed pressed(button);
    pressed.reach(Qt::MouseFocusReason);
    EXPECT_FALSE(pressed.press(Qt::Key_Space));
    EXPECT_FALSE(pressed.press(Qt::Key_Return));
    pressed.reach(Qt::TabFocusReason);
    QMouseEvent mouse(QEvent::MouseButtonPress, {1, 1}, button.mapToGlobal(QPointF(1, 1)), Qt::LeftButton,
                      Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&button, &mouse);
    EXPECT_FALSE(pressed.press(Qt::Key_Space));
    EXPECT_EQ(pressed.count, 0);
}

TEST(PopupKeys, a_button_that_stays_down_is_pressed_by_both) {
    QPushButton dark("Dark");
    dark.setCheckable(true);
    Pressed pressed(dark);
    pressed.reach(Qt::TabFocusReason);
    EXPECT_TRUE(pressed.press(Qt::Key_Return));
    EXPECT_TRUE(dark.isChecked());
    EXPECT_TRUE(pressed.press(Qt::Key_Space));
    EXPECT_FALSE(dark.isChecked());
}

TEST(PopupKeys, a_switch_is_turned_by_space_alone) {
    QCheckBox box("Follow");
    Pressed pressed(box);
    pressed.reach(Qt::TabFocusReason);
    EXPECT_TRUE(pressed.press(Qt::Key_Space));
    EXPECT_TRUE(box.isChecked());
    EXPECT_FALSE(pressed.press(Qt::Key_Return));
}

} // namespace
} // namespace ghost::ui
