#pragma once
// SPDX-License-Identifier: Apache-2.0
// BounceRow: how finely light bounces in the show, with what that costs beside it, or with a bar while its
// links are made, which can be cancelled. Window thread.

#include "ui/actions/bounce_edit.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class BounceRow : public QWidget {
    Q_OBJECT
public:
    BounceRow(AppModel& app, ShowDocument& document, QWidget* parent);

    // After each edit, with what went wrong.
    std::function<void(const Result<void>&)> on_done;

    // What the show says.
    void show_detail(scene::BounceDetail detail);

private:
    void show_state();

    AppModel& app_;
    QComboBox* detail_;
    QLabel* state_;
    QProgressBar* bar_;
    QPushButton* cancel_;
};

} // namespace ghost::ui
