// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/value_row.h"

#include "ui/language/language.h"
#include "ui/widgets/following.h"
#include "ui/widgets/theme.h"

#include <QLineEdit>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghost::ui {
namespace {

constexpr int kShareSteps = 1000; // of the slider

} // namespace

MixedSpinBox::MixedSpinBox(QWidget* parent) : QDoubleSpinBox(parent) {
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        const bool had_word = !std::exchange(word_, QString()).isEmpty();
        if (!std::exchange(is_typed_over_, true)) before_ = had_word ? std::nullopt : std::optional(value());
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        lineEdit()->setModified(false);
        // Another number is a change, of which valueChanged tells.
        const bool is_the_same = !before_ || value() == *before_;
        if (std::exchange(is_typed_over_, false) && is_the_same && on_typed_over) on_typed_over(value());
    });
}

bool MixedSpinBox::is_being_typed() const {
    return is_typed_over_ || (hasFocus() && lineEdit()->isModified());
}

QString MixedSpinBox::mixed_word() {
    return translated("Value", "mixed");
}

void MixedSpinBox::set_word(const QString& word) {
    if (unit_.isEmpty()) unit_ = suffix();
    const QString unit =
        word.isEmpty() ? unit_ : QString(); // a word has none, whatever value comes behind it
    if (word == word_ && suffix() == unit) return;
    word_ = word;
    if (!word.isEmpty()) last_word_ = word;
    setSuffix(unit);
    lineEdit()->setText(textFromValue(value()) + unit);
}

void MixedSpinBox::stepBy(int steps) {
    if (is_mixed() && on_mixed_step)
        on_mixed_step(steps * singleStep());
    else
        QDoubleSpinBox::stepBy(steps);
}

// The value behind the word may be at its end, the others are not.
QAbstractSpinBox::StepEnabled MixedSpinBox::stepEnabled() const {
    return is_mixed() && on_mixed_step ? StepUpEnabled | StepDownEnabled : QDoubleSpinBox::stepEnabled();
}

QString MixedSpinBox::textFromValue(double value) const {
    return is_mixed() ? word_ : QDoubleSpinBox::textFromValue(value);
}

double MixedSpinBox::valueFromText(const QString& text) const {
    return has(text) ? value() : QDoubleSpinBox::valueFromText(text);
}

QValidator::State MixedSpinBox::validate(QString& text, int& place) const {
    return has(text) ? QValidator::Acceptable : QDoubleSpinBox::validate(text, place);
}

RowLines::RowLines(QWidget& row, QWidget& label, QWidget& slider, QWidget& field, QWidget& button)
    : row_(row), label_(label), slider_(slider), field_(field), button_(button),
      grid_(new QGridLayout(&row)) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(ValueRow::kBetween_px);
    grid_->setVerticalSpacing(0);
    grid_->setColumnStretch(1, 1);
    grid_->addWidget(&label, 0, 0);
    grid_->addWidget(&slider, 0, 1);
    grid_->addWidget(&field, 0, 2);
    grid_->addWidget(&button, 0, 3);
}

void RowLines::fit() {
    const int words_px = label_.width() + field_.minimumWidth() + button_.sizeHint().width();
    const bool two = row_.width() - words_px - 3 * ValueRow::kBetween_px < ValueRow::kHandy_px;
    if (std::exchange(has_two_, two) == two) return;
    grid_->removeWidget(&slider_);
    if (two)
        grid_->addWidget(&slider_, 1, 0, 1, 4);
    else
        grid_->addWidget(&slider_, 0, 1);
}

ValueRow::ValueRow(const QString& name, const ValueRange& range, QWidget* parent)
    : QWidget(parent), range_(range), label_(new QLabel(name, this)),
      slider_(new QSlider(Qt::Horizontal, this)), field_(new MixedSpinBox(this)),
      release_(new QToolButton(this)), lines_(*this, *label_, *slider_, *field_, *release_) {
    label_->setFixedWidth(label_width(*this));
    slider_->setRange(0, kShareSteps);
    slider_->setMinimumWidth(kLeastSlider_px);
    slider_->setAccessibleName(name);
    field_->setRange(range.low, range.high);
    field_->setDecimals(range.decimals);
    field_->setSingleStep((range.high - range.low) / 100);
    field_->setSuffix(range.unit);
    field_->setKeyboardTracking(false);
    field_->setAccessibleName(name);
    field_->setFixedWidth(fontMetrics().averageCharWidth() * 13 + 4);
    release_->setText("\u21BA"); // back
    release_->setToolTip(translated("Value", "Give it back to the show and the desk"));
    release_->setEnabled(false);
    connect(slider_, &QSlider::valueChanged, this, [this](int at) {
        if (follows_) return;
        if (drag_.is_mixed() && on_mixed_drag)
            on_mixed_drag(drag_.from(), from_slider(at), drag_.begins(slider_->isSliderDown()));
        else if (on_change)
            on_change(from_slider(at));
    });
    connect(slider_, &QSlider::sliderReleased, this, [this] {
        drag_.end();
        if (drag_.is_mixed() && on_refresh) on_refresh();
    });
    connect(field_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!follows_ && on_change) on_change(value);
    });
    field_->on_typed_over = [this](double value) {
        if (on_change) on_change(value);
    };
    field_->on_mixed_step = [this](double by) {
        if (on_mixed_step) on_mixed_step(by);
    };
    connect(release_, &QToolButton::clicked, this, [this] {
        if (on_release) on_release();
    });
}

int ValueRow::label_width(const QWidget& widget) {
    return widget.fontMetrics().averageCharWidth() * 15;
}

int ValueRow::to_slider(double value) const {
    const double share = range_.by_ratio ? std::log(std::max(value, range_.low) / range_.low) /
                                               std::log(range_.high / range_.low)
                                         : (value - range_.low) / (range_.high - range_.low);
    return static_cast<int>(std::lround(kShareSteps * std::clamp(share, 0.0, 1.0)));
}

double ValueRow::from_slider(int at) const {
    const double share = static_cast<double>(at) / kShareSteps;
    return range_.by_ratio ? range_.low * std::pow(range_.high / range_.low, share)
                           : range_.low + share * (range_.high - range_.low);
}

void ValueRow::set_reach(double low, double high) {
    if (low == range_.low && high == range_.high) return;
    const Following following(follows_);
    range_.low = low;
    range_.high = high;
    field_->setRange(low, high);
    field_->setSingleStep((high - low) / 100);
}

void ValueRow::show_value(double value, bool by_hand, bool mixed) {
    {
        const Following following(follows_);
        if (!slider_->isSliderDown()) slider_->setValue(to_slider(value));
        drag_.show(mixed, value, slider_->isSliderDown());
        if (!field_->is_being_typed()) {
            field_->set_mixed(mixed);
            field_->setValue(value);
        }
    }
    release_->setVisible(on_release != nullptr);
    release_->setEnabled(by_hand);
    QPalette colours = palette();
    if (by_hand) colours.setColor(QPalette::WindowText, accent());
    label_->setPalette(colours);
}

void ValueRow::show_none() {
    if (!field_->is_being_typed()) field_->set_word("\u2013");
    release_->setVisible(on_release != nullptr);
    release_->setEnabled(false);
    label_->setPalette(palette());
}

} // namespace ghost::ui
