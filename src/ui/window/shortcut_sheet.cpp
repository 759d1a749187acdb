// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/shortcut_sheet.h"

#include <QTextBrowser>
#include <QVBoxLayout>

namespace ghost::ui {
namespace {

const char* const kMouse =
    "<tr><td><b>drag</b></td><td>around what is looked at</td></tr>"
    "<tr><td><b>right drag</b></td><td>look around</td></tr>"
    "<tr><td><b>middle drag, Shift+drag</b></td><td>sideways</td></tr>"
    "<tr><td><b>wheel</b></td><td>nearer, farther</td></tr>"
    "<tr><td><b>W A S D, arrows</b></td><td>fly; Q, E or page keys: down, up; Shift: faster</td></tr>"
    "<tr><td><b>click, Ctrl+click</b></td><td>select a fixture, one more</td></tr>"
    "<tr><td><b>Ctrl+drag</b></td><td>select all in a box</td></tr>"
    "<tr><td><b>double click</b></td><td>go to a fixture; choose a set piece, which its cross "
    "moves</td></tr>";

QString rows(const Actions& actions, const QString& menu) {
    QString text;
    for (const Action& action : actions.all()) {
        const QAction* item = actions.item(action.name);
        if (action.menu != menu || action.key.isEmpty() || !item->isVisible()) continue;
        text +=
            QString("<tr><td><b>%1</b></td><td>%2</td></tr>")
                .arg(QString(action.key).replace("; ", ", ").toHtmlEscaped(), item->text().toHtmlEscaped());
    }
    return text;
}

} // namespace

ShortcutSheet::ShortcutSheet(const Actions& actions, QWidget* parent) : QDialog(parent) {
    setWindowTitle("Keys and mouse");
    auto* text = new QTextBrowser(this);
    QString html = "<table cellspacing='14'><tr>";
    int column = 0;
    const auto add = [&](const QString& title, const QString& body) {
        if (body.isEmpty()) return;
        if (column == 3) html += "</tr><tr>";
        column = column == 3 ? 1 : column + 1;
        html +=
            QString("<td valign='top'><h3>%1</h3><table cellpadding='2'>%2</table></td>").arg(title, body);
    };
    add("In the picture", kMouse);
    for (const char* const menu : {"View", "Camera", "Edit", "Show", "Play", "Quality", "Panels", "Help"})
        add(menu, rows(actions, menu));
    text->setHtml(html + "</tr></table>");
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    resize(980, 620);
}

} // namespace ghost::ui
