#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixtureTable: the table of the fixture list. A double click edits all rows that were selected: its first
// click alone would have left one of them. Window thread.

#include <QKeyEvent>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QTableView>

#include <algorithm>

namespace ghost::ui {

class FixtureTable : public QTableView {
public:
    using QTableView::QTableView;
    // Whether a hand chooses beside what was chosen, with Ctrl; while the selection changes.
    bool adds() const { return adds_; }

protected:
    bool viewportEvent(QEvent* event) override {
        if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseMove ||
            event->type() == QEvent::MouseButtonRelease)
            adds_ = static_cast<QMouseEvent*>(event)->modifiers() & Qt::ControlModifier;
        const bool is_taken = QTableView::viewportEvent(event);
        adds_ = false;
        return is_taken;
    }
    void keyPressEvent(QKeyEvent* event) override {
        adds_ = event->key() == Qt::Key_Space && event->modifiers() & Qt::ControlModifier;
        QTableView::keyPressEvent(event);
        adds_ = false;
    }
    void mousePressEvent(QMouseEvent* event) override {
        before_ = selectionModel()->selection();
        QTableView::mousePressEvent(event);
    }
    void mouseDoubleClickEvent(QMouseEvent* event) override {
        if (event->modifiers() == Qt::NoModifier && before_.contains(indexAt(event->position().toPoint())))
            selectionModel()->select(before_, QItemSelectionModel::ClearAndSelect);
        QTableView::mouseDoubleClickEvent(event);
    }

    // Name, patch and light are seen whole, the name with all the room that is left.
    void resizeEvent(QResizeEvent* event) override {
        constexpr int kSeen = 4; // columns; the swatch is the last of them
        QTableView::resizeEvent(event);
        if (model() == nullptr || model()->columnCount() < kSeen) return;
        int others_px = 0;
        for (int column = 1; column < kSeen; ++column) others_px += columnWidth(column);
        setColumnWidth(0, std::max(viewport()->width() - others_px, 12 * fontMetrics().averageCharWidth()));
    }

private:
    QItemSelection before_; // the first click
    bool adds_ = false;
};

} // namespace ghost::ui
