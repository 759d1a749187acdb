#pragma once
// SPDX-License-Identifier: Apache-2.0
// ParameterRow: one parameter of heads under the hand: its name, a slider over the whole channel, what it
// means there, which is also the list of all that it can mean, and a button that gives it back. Window
// thread.

#include "ui/model/head_parameters.h"
#include "ui/widgets/slot_picture.h"
#include "ui/widgets/value_row.h"

#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class ParameterRow : public QWidget {
    Q_OBJECT
public:
    ParameterRow(const HeadParameter& parameter, SlotPictures& pictures, QWidget* parent);
    // Does not call back.
    void show_value(const ParameterValue& value, bool mixed);
    std::function<void(float share)> on_change; // a person moved it
    // Where heads differ, see ValueRow::on_mixed_drag.
    std::function<void(float from, float to, bool begins)> on_mixed_drag;
    std::function<void()> on_refresh;
    std::function<void()> on_release;

protected:
    void resizeEvent(QResizeEvent*) override { lines_.fit(); }

private:
    QLabel* label_;
    QSlider* slider_;
    QToolButton* meaning_;
    QToolButton* release_;
    RowLines lines_;
    bool follows_ = false; // it is being set, not moved
    MixedDrag drag_;
};

} // namespace ghost::ui
