// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/hang_edit.h"

#include "base/text.h"
#include "show/show.h"
#include "show_folder/hang.h"
#include "stage/overrides.h"
#include "ui/actions/patch_edit.h"
#include "ui/language/language.h"

namespace ghost::ui {
namespace {

// Who reads the file reads "5.75", not "5.7499995".
glm::vec3 in_millimetres(const glm::vec3& place_m) {
    return glm::round(place_m * 1000.0f) / 1000.0f;
}

Result<std::vector<glm::vec3>> places_of_selection(const AppModel& app, const ShowDocument& document) {
    TRY_VOID(document.check_editable());
    std::vector<glm::vec3> places;
    for (const std::size_t index : app.selection()) places.push_back(app.show()->fixtures[index].position_m);
    if (places.empty()) return Error{"no fixture is selected", ""};
    return places;
}

} // namespace

Result<void> hang_under(AppModel& app, ShowDocument& document, std::size_t object) {
    TRY(const std::vector<glm::vec3> are_m, places_of_selection(app, document));
    const std::vector<Object>& objects = app.opened().objects;
    if (object >= objects.size() || !objects[object].bar)
        return Error{"does not lie like a truss or a pipe, so nothing hangs under it",
                     object < objects.size() ? objects[object].name : ""};
    std::vector<scene::Bar> pieces;
    for (const Object& one : objects)
        if (one.bar && scene::is_slender(*one.bar)) pieces.push_back(*one.bar);
    std::vector<glm::vec3> places = scene::places_under(scene::joined(*objects[object].bar, pieces), are_m);
    for (glm::vec3& place_m : places) place_m = in_millimetres(place_m);
    return PatchEdit(app, document)
        .set_positions(
            translated("Undo", "Hang under '%1'").arg(QString::fromStdString(objects[object].name)), places);
}

Result<void> hang(AppModel& app, ShowDocument& document, const QString& pattern) {
    TRY(const std::vector<glm::vec3> are_m, places_of_selection(app, document));
    glm::vec3 middle_m(0);
    for (const glm::vec3& place_m : are_m) middle_m += place_m / static_cast<float>(are_m.size());
    const std::vector<Object>& objects = app.opened().objects;
    std::vector<scene::Bar> bars;
    std::vector<std::size_t> of_bar;
    bool is_called_so = false;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (!pattern.isEmpty() && !matches(pattern.toStdString(), objects[i].name)) continue;
        is_called_so = true;
        if (!objects[i].bar || !objects[i].shown) continue;
        bars.push_back(*objects[i].bar);
        of_bar.push_back(i);
    }
    if (!pattern.isEmpty() && !is_called_so)
        return Error{"there is no object '" + pattern.toStdString() + "'", ""};
    const std::optional<std::size_t> nearest = scene::nearest_bar(bars, middle_m);
    if (!nearest)
        return Error{pattern.isEmpty() ? "the stage has no truss or pipe to hang them under"
                                       : "'" + pattern.toStdString() + "' is no truss or pipe that lies",
                     ""};
    return hang_under(app, document, of_bar[*nearest]);
}

void add_hang_action(Actions& actions, AppModel& app, ShowDocument& document) {
    actions.add({"hang",
                 "Edit",
                 translated("Action", "Hang under the nearest truss"),
                 "Ctrl+H",
                 "[OBJECT]",
                 [&app, &document](const QStringList& words) { return hang(app, document, words.value(0)); },
                 {}});
}

} // namespace ghost::ui
