// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/programmer_actions.h"

#include "base/suggest.h"
#include "base/text.h"
#include "image/colour.h"
#include "show/show.h"
#include "stage/overrides.h"
#include "ui/language/language.h"
#include "ui/model/head_parameters.h"
#include "ui/model/head_values.h"

#include <QColor>

#include <algorithm>

namespace ghost::ui {
namespace {

Result<bool> switch_of(const QStringList& arguments, int index) {
    const QString word = index < arguments.size() ? arguments[index] : QString();
    if (word == "on") return true;
    if (word == "off") return false;
    return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
}

// One number for all selected fixtures.
void add_number(Actions& actions, AppModel& app, const QString& name, ProgrammerStep kind, double low,
                double high, std::optional<float> fixture::Programmer::*value) {
    actions.add({name,
                 "",
                 name,
                 "",
                 "NUMBER",
                 [&app, name, kind, low, high, value](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_selection(app));
                     TRY(const double number, number_of(words, 0, "number", low, high));
                     change_selected(app, name, kind, [&](fixture::Programmer& programmer) {
                         programmer.*value = static_cast<float>(number);
                     });
                     return {};
                 },
                 {}});
}

Result<void> set_parameter_by_name(AppModel& app, const QStringList& words) {
    TRY_VOID(need_selection(app));
    std::optional<float> share;
    if (words.value(1) != "off") {
        TRY(const double number, number_of(words, 1, "share", 0, 1));
        share = static_cast<float>(number);
    }
    TRY(const std::string attribute, attribute_named(app, words.value(0)));
    Look look = app.look();
    for (const std::size_t index : app.selection())
        set_parameter(app.show()->fixtures[index], attribute, share, look.fixtures[index]);
    app.set_look(std::move(look), words.value(0).toLower());
    return {};
}

Result<void> drive_mover_by_name(AppModel& app, const QStringList& words) {
    TRY(const std::size_t index, mover_called(app, words.value(0)));
    const scene::Mover& mover = app.show()->movers[index];
    if (words.value(1) == "off") {
        drive_mover(app, index, {});
        return {};
    }
    if (words.size() != static_cast<int>(mover.axes.size()) + 1)
        return Error{"mover '" + mover.name + "' has " + std::to_string(mover.axes.size()) +
                         " axes, expected a number for each, or off",
                     ""};
    std::vector<float> values;
    for (std::size_t k = 0; k < mover.axes.size(); ++k) {
        TRY(const double value,
            number_of(words, static_cast<int>(k) + 1, "value", static_cast<double>(mover.axes[k].low),
                      static_cast<double>(mover.axes[k].high)));
        values.push_back(static_cast<float>(value));
    }
    drive_mover(app, index, std::move(values));
    return {};
}

// Those that carry what is selected or chosen, along their ways: hoists all alike, of others the first axis.
Result<void> drive_on(AppModel& app, float steps) {
    constexpr float kStep_m = 0.1f, kStep_deg = 5;
    TRY_VOID(need_show(app));
    std::set<int> movers;
    for (const std::size_t fixture : app.selection()) movers.insert(app.show()->fixtures[fixture].mover);
    if (const auto object = app.marked(); object && app.selection().empty())
        movers.insert(app.opened().objects[*object].mover);
    movers.erase(scene::kNoMover);
    if (movers.empty())
        return Error{"nothing that a mover carries is selected: click a lamp on it, or double click it", ""};
    for (const int index : movers) {
        const auto mover = static_cast<std::size_t>(index);
        const scene::Mover& of = app.show()->movers[mover];
        std::vector<float> values = mover_goals(app, mover);
        const std::size_t count = of.kind == scene::MoverKind::hoists ? values.size() : 1;
        for (std::size_t k = 0; k < std::min(count, values.size()); ++k) {
            const scene::MoverAxis& axis = of.axes[k];
            values[k] =
                std::clamp(values[k] + steps * (axis.is_angle ? kStep_deg : kStep_m), axis.low, axis.high);
        }
        drive_mover(app, mover, std::move(values));
    }
    return {};
}

Result<void> set_motion(AppModel& app, const QString& word) {
    TRY_VOID(need_show(app));
    const bool is_machine =
        app.request().motion.value_or(app.show()->motion) == fixture::Motion::as_the_machine;
    const auto motion = word.isEmpty() ? std::optional(is_machine ? fixture::Motion::as_commanded
                                                                  : fixture::Motion::as_the_machine)
                                       : fixture::motion_from(word.toStdString());
    if (!motion) return Error{"'" + word.toStdString() + "' is neither commanded nor machine", ""};
    app.change_request([&](ViewRequest& request) { request.motion = motion; });
    return {};
}

void add_mover_actions(Actions& actions, AppModel& app) {
    actions.add({"mover",
                 "",
                 "mover",
                 "",
                 "NAME VALUE...|off",
                 [&app](const QStringList& words) { return drive_mover_by_name(app, words); },
                 {}});
    const auto add = [&](const QString& name, const QString& text, const QString& key, float steps) {
        actions.add({name,
                     "Edit",
                     text,
                     key,
                     "",
                     [&app, steps](const QStringList&) { return drive_on(app, steps); },
                     {}});
    };
    add("mover-on", translated("Action", "Drive its mover on: 0.1 m up, 5 degrees"), "Alt+PgUp", 1);
    add("mover-back", translated("Action", "Drive its mover back: 0.1 m down, 5 degrees"), "Alt+PgDown", -1);
    actions.add({"motion", "Play", translated("Action", "Heads and movers go as machines do"), "",
                 "[commanded|machine]",
                 [&app](const QStringList& words) { return set_motion(app, words.value(0)); },
                 [&app] {
                     return app.show() && app.request().motion.value_or(app.show()->motion) ==
                                              fixture::Motion::as_the_machine;
                 }});
}

void add_fixture_actions(Actions& actions, AppModel& app) {
    add_number(actions, app, "intensity", ProgrammerStep::intensity, 0, 1, &fixture::Programmer::intensity);
    add_number(actions, app, "zoom", ProgrammerStep::zoom, 0.05, 160, &fixture::Programmer::zoom_deg);
    add_number(actions, app, "pan", ProgrammerStep::pan, -3600, 3600, &fixture::Programmer::pan_deg);
    add_number(actions, app, "tilt", ProgrammerStep::tilt, -3600, 3600, &fixture::Programmer::tilt_deg);
    actions.add({"colour",
                 "",
                 "colour",
                 "",
                 "#RRGGBB",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_selection(app));
                     const QColor colour(words.value(0));
                     if (!colour.isValid())
                         return Error{"'" + words.value(0).toStdString() + "' is no colour like #ff8000", ""};
                     change_selected(
                         app, "colour", ProgrammerStep::colour,
                         [&](fixture::Programmer& programmer) { programmer.colour = filter_from(colour); });
                     return {};
                 },
                 {}});
    actions.add({"parameter",
                 "",
                 "parameter",
                 "",
                 "ATTRIBUTE SHARE|off",
                 [&app](const QStringList& words) { return set_parameter_by_name(app, words); },
                 {}});
    actions.add({"gobo",
                 "",
                 "gobo",
                 "",
                 "SLOT",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_selection(app));
                     TRY(const double slot, number_of(words, 0, "slot, 0 is open,", 0, 255));
                     change_selected(
                         app, translated("Undo", "gobo"), ProgrammerStep::gobo,
                         [&](fixture::Programmer& programmer) { programmer.gobo = static_cast<int>(slot); });
                     return {};
                 },
                 {}});
    actions.add({"release",
                 "Edit",
                 translated("Action", "Give the selected fixtures back"),
                 "R",
                 "",
                 [&app](const QStringList&) -> Result<void> {
                     const Look& look = app.look();
                     const std::set<std::size_t>& selection = app.selection();
                     if (std::none_of(selection.begin(), selection.end(),
                                      [&](std::size_t one) { return look.fixtures.contains(one); }))
                         return Error{selection.empty()
                                          ? "no fixture is selected; Shift+R gives everything back"
                                          : "nothing of the selected fixtures is set by hand; "
                                            "Shift+R gives everything back",
                                      ""};
                     change_selected(app, translated("Undo", "give back"), ProgrammerStep::step,
                                     [](fixture::Programmer& programmer) { programmer = {}; });
                     return {};
                 },
                 {}});
    actions.add({"release-all",
                 "Edit",
                 translated("Action", "Give back everything set by hand"),
                 "Shift+R",
                 "",
                 [&app](const QStringList&) -> Result<void> {
                     app.set_look({}, translated("Undo", "give everything back"));
                     return {};
                 },
                 {}});
}

