// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/panel_rail.h"

#include "ui/language/language.h"
#include "ui/window/private/panel_icons.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLayout>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kNarrowBelow_px = 1340; // a display of 1366 less the frame of a window still has columns
constexpr int kIcon_px = 16;

} // namespace

PanelRail::PanelRail(QMainWindow& window)
    : QToolBar(translated("Panel", "Panels"), &window), window_(window) {
    setObjectName("rail");
    setMovable(false);
    setIconSize(QSize(kIcon_px, kIcon_px));
    layout()->setContentsMargins(2, 1, 2, 1); // all buttons find room on a display of 768 pixels at scale 2
    layout()->setSpacing(0);
    toggleViewAction()->setVisible(false); // the window's width says whether it is there
    window.addToolBar(Qt::LeftToolBarArea, this);
    window.installEventFilter(this);
    hide();
}

void PanelRail::add(QDockWidget& panel) {
    panels_.push_back(&panel);
    connect(&panel, &QDockWidget::visibilityChanged, this, [this, &panel] {
        if (!is_narrow_ || !is_beside(panel)) return;
        for (QDockWidget* const other : panels_)
            if (other != &panel && is_beside(*other)) other->hide();
    });
}

void PanelRail::add_button(const QString& panel, QAction& toggle) {
    toggle.setIcon(panel_icon(panel));
    toggle.setIconVisibleInMenu(false);
    const QString key = toggle.shortcut().toString(QKeySequence::NativeText);
    toggle.setToolTip(key.isEmpty() ? toggle.text() : QString("%1 (%2)").arg(toggle.text(), key));
    auto* const button = new QToolButton(this);
    button->setDefaultAction(&toggle);
    button->setAutoRaise(true);
    addWidget(button);
}

void PanelRail::make_room(QDockWidget& panel) {
    if (!is_beside(panel) || std::find(had_room_.begin(), had_room_.end(), &panel) != had_room_.end()) return;
    const bool is_below = window_.dockWidgetArea(&panel) == Qt::BottomDockWidgetArea;
    if (!is_narrow_ && !is_below) return;
    had_room_.push_back(&panel);
    window_.layout()->activate();
    if (is_below) {
        const int most_px = window_.height() * (is_narrow_ ? 45 : 30) / 100;
        if (panel.height() > most_px) window_.resizeDocks({&panel}, {most_px}, Qt::Vertical);
    } else {
        window_.resizeDocks({&panel}, {std::clamp(window_.width() * 30 / 100, 300, 320)}, Qt::Horizontal);
    }
}

void PanelRail::wait_for_show(bool waits) {
    if (std::exchange(waits_, waits) == waits) return;
    if (waits_)
        take_away();
    else if (!is_narrow_ && !window_.isFullScreen())
        bring_back();
    show_where_due();
}

void PanelRail::leave_full_screen() {
    if (!is_narrow_ && !waits_) bring_back();
}

void PanelRail::fit() {
    if (!window_.isFullScreen()) set_narrow(window_.width() < kNarrowBelow_px);
    show_where_due();
}

void PanelRail::show_where_due() {
    setVisible(is_narrow_ && !waits_ && !window_.isFullScreen());
}

void PanelRail::put_back() {
    window_.removeEventFilter(this);
    waits_ = is_narrow_ = false;
    bring_back();
}

void PanelRail::set_narrow(bool narrow) {
    if (std::exchange(is_narrow_, narrow) == narrow) return;
    if (is_narrow_)
        take_away();
    else if (!waits_)
        bring_back();
}

void PanelRail::take_away() {
    in_front_.clear();
    for (QDockWidget* const one : panels_)
        if (!one->visibleRegion().isEmpty() || (!window_.isVisible() && one->objectName() == "programmer"))
            in_front_.push_back(one);
    for (QDockWidget* const one : panels_) {
        if (!is_beside(*one)) continue;
        away_.push_back(one);
        one->hide();
    }
}

void PanelRail::bring_back() {
    if (away_.empty()) return;
    for (QDockWidget* const one : std::exchange(away_, {})) one->show();
    for (QDockWidget* const one : in_front_) one->raise();
    Q_EMIT came_back();
}

// Also before the window is shown.
bool PanelRail::is_beside(const QDockWidget& panel) const {
    return !panel.isHidden() && !panel.isFloating();
}

QDockWidget* PanelRail::open_panel() const {
    if (!is_narrow_) return nullptr;
    const auto open = std::find_if(panels_.begin(), panels_.end(),
                                   [this](const QDockWidget* one) { return is_beside(*one); });
    return open == panels_.end() ? nullptr : *open;
}

// Esc closes what is open before it means anything else.
bool PanelRail::eventFilter(QObject* object, QEvent* event) {
    if (object != &window_) return false;
    if (event->type() == QEvent::Resize) fit();
    if (event->type() == QEvent::WindowStateChange) show_where_due(); // its size comes later
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    const auto* const key = static_cast<QKeyEvent*>(event);
    QDockWidget* const panel = open_panel();
    if (key->key() != Qt::Key_Escape || key->modifiers() != Qt::NoModifier || !panel) return false;
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        if (panel->isAncestorOf(QApplication::focusWidget())) window_.centralWidget()->setFocus();
        panel->hide();
    }
    return true;
}

} // namespace ghost::ui
