// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/theme.h"

#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

namespace ghost::ui {

namespace {

// Fusion, the same on every system; its box to tick has an outline darker than the window, and its button for
// what finds no room in a line is as dark, which a dark room swallows.
class Theme : public QProxyStyle {
public:
    Theme() : QProxyStyle(QStyleFactory::create("Fusion")) {}
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox) return;
        painter->save();
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
    // Over all: where a box of buttons is no larger than they are, it would cut the ring round the focus.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override {
        return hint == SH_FocusFrame_AboveWidget ? 1 : QProxyStyle::styleHint(hint, option, widget, more);
    }
    QIcon standardIcon(StandardPixmap kind, const QStyleOption* option,
                       const QWidget* widget) const override {
        const bool is_down = kind == SP_ToolBarVerticalExtensionButton;
        if (!is_down && kind != SP_ToolBarHorizontalExtensionButton)
            return QProxyStyle::standardIcon(kind, option, widget);
        QPixmap picture(64, 64);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(QGuiApplication::palette().color(QPalette::ButtonText), 6));
        for (const int at : {14, 32}) {
            const QPolygon right({{at, 16}, {at + 16, 32}, {at, 48}});
            painter.drawPolyline(is_down ? QTransform(0, 1, 1, 0, 0, 0).map(right) : right);
        }
        return picture;
    }
};

} // namespace

void set_theme(QApplication& application) {
    application.setStyle(new Theme);
    QPalette palette;
    const QColor ground(30, 30, 33), deep(22, 22, 24), text(222, 222, 222), grey(142, 142, 145),
        placeholder(164, 164, 168);
    palette.setColor(QPalette::Window, ground);
    palette.setColor(QPalette::WindowText, text);
    palette.setColor(QPalette::Base, deep);
    palette.setColor(QPalette::AlternateBase, QColor(27, 27, 30));
    palette.setColor(QPalette::ToolTipBase, QColor(48, 48, 52));
    palette.setColor(QPalette::ToolTipText, text);
    palette.setColor(QPalette::PlaceholderText, placeholder);
    palette.setColor(QPalette::Text, text);
    palette.setColor(QPalette::Button, QColor(46, 46, 50));
    palette.setColor(QPalette::ButtonText, text);
    // Fusion derives outlines from these, which shine in a dark room otherwise.
    palette.setColor(QPalette::Light, QColor(62, 62, 67));
    palette.setColor(QPalette::Midlight, QColor(54, 54, 58));
    palette.setColor(QPalette::Mid, QColor(38, 38, 41));
    palette.setColor(QPalette::Dark, QColor(20, 20, 22));
    palette.setColor(QPalette::Shadow, QColor(8, 8, 9));
    palette.setColor(QPalette::BrightText, bad());
    palette.setColor(QPalette::Link, accent());
    palette.setColor(QPalette::Highlight, QColor(112, 78, 30));
    palette.setColor(QPalette::HighlightedText, QColor(255, 240, 220));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, grey);
    // What cannot be typed into has no ground of its own, so that it looks other than an empty line.
    palette.setColor(QPalette::Disabled, QPalette::Base, ground);
    palette.setColor(QPalette::Disabled, QPalette::Button, QColor(36, 36, 39));
    application.setPalette(palette);
    application.setStyleSheet(
        "QToolTip { color: #dedede; background: #303034; border: 1px solid #55555a; padding: 3px; }"
        "QDockWidget::title { background: #28282b; padding: 5px 8px; }"
        "QMainWindow::separator { background: #141416; width: 4px; height: 4px; }"
        "QHeaderView::section { background: #28282b; color: #b4b4b8; border: 0; padding: 4px 6px; }"
        "QTableView, QTreeView, QPlainTextEdit, QTextBrowser { border: 0; }"
        "QTabBar::tab { padding: 6px 7px; }"
        "QTabBar { qproperty-elideMode: ElideNone; qproperty-usesScrollButtons: true; }"
        "QStatusBar { background: #18181a; color: #b4b4b8; }");
}

} // namespace ghost::ui
