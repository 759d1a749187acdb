// SPDX-License-Identifier: Apache-2.0
#include "ui/window/private/shortcut_sheet.h"

#include "ui/language/language.h"

#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace ghost::ui {
namespace {

constexpr std::pair<const char*, const char*> kMouse[] = {
    {QT_TRANSLATE_NOOP("Keys", "drag"), QT_TRANSLATE_NOOP("Keys", "around what is looked at")},
    {QT_TRANSLATE_NOOP("Keys", "right drag"), QT_TRANSLATE_NOOP("Keys", "look around")},
    {QT_TRANSLATE_NOOP("Keys", "middle drag, Shift+drag"), QT_TRANSLATE_NOOP("Keys", "sideways")},
    {QT_TRANSLATE_NOOP("Keys", "wheel"), QT_TRANSLATE_NOOP("Keys", "nearer, farther")},
    {QT_TRANSLATE_NOOP("Keys", "W A S D, arrows"),
     QT_TRANSLATE_NOOP("Keys", "fly; Q, E or page keys: down, up; Shift: faster")},
    {QT_TRANSLATE_NOOP("Keys", "click, Ctrl+click"), QT_TRANSLATE_NOOP("Keys", "select a fixture, one more")},
    {QT_TRANSLATE_NOOP("Keys", "Ctrl+drag"), QT_TRANSLATE_NOOP("Keys", "select all in a box")},
    {QT_TRANSLATE_NOOP("Keys", "Shift+click"),
     QT_TRANSLATE_NOOP("Keys", "the selected heads point at what is there")},
    {QT_TRANSLATE_NOOP("Keys", "drag of a selected lamp"),
     QT_TRANSLATE_NOOP("Keys", "the selected fixtures move along their truss; Shift: up and down")},
    {QT_TRANSLATE_NOOP("Keys", "right click"), QT_TRANSLATE_NOOP("Keys", "what can be done there")},
    {QT_TRANSLATE_NOOP("Keys", "double click"),
     QT_TRANSLATE_NOOP("Keys", "go to a fixture; choose a set piece, which its cross moves")}};

QString key_row(const QString& key, const QString& words) {
    return QString("<tr><td><b>%1</b></td><td>%2</td></tr>").arg(key.toHtmlEscaped(), words.toHtmlEscaped());
}

QString rows(const Actions& actions, const QString& menu) {
    QString text;
    for (const Action& action : actions.all()) {
        const QAction* item = actions.item(action.name);
        if (action.menu != menu || action.key.isEmpty() || !item->isVisible()) continue;
        const bool names_step = action.name == "undo" || action.name == "redo"; // that they would do now
        text += key_row(
            QKeySequence::listToString(item->shortcuts(), QKeySequence::NativeText).replace("; ", ", "),
            names_step ? action.text : item->text());
    }
    return text;
}

QString key_group(const QString& title, const QString& body) {
    if (body.isEmpty()) return {};
    return "<h3>" + title + "</h3><table cellpadding='2'>" + body + "</table>";
}

QString key_groups(const Actions& actions, const std::vector<const char*>& menus) {
    QString text;
    for (const char* const menu : menus) text += key_group(translated("Menu", menu), rows(actions, menu));
    return text;
}

// Columns of about the same length, so that a display of 1080 lines has all of it.
const std::vector<const char*> kMenusOfColumns[] = {
    {"Edit"}, {"View", "Show", "Panels"}, {"Camera", "Play", "Quality", "Help"}};

QString key_column(const QString& body) {
    return "<td valign='top' width='33%'>" + body + "</td>";
}

} // namespace

ShortcutSheet::ShortcutSheet(const Actions& actions, QWidget* parent) : QDialog(parent) {
    setWindowTitle(translated("Keys", "Keys and mouse"));
    auto* text = new QTextBrowser(this);
    QString mouse;
    for (const auto& [what, does] : kMouse)
        mouse += key_row(translated("Keys", what), translated("Keys", does));
    QString html = "<table cellspacing='14' width='100%'><tr>";
    for (const auto& menus : kMenusOfColumns) {
        const QString first =
            &menus == kMenusOfColumns ? key_group(translated("Keys", "In the picture"), mouse) : QString();
        html += key_column(first + key_groups(actions, menus));
    }
    text->setHtml(html + "</tr></table>");
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    resize(QSize(1240, 880).boundedTo(screen()->availableSize() * 9 / 10));
}

} // namespace ghost::ui
