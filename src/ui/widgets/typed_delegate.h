#pragma once
// SPDX-License-Identifier: Apache-2.0
// TypedDelegate: what is being typed in a cell of a list stays there when the list tells of other changes: a
// mark of another colour would bring the old text back. Window thread.

#include <QLineEdit>
#include <QStyledItemDelegate>

namespace ghost::ui {

class TypedDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        const auto* const field = qobject_cast<const QLineEdit*>(editor);
        const bool stays =
            field && (field->isModified() || field->text() == index.data(Qt::EditRole).toString());
        if (!stays) QStyledItemDelegate::setEditorData(editor, index);
    }
};

} // namespace ghost::ui
