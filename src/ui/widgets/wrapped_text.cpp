// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/wrapped_text.h"

#include <QHeaderView>

#include <algorithm>

namespace ghost::ui {

WrappedText::WrappedText(QTreeView* tree) : QStyledItemDelegate(tree), tree_(*tree) {
    connect(tree->header(), &QHeaderView::sectionResized, tree, &QTreeView::doItemsLayout,
            Qt::QueuedConnection);
}

QSize WrappedText::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    if (const QVariant own = index.data(Qt::SizeHintRole); own.isValid()) return own.toSize();
    int depth = tree_.rootIsDecorated() ? 1 : 0;
    for (QModelIndex above = index.parent(); above.isValid(); above = above.parent()) ++depth;
    const int margin = 2 * (tree_.style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1) +
                       (index.column() == 0 ? depth * tree_.indentation() : 0);
    const int width = std::max(tree_.columnWidth(index.column()) - margin, 1);
    QFont font = option.font;
    if (const QVariant own = index.data(Qt::FontRole); own.isValid()) font = qvariant_cast<QFont>(own);
    const QRect words =
        QFontMetrics(font).boundingRect(QRect(0, 0, width, 10000), Qt::TextWordWrap, index.data().toString());
    return {width, words.height() + 4};
}

} // namespace ghost::ui
