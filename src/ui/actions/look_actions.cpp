// SPDX-License-Identifier: Apache-2.0
// The actions that are about looks, solo and what-if.
#include "ui/actions/look_actions.h"

#include "image/colour.h"
#include "ui/language/language.h"

#include <QColor>

namespace ghost::ui {
namespace {

using Run = std::function<Result<void>(const QStringList& words)>;

Result<void> set_solo(AppModel& app, const QStringList& words) {
    Look look = app.look();
    const bool on = words.isEmpty() ? look.solo.empty() : words[0] == "on";
    if (!words.isEmpty() && words[0] != "on" && words[0] != "off")
        return Error{"'" + words[0].toStdString() + "' is neither on nor off", ""};
    if (on) TRY_VOID(need_selection(app));
    look.solo = on ? app.selection() : std::set<std::size_t>{};
    app.set_look(std::move(look), on ? translated("Undo", "solo") : translated("Undo", "end of solo"));
    return {};
}

// What a gel of this colour on a screen lets through: unlike a colour by hand it is not made brighter.
glm::vec3 transmission_of(const QColor& colour) {
    const auto linear = [](float encoded) { return image::srgb_to_linear(encoded); };
    return glm::max(image::rec709_to_rec2020({linear(static_cast<float>(colour.redF())),
                                              linear(static_cast<float>(colour.greenF())),
                                              linear(static_cast<float>(colour.blueF()))}),
                    glm::vec3(0));
}

Result<void> set_gel(AppModel& app, const QStringList& words) {
    TRY_VOID(need_selection(app));
    std::optional<glm::vec3> gel;
    if (words.value(0) != "off") {
        const QColor colour(words.value(0));
        if (!colour.isValid())
            return Error{"'" + words.value(0).toStdString() + "' is neither off nor a colour like #ff8000",
                         ""};
        gel = transmission_of(colour);
    }
    change_selected(app, translated("Undo", "gel"), ProgrammerStep::gel,
                    [&](fixture::Programmer& programmer) { programmer.gel = gel; });
    return {};
}

Result<void> set_lamp(AppModel& app, const QStringList& words) {
    TRY_VOID(need_selection(app));
    std::optional<float> factor, white_k;
    if (words.value(0) != "off") {
        TRY(const double times, number_of(words, 0, "factor", 0, 1000));
        factor = static_cast<float>(times);
        if (words.size() > 1) {
            TRY(const double kelvin, number_of(words, 1, "number of kelvin", 1000, 25000));
            white_k = static_cast<float>(kelvin);
        }
    }
    change_selected(app, translated("Undo", "lamp"), ProgrammerStep::lamp,
                    [&](fixture::Programmer& programmer) {
                        programmer.lamp = factor;
                        programmer.lamp_k = white_k;
                    });
    return {};
}

} // namespace

void add_look_actions(Actions& actions, AppModel& app, Looks& looks) {
    const auto add = [&](const QString& name, const QString& text, const QString& key,
                         const QString& arguments, const Run& run) {
        actions.add(
            {name, text.isEmpty() ? "" : "Play", text.isEmpty() ? name : text, key, arguments, run, {}});
    };
    const auto word = [](const QStringList& words, int index) { return words.value(index).toStdString(); };
    add("look-store", "", "", "NAME",
        [&looks, word](const QStringList& words) { return looks.store(word(words, 0)); });
    add("look-capture", "", "", "NAME",
        [&looks, word](const QStringList& words) { return looks.store_as_it_shines(word(words, 0)); });
    add("look-recall", "", "", "NAME [SECONDS]", [&looks, word](const QStringList& words) -> Result<void> {
        if (words.size() < 2) return looks.recall(word(words, 0));
        TRY(const double seconds, number_of(words, 1, "number of seconds", 0, scene::kLongestFade_s));
        return looks.recall(word(words, 0), seconds);
    });
    add("look-rename", "", "", "NAME NEW-NAME",
        [&looks, word](const QStringList& words) { return looks.rename(word(words, 0), word(words, 1)); });
    add("look-fade", "", "", "NAME SECONDS", [&looks, word](const QStringList& words) -> Result<void> {
        TRY(const double seconds, number_of(words, 1, "number of seconds", 0, scene::kLongestFade_s));
        return looks.set_fade(word(words, 0), seconds);
    });
    add("look-remove", "", "", "NAME",
        [&looks, word](const QStringList& words) { return looks.remove(word(words, 0)); });
    add("look-next", translated("Action", "Next look"), "Ctrl+PgDown", "",
        [&looks](const QStringList&) { return looks.step(1); });
    add("look-before", translated("Action", "Look before"), "Ctrl+PgUp", "",
        [&looks](const QStringList&) { return looks.step(-1); });
    actions.add({"solo", "Play", translated("Action", "Solo: the selected fixtures alone shine"), "O",
                 "[on|off]", [&app](const QStringList& words) { return set_solo(app, words); },
                 [&app] { return !app.look().solo.empty(); }});
    add("gel", "", "", "#RRGGBB|off", [&app](const QStringList& words) { return set_gel(app, words); });
    add("lamp", "", "", "FACTOR [KELVIN]|off",
        [&app](const QStringList& words) { return set_lamp(app, words); });
}

} // namespace ghost::ui
