// SPDX-License-Identifier: Apache-2.0
#include "ui/panel_parts/bounce_row.h"

#include "ui/language/language.h"
#include "ui/widgets/value_row.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace ghost::ui {

BounceRow::BounceRow(AppModel& app, ShowDocument& document, QWidget* parent) : QWidget(parent), app_(app) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    detail_ = new QComboBox(this);
    detail_->setAccessibleName(translated("Bounced light", "Bounced light"));
    detail_->setToolTip(
        translated("Bounced light",
                   "Light that surfaces and haze send on. The finer, the longer its links take to make, "
                   "once for a stage, and each change of light to solve."));
    for (const char* const name : scene::kBounceDetails) detail_->addItem(said(name));
    connect(detail_, &QComboBox::activated, this, [this, &document](int index) {
        const Result<void> done = set_bounce(app_, document, static_cast<scene::BounceDetail>(index));
        if (on_done) on_done(done);
    });
    auto* label = new QLabel(translated("Bounced light", "Bounced light"), this);
    label->setFixedWidth(ValueRow::label_width(*this));
    label->setBuddy(detail_);
    auto* line = new QHBoxLayout;
    line->addWidget(label);
    line->addWidget(detail_, 1);
    layout->addLayout(line);
    state_ = new QLabel(this);
    state_->setWordWrap(true);
    layout->addWidget(state_);
    bar_ = new QProgressBar(this);
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setAccessibleName(translated("Bounced light", "Links of bounced light"));
    cancel_ = new QPushButton(this);
    connect(cancel_, &QPushButton::clicked, this,
            [this] { stop_bounce(app_, app_.bounce().state == BounceNow::State::makes_links); });
    auto* making = new QHBoxLayout;
    making->addWidget(bar_, 1);
    making->addWidget(cancel_);
    layout->addLayout(making);
    connect(&app_, &AppModel::bounce_came, this, &BounceRow::show_state);
    show_state();
}

void BounceRow::show_detail(scene::BounceDetail detail) {
    detail_->setCurrentIndex(static_cast<int>(detail));
}

void BounceRow::show_state() {
    const BounceNow& bounce = app_.bounce();
    const bool makes_links = bounce.state == BounceNow::State::makes_links;
    const bool is_stopped = bounce.state == BounceNow::State::stopped;
    state_->setText(words_of(bounce));
    bar_->setVisible(makes_links);
    bar_->setValue(static_cast<int>(1000 * bounce.made_share));
    cancel_->setVisible(makes_links || is_stopped);
    cancel_->setText(is_stopped ? translated("Bounced light", "Make them")
                                : translated("Bounced light", "Cancel"));
}

} // namespace ghost::ui
