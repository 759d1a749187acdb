#pragma once
// SPDX-License-Identifier: Apache-2.0
// PlotPanel: what the plot has: fixture files that give no light, each with what could stand in and a button
// that takes it, then what is missing, guessed, found and odd. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/plot_report.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

namespace ghost::ui {

class PlotPanel : public QWidget {
    Q_OBJECT
public:
    PlotPanel(AppModel& app, const PlotReport& report, Actions& actions, QWidget* parent);

private:
    void fill();
    QTreeWidgetItem* add_section(const QString& title, const QColor& colour);
    QTreeWidgetItem* add(QTreeWidgetItem& below, const QString& words,
                         const std::vector<std::size_t>& fixtures);
    void add_lightless(QTreeWidgetItem& section, const scene::LightlessType& type);
    void add_groups(const QString& title, Severity severity, const QColor& colour);
    void select_these();
    void refresh();

    AppModel& app_;
    const PlotReport& report_;
    Actions& actions_;
    QLabel* title_;
    QTreeWidget* tree_;
    QPushButton *same_, *select_, *copy_, *save_;
};

} // namespace ghost::ui
