#pragma once
// SPDX-License-Identifier: Apache-2.0
// AirPanel: the air of the show as its file has it: how thick the haze is, how light bounces in it, clouds
// and the wind that carries them, and a table of the hazers, whose cells are edited where they stand. What is
// changed here is an edit of the show. Window thread.

#include "ui/actions/air_edit.h"
#include "ui/panel_parts/bounce_row.h"
#include "ui/widgets/value_row.h"

#include <QComboBox>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class AirPanel : public QWidget {
    Q_OBJECT
public:
    AirPanel(AppModel& app, ShowDocument& document, Actions& actions, QWidget* parent);

    // Where what went wrong is said.
    std::function<void(const Error&)> complain;

private:
    void add_rows(QLayout* layout);
    void add_hazers(QLayout* layout, Actions& actions);
    void refresh();
    void show_haze();
    void show_hazers();
    void blow(double speed_m_s, double towards_deg);
    void edit_cell(int row, int column);
    void take(const Result<void>& done);

    AppModel& app_;
    ShowDocument& document_;
    QComboBox* haze_;
    BounceRow* bounce_;
    ValueRow *clouds_, *size_, *wind_, *towards_;
    double towards_deg_ = 0; // also while there is no wind
    QTableWidget* hazers_;
    QPushButton* remove_;
    bool follows_ = false;
};

} // namespace ghost::ui
