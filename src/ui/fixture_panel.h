#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixturePanel: all fixtures with their patch and what they do now, a line to search in, and the selection,
// the same as in the picture. Window thread.

#include "ui/studio.h"

#include <QAbstractTableModel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QWidget>

namespace ghost::ui {

class FixtureModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { name, patch, level, colour, type, mode, kColumns };

    FixtureModel(Studio& studio, QObject* parent);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    Studio& studio_;
    std::set<std::size_t> shared_; // fixtures that read a channel of another one
};

class FixturePanel : public QWidget {
    Q_OBJECT
public:
    FixturePanel(Studio& studio, QWidget* parent);
    void find() { search_->setFocus(); }

private:
    void show_selection();
    void take_selection();

    Studio& studio_;
    QLineEdit* search_;
    QTableView* table_;
    FixtureModel* model_;
    QSortFilterProxyModel* sorted_;
    bool follows_ = false; // the table is being changed by the studio
};

} // namespace ghost::ui
