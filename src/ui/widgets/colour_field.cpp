// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/colour_field.h"

#include "image/colour.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/gel_book.h"
#include "ui/widgets/value_row.h"

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPixmap>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ghost::ui {
namespace {

constexpr int kFieldHeight_px = 84;
constexpr float kStep = 0.01f;  // of the arrow keys
constexpr float kLamp_k = 3200; // that a conversion filter is put before
constexpr float kUsual_k = 5600;
constexpr double kLeast_k = 2000, kMost_k = 10000, kStep_k = 50;

const std::pair<const char*, QColor> kSwatches[] = {
    {QT_TRANSLATE_NOOP("Colour", "White"), QColor(255, 255, 255)},
    {QT_TRANSLATE_NOOP("Colour", "Warm white"), QColor(255, 180, 107)},
    {QT_TRANSLATE_NOOP("Colour", "Red"), QColor(255, 0, 0)},
    {QT_TRANSLATE_NOOP("Colour", "Amber"), QColor(255, 126, 0)},
    {QT_TRANSLATE_NOOP("Colour", "Yellow"), QColor(255, 230, 0)},
    {QT_TRANSLATE_NOOP("Colour", "Green"), QColor(0, 255, 60)},
    {QT_TRANSLATE_NOOP("Colour", "Cyan"), QColor(0, 220, 255)},
    {QT_TRANSLATE_NOOP("Colour", "Blue"), QColor(0, 40, 255)},
    {QT_TRANSLATE_NOOP("Colour", "Lavender"), QColor(160, 120, 255)},
    {QT_TRANSLATE_NOOP("Colour", "Magenta"), QColor(255, 0, 180)},
};

QIcon icon_of(const QColor& colour, int size) {
    QPixmap picture(size, size);
    picture.fill(colour);
    return QIcon(picture);
}

// In the order of the book.
const std::vector<QColor>& gel_colours() {
    static const std::vector<QColor> all = [] {
        std::vector<QColor> colours;
        for (const Gel& gel : gel_book()) colours.push_back(screen_colour(colour_of(gel, kLamp_k)));
        return colours;
    }();
    return all;
}

// Within a step of a screen: colours go through the light of the lamp and back.
bool is_same(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) <= 1 && std::abs(a.green() - b.green()) <= 1 &&
           std::abs(a.blue() - b.blue()) <= 1;
}

QColor white_of(double kelvin) {
    return screen_colour(image::cct_to_rec2020(static_cast<float>(kelvin)));
}

// From kLeast_k on, kStep_k apart.
const std::vector<QColor>& white_colours() {
    static const std::vector<QColor> all = [] {
        std::vector<QColor> colours;
        for (double kelvin = kLeast_k; kelvin <= kMost_k; kelvin += kStep_k)
            colours.push_back(white_of(kelvin));
        return colours;
    }();
    return all;
}

} // namespace

HueField::HueField(QWidget* parent) : QWidget(parent) {
    setFixedHeight(kFieldHeight_px);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(translated("Colour", "Hue and saturation"));
    setToolTip(translated("Colour", "Hue across, saturation down; arrow keys move it"));
}

void HueField::show_colour(const QColor& colour) {
    if (colour.hsvSaturationF() > 0) hue_ = std::max(colour.hsvHueF(), 0.0f); // grey has none
    saturation_ = colour.hsvSaturationF();
    update();
}

void HueField::choose(float hue, float saturation) {
    hue_ = std::clamp(hue, 0.0f, 0.999f);
    saturation_ = std::clamp(saturation, 0.0f, 1.0f);
    update();
    if (on_change) on_change(QColor::fromHsvF(hue_, saturation_, 1));
}

void HueField::resizeEvent(QResizeEvent*) {
    field_ = QImage(size(), QImage::Format_RGB32);
    for (int y = 0; y < height(); ++y)
        for (int x = 0; x < width(); ++x)
            field_.setPixelColor(x, y,
                                 QColor::fromHsvF(static_cast<float>(x) / static_cast<float>(width()),
                                                  static_cast<float>(y) / static_cast<float>(height()), 1));
}

void HueField::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setOpacity(isEnabled() ? 1 : 0.3);
    painter.drawImage(0, 0, field_);
    const QPointF at(static_cast<double>(hue_) * width(), static_cast<double>(saturation_) * height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::black, 3));
    painter.drawEllipse(at, 6, 6);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.drawEllipse(at, 6, 6);
    if (!hasFocus()) return;
    painter.setPen(QPen(palette().color(QPalette::Link), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void HueField::mousePressEvent(QMouseEvent* event) {
    mouseMoveEvent(event);
}

void HueField::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) == 0) return;
    choose(static_cast<float>(event->position().x() / std::max(width(), 1)),
           static_cast<float>(event->position().y() / std::max(height(), 1)));
}

