// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/parameter_row.h"

#include "ui/language/language.h"
#include "ui/widgets/following.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/value_row.h"

#include <QFontMetrics>
#include <QMenu>
#include <QStyle>

#include <cmath>

namespace ghost::ui {
namespace {

constexpr int kParameterSteps = 1020; // of the slider: four to a value of eight bits

// In two where it is too long for one and has a blank to break at; what is too long even so ends in dots.
QString in_lines(const QString& words, const QFontMetrics& metrics, int width_px) {
    qsizetype end = words.size();
    while (end > 0 && metrics.horizontalAdvance(words.left(end)) > width_px)
        end = words.lastIndexOf(' ', end - 1);
    const auto fitted = [&](const QString& line) {
        return metrics.elidedText(line, Qt::ElideRight, width_px);
    };
    if (end <= 0 || end == words.size()) return fitted(words);
    return words.left(end) + "\n" + fitted(words.mid(end + 1));
}

} // namespace

ParameterRow::ParameterRow(const HeadParameter& parameter, SlotPictures& pictures, QWidget* parent)
    : QWidget(parent), label_(new QLabel(this)), slider_(new QSlider(Qt::Horizontal, this)),
      meaning_(new QToolButton(this)), release_(new QToolButton(this)),
      lines_(*this, *label_, *slider_, *meaning_, *release_) {
    label_->setFixedWidth(ValueRow::label_width(*this));
    label_->setText(in_lines(parameter.name, label_->fontMetrics(), label_->width()));
    label_->setToolTip(parameter.name + " (" + QString::fromStdString(parameter.attribute) + ")");
    slider_->setRange(0, kParameterSteps);
    slider_->setMinimumWidth(ValueRow::kLeastSlider_px);
    slider_->setAccessibleName(parameter.name);
    meaning_->setAccessibleName(translated("Value", "%1: what it can be").arg(parameter.name));
    meaning_->setFixedWidth(fontMetrics().averageCharWidth() * 14);
    meaning_->setToolButtonStyle(Qt::ToolButtonTextOnly);
    meaning_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(meaning_);
    const int side_px = style()->pixelMetric(QStyle::PM_SmallIconSize);
    for (const ParameterRange& range : parameter.ranges) {
        QAction* const one = menu->addAction(range.name);
        one->setIcon(pictures.of(parameter.type, range.wheel, range.slot, side_px));
        connect(one, &QAction::triggered, this, [this, range] {
            if (on_change) on_change(0.5f * (range.from + range.to));
        });
    }
    meaning_->setMenu(menu);
    release_->setText("\u21BA"); // back
    release_->setToolTip(translated("Value", "Give it back to the show and the desk"));
    release_->setAccessibleName(translated("Value", "Give back %1").arg(parameter.name));
    connect(slider_, &QSlider::valueChanged, this, [this](int at) {
        if (follows_) return;
        const float to = static_cast<float>(at) / kParameterSteps;
        if (drag_.is_mixed() && on_mixed_drag)
            on_mixed_drag(static_cast<float>(drag_.from()), to, drag_.begins(slider_->isSliderDown()));
        else if (on_change)
            on_change(to);
    });
    connect(slider_, &QSlider::sliderReleased, this, [this] {
        drag_.end();
        if (drag_.is_mixed() && on_refresh) on_refresh();
    });
    connect(release_, &QToolButton::clicked, this, [this] {
        if (on_release) on_release();
    });
}

void ParameterRow::show_value(const ParameterValue& value, bool mixed) {
    {
        const Following following(follows_);
        if (!slider_->isSliderDown())
            slider_->setValue(
                static_cast<int>(std::lround(kParameterSteps * static_cast<double>(value.share))));
        drag_.show(mixed, static_cast<double>(value.share), slider_->isSliderDown());
    }
    const QString words = mixed ? translated("Value", "mixed") : value.words;
    meaning_->setText(meaning_->fontMetrics().elidedText(words, Qt::ElideRight, meaning_->width() - 22));
    meaning_->setToolTip(words);
    release_->setEnabled(value.by_hand && !value.is_of_other);
    QPalette colours = palette();
    if (value.by_hand) colours.setColor(QPalette::WindowText, accent());
    label_->setPalette(colours);
}

} // namespace ghost::ui
