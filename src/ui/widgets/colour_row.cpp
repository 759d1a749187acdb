// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/colour_row.h"

#include "ui/language/language.h"
#include "ui/widgets/colour_field.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/value_row.h"

#include <QHBoxLayout>

#include <cmath>

namespace ghost::ui {
namespace {

// Words on that ground, black or white, whichever has more contrast (WCAG 2.1: the luminance where both have
// the same is 0.179).
QColor words_on(const QColor& ground) {
    const auto linear = [](float share) { return std::pow(share, 2.2f); };
    const float luminance = 0.2126f * linear(ground.redF()) + 0.7152f * linear(ground.greenF()) +
                            0.0722f * linear(ground.blueF());
    return luminance > 0.179f ? Qt::black : Qt::white;
}

} // namespace

ColourRow::ColourRow(const QString& name, QWidget* parent)
    : QWidget(parent), label_(new QLabel(name, this)), button_(new QPushButton(this)),
      release_(new QToolButton(this)), column_(new QVBoxLayout(this)) {
    label_->setFixedWidth(ValueRow::label_width(*this));
    button_->setAccessibleName(name);
    button_->setCheckable(true);
    button_->setToolTip(translated("Value", "Unfolds the colours"));
    release_->setText("\u21BA"); // back
    release_->setToolTip(translated("Value", "Give it back to the show and the desk"));
    release_->setAccessibleName(translated("Value", "Give back %1").arg(name));
    column_->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    row->setSpacing(ValueRow::kBetween_px);
    row->addWidget(label_);
    row->addWidget(button_, 1);
    row->addWidget(release_);
    column_->addLayout(row);
    connect(button_, &QPushButton::toggled, this, &ColourRow::unfold);
    connect(release_, &QToolButton::clicked, this, [this] {
        if (on_release) on_release();
    });
    show_colour(Qt::white, false);
}

void ColourRow::unfold(bool on) {
    if (!field_) {
        field_ = new ColourField(this);
        field_->on_change = [this](const QColor& colour) {
            if (on_change) on_change(colour);
        };
        field_->show_colour(colour_, mixed_);
        column_->addWidget(field_);
    }
    field_->setVisible(on);
}

void ColourRow::show_colour(const QColor& colour, bool by_hand, bool mixed) {
    colour_ = colour;
    mixed_ = mixed;
    if (field_) field_->show_colour(colour, mixed);
    button_->setText(mixed     ? translated("Value", "mixed")
                     : by_hand ? translated("Value", "By hand")
                               : QString());
    const QString style =
        QString("QPushButton { background: %1; color: %2; border: 1px solid #55555a; padding: 4px; } "
                "QPushButton:focus { border: 2px solid %3; }")
            .arg(colour.name(), words_on(colour).name(), accent().name());
    if (style != button_->styleSheet()) button_->setStyleSheet(style); // it costs a layout
    release_->setEnabled(by_hand);
    QPalette colours = palette();
    if (by_hand) colours.setColor(QPalette::WindowText, accent());
    label_->setPalette(colours);
}

} // namespace ghost::ui
