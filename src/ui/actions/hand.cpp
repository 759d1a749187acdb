// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/hand.h"

#include "base/suggest.h"
#include "base/text.h"
#include "image/colour.h"
#include "stage/overrides.h"
#include "ui/model/head_parameters.h"

#include <QColor>

#include <algorithm>

namespace ghost::ui {
namespace {

Result<void> need_selection(const Studio& studio) {
    if (!studio.selection().empty()) return {};
    return Error{"no fixture is selected", ""};
}

Result<bool> switch_of(const QStringList& arguments, int index) {
    const QString word = index < arguments.size() ? arguments[index] : QString();
    if (word == "on") return true;
    if (word == "off") return false;
    return Error{"'" + word.toStdString() + "' is neither on nor off", ""};
}

// One number for all selected fixtures.
void add_number(Actions& actions, Studio& studio, const QString& name, Hand kind, double low, double high,
                std::optional<float> fixture::Manual::*value) {
    actions.add({name,
                 "",
                 name,
                 "",
                 "NUMBER",
                 [&studio, name, kind, low, high, value](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_selection(studio));
                     TRY(const double number, number_of(words, 0, "number", low, high));
                     change_selected(studio, name, kind, [&](fixture::Manual& manual) {
                         manual.*value = static_cast<float>(number);
                     });
                     return {};
                 },
                 {}});
}

// By the name of GDTF or the words of the panel.
Result<void> set_parameter_by_name(Studio& studio, const QStringList& words) {
    TRY_VOID(need_selection(studio));
    std::optional<float> share;
    if (words.value(1) != "off") {
        TRY(const double number, number_of(words, 1, "share", 0, 1));
        share = static_cast<float>(number);
    }
    std::vector<std::string> names;
    for (const HeadParameter& parameter : parameters_of(*studio.show(), studio.selection())) {
        names.push_back(parameter.attribute);
        if (words.value(0) != QString::fromStdString(parameter.attribute) && words.value(0) != parameter.name)
            continue;
        Look look = studio.look();
        for (const std::size_t index : studio.selection())
            set_parameter(studio.show()->fixtures[index], parameter.attribute, share, look.fixtures[index]);
        studio.set_look(std::move(look), parameter.name.toLower());
        return {};
    }
    return Error{"no selected fixture has '" + words.value(0).toStdString() + "'" +
                     did_you_mean(words.value(0).toStdString(), names),
                 ""};
}

void add_fixture_actions(Actions& actions, Studio& studio) {
    add_number(actions, studio, "intensity", Hand::intensity, 0, 1, &fixture::Manual::intensity);
    add_number(actions, studio, "zoom", Hand::zoom, 0.05, 160, &fixture::Manual::zoom_deg);
    add_number(actions, studio, "pan", Hand::pan, -3600, 3600, &fixture::Manual::pan_deg);
    add_number(actions, studio, "tilt", Hand::tilt, -3600, 3600, &fixture::Manual::tilt_deg);
    actions.add({"colour",
                 "",
                 "colour",
                 "",
                 "#RRGGBB",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_selection(studio));
                     const QColor colour(words.value(0));
                     if (!colour.isValid())
                         return Error{"'" + words.value(0).toStdString() + "' is no colour like #ff8000", ""};
                     change_selected(studio, "colour", Hand::colour,
                                     [&](fixture::Manual& manual) { manual.colour = filter_from(colour); });
                     return {};
                 },
                 {}});
    actions.add({"parameter",
                 "",
                 "parameter",
                 "",
                 "ATTRIBUTE SHARE|off",
                 [&studio](const QStringList& words) { return set_parameter_by_name(studio, words); },
                 {}});
    actions.add({"gobo",
                 "",
                 "gobo",
                 "",
                 "SLOT",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY_VOID(need_selection(studio));
                     TRY(const double slot, number_of(words, 0, "slot, 0 is open,", 0, 255));
                     change_selected(studio, "gobo", Hand::gobo,
                                     [&](fixture::Manual& manual) { manual.gobo = static_cast<int>(slot); });
                     return {};
                 },
                 {}});
    actions.add(
        {"release",
         "Edit",
         "Release selected fixtures",
         "R",
         "",
         [&studio](const QStringList&) -> Result<void> {
             const Look& look = studio.look();
             const std::set<std::size_t>& selection = studio.selection();
             if (std::none_of(selection.begin(), selection.end(),
                              [&](std::size_t one) { return look.fixtures.contains(one); }))
                 return Error{selection.empty() ? "no fixture is selected; Shift+R releases everything"
                                                : "nothing of the selected fixtures is set by hand; "
                                                  "Shift+R releases everything",
                              ""};
             change_selected(studio, "release", Hand::step, [](fixture::Manual& manual) { manual = {}; });
             return {};
         },
         {}});
    actions.add({"release-all",
                 "Edit",
                 "Release everything set by hand",
                 "Shift+R",
                 "",
                 [&studio](const QStringList&) -> Result<void> {
                     studio.set_look({}, "release everything");
                     return {};
                 },
                 {}});
}

