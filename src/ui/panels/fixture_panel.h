#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixturePanel: all fixtures with their patch and what they do now, a line to search in, and the selection,
// the same as in the picture. Cells of the patch are edited where they stand; what is typed goes to all that
// are selected. Window thread.

#include "ui/actions/patch_edit.h"
#include "ui/model/fixture_groups.h"

#include <QAbstractTableModel>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QWidget>

namespace ghost::ui {

class FixtureModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { name, patch, level, colour, type, mode, x, y, z, turn, kColumns };
    static constexpr int kSwatch = Qt::UserRole; // colour of the light, where there is one

    FixtureModel(AppModel& app, ShowDocument& document, QObject* parent);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    // What an edit that cannot be done says.
    std::function<void(const Error&)> complain;

private:
    void take_show();
    Result<void> edit(int column, const QString& words);

    AppModel& app_;
    ShowDocument& document_;
    int rows_ = 0;
    std::set<std::size_t> shared_; // fixtures that read a channel of another one
};

// The rows of the list, sorted; of them those of one group, if one is chosen.
class FixtureFilter : public QSortFilterProxyModel {
    Q_OBJECT
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void show_only(std::optional<std::set<std::size_t>> fixtures);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    std::optional<std::set<std::size_t>> only_;
};

class FixturePanel : public QWidget {
    Q_OBJECT
public:
    FixturePanel(AppModel& app, ShowDocument& document, QWidget* parent);
    void find() { search_->setFocus(); }
    FixtureModel& model() { return *model_; }
    QTableView* table() { return table_; }

private:
    void show_selection();
    void take_selection();
    void list_groups();
    void show_group();
    void count();

    AppModel& app_;
    QLabel* title_;
    QLineEdit* search_;
    QComboBox* group_;
    QToolButton* dark_;
    std::vector<FixtureGroup> groups_;
    QTableView* table_;
    FixtureModel* model_;
    FixtureFilter* sorted_;
    bool follows_ = false; // the table is being changed by the model
};

} // namespace ghost::ui
