#pragma once
// SPDX-License-Identifier: Apache-2.0
// ColourField: a colour chosen in the panel itself: hue across and saturation down, as desks have it
// (intensity is a parameter of its own), white by kelvin, a gel book, and swatches. Window thread.

#include <QColor>
#include <QComboBox>
#include <QImage>
#include <QWidget>

#include <functional>

namespace ghost::ui {

class ValueRow;

// The field of hues alone. Arrow keys move it, too.
class HueField : public QWidget {
    Q_OBJECT
public:
    explicit HueField(QWidget* parent);
    void show_colour(const QColor& colour);
    std::function<void(const QColor&)> on_change;

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void keyPressEvent(QKeyEvent*) override;

private:
    void choose(float hue, float saturation);

    QImage field_;
    float hue_ = 0, saturation_ = 0; // 0..1
};

class ColourField : public QWidget {
    Q_OBJECT
public:
    explicit ColourField(QWidget* parent);
    void show_colour(const QColor& colour, bool mixed = false); // does not call back
    std::function<void(const QColor&)> on_change;

private:
    void choose(const QColor& colour);
    void show_gel(const QColor& colour, bool mixed);
    void show_white(const QColor& colour, bool mixed);

    HueField* hues_;
    ValueRow* kelvin_;
    double white_k_; // that was chosen or shown last
    QComboBox* gels_;
};

} // namespace ghost::ui
