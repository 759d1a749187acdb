#pragma once
// SPDX-License-Identifier: Apache-2.0
// PanelArea: what a dock holds, so that a tall or wide panel does not make the window so: it scrolls where
// the dock is smaller than the panel needs. A plain QScrollArea gives a panel with wrapped words the height
// that it would like to have, and so a second bar beside that of the list in it. Window thread.

#include <QScrollArea>

namespace ghost::ui {

class PanelArea : public QScrollArea {
    Q_OBJECT
public:
    PanelArea(QWidget* panel, QWidget* parent);
    QSize sizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();
};

} // namespace ghost::ui
