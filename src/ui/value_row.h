#pragma once
// SPDX-License-Identifier: Apache-2.0
// ValueRow: one number under the hand: its name, a slider, a field, and a button that gives it back to the
// show. It shows what is there until it is moved. Window thread.

#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QString>
#include <QToolButton>
#include <QWidget>

#include <functional>

namespace ghost::ui {

struct ValueRange {
    double low = 0;
    double high = 1;
    int decimals = 2;
    QString unit;          // " deg"
    bool by_ratio = false; // the slider's steps are ratios: for what spans decades; low above 0
};

class ValueRow : public QWidget {
    Q_OBJECT
public:
    // Of the names of rows, so that all of a panel begin at one place.
    static int label_width(const QWidget& widget);
    ValueRow(const QString& name, const ValueRange& range, QWidget* parent);

    // by_hand: it is set by a person; else it is only shown. Does not call back.
    void show_value(double value, bool by_hand);
    // Does not call back.
    void set_reach(double low, double high);
    std::function<void(double)> on_change; // a person moved it
    std::function<void()> on_release;      // none: there is nothing to give it back to

private:
    int to_slider(double value) const;
    double from_slider(int at) const;

    ValueRange range_;
    QLabel* label_;
    QSlider* slider_;
    QDoubleSpinBox* field_;
    QToolButton* release_;
    bool follows_ = false; // it is being set, not moved
};

} // namespace ghost::ui
