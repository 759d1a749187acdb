#pragma once
// SPDX-License-Identifier: Apache-2.0
// Set pieces: which object of the stage is chosen, and where it stands, written as an [[object]] of the show,
// one step of the undo list. Errors: there is no such object, or others elsewhere are called the same, for a
// show knows objects by name; those at the same place are parts of it and go along. Which are hidden by hand
// belongs to the look. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace ghost::ui {

// Of Opened::objects; without a name, the chosen one.
Result<std::size_t> object_called(const AppModel& app, const QString& name);

// What has several materials comes as several objects of one name at one place.
bool is_part_of(const Object& one, const Object& other);
// Of the objects called as the one that was met, that which is there; nothing: there is none.
std::optional<std::size_t> object_met(const AppModel& app, const Picked& picked);

// object: of Opened::objects.
Result<void> move_object(AppModel& app, ShowDocument& document, std::size_t object, const glm::vec3& by_m);

// "choose-object [OBJECT]", "move-object X Y Z [OBJECT]", and a key for each way on the floor.
void add_object_actions(Actions& actions, AppModel& app, ShowDocument& document);

// Hides by hand what the picture shows at a place, as soon as the engine says what that is, with all its
// parts: one step of the undo list. Heads and air are told and stay.
class Hiding : public QObject {
    Q_OBJECT
public:
    // actions: where it is said what cannot be.
    Hiding(AppModel& app, Actions& actions, QObject* parent);
    // (0, 0): the top left corner of the picture.
    Result<void> hide_through(const glm::vec2& place);

    std::function<void(const QString&)> on_done; // what was hidden

private:
    void take_picked();
    Result<void> hide(const Picked& picked);

    AppModel& app_;
    Actions& actions_;
    std::uint64_t number_ = 0; // of the pick that is waited for; 0: none
};

// "hide-through [X Y]".
void add_hide_action(Actions& actions, Hiding& hiding);

} // namespace ghost::ui
