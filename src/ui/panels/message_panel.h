#pragma once
// SPDX-License-Identifier: Apache-2.0
// MessagePanel: what the import doctor says of the show that is open, errors first, equal ones in one line,
// each with what to do about it; a double click goes to what it is about. Window thread.

#include "ui/model/studio.h"

#include <QTreeWidget>
#include <QWidget>

namespace ghost::ui {

class MessagePanel : public QWidget {
    Q_OBJECT
public:
    MessagePanel(Studio& studio, QWidget* parent);

private:
    void refresh();
    void go_to(const QTreeWidgetItem& item);

    Studio& studio_;
    QTreeWidget* list_;
};

} // namespace ghost::ui
