#pragma once
// SPDX-License-Identifier: Apache-2.0
// Waveform: the recording from its begin to its end, how much changes when, and where it is played. A click
// or drag goes there, with Shift it marks what is played again and again. Window thread.

#include "ui/model/app_model.h"

#include <QWidget>

namespace ghost::ui {

class Waveform : public QWidget {
    Q_OBJECT
public:
    Waveform(AppModel& app, QWidget* parent);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;

private:
    double second_at(double x) const;
    double x_of(double second) const;
    void seek(double second);
    void loop_to(double second);

    AppModel& app_;
    bool marks_ = false;
    double mark_from_s_ = 0;
};

} // namespace ghost::ui
