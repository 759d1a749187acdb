#pragma once
// SPDX-License-Identifier: Apache-2.0
// MessagePanel: what the import doctor says of the show that is open, errors first, equal ones in one line,
// each with what to do about it; a double click goes to what it is about. Window thread.

#include "ui/model/app_model.h"

#include <QTreeWidget>
#include <QWidget>

namespace ghost::ui {

class MessagePanel : public QWidget {
    Q_OBJECT
public:
    MessagePanel(AppModel& app, QWidget* parent);

private:
    void refresh();
    void go_to(const QTreeWidgetItem& item);

    AppModel& app_;
    QTreeWidget* list_;
};

} // namespace ghost::ui
