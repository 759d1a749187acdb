// SPDX-License-Identifier: Apache-2.0
// What a screen reader says: every control of the window has a name. And Tab comes by every one of a panel.
#include "support/test_window.h"
#include "ui/panels/plot_panel.h"
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

// Down the panel, not criss-cross: each next one that can be typed to or pressed lies below the one before,
// or beside it on its right.
TEST(Names, tab_goes_down_each_panel) {
    Link link;
    Window window(link, WindowOptions{.remembers = false, .width = 1400, .height = 900});
    window.show();
    link.opened.put(four_lamps());
    link.rig.put(four_lit());
    link.on_news();
    settle();
    window.app().select({0, 1});
    for (const char* const name : {"plot", "looks", "scene", "export"}) {
        ASSERT_TRUE(window.actions().run(QString("panel-%1 on").arg(name)).ok());
        settle();
        // The page of the plot is made on a thread of its own.
        for (int i = 0; i < 100 && !window.findChild<PlotPanel*>()->isEnabled(); ++i) wait_ms(50);
        auto* const dock = window.findChild<QDockWidget*>(name);
        QWidget* first = dock;
        std::vector<QWidget*> in_order;
        for (QWidget* one = first->nextInFocusChain(); one != first; one = one->nextInFocusChain())
            if (dock->isAncestorOf(one) && is_control(one) && one->isVisible() && one->isEnabled() &&
                (one->focusPolicy() & Qt::TabFocus) && !is_control(one->parentWidget()))
                in_order.push_back(one);
        ASSERT_FALSE(in_order.empty()) << name;
        for (std::size_t i = 1; i < in_order.size(); ++i) {
            const QPoint before = in_order[i - 1]->mapTo(dock, QPoint(0, 0)),
                         now = in_order[i]->mapTo(dock, QPoint(0, 0));
            EXPECT_TRUE(now.y() > before.y() - 8 || now.x() > before.x())
                << name << ": " << in_order[i - 1]->accessibleName().toStdString() << " "
                << in_order[i - 1]->metaObject()->className() << " -> "
                << in_order[i]->accessibleName().toStdString() << " "
                << in_order[i]->metaObject()->className();
        }
    }
}

} // namespace
} // namespace ghost::ui