void add_scene_actions(Actions& actions, Studio& studio) {
    actions.add({"smoke",
                 "",
                 "smoke",
                 "",
                 "FACTOR",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const double factor, number_of(words, 0, "factor", 0, 20));
                     change_scene(studio, "smoke", Hand::scene,
                                  [&](SceneLook& scene) { scene.smoke = static_cast<float>(factor); });
                     return {};
                 },
                 {}});
    actions.add({"ambient",
                 "",
                 "ambient",
                 "",
                 "LUX [#RRGGBB]",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const double lux, number_of(words, 0, "number of lux", 0, 100000));
                     const QColor colour(words.value(1, "#ffffff"));
                     if (!colour.isValid())
                         return Error{"'" + words.value(1).toStdString() + "' is no colour like #ff8000", ""};
                     change_scene(studio, "even light", Hand::scene, [&](SceneLook& scene) {
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
                 [&studio](const QStringList& words) -> Result<void> {
                     glm::vec3 factors(0);
                     for (int i = 0; i < 3; ++i) {
                         TRY(const double factor, number_of(words, i, "factor", 0, 1000));
                         factors[i] = static_cast<float>(factor);
                     }
                     if (factors == glm::vec3(0)) return Error{"one of the factors must be above 0", ""};
                     change_scene(studio, "attenuation", Hand::scene,
                                  [&](SceneLook& scene) { scene.attenuation = factors; });
                     return {};
                 },
                 {}});
    actions.add({"samples",
                 "",
                 "samples",
                 "",
                 "NUMBER",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const double samples, number_of(words, 0, "number of samples", 1, 256));
                     change_samples(studio, static_cast<int>(samples));
                     return {};
                 },
                 {}});
    actions.add({"shadows",
                 "",
                 "shadows",
                 "",
                 "on|off",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const bool on, switch_of(words, 0));
                     change_scene(studio, "shadows", Hand::step,
                                  [&](SceneLook& scene) { scene.shadows = on; });
                     return {};
                 },
                 {}});
    actions.add({"object",
                 "",
                 "object",
                 "",
                 "NAME on|off",
                 [&studio](const QStringList& words) -> Result<void> {
                     TRY(const bool on, switch_of(words, 1));
                     Look look = studio.look();
                     bool found = false;
                     for (const Object& object : studio.opened().objects) {
                         if (!matches(words[0].toStdString(), object.name)) continue;
                         found = true;
                         look.shown.erase(object.instance);
                         if (object.shown != on) look.shown[object.instance] = on;
                     }
                     if (!found) return Error{"there is no object '" + words[0].toStdString() + "'", ""};
                     studio.set_look(std::move(look), on ? "show object" : "hide object");
                     return {};
                 },
                 {}});
    actions.add(
        {"surface",
         "",
         "surface",
         "",
         "MATERIAL specular|roughness|shininess NUMBER",
         [&studio](const QStringList& words) -> Result<void> {
             const QString key = words.value(1);
             if (key != "specular" && key != "roughness" && key != "shininess")
                 return Error{"'" + key.toStdString() + "' is none of specular, roughness, shininess", ""};
             TRY(const double number, number_of(words, 2, "number", 0, key == "shininess" ? 100000 : 1));
             Look look = studio.look();
             bool found = false;
             const auto& materials = studio.opened().materials;
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
             studio.set_look(std::move(look), key, static_cast<int>(Hand::surface));
             return {};
         },
         {}});
}

} // namespace

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

void change_samples(Studio& studio, std::optional<int> samples) {
    Look look = studio.look();
    look.haze_samples = samples;
    studio.set_look(std::move(look), samples ? "samples" : "release samples",
                    static_cast<int>(samples ? Hand::samples : Hand::step));
}

QString words_of(const Look& look) {
    QStringList words;
    const auto add = [&](std::size_t count, const QString& thing) {
        if (count > 0) words << QString("%1 %2%3").arg(count).arg(thing, count == 1 ? "" : "s");
    };
    add(look.fixtures.size(), "fixture");
    if (look.scene != SceneLook{}) words << "scene";
    add(look.shown.size(), "object");
    add(look.surfaces.size(), "material");
    if (!look.solo.empty()) words << "solo";
    if (look.haze_samples) words << "samples";
    return words.join(", ");
}

void add_hand_actions(Actions& actions, Studio& studio) {
    add_fixture_actions(actions, studio);
    add_scene_actions(actions, studio);
}

} // namespace ghost::ui
