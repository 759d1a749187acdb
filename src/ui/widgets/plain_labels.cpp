// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/plain_labels.h"

#include <QEvent>
#include <QLabel>

namespace ghost::ui {

bool PlainLabels::eventFilter(QObject* object, QEvent* event) {
    // Before it is shown; a tool tip is a label, too.
    if (event->type() == QEvent::Polish)
        if (auto* const label = qobject_cast<QLabel*>(object); label && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
    return QObject::eventFilter(object, event);
}

} // namespace ghost::ui
