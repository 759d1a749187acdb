#pragma once
// SPDX-License-Identifier: Apache-2.0
// WrappedText: rows of a tree as high as their words need in columns as wide as they are; trees alone ask for
// one line. An item with a size hint of its own keeps it. Window thread.

#include <QStyledItemDelegate>
#include <QTreeView>

namespace ghost::ui {

class WrappedText : public QStyledItemDelegate {
    Q_OBJECT
public:
    // Lays the tree out again when its columns change.
    explicit WrappedText(QTreeView* tree);
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const QTreeView& tree_;
};

} // namespace ghost::ui
