#pragma once
// SPDX-License-Identifier: Apache-2.0
// FixtureList: the rows of the fixture list, one for each fixture of the show in its order, with the patch
// and what it does now, and FixtureFilter: which of them are listed, and in which order. Metres and degrees
// of the show; colours linear Rec.2020. What is typed in a cell goes to `edit`. Window thread.

#include "ui/model/app_model.h"

#include <QAbstractTableModel>
#include <QCollator>
#include <QSortFilterProxyModel>

#include <functional>
#include <optional>
#include <set>

namespace ghost::ui {

// "1.005", of a channel from 1.
QString address_words(int universe, int channel);

class FixtureList : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { name, patch, level, colour, type, mode, x, y, z, turn, kColumns };
    enum Role {
        kIsWrong = Qt::UserRole, // bool
        kIsByHand,               // bool: the programmer has it
        kLight,                  // glm::vec3, the colour of the light, where there is one
        kOrder,                  // double or text: what rows are sorted by
        kTyped                   // to be set: as Qt::EditRole, by a person who typed what stood there already
    };

    FixtureList(AppModel& app, QObject* parent);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    // Changes this of all that are selected; false: it cannot be done.
    std::function<bool(Column column, const QString& words)> edit;

private:
    void take_show();
    bool others_have_else(const QModelIndex& index) const; // of what is selected with it

    AppModel& app_;
    int rows_ = 0;
    std::set<std::size_t> shared_; // fixtures that read a channel of another one
};

// The rows of the list, sorted; of them those of one group, if one is chosen.
class FixtureFilter : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit FixtureFilter(QObject* parent);
    void show_only(std::optional<std::set<std::size_t>> fixtures);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    std::optional<std::set<std::size_t>> only_;
    QCollator collator_{QLocale(QLocale::English)}; // C's knows no numbers
};

} // namespace ghost::ui
