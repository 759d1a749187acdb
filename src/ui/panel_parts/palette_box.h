#pragma once
// SPDX-License-Identifier: Apache-2.0
// PaletteBox: the palettes of the show in the programmer: one kind at a time, a click gives one to the
// selected fixtures, F2 renames it. Window thread.

#include "ui/actions/palette_list.h"

#include <QButtonGroup>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>
#include <QWidget>

#include <vector>

namespace ghost::ui {

class PaletteBox : public QWidget {
    Q_OBJECT
public:
    // Clicks run actions, so that what goes wrong is said where it is for keys.
    PaletteBox(AppModel& app, PaletteList& palettes, Actions& actions, QWidget* parent);

    QListWidget* list() { return list_; }
    // What the right button brings up over the list.
    void fill_menu(QMenu& menu);

private:
    scene::PaletteKind kind() const;
    QString kind_word() const; // as actions have it
    QString chosen() const;
    QString new_name() const; // that nobody has
    void run(const QString& line);
    void fill();

    AppModel& app_;
    PaletteList& palettes_;
    Actions& actions_;
    QButtonGroup* kinds_;
    QToolButton* store_;
    QListWidget* list_;
    std::vector<scene::Palette> shown_; // of the kind
    bool follows_ = false;              // it is being filled, not edited
};

} // namespace ghost::ui
