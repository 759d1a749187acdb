// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/air_edit.h"

#include "show/haze_presets.h"
#include "show/show.h"
#include "ui/language/language.h"

#include <algorithm>

namespace ghost::ui {
namespace {

// As the show file takes them (docs/reference/show-file.md).
constexpr double kFarthestHazer_m = 10000;
constexpr double kMostExtinction_per_m = 10;

Result<glm::vec3> vector_of(const QStringList& words, int from, const char* what, double most) {
    glm::vec3 numbers{0};
    for (int i = 0; i < 3; ++i) {
        TRY(const double number, number_of(words, from + i, what, -most, most));
        numbers[i] = static_cast<float>(number);
    }
    return numbers;
}

Result<std::size_t> hazer_of(const AppModel& app, const QString& word) {
    bool is_number = false;
    const int number = word.toInt(&is_number);
    const std::size_t count = app.show() ? app.show()->hazers.size() : 0;
    if (!is_number || number < 1 || static_cast<std::size_t>(number) > count)
        return Error{"there is no hazer '" + word.toStdString() + "'; the show has " + std::to_string(count),
                     ""};
    return static_cast<std::size_t>(number) - 1;
}

using AirRun = std::function<Result<void>(AirEdit& edit, const QStringList& words)>;

} // namespace

Result<void> AirEdit::edit(const QString& what, const Result<std::string>& text, Kind kind) {
    TRY_VOID(text);
    return document_.edit(what, {*text, app_.look(), app_.selection()}, static_cast<int>(kind));
}

Result<void> AirEdit::set_haze(const QString& words) {
    TRY_VOID(document_.check_editable());
    scene::HazeEdit haze;
    bool is_number = false;
    words.toDouble(&is_number);
    if (is_number) {
        TRY(const double per_m, number_of({words}, 0, "extinction per metre", 0, kMostExtinction_per_m));
        haze.extinction_per_m = static_cast<float>(per_m);
    } else if (scene::find_haze_preset(words.toStdString())) {
        haze.preset = words.toStdString();
    } else {
        return Error{"haze " + scene::no_such_haze_preset(words.toStdString()), ""};
    }
    return edit(translated("Undo", "Haze"), scene::edit_haze(document_.text(), haze));
}

Result<void> AirEdit::set_clouds(float unevenness) {
    TRY_VOID(document_.check_editable());
    return edit(translated("Undo", "Clouds"), scene::edit_haze(document_.text(), {.unevenness = unevenness}),
                Kind::clouds);
}

Result<void> AirEdit::set_cloud_size(float patch_m) {
    TRY_VOID(document_.check_editable());
    return edit(translated("Undo", "Size of the clouds"),
                scene::edit_haze(document_.text(), {.patch_m = patch_m}), Kind::cloud_size);
}

Result<void> AirEdit::set_wind(const glm::vec3& wind_m_s) {
    TRY_VOID(document_.check_editable());
    return edit(translated("Undo", "Wind"), scene::edit_haze(document_.text(), {.wind_m_s = wind_m_s}),
                Kind::wind);
}

Result<void> AirEdit::edit_hazer(std::size_t index, const scene::HazerEdit& hazer) {
    TRY_VOID(document_.check_editable());
    return edit(translated("Undo", "Hazer"),
                scene::edit_hazer(document_.text(), app_.show()->hazers, index, hazer));
}

Result<void> AirEdit::add_hazer(const glm::vec3& position_m) {
    TRY_VOID(document_.check_editable());
    scene::Hazer hazer;
    hazer.position_m = position_m;
    return edit(translated("Undo", "Add a hazer"), scene::add_hazer(document_.text(), hazer));
}

Result<void> AirEdit::remove_hazer(std::size_t index) {
    TRY_VOID(document_.check_editable());
    return edit(translated("Undo", "Remove a hazer"),
                scene::remove_hazer(document_.text(), app_.show()->hazers, index));
}

Result<scene::HazerEdit> hazer_edit(const QString& what, const QStringList& numbers) {
    const auto number = [&](double low, double high) -> Result<float> {
        TRY(const double value, number_of(numbers, 0, what.toUtf8().constData(), low, high));
        return static_cast<float>(value);
    };
    scene::HazerEdit edit;
    const int expected = what == "place" || what == "direction" ? 3 : 1;
    if (numbers.size() > expected)
        return Error{"hazer " + what.toStdString() + ": expected " + std::to_string(expected) +
                         (expected == 1 ? " number" : " numbers") + ", not " + std::to_string(numbers.size()),
                     ""};
    if (what == "place") {
        TRY(edit.position_m, vector_of(numbers, 0, "metres", kFarthestHazer_m));
    } else if (what == "direction") {
        TRY(edit.direction, vector_of(numbers, 0, "direction", 1000));
        if (glm::length(*edit.direction) < 1e-3f)
            return Error{"0 0 0 has no length, expected where the haze is blown, like 0 0 1", ""};
    } else if (what == "rate") {
        TRY(edit.rate, number(0, 1000));
    } else if (what == "spread") {
        TRY(edit.spread_deg, number(1, 180));
    } else if (what == "reach") {
        TRY(edit.reach_m, number(0.1, 1000));
    } else {
        return Error{
            "hazer: expected place, direction, rate, spread or reach, not '" + what.toStdString() + "'", ""};
    }
    return edit;
}

void add_air_actions(Actions& actions, AppModel& app, ShowDocument& document) {
    const auto add = [&](const QString& name, const QString& text, const QString& arguments,
                         const AirRun& run) {
        actions.add({name,
                     text.isEmpty() ? "" : "Edit",
                     text.isEmpty() ? name : text,
                     "",
                     arguments,
                     [&app, &document, run](const QStringList& words) -> Result<void> {
                         AirEdit edit(app, document);
                         return run(edit, words);
                     },
                     {}});
    };
    add("haze", "", "PRESET|PER_METRE",
        [](AirEdit& edit, const QStringList& words) { return edit.set_haze(words.value(0)); });
    add("clouds", "", "0..1", [](AirEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const double unevenness, number_of(words, 0, "unevenness", 0, 1));
        return edit.set_clouds(static_cast<float>(unevenness));
    });
    add("cloud-size", "", "METRES", [](AirEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const double size_m, number_of(words, 0, "metres", 0.1, 100));
        return edit.set_cloud_size(static_cast<float>(size_m));
    });
    add("wind", "", "X Y Z", [](AirEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const glm::vec3 wind_m_s, vector_of(words, 0, "metres a second", kMostWind_m_s));
        return edit.set_wind(wind_m_s);
    });
    add("hazer", "", "NUMBER place|direction|rate|spread|reach NUMBERS",
        [&app](AirEdit& edit, const QStringList& words) -> Result<void> {
            TRY(const std::size_t index, hazer_of(app, words.value(0)));
            TRY(const scene::HazerEdit change, hazer_edit(words.value(1), words.mid(2)));
            return edit.edit_hazer(index, change);
        });
    add("add-hazer", translated("Action", "Add a hazer"), "[X Y Z]",
        [&app](AirEdit& edit, const QStringList& words) -> Result<void> {
            glm::vec3 place_m = app.camera().target_m;
            place_m.z = 0; // they stand on the floor
            if (!words.isEmpty()) {
                TRY(place_m, vector_of(words, 0, "metres", kFarthestHazer_m));
            }
            return edit.add_hazer(place_m);
        });
    add("remove-hazer", "", "NUMBER", [&app](AirEdit& edit, const QStringList& words) -> Result<void> {
        TRY(const std::size_t index, hazer_of(app, words.value(0)));
        return edit.remove_hazer(index);
    });
}

} // namespace ghost::ui
