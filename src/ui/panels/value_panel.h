#pragma once
// SPDX-License-Identifier: Apache-2.0
// ValuePanel: the current fixture, live: each channel with its DMX value, what that means, and a bar; above
// them why it shines or not (diagnose/explain.h), below the whole explanation in words. Window thread.

#include "ui/model/app_model.h"

#include <QAbstractTableModel>
#include <QLabel>
#include <QTableView>
#include <QTextBrowser>
#include <QWidget>

namespace ghost::ui {

class ChannelModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { address, attribute, value, meaning, by_hand, kColumns };
    static constexpr int kShare = Qt::UserRole; // of the bar behind the value, 0..1

    explicit ChannelModel(QObject* parent) : QAbstractTableModel(parent) {}
    // programmer: what hands set of the fixture.
    void show(const scene::Explanation& explanation, const fixture::Programmer& programmer);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<scene::ChannelFacts> channels_;
    fixture::Programmer programmer_;
};

class ValuePanel : public QWidget {
    Q_OBJECT
public:
    ValuePanel(AppModel& app, QWidget* parent);

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void refresh();

    AppModel& app_;
    QLabel* title_;
    QLabel* verdict_;
    ChannelModel* model_;
    QTableView* table_;
    QTextBrowser* words_;
    std::string shown_words_;
};

} // namespace ghost::ui