void add_scene_actions(Actions& actions, AppModel& app) {
    actions.add({"smoke",
                 "",
                 "smoke",
                 "",
                 "FACTOR",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double factor, number_of(words, 0, "factor", 0, 20));
                     change_scene(app, translated("Undo", "smoke"), ProgrammerStep::scene,
                                  [&](SceneLook& scene) { scene.smoke = static_cast<float>(factor); });
                     return {};
                 },
                 {}});
    actions.add({"ambient",
                 "",
                 "ambient",
                 "",
                 "LUX [#RRGGBB]",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double lux, number_of(words, 0, "number of lux", 0, 100000));
                     const QColor colour(words.value(1, "#ffffff"));
                     if (!colour.isValid())
                         return Error{"'" + words.value(1).toStdString() + "' is no colour like #ff8000", ""};
                     change_scene(app, translated("Undo", "even light"), ProgrammerStep::scene,
                                  [&](SceneLook& scene) {
                                      scene.ambient_lux = static_cast<float>(lux);
                                      if (words.size() > 1) scene.ambient_colour = filter_from(colour);
                                  });
                     return {};
                 },
                 {}});
    actions.add({"attenuation",
                 "",
                 "attenuation",
                 "",
                 "CONSTANT LINEAR QUADRATIC",
                 [&app](const QStringList& words) -> Result<void> {
                     glm::vec3 factors(0);
                     for (int i = 0; i < 3; ++i) {
                         TRY(const double factor, number_of(words, i, "factor", 0, 1000));
                         factors[i] = static_cast<float>(factor);
                     }
                     if (factors == glm::vec3(0)) return Error{"one of the factors must be above 0", ""};
                     change_scene(app, translated("Undo", "attenuation"), ProgrammerStep::scene,
                                  [&](SceneLook& scene) { scene.attenuation = factors; });
                     return {};
                 },
                 {}});
    actions.add({"samples",
                 "",
                 "samples",
                 "",
                 "NUMBER",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const double samples, number_of(words, 0, "number of samples", 1, 256));
                     change_samples(app, static_cast<int>(samples));
                     return {};
                 },
                 {}});
    actions.add({"shadows",
                 "",
                 "shadows",
                 "",
                 "on|off",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const bool on, switch_of(words, 0));
                     change_scene(app, translated("Undo", "shadows"), ProgrammerStep::step,
                                  [&](SceneLook& scene) { scene.shadows = on; });
                     return {};
                 },
                 {}});
    actions.add({"object",
                 "",
                 "object",
                 "",
                 "NAME on|off",
                 [&app](const QStringList& words) -> Result<void> {
                     TRY(const bool on, switch_of(words, 1));
                     Look look = app.look();
                     bool found = false;
                     for (const Object& object : app.opened().objects) {
                         if (!matches(words[0].toStdString(), object.name)) continue;
                         found = true;
                         look.shown.erase(object.instance);
                         if (object.shown != on) look.shown[object.instance] = on;
                     }
                     if (!found) return Error{"there is no object '" + words[0].toStdString() + "'", ""};
                     app.set_look(std::move(look),
                                  on ? translated("Undo", "show object") : translated("Undo", "hide object"));
                     return {};
                 },
                 {}});
    actions.add(
        {"surface",
         "",
         "surface",
         "",
         "MATERIAL specular|roughness|shininess NUMBER",
         [&app](const QStringList& words) -> Result<void> {
             const QString key = words.value(1);
             if (key != "specular" && key != "roughness" && key != "shininess")
                 return Error{"'" + key.toStdString() + "' is none of specular, roughness, shininess", ""};
             TRY(const double number, number_of(words, 2, "number", 0, key == "shininess" ? 100000 : 1));
             Look look = app.look();
             bool found = false;
             const auto& materials = app.opened().materials;
             for (std::size_t i = 0; i < materials.size(); ++i) {
                 if (!matches(words[0].toStdString(), materials[i].name)) continue;
                 found = true;
                 const auto value = static_cast<float>(number);
                 if (key == "specular")
                     look.surfaces[i].specular = value;
                 else
                     look.surfaces[i].roughness =
                         key == "roughness" ? value : scene::roughness_from_shininess(value);
             }
             if (!found) return Error{"there is no material '" + words[0].toStdString() + "'", ""};
             app.set_look(std::move(look), key, static_cast<int>(ProgrammerStep::surface));
             return {};
         },
         {}});
}

} // namespace

