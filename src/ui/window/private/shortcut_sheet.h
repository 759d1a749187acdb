#pragma once
// SPDX-License-Identifier: Apache-2.0
// ShortcutSheet: all keys on one page, from the table of actions, and what the mouse does. Window thread.

#include "ui/actions/actions.h"

#include <QDialog>

namespace ghost::ui {

class ShortcutSheet : public QDialog {
    Q_OBJECT
public:
    ShortcutSheet(const Actions& actions, QWidget* parent);
};

} // namespace ghost::ui
