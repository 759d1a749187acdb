#pragma once
// SPDX-License-Identifier: Apache-2.0
// UndoKeys: undo and redo are the window's also where a field of one line has the focus (a number, an
// editable list), which would take them for its own text, and so are letters and the space bar where that is
// a number of a panel. It keeps them only while something is typed in it that was not entered. A number that
// is entered gives the keys back. Window thread.

#include <QObject>

class QWidget;

namespace ghost::ui {

class UndoKeys : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

Q_SIGNALS:
    // Return in a number, before the number has it; not in a table or a dialog.
    void entered(QWidget* field);

protected:
    bool eventFilter(QObject* object, QEvent* event) override; // of the application
};

} // namespace ghost::ui
