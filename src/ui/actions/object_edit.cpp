// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/object_edit.h"

#include "base/suggest.h"
#include "base/text.h"
#include "show/camera_moves.h"
#include "show/show.h"
#include "show_file/object_edit.h"
#include "stage/overrides.h"
#include "ui/actions/patch_edit.h"
#include "ui/language/language.h"

#include <algorithm>

namespace ghost::ui {
namespace {

constexpr double kFarthest_m = scene::kMaxCoordinate_m;
constexpr float kNudge_m = 0.1f;

// What the show moves it by already.
glm::vec3 moved_m(const scene::Show& show, const std::string& name) {
    glm::vec3 moved(0);
    for (const scene::ObjectSettings& settings : show.objects)
        if (settings.move_m && matches(settings.name, name)) moved = *settings.move_m;
    return moved;
}

} // namespace

bool is_part_of(const Object& one, const Object& other) {
    return glm::distance(one.centre_m, other.centre_m) < std::max(one.radius_m, other.radius_m);
}

Result<std::size_t> object_called(const AppModel& app, const QString& name) {
    if (!app.show()) return Error{"no show is open", ""};
    if (name.isEmpty()) {
        if (app.marked()) return *app.marked();
        return Error{"no object of the stage is chosen: double click one, or choose it in Scene", ""};
    }
    std::vector<std::string> names;
    const std::vector<Object>& objects = app.opened().objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i].name == name.toStdString()) return i;
        names.push_back(objects[i].name);
    }
    return Error{
        "the stage has no object '" + name.toStdString() + "'" + did_you_mean(name.toStdString(), names), ""};
}

Result<void> move_object(AppModel& app, ShowDocument& document, std::size_t object, const glm::vec3& by_m) {
    TRY_VOID(document.check_editable());
    const std::vector<Object>& objects = app.opened().objects;
    if (object >= objects.size()) return Error{"there is no such object", ""};
    const std::string& name = objects[object].name;
    const auto elsewhere = std::count_if(objects.begin(), objects.end(), [&](const Object& one) {
        return matches(name, one.name) && !is_part_of(one, objects[object]);
    });
    if (elsewhere > 0)
        return Error{std::to_string(elsewhere + 1) + " objects are called '" + name +
                         "', and a show knows them by name: in the model give each its own",
                     ""};
    const glm::vec3 move_m = glm::round((moved_m(*app.show(), name) + by_m) * 1000.0f) / 1000.0f;
    TRY(std::string text, scene::set_object_move(document.text(), name, move_m));
    return document.edit(translated("Undo", "'%1' moved").arg(QString::fromStdString(name)),
                         {std::move(text), app.look(), app.selection()});
}

std::optional<std::size_t> object_met(const AppModel& app, const Picked& picked) {
    const std::vector<Object>& objects = app.opened().objects;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i].name != picked.object) continue;
        if (!nearest || glm::distance(objects[i].centre_m, picked.at_m) <
                            glm::distance(objects[*nearest].centre_m, picked.at_m))
            nearest = i;
    }
    return nearest;
}

Hiding::Hiding(AppModel& app, Actions& actions, QObject* parent)
    : QObject(parent), app_(app), actions_(actions) {
    connect(&app_, &AppModel::picked_came, this, &Hiding::take_picked);
}

Result<void> Hiding::hide_through(const glm::vec2& place) {
    if (!app_.picture().image) return Error{"there is no picture yet", ""};
    const scene::Camera& camera = app_.picture().camera;
    number_ = app_.pick(camera.position_m, scene::way_through(camera, place));
    return {};
}

void Hiding::take_picked() {
    const Picked& picked = app_.picked();
    if (picked.number != number_) return;
    number_ = 0;
    if (const Result<void> done = hide(picked); !done.ok() && actions_.complain)
        actions_.complain(done.error());
}

Result<void> Hiding::hide(const Picked& picked) {
    if (!picked.hit) return Error{"there is nothing but air to hide", ""};
    if (picked.fixture) return Error{"this is a fixture; Remove takes it away", ""};
    const std::optional<std::size_t> met = object_met(app_, picked);
    if (!met) return Error{"there is no such object", ""};
    const std::vector<Object>& objects = app_.opened().objects;
    Look look = app_.look();
    for (const Object& one : objects) {
        if (one.name != picked.object || !is_part_of(one, objects[*met])) continue;
        look.shown.erase(one.instance);
        if (one.shown) look.shown[one.instance] = false;
    }
    const QString what = translated("Undo", "'%1' hidden").arg(QString::fromStdString(picked.object));
    app_.set_look(std::move(look), what);
    if (on_done) on_done(what);
    return {};
}

void add_hide_action(Actions& actions, Hiding& hiding) {
    actions.add({"hide-through",
                 "",
                 "hide-through",
                 "",
                 "[X Y]",
                 [&hiding](const QStringList& words) -> Result<void> {
                     glm::vec2 place(0.5f);
                     for (int axis = 0; axis < 2 && !words.isEmpty(); ++axis) {
                         TRY(const double share, number_of(words, axis, "share of the picture", 0, 1));
                         place[axis] = static_cast<float>(share);
                     }
                     return hiding.hide_through(place);
                 },
                 {}});
}

void add_object_actions(Actions& actions, AppModel& app, ShowDocument& document) {
    actions.add({"choose-object",
                 "",
                 "choose-object",
                 "",
                 "[OBJECT]",
                 [&app](const QStringList& words) -> Result<void> {
                     if (words.isEmpty()) {
                         app.mark(std::nullopt);
                         return {};
                     }
                     TRY(const std::size_t object, object_called(app, words[0]));
                     app.mark(object);
                     return {};
                 },
                 {}});
    actions.add({"move-object",
                 "",
                 "move-object",
                 "",
                 "X Y Z [OBJECT]",
                 [&app, &document](const QStringList& words) -> Result<void> {
                     glm::vec3 by_m(0);
                     for (int axis = 0; axis < 3; ++axis) {
                         TRY(const double metres,
                             number_of(words, axis, "metres", -kFarthest_m, kFarthest_m));
                         by_m[axis] = static_cast<float>(metres);
                     }
                     TRY(const std::size_t object, object_called(app, words.value(3)));
                     return move_object(app, document, object, by_m);
                 },
                 {}});
    const auto nudge = [&](const QString& name, const QString& text, const QString& key,
                           const glm::vec3& way) {
        actions.add({"nudge-" + name,
                     "Edit",
                     text,
                     key,
                     "",
                     [&app, &document, way](const QStringList&) -> Result<void> {
                         // A chosen set piece, where no fixture is selected.
                         if (!app.selection().empty())
                             return PatchEdit(app, document).move_by(kNudge_m * way);
                         TRY(const std::size_t object, object_called(app, {}));
                         return move_object(app, document, object, kNudge_m * way);
                     },
                     {}});
    };
    nudge("left", translated("Action", "Move by 0.1 m to the left"), "Alt+Left", {-1, 0, 0});
    nudge("right", translated("Action", "Move by 0.1 m to the right"), "Alt+Right", {1, 0, 0});
    nudge("up-stage", translated("Action", "Move by 0.1 m up-stage"), "Alt+Up", {0, 1, 0});
    nudge("down-stage", translated("Action", "Move by 0.1 m down-stage"), "Alt+Down", {0, -1, 0});
}

} // namespace ghost::ui
