// SPDX-License-Identifier: Apache-2.0
// What a screen reader says: every control of the window has a name.
#include "support/test_window.h"
#include "ui/window/window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenuBar>
#include <QSlider>

namespace ghost::ui {
namespace {

bool is_control(const QWidget* widget) {
    if (qobject_cast<const QHeaderView*>(widget)) return false;
    if (widget->objectName().startsWith("qt_")) return false; // parts of Qt's own controls
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QSlider*>(widget);
}

TEST(Names, every_control_has_one) {
    Link link;
    Window window(link,
                  WindowOptions{.demo = "assets/demo", .remembers = false, .width = 900, .height = 600});
    window.show();
    link.opened.put(four_lamps());
    link.rig.put(four_lit());
    link.on_news();
    settle();
    window.app().select({0, 1});
    for (QDockWidget* const dock : window.findChildren<QDockWidget*>()) dock->show();
    settle();
    int controls = 0;
    for (QWidget* const widget : window.findChildren<QWidget*>()) {
        // Inside of another control, or in its list, they speak for that.
        if (!is_control(widget) || widget->window() != &window ||
            (widget->parentWidget() && is_control(widget->parentWidget())))
            continue;
        ++controls;
        QAccessibleInterface* const said = QAccessible::queryAccessibleInterface(widget);
        ASSERT_TRUE(said);
        QString path;
        for (const QWidget* one = widget; one; one = one->parentWidget())
            path += QString(one->metaObject()->className()) + " " + one->objectName() + " < ";
        EXPECT_FALSE(said->text(QAccessible::Name).isEmpty()) << path.toStdString();
    }
    EXPECT_GT(controls, 60);
}

} // namespace
} // namespace ghost::ui
