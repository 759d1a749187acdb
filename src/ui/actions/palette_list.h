#pragma once
// SPDX-License-Identifier: Apache-2.0
// PaletteList: the palettes of the show ([[palette]] of show.toml) as the window keeps and gives them. Each
// change of them is an edit of the show, one step of the undo list; giving one to the selected fixtures is a
// step of what hands do. Window thread.

#include "show/palettes.h"
#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

namespace ghost::ui {

class PaletteList {
public:
    PaletteList(AppModel& app, ShowDocument& document) : app_(app), document_(document) {}

    const std::vector<scene::Palette>& all() const;

    // What hands set of that kind for the selected fixtures: one value for any head where they have the same,
    // else each one's own. Under a name that is there it takes that one's place, but what that has for other
    // heads stays, and one that has values for each head keeps them so.
    Result<void> store(scene::PaletteKind kind, const QString& name);
    // To the selected fixtures. Error: none of them has anything of it.
    Result<void> give(const QString& name);
    Result<void> rename(const QString& name, const QString& to);
    Result<void> remove(const QString& name);

private:
    Result<void> edit(const QString& what, const Result<std::string>& text);

    AppModel& app_;
    ShowDocument& document_;
};

// "palette-store colour Amber", "palette Amber", "palette-rename Amber Warm", "palette-remove Warm".
void add_palette_actions(Actions& actions, PaletteList& palettes);

} // namespace ghost::ui
