#pragma once
// SPDX-License-Identifier: Apache-2.0
// HandPanel: the selected fixtures under the hand, beside DMX: intensity, colour, zoom, pan, tilt, gobo. What
// is moved is set for all of them; what is not moved stays the desk's. Window thread.

#include "ui/colour_row.h"
#include "ui/studio.h"
#include "ui/value_row.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace ghost::ui {

class HandPanel : public QWidget {
    Q_OBJECT
public:
    HandPanel(Studio& studio, QWidget* parent);

private:
    ValueRow* add_row(const QString& name, const ValueRange& range, int kind,
                      std::optional<float> fixture::Manual::*value, double per_unit);
    void refresh();
    void set_reach(ValueRow& row, fixture::Role role, const fixture::Reach& otherwise);
    void take_kinds();

    Studio& studio_;
    QLabel* title_;
    ValueRow *intensity_, *zoom_, *pan_, *tilt_;
    ColourRow* colour_;
    QComboBox* gobo_;
    QPushButton* release_;
};

} // namespace ghost::ui
