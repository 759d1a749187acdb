// SPDX-License-Identifier: Apache-2.0
// Ctrl+Z and Ctrl+Shift+Z where something else than the picture has the focus.
#include "support/test_window.h"

#include "ui/widgets/undo_keys.h"
#include "ui/window/window.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSlider>

namespace ghost::ui {
namespace {

// Qt asks so whether a widget wants the key for itself, before it looks for a shortcut.
bool keeps(QWidget& widget, int key, Qt::KeyboardModifiers modifiers) {
    QKeyEvent event(QEvent::ShortcutOverride, key, modifiers);
    event.ignore();
    QCoreApplication::sendEvent(&widget, &event);
    return event.isAccepted();
}

bool keeps_undo(QWidget& widget) {
    const bool undo = keeps(widget, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(keeps(widget, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier), undo);
    return undo;
}

void type(QWidget& widget, int key, const QString& text = {}) {
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, text);
    QCoreApplication::sendEvent(&widget, &event);
}

TEST(UndoKeys, no_control_of_the_window_keeps_undo_for_itself) {
    Link link;
    Window window(link, {.remembers = false, .width = 900, .height = 600});
    window.show();
    link.opened.put(four_lamps());
    link.rig.put(four_lit());
    link.on_news();
    settle();
    int fields = 0;
    for (QWidget* const one : window.findChildren<QWidget*>()) {
        const bool is_field = qobject_cast<QAbstractSpinBox*>(one) || qobject_cast<QLineEdit*>(one);
        if (!is_field && !qobject_cast<QComboBox*>(one) && !qobject_cast<QAbstractItemView*>(one) &&
            !qobject_cast<QSlider*>(one))
            continue;
        fields += is_field ? 1 : 0;
        EXPECT_FALSE(keeps_undo(*one))
            << one->metaObject()->className() << " " << one->accessibleName().toStdString();
    }
    EXPECT_GT(fields, 10);
}

TEST(UndoKeys, what_is_typed_and_not_entered_is_undone_in_its_field) {
    UndoKeys keys;
    qApp->installEventFilter(&keys);
    QDoubleSpinBox number;
    QComboBox list;
    list.setEditable(true);
    QLineEdit text;
    for (QWidget* const one : std::initializer_list<QWidget*>{&number, &list, &text}) {
        SCOPED_TRACE(one->metaObject()->className());
        EXPECT_FALSE(keeps_undo(*one));
        type(*one, Qt::Key_7, "7");
        EXPECT_TRUE(keeps_undo(*one));
        type(*one, Qt::Key_Return);
        EXPECT_FALSE(keeps_undo(*one)) << "entered";
        EXPECT_TRUE(keeps(*one, Qt::Key_A, Qt::ControlModifier)) << "any other key is its own";
    }
    number.stepUp();
    EXPECT_FALSE(keeps_undo(number));
}

// Who clicked an arrow has its field under the keys, and typed nothing there.
TEST(UndoKeys, letters_are_the_windows_where_a_number_has_the_keys_and_is_not_being_typed) {
    UndoKeys keys;
    qApp->installEventFilter(&keys);
    QDoubleSpinBox number;
    QLineEdit text;
    QComboBox list;
    list.setEditable(true);
    for (const int key : {Qt::Key_B, Qt::Key_K, Qt::Key_R, Qt::Key_Space}) {
        EXPECT_FALSE(keeps(number, key, Qt::NoModifier)) << key;
        EXPECT_FALSE(keeps(number, key, Qt::ShiftModifier)) << key;
        EXPECT_TRUE(keeps(text, key, Qt::NoModifier)) << "a text has letters";
        EXPECT_TRUE(keeps(list, key, Qt::NoModifier)) << "so has a list that is typed in";
    }
    EXPECT_TRUE(keeps(number, Qt::Key_7, Qt::NoModifier));
    EXPECT_TRUE(keeps(number, Qt::Key_Minus, Qt::NoModifier));
    type(number, Qt::Key_7, "7");
    EXPECT_TRUE(keeps(number, Qt::Key_K, Qt::NoModifier)) << "it is being typed";
    type(number, Qt::Key_Return);
    EXPECT_FALSE(keeps(number, Qt::Key_K, Qt::NoModifier));
}

// K is the work light's again, and letters fly.
TEST(UndoKeys, a_number_that_is_entered_gives_the_keys_back_to_the_picture) {
    Link link;
    Window window(link, {.remembers = false, .width = 900, .height = 600});
    window.show();
    link.opened.put(four_lamps());
    link.rig.put(four_lit());
    link.on_news();
    settle();
    window.app().select({0});
    settle();
    auto* const number = window.findChild<QDockWidget*>("programmer")->findChild<QAbstractSpinBox*>();
    ASSERT_TRUE(number);
    number->setFocus();
    ASSERT_EQ(window.focusWidget(), number);
    number->selectAll();
    type(*number, Qt::Key_5, "5");
    settle();
    EXPECT_EQ(window.focusWidget(), number) << "it is being typed";
    type(*number, Qt::Key_Return);
    settle();
    EXPECT_EQ(window.focusWidget(), window.centralWidget());
    EXPECT_TRUE(window.app().look().fixtures.contains(0)) << "and it is taken";
}

} // namespace
} // namespace ghost::ui
