#pragma once
// SPDX-License-Identifier: Apache-2.0
// TransportPanel: the show's recording: play, pause, jump, loop, and which input is shown; black-out and
// master. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"
#include "ui/panel_parts/waveform.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QWidget>

namespace ghost::ui {

class TransportPanel : public QWidget {
    Q_OBJECT
public:
    // actions: has "play", "to-start" and "black-out".
    TransportPanel(AppModel& app, const Actions& actions, QWidget* parent);

private:
    void refresh();

    AppModel& app_;
    Waveform* place_;
    QLabel* time_;
    QAction* play_;
    QComboBox* input_;
    QSlider* master_;
};

} // namespace ghost::ui