Result<void> need_show(const AppModel& app) {
    if (app.show()) return {};
    return Error{"no show is open", ""};
}

Result<void> need_selection(const AppModel& app) {
    if (!app.selection().empty()) return {};
    return Error{"no fixture is selected", ""};
}

Result<std::string> attribute_named(const AppModel& app, const QString& words) {
    std::vector<std::string> names;
    for (const HeadParameter& parameter : parameters_of(*app.show(), app.selection())) {
        if (words == QString::fromStdString(parameter.attribute) || words == parameter.name)
            return parameter.attribute;
        names.push_back(parameter.attribute);
    }
    return Error{"no selected fixture has '" + words.toStdString() + "'" +
                     did_you_mean(words.toStdString(), names),
                 ""};
}

glm::vec3 filter_from(const QColor& colour) {
    const auto linear = [](double encoded) { return image::srgb_to_linear(static_cast<float>(encoded)); };
    const glm::vec3 rgb =
        image::rec709_to_rec2020({linear(colour.redF()), linear(colour.greenF()), linear(colour.blueF())});
    return rgb / std::max({rgb.x, rgb.y, rgb.z, 1e-4f});
}

QColor screen_colour(const glm::vec3& rec2020) {
    glm::vec3 rgb = glm::max(image::rec2020_to_rec709(rec2020), glm::vec3(0));
    rgb /= std::max({rgb.x, rgb.y, rgb.z, 1.0f});
    return QColor::fromRgbF(image::linear_to_srgb(rgb.x), image::linear_to_srgb(rgb.y),
                            image::linear_to_srgb(rgb.z));
}

