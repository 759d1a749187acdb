// SPDX-License-Identifier: Apache-2.0
// The actions that are about the camera, the selection and the exposure.
#include "base/text.h"
#include "show/camera_moves.h"
#include "show/show.h"
#include "stage/box.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"

#include <glm/gtc/constants.hpp>

namespace ghost::ui {
namespace {

constexpr float kPerson_m = 2; // radius of what is looked at around one fixture
constexpr double kMostEv = 20, kLeastEv = -10;

// Numbers of a line, all of them.
Result<std::vector<float>> numbers(const QStringList& words, int count, double most) {
    std::vector<float> values;
    for (int i = 0; i < count; ++i) {
        TRY(const double value, number_of(words, i, "number", -most, most));
        values.push_back(static_cast<float>(value));
    }
    return values;
}

Result<void> go_to(AppModel& app, const QString& which) {
    TRY_VOID(need_show(app));
    const std::vector<scene::Camera>& cameras = app.show()->cameras;
    bool is_number = false;
    const int number = which.toInt(&is_number);
    if (is_number && number >= 1 && number <= static_cast<int>(cameras.size())) {
        app.travel_to_stored(cameras[static_cast<std::size_t>(number - 1)]);
        return {};
    }
    const Result<std::size_t> found = app.show()->find_camera(which.toStdString());
    if (!found.ok() && is_number)
        return Error{"the show has " + std::to_string(cameras.size()) + " cameras, no number " +
                         which.toStdString(),
                     ""};
    TRY_VOID(found);
    app.travel_to_stored(cameras[*found]);
    return {};
}

Result<void> focus(AppModel& app, bool all) {
    TRY_VOID(need_show(app));
    const std::vector<FixtureNow>& fixtures = app.rig().fixtures;
    scene::Box box;
    for (const std::size_t index : app.selection()) {
        if (index >= fixtures.size()) continue;
        box.add(fixtures[index].light_m);
    }
    if (const auto object = app.marked(); !all && app.selection().empty() && object) {
        const Object& one = app.opened().objects[*object];
        app.look_at(one.centre_m, kPerson_m + one.radius_m);
        return {};
    }
    if (all || box.is_empty())
        app.look_at(app.opened().centre_m, app.opened().radius_m);
    else
        app.look_at(box.middle_m(), kPerson_m + 0.5f * glm::length(box.size_m()));
    return {};
}

// That the picture has, where it finds its own.
double exposure_seen(const AppModel& app) {
    const bool is_measured = app.camera().auto_exposure && app.picture().image;
    return static_cast<double>(is_measured ? app.picture().ev100 : app.camera().ev100);
}

Result<void> expose(AppModel& app, double ev100, bool automatic) {
    app.set_exposure(static_cast<float>(std::clamp(ev100, kLeastEv, kMostEv)), automatic);
    return {};
}

void add_moves(Actions& actions, AppModel& app) {
    const auto move = [&](const QString& name, const QString& arguments, int count, double most, auto f) {
        actions.add({name,
                     "",
                     name,
                     "",
                     arguments,
                     [&app, count, most, f](const QStringList& words) -> Result<void> {
                         TRY(const std::vector<float> values, numbers(words, count, most));
                         app.set_camera(f(app.camera_to_move(), values));
                         return {};
                     },
                     {}});
    };
    using Values = std::vector<float>;
    move("orbit", "RIGHT-DEG UP-DEG", 2, 3600, [](const scene::Camera& camera, const Values& v) {
        return scene::orbited(camera, glm::radians(v[0]), glm::radians(v[1]));
    });
    move("turn", "LEFT-DEG UP-DEG", 2, 3600, [](const scene::Camera& camera, const Values& v) {
        return scene::turned(camera, glm::radians(v[0]), glm::radians(v[1]));
    });
    move("fly", "RIGHT-M FORWARD-M UP-M", 3, 10000, [](const scene::Camera& camera, const Values& v) {
        return scene::flown(camera, {v[0], v[1], v[2]});
    });
    move("slide", "RIGHT-SHARE UP-SHARE", 2, 100,
         [](const scene::Camera& camera, const Values& v) { return scene::panned(camera, v[0], v[1]); });
    actions.add({"dolly",
                 "",
                 "dolly",
                 "",
                 "FACTOR",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double factor, number_of(words, 0, "factor", 0.001, 1000));
                     app.set_camera(scene::dollied(app.camera_to_move(), static_cast<float>(factor)));
                     return {};
                 },
                 {}});
    actions.add({"look",
                 "",
                 "look",
                 "",
                 "X Y Z TARGET-X TARGET-Y TARGET-Z [FOV-DEG]",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const Values v, numbers(words, 6, 10000));
                     scene::Camera camera = app.camera_to_move();
                     camera.position_m = {v[0], v[1], v[2]};
                     camera.target_m = {v[3], v[4], v[5]};
                     if (glm::distance(camera.position_m, camera.target_m) < 1e-3f)
                         return Error{"the camera stands at what it looks at", ""};
                     if (words.size() > 6) {
                         TRY(const double fov, number_of(words, 6, "field of view", 1, 150));
                         camera.fov_y_deg = static_cast<float>(fov);
                     }
                     app.set_camera(camera);
                     return {};
                 },
                 {}});
}

} // namespace

