// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/transport_panel.h"

#include "ui/language/language.h"

#include <QHBoxLayout>
#include <QToolButton>

#include <cmath>

namespace ghost::ui {
namespace {

QString clock_of(double seconds) {
    const int tenths = static_cast<int>(std::floor(seconds * 10));
    return QString("%1:%2.%3").arg(tenths / 600).arg(tenths / 10 % 60, 2, 10, QChar('0')).arg(tenths % 10);
}

QToolButton* button_of(QAction* action, const QString& text, QWidget* parent) {
    auto* button = new QToolButton(parent);
    action->setIconText(text); // shorter than the menu's
    button->setDefaultAction(action);
    button->setToolTip(action->text() + " (" + action->shortcut().toString(QKeySequence::NativeText) + ")");
    button->setFocusPolicy(Qt::NoFocus);
    return button;
}

} // namespace

TransportPanel::TransportPanel(AppModel& app, const Actions& actions, QWidget* parent)
    : QWidget(parent), app_(app) {
    place_ = new Waveform(app_, this);
    time_ = new QLabel(this);
    time_->setMinimumWidth(fontMetrics().averageCharWidth() * 17);
    input_ = new QComboBox(this);
    input_->setAccessibleName(translated("Transport", "Input"));
    input_->setFocusPolicy(Qt::NoFocus);
    input_->setMinimumWidth(fontMetrics().averageCharWidth() * 12); // a narrow window cuts its words
    input_->addItems({translated("Transport", "Desk, else recording"), translated("Transport", "Desk"),
                      translated("Transport", "Recording")});
    master_ = new QSlider(Qt::Horizontal, this);
    master_->setRange(0, 100);
    master_->setMinimumWidth(fontMetrics().averageCharWidth() * 8);
    master_->setMaximumWidth(fontMetrics().averageCharWidth() * 16);
    master_->setAccessibleName(translated("Transport", "Master"));
    master_->setToolTip(translated("Transport", "Master: all light"));
    master_->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->addWidget(button_of(actions.item("to-start"), "|\u25C0", this));
    play_ = actions.item("play");
    layout->addWidget(button_of(play_, "\u25B6", this));
    layout->addWidget(place_, 1);
    layout->addWidget(time_);
    layout->addWidget(input_);
    layout->addWidget(new QLabel(translated("Transport", "Master"), this));
    layout->addWidget(master_);
    layout->addWidget(button_of(actions.item("black-out"), translated("Transport", "Black-out"), this));
    connect(input_, &QComboBox::activated, this, [this](int index) {
        app_.change_request([&](ViewRequest& request) { request.input = static_cast<Input>(index); });
    });
    connect(master_, &QSlider::valueChanged, this, [this](int percent) {
        const float share = static_cast<float>(percent) / 100.0f;
        if (std::lround(app_.request().master * 100) != percent)
            app_.change_request([&](ViewRequest& request) { request.master = share; });
    });
    for (const auto signal : {&AppModel::rig_came, &AppModel::request_changed})
        connect(&app_, signal, this, &TransportPanel::refresh);
    refresh();
}

void TransportPanel::refresh() {
    play_->setIconText(app_.request().transport.playing ? "\u275A\u275A" : "\u25B6"); // what it will do
    const double length_s = app_.rig().recording_s;
    place_->setEnabled(length_s > 0 && !app_.rig().from_desk);
    const bool is_driven = app_.rig().from_desk && !app_.rig().universes.list.empty();
    time_->setText(is_driven      ? translated("Transport", "desk")
                   : length_s > 0 ? clock_of(app_.moment_s()) + " / " + clock_of(length_s)
                                  : translated("Transport", "no recording"));
    input_->setCurrentIndex(static_cast<int>(app_.request().input));
    master_->setValue(static_cast<int>(std::lround(app_.request().master * 100)));
}

} // namespace ghost::ui
