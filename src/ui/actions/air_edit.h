#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the show's air: how thick its haze is, clouds and wind, hazers; each one step of the undo list,
// where a slider that still moves goes on with the last. What hands do to the smoke is beside it (Look).
// Error: it cannot be done; then nothing is. Window thread.

#include "show_file/air_edit.h"
#include "ui/actions/actions.h"
#include "ui/model/show_document.h"

namespace ghost::ui {

inline constexpr float kMostWind_m_s = 20; // of each of its three numbers

class AirEdit {
public:
    AirEdit(AppModel& app, ShowDocument& document) : app_(app), document_(document) {}

    // A preset's name ("haze", "fog") or the extinction per metre.
    Result<void> set_haze(const QString& words);
    Result<void> set_clouds(float unevenness);
    Result<void> set_cloud_size(float patch_m);
    Result<void> set_wind(const glm::vec3& wind_m_s);
    // index: of Show::hazers.
    Result<void> edit_hazer(std::size_t index, const scene::HazerEdit& edit);
    Result<void> add_hazer(const glm::vec3& position_m);
    Result<void> remove_hazer(std::size_t index);

private:
    enum class Kind : int { step = 0, clouds, cloud_size, wind };
    Result<void> edit(const QString& what, const Result<std::string>& text, Kind kind = Kind::step);

    AppModel& app_;
    ShowDocument& document_;
};

// "haze fog", "wind 0.5 0 0", "add-hazer", "hazer 1 place 0 2 0" and so on.
void add_air_actions(Actions& actions, AppModel& app, ShowDocument& document);

// What can be said of a hazer by name: "place", "direction", "rate", "spread", "reach", with its numbers.
Result<scene::HazerEdit> hazer_edit(const QString& what, const QStringList& numbers);

} // namespace ghost::ui
