#pragma once
// SPDX-License-Identifier: Apache-2.0
// Menus: the table of actions as menus: those of one kind together, and what cannot be done now is grey while
// a menu is open. Keys and scripts still run it, and hear why it cannot be done. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"
#include "ui/window/recent_shows.h"

#include <QMenu>
#include <QMenuBar>

#include <glm/glm.hpp>

namespace ghost::ui {

class Menus : public QObject {
    Q_OBJECT
public:
    Menus(Actions& actions, AppModel& app, ShowDocument& document, RecentShows& recent);
    void fill(QMenuBar& bar);
    // What the right button brings up over the list of fixtures.
    void fill_for_fixtures(QMenu& menu);
    // Before it, over the picture, what is about that place in it, (0, 0) its top left corner.
    void fill_for_picture(QMenu& menu, const glm::vec2& place);

private:
    // "-" is a line between groups, "@recent" the shows of the last time.
    void add(QMenu& menu, const QString& names);
    void add_recent(QMenu& menu);
    void add_languages(QMenu& menu);
    void grey(QMenu& menu);

    Actions& actions_;
    AppModel& app_;
    ShowDocument& document_;
    RecentShows& recent_;
};

} // namespace ghost::ui
