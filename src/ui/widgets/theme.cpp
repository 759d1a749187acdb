// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/theme.h"

#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

#include <vector>

namespace ghost::ui {

namespace {

constexpr int kMenuLine_px = 24, kIcon = 64;

// Fusion, the same on every system; its box to tick has an outline darker than the window, and its button for
// what finds no room in a line is as dark, which a dark room swallows.
class Theme : public QProxyStyle {
public:
    Theme() : QProxyStyle(QStyleFactory::create("Fusion")) {}
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        const bool is_button = element == PE_PanelButtonCommand || element == PE_PanelButtonTool;
        if (is_button && (option->state & State_On)) return draw_pressed(*option, *painter);
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox) return;
        painter->save();
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
    // The words of the menus stand at the height of those beside them, in the buttons of the view.
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override {
        const QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
        return type == CT_MenuBarItem ? size.expandedTo({0, kMenuLine_px}) : size;
    }
    // Over all: where a box of buttons is no larger than they are, it would cut the ring round the focus.
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* more) const override {
        return hint == SH_FocusFrame_AboveWidget ? 1 : QProxyStyle::styleHint(hint, option, widget, more);
    }
    QIcon standardIcon(StandardPixmap kind, const QStyleOption* option,
                       const QWidget* widget) const override {
        const std::vector<QPolygon> lines = lines_of(kind);
        if (lines.empty()) return QProxyStyle::standardIcon(kind, option, widget);
        QPixmap picture(kIcon, kIcon);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(QGuiApplication::palette().color(QPalette::ButtonText), 6));
        for (const QPolygon& line : lines) painter.drawPolyline(line);
        return picture;
    }

private:
    // Fusion's own are of so few pixels that they blur where a point has two.
    static std::vector<QPolygon> lines_of(StandardPixmap kind) {
        switch (kind) {
        case SP_ToolBarVerticalExtensionButton:
            return {{{{48, 14}, {32, 30}, {16, 14}}}, {{{48, 32}, {32, 48}, {16, 32}}}};
        case SP_ToolBarHorizontalExtensionButton:
            return {{{{14, 16}, {30, 32}, {14, 48}}}, {{{32, 16}, {48, 32}, {32, 48}}}};
        case SP_TitleBarNormalButton: // torn off, or put back
            return {{{{8, 24}, {40, 24}, {40, 56}, {8, 56}, {8, 24}}},
                    {{{24, 22}, {24, 8}, {56, 8}, {56, 40}, {42, 40}}}};
        case SP_TitleBarCloseButton:
            return {{{{12, 12}, {52, 52}}}, {{{52, 12}, {12, 52}}}};
        default:
            return {};
        }
    }
    // Fusion's is a shade darker than one that is not, which nobody sees on a dark ground.
    static void draw_pressed(const QStyleOption& option, QPainter& painter) {
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(option.state & State_Enabled ? accent() : option.palette.color(QPalette::ButtonText));
        painter.setBrush(option.palette.color(QPalette::Highlight));
        painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), 2, 2);
        painter.restore();
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
