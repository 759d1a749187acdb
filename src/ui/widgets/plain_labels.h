#pragma once
// SPDX-License-Identifier: Apache-2.0
// Labels and tool tips show names from files and networks. Qt looks in them for mark-up, which could hide
// words, show others and open pictures; with this filter on the application they are plain, unless one says
// that it is rich. Window thread.

#include <QObject>

namespace ghost::ui {

class PlainLabels : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    bool eventFilter(QObject* object, QEvent* event) override;
};

} // namespace ghost::ui
