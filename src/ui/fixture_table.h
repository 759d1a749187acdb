#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixtureTable: the table of the fixture list. A double click edits all rows that were selected: its first
// click alone would have left one of them. Window thread.

#include <QMouseEvent>
#include <QTableView>

namespace ghost::ui {

class FixtureTable : public QTableView {
public:
    using QTableView::QTableView;

protected:
    void mousePressEvent(QMouseEvent* event) override {
        before_ = selectionModel()->selection();
        QTableView::mousePressEvent(event);
    }
    void mouseDoubleClickEvent(QMouseEvent* event) override {
        if (event->modifiers() == Qt::NoModifier && before_.contains(indexAt(event->position().toPoint())))
            selectionModel()->select(before_, QItemSelectionModel::ClearAndSelect);
        QTableView::mouseDoubleClickEvent(event);
    }

private:
    QItemSelection before_; // the first click
};

} // namespace ghost::ui
