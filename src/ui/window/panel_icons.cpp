// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/panel_icons.h"

#include "ui/widgets/theme.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <utility>

namespace ghost::ui {
namespace {

constexpr double kSide = 16; // of the square in which they are drawn

// L x y x y ...: a line; P: likewise, closed; O x y r: a circle; D x y r: a disc.
constexpr std::pair<const char*, const char*> kDrawings[] = {
    {"fixtures", "D 3 4 1.2 L 6.5 4 14 4 D 3 8 1.2 L 6.5 8 14 8 D 3 12 1.2 L 6.5 12 14 12"},
    {"programmer", "L 3.5 2 3.5 14 D 3.5 10 1.9 L 8 2 8 14 D 8 5 1.9 L 12.5 2 12.5 14 D 12.5 8.5 1.9"},
    {"values", "L 2 14 14 14 P 3 14 3 9 5 9 5 14 P 7 14 7 3 9 3 9 14 P 11 14 11 6 13 6 13 14"},
    {"looks", "P 2 5 2 14 11 14 11 5 L 5 2 14 2 14 11 D 5 8 1.1 L 2.5 13 6.5 10 8 11 10.5 8.5"},
    {"cues", "P 2 4.5 2 11.5 7.5 8 L 10 4 14 4 L 10 8 14 8 L 10 12 14 12"},
    {"scene", "P 8 1.5 13.7 4.6 13.7 11.4 8 14.5 2.3 11.4 2.3 4.6 L 2.3 4.6 8 7.8 13.7 4.6 L 8 7.8 8 14.5"},
    {"air", "L 2 5 4.5 3.5 7 5 9.5 6.5 12 5 14 3.8 L 2 9 4.5 7.5 7 9 9.5 10.5 12 9 14 7.8 "
            "L 2 13 4.5 11.5 7 13 9.5 14.5 12 13 14 11.8"},
    {"plot", "P 1.5 3 14.5 3 14.5 6 1.5 6 L 1.5 6 4.5 3 7.5 6 10.5 3 14.5 6 O 4 10.5 2 O 12 10.5 2 "
             "L 4 6 4 8.5 L 12 6 12 8.5"},
    {"network",
     "O 8 3.5 2 O 3.5 12.5 2 O 12.5 12.5 2 L 7 5.4 4.4 10.6 L 9 5.4 11.6 10.6 L 5.6 12.5 10.4 12.5"},
    {"messages", "P 2 3 14 3 14 11 8 11 5 14 5 11 2 11 L 5 6 11 6 L 5 8.5 9 8.5"},
    {"export", "L 2 9 2 14 14 14 14 9 L 8 10.5 8 2 L 4.8 5 8 2 11.2 5"},
    {"browsers", "P 1.5 3 14.5 3 14.5 11 1.5 11 L 8 11 8 14 L 5 14 11 14"},
};
constexpr const char* kNone = "P 3 3 13 3 13 13 3 13";

void draw(QPainter& painter, const char* drawing) {
    const QStringList words = QString(drawing).split(' ', Qt::SkipEmptyParts);
    for (qsizetype at = 0; at < words.size();) {
        const QChar kind = words[at++][0];
        QList<double> numbers;
        for (; at < words.size() && !words[at][0].isLetter(); ++at) numbers << words[at].toDouble();
        const QPointF begin(numbers[0], numbers[1]);
        if (kind == 'O' || kind == 'D') {
            painter.setBrush(kind == 'D' ? QBrush(painter.pen().color()) : QBrush(Qt::NoBrush));
            painter.drawEllipse(begin, numbers[2], numbers[2]);
            continue;
        }
        QPainterPath path(begin);
        for (qsizetype i = 2; i + 1 < numbers.size(); i += 2) path.lineTo(numbers[i], numbers[i + 1]);
        if (kind == 'P') path.closeSubpath();
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
    }
}

class PanelIcon : public QIconEngine {
public:
    explicit PanelIcon(const char* drawing) : drawing_(drawing) {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const QColor colour = state == QIcon::On ? accent()
                              : mode == QIcon::Disabled
                                  ? faint()
                                  : QGuiApplication::palette().color(QPalette::ButtonText);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / kSide, rect.height() / kSide);
        painter->setPen(QPen(colour, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        draw(*painter, drawing_);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return picture;
    }
    QIconEngine* clone() const override { return new PanelIcon(drawing_); }

private:
    const char* drawing_;
};

} // namespace

QIcon panel_icon(const QString& name) {
    for (const auto& [panel, drawing] : kDrawings)
        if (name == panel) return QIcon(new PanelIcon(drawing));
    return QIcon(new PanelIcon(kNone));
}

} // namespace ghost::ui