void HueField::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return choose(hue_ - kStep, saturation_);
    case Qt::Key_Right:
        return choose(hue_ + kStep, saturation_);
    case Qt::Key_Up:
        return choose(hue_, saturation_ - kStep);
    case Qt::Key_Down:
        return choose(hue_, saturation_ + kStep);
    default:
        QWidget::keyPressEvent(event);
    }
}

ColourField::ColourField(QWidget* parent)
    : QWidget(parent), hues_(new HueField(this)),
      kelvin_(new ValueRow(translated("Colour", "White"), {kLeast_k, kMost_k, 0, " K"}, this)),
      white_k_(static_cast<double>(kUsual_k)), gels_(new QComboBox(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 4);
    layout->setSpacing(4);
    auto* swatches = new QHBoxLayout;
    swatches->setSpacing(2);
    for (const auto& [name, colour] : kSwatches) {
        auto* button = new QToolButton(this);
        button->setIcon(icon_of(colour, 16));
        button->setToolTip(translated("Colour", name));
        button->setAccessibleName(translated("Colour", name));
        button->setAutoRaise(true);
        button->setMinimumWidth(16);
        connect(button, &QToolButton::clicked, this, [this, colour = colour] { choose(colour); });
        swatches->addWidget(button);
    }
    gels_->setAccessibleName(translated("Colour", "Gel"));
    gels_->setToolTip(translated(
        "Colour", "Lee's conversions before a lamp of 3200 K; its colours as they look on a screen"));
    gels_->addItem(translated("Colour", "Gel ..."));
    for (const Gel& gel : gel_book())
        gels_->addItem(icon_of(screen_colour(colour_of(gel, kLamp_k)), 14),
                       QString::fromUtf8(gel.number.data(), static_cast<qsizetype>(gel.number.size())) +
                           "  " +
                           QString::fromUtf8(gel.name.data(), static_cast<qsizetype>(gel.name.size())));
    gels_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    gels_->setMinimumContentsLength(8);
    layout->addWidget(hues_);
    layout->addLayout(swatches);
    layout->addWidget(kelvin_);
    layout->addWidget(gels_);
    kelvin_->show_value(white_k_, false);
    kelvin_->show_none();
    hues_->on_change = [this](const QColor& colour) {
        show_gel(colour, false);
        show_white(colour, false);
        if (on_change) on_change(colour);
    };
    kelvin_->on_change = [this](double kelvin) {
        white_k_ = kelvin;
        choose(white_of(kelvin));
    };
    connect(gels_, &QComboBox::activated, this, [this](int index) {
        if (index > 0) choose(gel_colours()[static_cast<std::size_t>(index - 1)]);
    });
}

void ColourField::show_colour(const QColor& colour, bool mixed) {
    hues_->show_colour(colour);
    show_gel(colour, mixed);
    show_white(colour, mixed);
}

// The one that has this colour, or none; an open list stays as it is.
void ColourField::show_gel(const QColor& colour, bool mixed) {
    if (gels_->view()->isVisible()) return;
    const std::vector<QColor>& gels = gel_colours();
    const auto found =
        std::find_if(gels.begin(), gels.end(), [&](const QColor& gel) { return is_same(gel, colour); });
    gels_->setCurrentIndex(mixed || found == gels.end() ? 0 : static_cast<int>(found - gels.begin()) + 1);
}

// What it is in kelvin where it is a white, else nothing. What was typed stays as it was typed, though its
// neighbours are the same on a screen.
void ColourField::show_white(const QColor& colour, bool mixed) {
    std::optional<double> found;
    if (!mixed && is_same(white_of(white_k_), colour)) found = white_k_;
    const std::vector<QColor>& whites = white_colours();
    const auto same = std::find_if(whites.begin(), whites.end(),
                                   [&](const QColor& white) { return is_same(white, colour); });
    if (!mixed && !found && same != whites.end())
        found = kLeast_k + kStep_k * static_cast<double>(same - whites.begin());
    if (!found) return kelvin_->show_none();
    white_k_ = *found;
    kelvin_->show_value(white_k_, false);
}

void ColourField::choose(const QColor& colour) {
    show_colour(colour);
    if (on_change) on_change(colour);
}

} // namespace ghost::ui
