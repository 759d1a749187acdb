#pragma once
// SPDX-License-Identifier: Apache-2.0
// What hands do: one change of the look, for panels, keys and scripts alike. Each is one undo step, or goes
// on with the one before where a slider is still moving. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"

#include <QString>

namespace ghost::ui {

// Kinds of change, see AppModel::set_look.
enum class ProgrammerStep : int {
    step = 0,
    intensity,
    colour,
    zoom,
    pan,
    tilt,
    gobo,
    gel,
    lamp,
    scene,
    surface,
    samples,
    mover,
    fan = 20,             // and on: the words of head_words(), then any attribute
    first_parameter = 100 // and on: those of HeadParameter, by their place in the panel
};

// Changes the values of all selected fixtures; f gets each fixture's.
template <class F>
void change_selected(AppModel& app, const QString& text, ProgrammerStep kind, F&& f) {
    Look look = app.look();
    for (const std::size_t index : app.selection()) f(look.fixtures[index]);
    app.set_look(std::move(look), text, static_cast<int>(kind));
}

template <class F>
void change_scene(AppModel& app, const QString& text, ProgrammerStep kind, F&& f) {
    Look look = app.look();
    f(look.scene);
    app.set_look(std::move(look), text, static_cast<int>(kind));
}

// Error: no show is open.
Result<void> need_show(const AppModel& app);
// Error: no fixture is selected.
Result<void> need_selection(const AppModel& app);

// The attribute of that name, or of these words of the panel. Error: no selected fixture has it.
Result<std::string> attribute_named(const AppModel& app, const QString& words);

// Of the haze along a ray through one beam; nothing: as many as the program finds good.
void change_samples(AppModel& app, std::optional<int> samples);

// Of the show, by name.
Result<std::size_t> mover_called(const AppModel& app, const QString& name);
// Where the axes of a mover go, for each one: what a hand asks for, else what drives it.
std::vector<float> mover_goals(const AppModel& app, std::size_t mover);
// Values of all axes of a mover (index of the show); empty: what drives it else.
void drive_mover(AppModel& app, std::size_t mover, std::vector<float> values);

// A colour as screens have it -> a filter: linear Rec.2020 with its largest component at 1.
glm::vec3 filter_from(const QColor& colour);
QColor screen_colour(const glm::vec3& rec2020);

// What of it is not as the show has it: "2 fixtures, scene, 1 object".
QString words_of(const Look& look);

// "intensity 0.5", "release", "smoke 2", "shadows off" and so on.
void add_programmer_actions(Actions& actions, AppModel& app);
// "camera house", "orbit 30 0", "exposure 6", "focus" and so on.
// listed: what a hand means by all; nothing: all there are.
void add_camera_actions(Actions& actions, AppModel& app,
                        const std::function<std::optional<std::set<std::size_t>>()>& listed = {});
// "play", "jump 20", "input desk", "fps 25", "resolution 50" and so on.
void add_play_actions(Actions& actions, AppModel& app);

} // namespace ghost::ui