void add_camera_actions(Actions& actions, AppModel& app,
                        const std::function<std::optional<std::set<std::size_t>>()>& listed) {
    actions.add({"camera",
                 "",
                 "camera",
                 "",
                 "NAME|NUMBER",
                 [&app](const QStringList& words) { return go_to(app, words.value(0)); },
                 {}});
    for (int number = 1; number <= 9; ++number)
        actions.add({QString("camera-%1").arg(number),
                     "Camera",
                     translated("Action", "Camera %1").arg(number),
                     QString::number(number),
                     "",
                     [&app, number](const QStringList&) { return go_to(app, QString::number(number)); },
                     {}});
    actions.add({"focus",
                 "Camera",
                 translated("Action", "Look at the selection"),
                 "F",
                 "",
                 [&app](const QStringList&) { return focus(app, false); },
                 {}});
    actions.add({"see-all",
                 "Camera",
                 translated("Action", "Look at the whole rig"),
                 "Home",
                 "",
                 [&app](const QStringList&) { return focus(app, true); },
                 {}});
    add_moves(actions, app);
    actions.add({"exposure",
                 "",
                 "exposure",
                 "",
                 "EV100",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double ev100, number_of(words, 0, "EV100", kLeastEv, kMostEv));
                     return expose(app, ev100, false);
                 },
                 {}});
    actions.add({"brighter",
                 "Camera",
                 translated("Action", "Expose brighter"),
                 "+; =",
                 "",
                 [&app](const QStringList&) { return expose(app, exposure_seen(app) - 0.5, false); },
                 {}});
    actions.add({"darker",
                 "Camera",
                 translated("Action", "Expose darker"),
                 "-",
                 "",
                 [&app](const QStringList&) { return expose(app, exposure_seen(app) + 0.5, false); },
                 {}});
    actions.add({"auto-exposure", "Camera", translated("Action", "Automatic exposure"), "X", "",
                 [&app](const QStringList&) {
                     // What the picture has now is where the hand goes on.
                     return expose(app, exposure_seen(app), !app.camera().auto_exposure);
                 },
                 [&app] { return app.camera().auto_exposure; }});
    actions.add({"baked", "Camera", translated("Action", "Baked pictures where they are fresh"), "",
                 "[on|off]",
                 [&app](const QStringList& words) -> Result<void> {
                     const QString word = words.value(0, app.request().takes_baked ? "off" : "on");
                     if (word != "on" && word != "off")
                         return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
                     app.change_request([&](ViewRequest& request) { request.takes_baked = word == "on"; });
                     return {};
                 },
                 [&app] { return app.request().takes_baked; }});
    actions.add({"select",
                 "",
                 "select",
                 "",
                 "NAME...",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_show(app));
                     if (app.show()->fixtures.empty()) return Error{"the show has no fixtures", ""};
                     std::set<std::size_t> wanted;
                     for (const QString& word : words) {
                         const std::size_t before = wanted.size();
                         for (std::size_t i = 0; i < app.show()->fixtures.size(); ++i)
                             if (matches(word.toStdString(), app.show()->fixtures[i].name)) wanted.insert(i);
                         if (wanted.size() == before)
                             return Error{
                                 (before > 0 ? "no further fixture is called '" : "no fixture is called '") +
                                     word.toStdString() + "'",
                                 ""};
                     }
                     app.select(std::move(wanted));
                     return {};
                 },
                 {}});
    actions.add({"select-all",
                 "Edit",
                 translated("Action", "Select all fixtures"),
                 "Ctrl+A",
                 "",
                 [&app, &actions, listed](const QStringList&) -> Result<void> {
                     std::set<std::size_t> all;
                     const auto of_list = actions.is_by_hand() && listed ? listed() : std::nullopt;
                     if (of_list) all = *of_list;
                     for (std::size_t i = 0; !of_list && app.show() && i < app.show()->fixtures.size(); ++i)
                         all.insert(i);
                     app.select(std::move(all));
                     return {};
                 },
                 {}});
    actions.add({"select-none",
                 "Edit",
                 translated("Action", "Select nothing"),
                 "Esc",
                 "",
                 [&app, &actions](const QStringList&) -> Result<void> {
                     // A hand takes one thing after the other, for the key is pressed twice as easily.
                     const bool had_object = app.marked().has_value();
                     if (actions.is_by_hand() && !had_object && app.selection().empty() &&
                         actions.item("full-screen"))
                         return actions.run("full-screen off"); // as with every film; does nothing else
                     app.mark(std::nullopt);
                     if (!had_object || !actions.is_by_hand()) app.select({});
                     return {};
                 },
                 {}});
}

} // namespace ghost::ui
