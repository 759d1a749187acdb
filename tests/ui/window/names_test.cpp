// SPDX-License-Identifier: Apache-2.0
// What a screen reader says: every control of the window has a name. And Tab comes by every one of a panel.
#include "disk/files.h"
#include "show/show.h"
#include "support/test_window.h"
#include "ui/panels/plot_panel.h"
#include "ui/window/window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QSlider>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolTip>

#include <filesystem>
#include <utility>

namespace ghost::ui {
namespace {

bool is_control(const QWidget* widget) {
    if (qobject_cast<const QHeaderView*>(widget)) return false;
    if (widget->objectName().startsWith("qt_")) return false; // parts of Qt's own controls
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
           qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QSlider*>(widget);
}

// Of a window or dialog: how many controls, each of which has a name.
int named_controls(const QWidget& top) {
    int controls = 0;
    for (QWidget* const widget : top.findChildren<QWidget*>()) {
        // Inside of another control, or in its list, they speak for that.
        if (!is_control(widget) || widget->window() != &top ||
            (widget->parentWidget() && is_control(widget->parentWidget())))
            continue;
        ++controls;
        QAccessibleInterface* const said = QAccessible::queryAccessibleInterface(widget);
        if (!said) {
            ADD_FAILURE() << widget->metaObject()->className();
            continue;
        }
        QString path;
        for (const QWidget* one = widget; one; one = one->parentWidget())
            path += QString(one->metaObject()->className()) + " " + one->objectName() + " < ";
        EXPECT_FALSE(said->text(QAccessible::Name).isEmpty()) << path.toStdString();
        // Tab goes on to the next control, not through all cells of this one.
        const auto* const table = qobject_cast<const QAbstractItemView*>(widget);
        if (table && table->focusPolicy() != Qt::NoFocus) {
            EXPECT_FALSE(table->tabKeyNavigation()) << path.toStdString();
        }
    }
    return controls;
}

TEST(Names, every_control_has_one) {
    Link link;
    Window window(link,
                  WindowOptions{.demo = "assets/demo", .remembers = false, .width = 900, .height = 600});
    window.show();
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->folder = "test";
    opened.show = show;
    link.opened.put(std::move(opened));
    link.rig.put(four_lit());
    link.on_news();
    settle();
    window.app().select({0, 1});
    for (QDockWidget* const dock : window.findChildren<QDockWidget*>()) dock->show();
    settle();
    EXPECT_GT(named_controls(window), 60);
    const std::pair<const char*, int> kDialogs[] = {{"paperwork", 10}, {"cue-book", 10}, {"about", 1}};
    for (const auto& [name, least] : kDialogs) {
        ASSERT_TRUE(window.actions().run(name).ok()) << name;
        settle();
        QWidget* dialog = nullptr;
        for (QWidget* const one : QApplication::topLevelWidgets())
            if (one->isVisible() && qobject_cast<QDialog*>(one)) dialog = one;
        ASSERT_TRUE(dialog) << name;
        EXPECT_GE(named_controls(*dialog), least) << name;
        dialog->close();
        settle();
    }
}

// A person who quits is asked what shall be with changes; a script is not, for what is not saved is kept.
TEST(Closing, asks_where_something_is_not_saved) {
    QTemporaryDir place;
    const std::filesystem::path file = std::filesystem::path(place.path().toStdString()) / "show.toml";
    ASSERT_TRUE(write_file_atomic(file, "[show]\nname = \"Test\"\n").ok());
    Link link;
    Window window(link, WindowOptions{.remembers = false, .width = 900, .height = 600});
    window.show();
    Opened opened = four_lamps();
    auto show = std::make_shared<scene::Show>(*opened.show);
    show->folder = file.parent_path();
    show->file = file;
    opened.show = show;
    link.opened.put(std::move(opened));
    link.rig.put(four_lit());
    link.on_news();
    settle();
    window.actions().choose("haze 0.05");
    settle();
    ASSERT_TRUE(window.isWindowModified());
    // Over at once, but nobody has seen that yet.
    window.app().jobs().start("Bake", {"--gtest_filter=no.test"});
    window.actions().choose("quit");
    auto* const box = window.findChild<QMessageBox*>();
    ASSERT_TRUE(box);
    EXPECT_TRUE(box->informativeText().contains("1 job of Export ends with the window"))
        << box->informativeText().toStdString();
    settle();
    EXPECT_TRUE(window.isVisible());
    for (QAbstractButton* const button : box->buttons())
        if (box->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    settle();
    EXPECT_FALSE(window.isVisible());
    EXPECT_NE(read_text_file(file, 1 << 20)->find("[haze]"), std::string::npos);
}

// They come from files and networks.
TEST(Names, mark_up_in_them_is_words_in_the_window_and_its_tool_tips) {
    const QString name = "<b>Spot</b> <img src='file:///etc/passwd'>";
    Link link;
    Window window(link, WindowOptions{.remembers = false, .width = 900, .height = 600});
    window.show();
    QToolTip::showText({10, 10}, name, &window);
    int tips = 0;
    for (QWidget* const widget : QApplication::topLevelWidgets()) {
        if (!widget->inherits("QTipLabel")) continue;
        ++tips;
        EXPECT_EQ(static_cast<QLabel*>(widget)->textFormat(), Qt::PlainText);
    }
    EXPECT_EQ(tips, 1);
    QToolTip::hideText();
    for (const QLabel* const label : window.statusBar()->findChildren<QLabel*>())
        EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->text().toStdString();
}

// Tags are drawn, not shown.
TEST(Names, about_is_words) {
    Link link;
    Window window(link, WindowOptions{.remembers = false, .width = 900, .height = 600});
    window.show();
    ASSERT_TRUE(window.actions().run("about").ok());
    settle();
    auto* const about = window.findChild<QMessageBox*>();
    ASSERT_TRUE(about && about->isVisible());
    for (const QLabel* const label : about->findChildren<QLabel*>())
        EXPECT_FALSE(label->textFormat() == Qt::PlainText && label->text().contains("<p>"));
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
