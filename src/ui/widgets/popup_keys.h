#pragma once
// SPDX-License-Identifier: Apache-2.0
// PopupKeys: a key that an open list or menu had is not a key of ours as well. A list closes when Qt asks
// whether anybody overrides the shortcut, so nothing is open any more when it looks for one. Nor are the keys
// that open the list of a combo box that has the focus: Space, and Alt with up or down; nor Space and Return
// where the keyboard reached a button. Window thread.

#include <QAbstractButton>
#include <QKeyEvent>
#include <QObject>
#include <QPointer>

namespace ghost::ui {

class PopupKeys : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override; // of the application

private:
    void follow_focus(QObject* object, const QEvent& event);
    bool presses(const QObject* object, const QKeyEvent& key) const;

    QPointer<QAbstractButton> reached_; // by the keyboard, and has the focus
    bool popup_had_it_ = false;         // the key that is on its way
};

} // namespace ghost::ui
