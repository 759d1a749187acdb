// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/popup_keys.h"

#include <QApplication>
#include <QEvent>

#include <utility>

namespace ghost::ui {

// Qt sends ShortcutOverride, then either Shortcut or KeyPress.
bool PopupKeys::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && QApplication::activePopupWidget()) popup_had_it_ = true;
    if (event->type() == QEvent::KeyPress) popup_had_it_ = false;
    return event->type() == QEvent::Shortcut && std::exchange(popup_had_it_, false);
}

} // namespace ghost::ui
