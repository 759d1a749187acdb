#pragma once
// SPDX-License-Identifier: Apache-2.0
// ExportPanel: bakes, stills, films and contact sheets to be started, and what runs in the background with
// its progress, to be watched and cancelled. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QWidget>

#include <map>

namespace ghost::ui {

class ExportPanel : public QWidget {
    Q_OBJECT
public:
    // Buttons run actions, so that what goes wrong is said where it is for keys.
    ExportPanel(AppModel& app, Actions& actions, QWidget* parent);

    // Whether a job can begin now; says itself why not. Asked before a file is.
    std::function<bool()> can_begin;

private:
    // A job in the list.
    struct Row {
        QWidget* widget;
        QLabel* words;
        QProgressBar* bar;
        QPushButton* cancel;
    };

    QWidget* make_bake();
    QWidget* make_pictures();
    void run(const QString& line);
    void run_with_file(const QString& action, const FileQuestion& asks, const QString& arguments);
    void name_cameras();
    void show_jobs();
    Row add_row(const Job& job);

    AppModel& app_;
    Actions& actions_;
    QComboBox *bake_camera_, *camera_, *size_;
    QComboBox *bake_by_, *film_by_; // this machine, or a farm
    QSpinBox *spp_, *bounces_, *fps_;
    QDoubleSpinBox *from_, *to_;
    QVBoxLayout* list_;
    std::map<int, Row> rows_; // by number of the job
};

} // namespace ghost::ui