Result<std::size_t> mover_called(const AppModel& app, const QString& words) {
    TRY_VOID(need_show(app));
    std::vector<std::string> names;
    for (const scene::Mover& mover : app.show()->movers) names.push_back(mover.name);
    const std::string name = words.toStdString();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        return Error{"the show has no mover '" + name + "'" + did_you_mean(name, names), ""};
    return static_cast<std::size_t>(found - names.begin());
}

std::vector<float> mover_goals(const AppModel& app, std::size_t mover) {
    std::vector<float> goals;
    if (const auto by_hand = app.look().movers.find(mover); by_hand != app.look().movers.end())
        goals = by_hand->second;
    else if (mover < app.rig().movers.size())
        goals = app.rig().movers[mover].goals;
    goals.resize(app.show()->movers[mover].axes.size());
    return goals;
}

void drive_mover(AppModel& app, std::size_t mover, std::vector<float> values) {
    Look look = app.look();
    const bool lets_go = values.empty();
    if (lets_go)
        look.movers.erase(mover);
    else
        look.movers[mover] = std::move(values);
    const QString name = QString::fromStdString(app.show()->movers[mover].name);
    app.set_look(std::move(look),
                 lets_go ? translated("Undo", "release %1").arg(name)
                         : translated("Undo", "drive %1").arg(name),
                 static_cast<int>(lets_go ? ProgrammerStep::step : ProgrammerStep::mover));
}

void change_samples(AppModel& app, std::optional<int> samples) {
    Look look = app.look();
    look.haze_samples = samples;
    app.set_look(std::move(look),
                 samples ? translated("Undo", "samples") : translated("Undo", "release samples"),
                 static_cast<int>(samples ? ProgrammerStep::samples : ProgrammerStep::step));
}

QString words_of(const Look& look) {
    QStringList words;
    const auto number = [](const auto& all) { return all.size(); };
    if (!look.fixtures.empty())
        words << translated("By hand", "%n fixture(s)", nullptr, number(look.fixtures));
    if (look.scene != SceneLook{}) words << translated("By hand", "scene");
    if (!look.shown.empty()) words << translated("By hand", "%n object(s)", nullptr, number(look.shown));
    if (!look.surfaces.empty())
        words << translated("By hand", "%n material(s)", nullptr, number(look.surfaces));
    if (!look.solo.empty()) words << translated("By hand", "solo");
    if (look.haze_samples) words << translated("By hand", "samples");
    if (!look.movers.empty()) words << translated("By hand", "%n mover(s)", nullptr, number(look.movers));
    return words.join(", ");
}

void add_programmer_actions(Actions& actions, AppModel& app) {
    add_fixture_actions(actions, app);
    add_scene_actions(actions, app);
    add_mover_actions(actions, app);
}

} // namespace ghost::ui
