#pragma once
// SPDX-License-Identifier: Apache-2.0
// PopupKeys: a key that an open list or menu had is not a key of ours as well. A list closes when Qt asks
// whether anybody overrides the shortcut, so nothing is open any more when it looks for one. Nor are the keys
// that open the list of a combo box that has the focus: Space, and Alt with up or down. Window thread.

#include <QObject>

namespace ghost::ui {

class PopupKeys : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* object, QEvent* event) override; // of the application

private:
    bool popup_had_it_ = false; // the key that is on its way
};

} // namespace ghost::ui
