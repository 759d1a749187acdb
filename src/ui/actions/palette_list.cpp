// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/palette_list.h"

#include "show/looks.h"
#include "show/show.h"
#include "show_file/palette_edit.h"
#include "ui/language/language.h"
#include "ui/model/palette_values.h"

#include <algorithm>

namespace ghost::ui {

const std::vector<scene::Palette>& PaletteList::all() const {
    static const std::vector<scene::Palette> kNone;
    return app_.show() ? app_.show()->palettes : kNone;
}

Result<void> PaletteList::edit(const QString& what, const Result<std::string>& text) {
    TRY_VOID(text);
    return document_.edit(what, {*text, app_.look(), app_.selection()});
}

Result<void> PaletteList::store(scene::PaletteKind kind, const QString& name) {
    TRY_VOID(document_.check_editable());
    if (app_.selection().empty()) return Error{"no fixture is selected", ""};
    TRY_VOID(scene::check_stored_name("palette", name.toStdString()));
    std::map<std::string, scene::PaletteValues> own;
    for (const std::size_t head : app_.selection()) {
        const auto programmer = app_.look().fixtures.find(head);
        if (programmer == app_.look().fixtures.end()) continue;
        const scene::PatchedFixture& fixture = app_.show()->fixtures[head];
        scene::PaletteValues values = palette_values_of(kind, fixture, programmer->second);
        if (!values.is_empty()) own.emplace(fixture.name, std::move(values));
    }
    const std::string word = scene::kPaletteKinds[static_cast<std::size_t>(kind)];
    if (own.empty())
        return Error{"nothing of " + word +
                         " is set by hand for the selected fixtures; 'hold' takes what the desk asks for",
                     ""};
    const Result<std::size_t> before = scene::find_palette(all(), name.toStdString());
    scene::Palette palette;
    if (before.ok() && all()[*before].kind == kind)
        palette = all()[*before]; // others keep what it has of them
    palette.name = name.toStdString();
    palette.kind = kind;
    QStringList names; // a palette of a tilt alone leaves the pan to the desk
    for (const auto& [fixture, values] : own)
        for (const QString& one : names_of(values))
            if (!names.contains(one)) names << one;
    for (auto& [fixture, values] : own) {
        const auto stored = palette.fixtures.find(fixture);
        values = merged(stored == palette.fixtures.end() ? palette.values : stored->second, values);
    }
    const scene::PaletteValues& first = own.begin()->second;
    const bool are_same =
        std::all_of(own.begin(), own.end(), [&](const auto& one) { return one.second == first; });
    if (are_same && palette.fixtures.empty())
        palette.values = first;
    else
        for (auto& [fixture, values] : own) palette.fixtures.insert_or_assign(fixture, std::move(values));
    const QString what =
        (palette.fixtures.empty() ? translated("Undo", "Palette '%1' stored for any head: %2")
                                  : translated("Undo", "Palette '%1' stored: %2"))
            .arg(name, names.join(", "));
    if (!before.ok()) return edit(what, scene::add_palette(document_.text(), palette));
    return edit(what, scene::replace_palette(document_.text(), all(), *before, palette));
}

Result<void> PaletteList::give(const QString& name) {
    TRY(const std::size_t index, scene::find_palette(all(), name.toStdString()));
    if (app_.selection().empty()) return Error{"no fixture is selected", ""};
    const scene::Palette& palette = all()[index];
    Look look = app_.look();
    bool any = false;
    for (const std::size_t head : app_.selection()) {
        const scene::PatchedFixture& fixture = app_.show()->fixtures[head];
        const auto own = palette.fixtures.find(fixture.name);
        const scene::PaletteValues& values = own == palette.fixtures.end() ? palette.values : own->second;
        any = give_values(values, fixture, look.fixtures[head]) || any;
    }
    if (!any) return Error{"no selected fixture has anything of the palette '" + palette.name + "'", ""};
    app_.set_look(std::move(look), translated("Undo", "palette %1").arg(name));
    return {};
}

Result<void> PaletteList::rename(const QString& name, const QString& to) {
    TRY_VOID(document_.check_editable());
    TRY(const std::size_t index, scene::find_palette(all(), name.toStdString()));
    TRY_VOID(scene::check_stored_name("palette", to.toStdString()));
    if (name != to && scene::find_palette(all(), to.toStdString()).ok())
        return Error{"another palette is called '" + to.toStdString() + "'", ""};
    return edit(translated("Undo", "Palette '%1' renamed '%2'").arg(name, to),
                scene::rename_palette(document_.text(), all(), index, to.toStdString()));
}

Result<void> PaletteList::remove(const QString& name) {
    TRY_VOID(document_.check_editable());
    TRY(const std::size_t index, scene::find_palette(all(), name.toStdString()));
    return edit(translated("Undo", "Palette '%1' removed").arg(name),
                scene::remove_palette(document_.text(), all(), index));
}

void add_palette_actions(Actions& actions, PaletteList& palettes) {
    const auto add = [&](const QString& name, const QString& arguments, auto run) {
        actions.add(
            {name,
             "",
             name,
             "",
             arguments,
             [&palettes, run](const QStringList& words) -> Result<void> { return run(palettes, words); },
             {}});
    };
    add("palette", "NAME",
        [](PaletteList& list, const QStringList& words) { return list.give(words.value(0)); });
    add("palette-store", "position|colour|beam|gobo NAME",
        [](PaletteList& list, const QStringList& words) -> Result<void> {
            TRY(const scene::PaletteKind kind, scene::palette_kind_of(words.value(0).toStdString()));
            return list.store(kind, words.value(1));
        });
    add("palette-rename", "NAME NEW-NAME", [](PaletteList& list, const QStringList& words) {
        return list.rename(words.value(0), words.value(1));
    });
    add("palette-remove", "NAME",
        [](PaletteList& list, const QStringList& words) { return list.remove(words.value(0)); });
}

} // namespace ghost::ui
