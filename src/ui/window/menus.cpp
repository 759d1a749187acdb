// SPDX-License-Identifier: Apache-2.0
#include "ui/window/menus.h"

#include "ui/actions/can_do.h"
#include "ui/language/language.h"

#include <QFileInfo>
#include <QShortcut>

#include <utility>

namespace ghost::ui {
namespace {

// Order and groups; an action that is not named here stands at the end of its menu.
// The first is the name by which actions ask for a menu, translated where it is shown.
constexpr std::pair<const char*, const char*> kMenus[] = {
    {QT_TRANSLATE_NOOP("Menu", "Show"),
     "new open @recent import-plot open-demo - save save-as save-copy reload - panel-plot plot-text "
     "save-picture screenshot "
     "panel-export paperwork cue-book cancel-jobs - take-plot - quit"},
    {QT_TRANSLATE_NOOP("Menu", "Edit"),
     "undo redo - select-all select-none select-similar find - hold release release-all - add-fixture "
     "duplicate remove unpatch hang fly-on-hoists aim-through - distribute align-x align-y align-z "
     "nudge-left nudge-right "
     "nudge-up-stage nudge-down-stage mover-on mover-back - set-stage add-model "
     "add-hazer substitute - take-changes drop-changes take-over"},
    {QT_TRANSLATE_NOOP("Menu", "View"),
     "work-light black-out - false-lux false-luminance probe wipe - chips figures frame names addresses aims "
     "marks movers - full-screen second-display second-window - @language"},
    {QT_TRANSLATE_NOOP("Menu", "Camera"),
     "camera-1 camera-2 camera-3 camera-4 camera-5 camera-6 camera-7 camera-8 camera-9 - "
     "camera-strip keep-camera camera-rename camera-remove "
     "focus see-all - brighter darker auto-exposure tone tone-agx tone-aces tone-linear - baked"},
    {QT_TRANSLATE_NOOP("Menu", "Play"),
     "play to-start freeze motion - cue-go cue-back cue-follow - look-next look-before solo - "
     "input-automatic input-desk "
     "input-recording - record play-recorded play-file play-own"},
    {QT_TRANSLATE_NOOP("Menu", "Quality"),
     "fps-15 fps-25 fps-30 fps-44 fps-60 - resolution-0 resolution-100 resolution-50 resolution-25 "
     "resolution-10"},
    {QT_TRANSLATE_NOOP("Menu", "Panels"), ""},
    {QT_TRANSLATE_NOOP("Menu", "Help"), "shortcuts documentation - about"},
};

// With the letter that opens it together with Alt: the first one that none before it has.
QString with_mnemonic(const QString& title, QString& taken) {
    for (int i = 0; i < title.size(); ++i)
        if (title[i].isLetter() && !taken.contains(title[i].toLower())) {
            taken += title[i].toLower();
            return QString(title).insert(i, '&');
        }
    return title;
}

} // namespace

Menus::Menus(Actions& actions, AppModel& app, ShowDocument& document, RecentShows& recent)
    : actions_(actions), app_(app), document_(document), recent_(recent) {}

void Menus::fill(QMenuBar& bar) {
    QString taken;
    for (const auto& [title, names] : kMenus) {
        QMenu* menu = bar.addMenu(with_mnemonic(translated("Menu", title), taken));
        add(*menu, names);
        // Panels, and what nobody has put in its place; quit stays the last, as everywhere.
        const bool ends_with_quit = QString(names).endsWith("quit");
        bool parted = menu->isEmpty();
        for (const Action& action : actions_.all()) {
            QAction* const item = actions_.item(action.name);
            if (action.menu != title || menu->actions().contains(item)) continue;
            if (!parted && !ends_with_quit) menu->addSeparator();
            parted = true;
            menu->insertAction(ends_with_quit ? menu->actions().last() : nullptr, item);
        }
        grey(*menu);
    }
    // Qt has this key for menus on Windows alone.
    connect(new QShortcut(Qt::Key_F10, &bar), &QShortcut::activated, &bar, [&bar] {
        bar.setFocus(Qt::MenuBarFocusReason);
        bar.setActiveAction(bar.actions().first());
    });
}

void Menus::add(QMenu& menu, const QString& names) {
    for (const QString& name : names.split(' ', Qt::SkipEmptyParts)) {
        if (name == "-")
            menu.addSeparator();
        else if (name == "@recent")
            add_recent(*menu.addMenu(translated("Menu", "Open recent")));
        else if (name == "@language")
            add_languages(*menu.addMenu(translated("Menu", "Language")));
        else if (QAction* const item = actions_.item(name))
            menu.addAction(item);
    }
}

void Menus::add_languages(QMenu& menu) {
    add(menu, "language-system -");
    for (const LanguageChoice& one : kLanguages) add(menu, QString("language-") + one.code);
}

void Menus::add_recent(QMenu& menu) {
    const auto refill = [this, &menu] {
        menu.clear();
        for (const RecentShows::One& one : recent_.all()) {
            const QString folder = QFileInfo(one.path).path();
            connect(menu.addAction(one.name + "    " + folder), &QAction::triggered, this,
                    [this, path = one.path] { actions_.choose("open " + quoted(path)); });
        }
        menu.menuAction()->setEnabled(!recent_.all().empty());
    };
    connect(&recent_, &RecentShows::changed, &menu, refill);
    refill();
}

void Menus::fill_for_fixtures(QMenu& menu) {
    if (app_.selection().empty())
        add(menu, "select-all find - see-all keep-camera work-light - add-fixture add-model fly-on-hoists");
    else
        add(menu, "select-similar select-none - focus solo aim-through - hold release panel-programmer "
                  "panel-values - "
                  "hang duplicate "
                  "unpatch remove - substitute");
    grey(menu);
}

void Menus::fill_for_picture(QMenu& menu, const glm::vec2& place) {
    const QString at = QString(" %1 %2").arg(place.x, 0, 'f', 4).arg(place.y, 0, 'f', 4);
    const auto add_line = [&](const QString& text, const QString& line, bool can) {
        QAction* const item = menu.addAction(text);
        item->setEnabled(can);
        connect(item, &QAction::triggered, this, [this, line] { actions_.choose(line); });
    };
    const bool any = !app_.selection().empty();
    add_line(translated("Action", "Aim here"), "aim-through" + at, any);
    add_line(translated("Action", "Explain why it shines or not"), "panel-values on", any);
    add_line(translated("Action", "Hide what is here"), "hide-through" + at, app_.show() != nullptr);
    menu.addSeparator();
    fill_for_fixtures(menu);
}

// An item that is grey has no key, so they are grey only while they are looked at.
void Menus::grey(QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
        for (const Action& action : actions_.all())
            if (QAction* const item = actions_.item(action.name); menu.actions().contains(item))
                item->setEnabled(can_do(action.name, app_, document_));
    });
    connect(&menu, &QMenu::aboutToHide, this, [&menu] {
        for (QAction* const item : menu.actions())
            if (!item->menu()) item->setEnabled(true);
    });
}

} // namespace ghost::ui
