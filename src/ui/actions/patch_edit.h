#pragma once
// SPDX-License-Identifier: Apache-2.0
// Edits of the patch: what can be done to the selected fixtures, each one step of the undo list. Places are
// metres and degrees of the show. Error: nothing is selected, or it cannot be done; then nothing is. Window
// thread.

#include "show/show.h"
#include "show_file/show_edit.h"
#include "ui/model/show_document.h"

#include <QString>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ghost::ui {

// By its ending: a model of a stage.
bool is_model(const std::filesystem::path& file);

class PatchEdit {
public:
    PatchEdit(AppModel& app, ShowDocument& document) : app_(app), document_(document) {}
    // The same for one fixture, selected or not, by somebody else: address, name and mode. by: " by RDM", for
    // the undo list.
    PatchEdit(AppModel& app, ShowDocument& document, std::size_t fixture, QString by)
        : app_(app), document_(document), one_(std::set<std::size_t>{fixture}), by_(std::move(by)) {}

    // The first gets it, the others follow one behind the other, in the order of the show; channel 0: not
    // patched.
    Result<void> set_address(fixture::Address from);
    // Several get numbers behind it. What refers to them by name has the new one, too, looks among them.
    Result<void> rename(const QString& name);
    Result<void> set_mode(const QString& mode);
    Result<void> set_position(const glm::vec3& position_m);
    Result<void> set_axis(int axis, float place_m); // axis 0 to 2
    Result<void> move_by(const glm::vec3& by_m);
    Result<void> set_rotation(const glm::vec3& rotation_deg);
    // Each selected one its own, in the order of the show. mover: that all of them go with from now on, ""
    // with none; nothing: each as it did.
    Result<void> set_positions(const QString& what, const std::vector<glm::vec3>& positions_m,
                               const std::optional<std::string>& mover = {});
    // All at the first one's place on this axis.
    Result<void> align(int axis);
    // Evenly between the first and the last.
    Result<void> distribute();
    // Copies beside them, patched where there is room, and selected.
    Result<void> duplicate(const glm::vec3& by_m);
    // Objects of a plot are hidden, which its next version does not undo.
    Result<void> remove();
    // A fixture file; one from elsewhere is copied beside the show first, and the window goes on meanwhile.
    using Place = std::function<glm::vec3(const scene::PatchedFixture& made)>;
    Result<void> add(const std::filesystem::path& file, const Place& place_of);
    // The picture as it is seen now becomes a camera of the show; name empty: "Camera 3" and so on.
    Result<void> keep_camera(const QString& name);
    // which: a number from 1, or a name; empty: where the picture stands. What refers to it by name has the
    // new one, too. None is removed that is the last, or that cues, trackers or movers name.
    Result<void> rename_camera(const QString& which, const QString& name);
    Result<void> remove_camera(const QString& which);
    Result<std::size_t> camera_of(const QString& which) const; // index; error: none
    // A model becomes the stage of the show, a plot (.mvr) its plot, where it has none; copied likewise.
    Result<void> set_stage(const std::filesystem::path& file);
    Result<void> set_plot(const std::filesystem::path& file);
    // A model beside the stage, its origin there; copied likewise.
    Result<void> add_model(const std::filesystem::path& file, const glm::vec3& position_m);

    // How the show writes a fixture file; one from elsewhere is copied beside the show.
    Result<std::string> fixture_beside_show(const std::filesystem::path& file) const;

private:
    using Fixtures = std::vector<scene::PatchedFixture>;
    Result<void> check() const; // something is selected that can be edited
    const Fixtures& fixtures() const { return app_.show()->fixtures; }
    template <class F>
    Result<void> edit_each(const QString& what, F&& f);
    template <class F>
    Result<std::vector<std::pair<scene::FixturePlace, scene::FixtureEdit>>> edits_of_each(F&& f) const;
    QString of_chosen(const QString& what) const; // for the undo list: "Mode of 'Spot 1'"
    std::vector<fixture::Patch> patches() const;
    std::optional<fixture::Address> address_for_new(int footprint) const;
    // The path as the show writes it; a file from elsewhere is copied beside the show.
    Result<std::string> beside_show(const std::filesystem::path& file, std::uintmax_t most_bytes) const;
    template <class Work>
    std::invoke_result_t<Work> aside_of_show(Work work) const;
    Result<void> set_file(const QString& what, const std::string& key, const std::filesystem::path& file);

    const std::set<std::size_t>& chosen() const { return one_ ? *one_ : app_.selection(); }

    AppModel& app_;
    ShowDocument& document_;
    std::optional<std::set<std::size_t>> one_; // instead of the selection
    QString by_;
};

} // namespace ghost::ui
