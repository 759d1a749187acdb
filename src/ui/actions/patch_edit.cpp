// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/patch_edit.h"

#include "base/text.h"
#include "disk/files.h"
#include "disk/user_file.h"
#include "fixture_files/load_type.h"
#include "show/free_address.h"
#include "show/names.h"
#include "show_file/camera_edit.h"
#include "show_file/fixture_names_edit.h"
#include "show_file/mover_edit.h"
#include "ui/actions/hang_edit.h"
#include "ui/language/language.h"
#include "ui/model/aside.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <type_traits>

namespace ghost::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostFixtureBytes = std::uintmax_t{256} << 20;
constexpr std::uintmax_t kMostModelBytes = std::uintmax_t{1} << 30;

int footprint(const scene::PatchedFixture& fixture) {
    return fixture.type ? fixture::footprint_of(*fixture.type, fixture.mode) : 1;
}

// "Spot 3" -> "Spot 4", and on until nobody has it.
std::string next_name(const std::string& name, std::set<std::string>& taken) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::string stem = digits < name.size() ? name.substr(0, digits) : name + " ";
    long number = digits < name.size() && name.size() - digits < 9 ? std::stol(name.substr(digits)) : 1;
    std::string next;
    do {
        next = stem + std::to_string(++number);
    } while (!taken.insert(next).second);
    return next;
}

// What goes by index of the fixture, as another text counts; f: nothing where the fixture is gone.
template <class F>
Look counted_anew(const Look& look, F&& f) {
    Look anew = look;
    anew.fixtures.clear();
    for (const auto& [index, programmer] : look.fixtures)
        if (const std::optional<std::size_t> now = f(index)) anew.fixtures[*now] = programmer;
    anew.solo.clear();
    for (const std::size_t index : look.solo)
        if (const std::optional<std::size_t> now = f(index)) anew.solo.insert(*now);
    return anew;
}

// As a show in that folder writes it; "": it lies elsewhere.
std::string name_inside(const fs::path& file, const fs::path& folder) {
    std::error_code code;
    const fs::path inside = fs::relative(file, folder, code);
    return !code && !inside.empty() && *inside.begin() != ".." ? inside.generic_string() : "";
}

Result<std::string> copied_beside(const fs::path& file, const fs::path& folder, std::uintmax_t most_bytes) {
    const fs::path inside = file.filename();
    TRY(const std::vector<std::uint8_t> bytes, read_file(file, most_bytes));
    const auto there = read_file(folder / inside, most_bytes);
    if (there.ok() && *there != bytes)
        return Error{"another file of this name lies beside the show already; rename the new one, or put it "
                     "there yourself and the show takes it",
                     (folder / inside).string()};
    if (there.ok()) return inside.generic_string();
    const fs::path temporary = temporary_beside(folder / inside);
    TRY_VOID(write_file_atomic(temporary, bytes));
    const auto done = commit_new(temporary, folder / inside);
    if (done.ok() && *done) return inside.generic_string();
    std::error_code code;
    fs::remove(temporary, code);
    return done.ok() ? there.error() : done.error(); // what is there cannot be read
}

struct FixtureFile {
    std::shared_ptr<const fixture::Type> type;
    std::string inside; // as the show writes it
};

Result<FixtureFile> read_fixture(const fs::path& file, const fs::path& folder) {
    TRY(fixture::LoadedType loaded, fixture::load_type(file));
    if (loaded.type.modes.empty()) return Error{"has no DMX mode", file.string()};
    FixtureFile read{std::make_shared<const fixture::Type>(std::move(loaded.type)),
                     name_inside(file, folder)};
    if (!read.inside.empty()) return read;
    TRY(read.inside, copied_beside(file, folder, kMostFixtureBytes));
    return read;
}

} // namespace

Result<void> PatchEdit::check() const {
    TRY_VOID(document_.check_editable());
    if (chosen().empty()) return Error{"no fixture is selected", ""};
    return {};
}

std::vector<fixture::Patch> PatchEdit::patches() const {
    std::vector<fixture::Patch> all;
    for (const scene::PatchedFixture& fixture : fixtures())
        if (fixture.type) all.push_back(fixture.patch());
    return all;
}

// f: what becomes of each selected fixture, in their order.
template <class F>
Result<std::vector<std::pair<scene::FixturePlace, scene::FixtureEdit>>>
PatchEdit::edits_of_each(F&& f) const {
    TRY_VOID(check());
    std::vector<std::pair<scene::FixturePlace, scene::FixtureEdit>> edits;
    for (const std::size_t index : chosen()) {
        if (index >= fixtures().size()) continue;
        scene::FixtureEdit edit;
        TRY_VOID(f(fixtures()[index], edit));
        edits.emplace_back(scene::place_of(fixtures()[index], index), edit);
    }
    return edits;
}

template <class F>
Result<void> PatchEdit::edit_each(const QString& what, F&& f) {
    TRY(const auto edits, edits_of_each(f));
    TRY(std::string text, scene::edit_fixtures(document_.text(), edits));
    return document_.edit(what + by_, {std::move(text), app_.look(), app_.selection()});
}

QString PatchEdit::of_chosen(const QString& what) const {
    if (!by_.isEmpty() || chosen().empty()) return what;
    const std::size_t first = *chosen().begin();
    if (chosen().size() == 1 && app_.show() && first < fixtures().size())
        return translated("Undo", "%1 of '%2'").arg(what, QString::fromStdString(fixtures()[first].name));
    return translated("Undo", "%1 of %n fixture(s)", nullptr, chosen().size()).arg(what);
}

Result<void> PatchEdit::set_address(fixture::Address from) {
    int before = 0; // footprint
    fixture::Address at = from;
    return edit_each(from.channel == 0
                         ? translated("Undo", "%n fixture(s) unpatched", nullptr, chosen().size())
                         : of_chosen(translated("Undo", "Address")),
                     [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
                         if (before > 0 && from.channel > 0)
                             at = fixture::next_address(at, before, footprint(fixture));
                         before = footprint(fixture);
                         edit.address = at;
                         return {};
                     });
}

Result<void> PatchEdit::rename(const QString& name) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < (app_.show() ? fixtures().size() : 0); ++i)
        if (!chosen().contains(i)) taken.insert(fixtures()[i].name);
    std::string next = name.trimmed().toStdString();
    if (!scene::is_good_name(next))
        return Error{"'" + next + "' is no name: 1 to 100 bytes, no leading dot, none of /\\:*?\"<>|", ""};
    const bool several = chosen().size() > 1;
    if (!several && taken.contains(next)) return Error{"another fixture is called '" + next + "'", ""};
    scene::FixtureNames renamed;
    const auto call = [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
        if (several) {
            // "Spot" -> Spot 1, Spot 2; "Spot 5" -> Spot 5, Spot 6.
            if (next.find_last_of("0123456789") != next.size() - 1) next += " 1";
            if (!taken.insert(next).second) next = next_name(next, taken);
            edit.name = next;
            std::set<std::string> none;
            next = next_name(next, none);
        } else {
            edit.name = next;
            taken.insert(next);
        }
        if (fixture.name != *edit.name) renamed[fixture.name] = *edit.name;
        if (!fixture.written_name.empty()) renamed[fixture.written_name] = *edit.name;
        return {};
    };
    TRY(const auto edits, edits_of_each(call));
    TRY(std::string text, scene::edit_fixtures(document_.text(), edits));
    TRY(text, scene::rename_in_references(text, renamed, taken));
    return document_.edit_names(by_.isEmpty() ? of_chosen(translated("Undo", "Rename"))
                                              : translated("Undo", "Name") + by_,
                                {std::move(text), app_.look(), app_.selection()}, renamed);
}

Result<void> PatchEdit::set_mode(const QString& mode) {
    const auto set = [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
        if (!fixture.type) return Error{"has no fixture file that can be read", fixture.name};
        if (auto found = fixture::find_mode(*fixture.type, mode.toStdString()); !found.ok())
            return Error{found.error().what, fixture.name};
        edit.mode = mode.toStdString();
        return {};
    };
    TRY(const auto edits, edits_of_each(set));
    TRY(std::string text, scene::edit_fixtures(document_.text(), edits));
    Look look = app_.look(); // levels of one mode are others, or none, in another
    for (auto& [index, programmer] : look.fixtures) {
        if (!chosen().contains(index) || index >= fixtures().size()) continue;
        const scene::PatchedFixture& fixture = fixtures()[index];
        const auto found = fixture::find_mode(*fixture.type, mode.toStdString());
        if (!found.ok() || *found == fixture.mode) continue;
        programmer.levels.clear();
    }
    std::erase_if(look.fixtures, [](const auto& entry) { return entry.second.is_empty(); });
    return document_.edit(of_chosen(translated("Undo", "Mode")) + by_,
                          {std::move(text), std::move(look), app_.selection()});
}

Result<void> PatchEdit::set_position(const glm::vec3& position_m) {
    return edit_each(of_chosen(translated("Undo", "Position")),
                     [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
                         if (fixture.track)
                             return Error{"hangs on a track, which says where it is", fixture.name};
                         edit.position_m = position_m;
                         return {};
                     });
}

Result<void> PatchEdit::set_positions(const QString& what, const std::vector<glm::vec3>& positions_m,
                                      const std::optional<std::string>& mover) {
    std::vector<std::string> names;
    const auto place = [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
        if (fixture.track) return Error{"hangs on a track, which says where it is", fixture.name};
        edit.position_m = positions_m.at(names.size());
        names.push_back(fixture.name);
        return {};
    };
    TRY(const auto edits, edits_of_each(place));
    TRY(std::string text, scene::edit_fixtures(document_.text(), edits));
    if (mover) {
        TRY(text, scene::hang_on_mover(text, *mover, names));
    }
    return document_.edit(what + by_, {std::move(text), app_.look(), app_.selection()});
}

Result<void> PatchEdit::move_by(const glm::vec3& by_m) {
    return edit_each(of_chosen(translated("Undo", "Move")),
                     [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
                         if (fixture.track)
                             return Error{"hangs on a track, which says where it is", fixture.name};
                         constexpr float kSteps_m = 10000; // else a sum of 2.39 is written as 2.3899999
                         edit.position_m = glm::round((fixture.position_m + by_m) * kSteps_m) / kSteps_m;
                         return {};
                     });
}

Result<void> PatchEdit::set_rotation(const glm::vec3& rotation_deg) {
    return edit_each(of_chosen(translated("Undo", "Turn")),
                     [&](const scene::PatchedFixture&, scene::FixtureEdit& edit) -> Result<void> {
                         edit.rotation_deg = rotation_deg;
                         return {};
                     });
}

Result<void> PatchEdit::align(int axis) {
    TRY_VOID(check());
    return set_axis(axis, fixtures()[*app_.current()].position_m[axis]);
}

Result<void> PatchEdit::set_axis(int axis, float place_m) {
    return edit_each(of_chosen(translated("Undo", "Position")),
                     [&](const scene::PatchedFixture& fixture, scene::FixtureEdit& edit) -> Result<void> {
                         if (fixture.track)
                             return Error{"hangs on a track, which says where it is", fixture.name};
                         edit.position_m = fixture.position_m;
                         (*edit.position_m)[axis] = place_m;
                         return {};
                     });
}

Result<void> PatchEdit::distribute() {
    TRY_VOID(check());
    const std::set<std::size_t>& chosen = app_.selection();
    if (chosen.size() < 3) return Error{"three fixtures or more can be spread evenly", ""};
    const glm::vec3 first_m = fixtures()[*chosen.begin()].position_m;
    const glm::vec3 last_m = fixtures()[*chosen.rbegin()].position_m;
    std::vector<glm::vec3> places;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        places.push_back(
            glm::mix(first_m, last_m, static_cast<float>(i) / static_cast<float>(chosen.size() - 1)));
    return set_positions(translated("Undo", "%n fixture(s) spread evenly", nullptr, chosen.size()), places);
}

Result<void> PatchEdit::duplicate(const glm::vec3& by_m) {
    TRY_VOID(check());
    std::set<std::string> taken;
    for (const scene::PatchedFixture& fixture : fixtures()) taken.insert(fixture.name);
    std::vector<fixture::Patch> patched = patches();
    std::vector<std::pair<std::size_t, scene::FixtureEdit>> copies;
    std::map<std::size_t, std::vector<std::string>> carried; // by index of the mover
    for (const std::size_t index : app_.selection()) {
        const scene::PatchedFixture& fixture = fixtures()[index];
        if (!fixture.uuid.empty())
            return Error{"is of the plot, which only its own program can add to", fixture.name};
        scene::FixtureEdit edit;
        edit.name = next_name(fixture.name, taken);
        if (fixture.mover != scene::kNoMover)
            carried[static_cast<std::size_t>(fixture.mover)].push_back(*edit.name);
        if (!fixture.track) edit.position_m = fixture.position_m + by_m;
        if (fixture.address > 0) {
            const auto free =
                fixture::find_free_address(patched, footprint(fixture), {fixture.universe, fixture.address});
            edit.address = free.value_or(fixture::Address{fixture.universe, 0});
            if (free && fixture.type) {
                patched.push_back(fixture.patch());
                patched.back().addresses = {*free};
            }
        }
        copies.emplace_back(index, edit);
    }
    std::string text = document_.text();
    for (auto copy = copies.rbegin(); copy != copies.rend(); ++copy) {
        TRY(text, scene::copy_fixture(text, copy->first, copy->second));
    }
    for (const auto& [mover, names] : carried) {
        TRY(text, scene::hang_on_mover(text, app_.show()->movers[mover].name, names));
    }
    const auto place = [&](std::size_t index) -> std::optional<std::size_t> {
        return index +
               static_cast<std::size_t>(std::count_if(copies.begin(), copies.end(),
                                                      [&](const auto& copy) { return copy.first < index; }));
    };
    std::set<std::size_t> selection;
    for (const auto& copy : copies) selection.insert(*place(copy.first) + 1);
    return document_.edit(translated("Undo", "%n fixture(s) duplicated", nullptr, copies.size()),
                          {std::move(text), counted_anew(app_.look(), place), selection});
}

Result<void> PatchEdit::remove() {
    TRY_VOID(check());
    std::vector<std::size_t> numbers;
    std::vector<std::pair<scene::FixturePlace, scene::FixtureEdit>> hidden;
    for (const std::size_t index : app_.selection()) {
        const scene::PatchedFixture& fixture = fixtures()[index];
        if (fixture.uuid.empty())
            numbers.push_back(index);
        else
            hidden.push_back({scene::place_of(fixture, index), {.hidden = true}});
    }
    TRY(std::string text, scene::edit_fixtures(document_.text(), hidden));
    if (!numbers.empty()) {
        TRY(text, scene::remove_fixtures(text, numbers));
    }
    const std::set<std::size_t>& gone = app_.selection();
    const auto place = [&](std::size_t index) -> std::optional<std::size_t> {
        if (gone.contains(index)) return std::nullopt;
        return index - static_cast<std::size_t>(std::distance(gone.begin(), gone.lower_bound(index)));
    };
    return document_.edit(translated("Undo", "%n fixture(s) removed", nullptr, gone.size()),
                          {std::move(text), counted_anew(app_.look(), place), {}});
}

// The window goes on meanwhile, perhaps to another show.
template <class Work>
std::invoke_result_t<Work> PatchEdit::aside_of_show(Work work) const {
    const fs::path file = app_.show()->file;
    std::invoke_result_t<Work> done = aside(std::move(work));
    if (done.ok() && (!app_.show() || app_.show()->file != file))
        return Error{"another show was opened meanwhile; it is left as it is", file.string()};
    return done;
}

Result<std::string> PatchEdit::beside_show(const fs::path& file, std::uintmax_t most_bytes) const {
    const fs::path folder = app_.show()->folder;
    if (const std::string inside = name_inside(file, folder); !inside.empty()) return inside;
    return aside_of_show([=] { return copied_beside(file, folder, most_bytes); });
}

Result<std::string> PatchEdit::fixture_beside_show(const fs::path& file) const {
    return beside_show(file, kMostFixtureBytes);
}

Result<void> PatchEdit::set_file(const QString& what, const std::string& key, const fs::path& file) {
    TRY_VOID(document_.check_editable());
    TRY(const std::string inside, beside_show(file, kMostModelBytes));
    TRY(std::string text, scene::set_of_show(document_.text(), key, inside));
    Look look = app_.look(); // objects and materials are others now
    look.shown.clear();
    look.surfaces.clear();
    return document_.edit(what, {std::move(text), std::move(look), app_.selection()});
}

Result<void> PatchEdit::keep_camera(const QString& name) {
    TRY_VOID(document_.check_editable());
    const std::vector<scene::Camera>& cameras = app_.show()->cameras;
    std::set<std::string> taken;
    for (const scene::Camera& camera : cameras) taken.insert(camera.name);
    scene::Camera camera = app_.seen_camera();
    camera.name =
        name.isEmpty() ? next_name("Camera " + std::to_string(cameras.size()), taken) : name.toStdString();
    if (camera.name.find_first_of("/\\:*?\"<>|") != std::string::npos || camera.name.front() == '.')
        return Error{"'" + camera.name + "' is no name of a camera: it names a folder", ""};
    if (!name.isEmpty() && taken.contains(camera.name))
        return Error{"another camera is called '" + camera.name + "'", ""};
    TRY(std::string text, scene::own_cameras(document_.text(), cameras));
    TRY(text, scene::add_camera(text, camera));
    return document_.edit(translated("Undo", "Camera '%1' kept").arg(QString::fromStdString(camera.name)),
                          {std::move(text), app_.look(), app_.selection()});
}

Result<std::size_t> PatchEdit::camera_of(const QString& which) const {
    if (!app_.show()) return Error{"no show is open", ""};
    const std::vector<scene::Camera>& cameras = app_.show()->cameras;
    bool is_number = false;
    const int number = which.toInt(&is_number);
    if (is_number && number >= 1 && number <= static_cast<int>(cameras.size()))
        return static_cast<std::size_t>(number - 1);
    if (!which.isEmpty()) return app_.show()->find_camera(which.toStdString());
    if (const auto stored = app_.stored_camera()) return *stored;
    return Error{"the picture stands at no camera of the show: go to one, or keep this one (Ctrl+K)", ""};
}

Result<void> PatchEdit::rename_camera(const QString& which, const QString& name) {
    TRY_VOID(document_.check_editable());
    TRY(const std::size_t index, camera_of(which));
    const std::vector<scene::Camera>& cameras = app_.show()->cameras;
    const std::string next = name.trimmed().toStdString(), before = cameras[index].name;
    if (!scene::is_good_name(next))
        return Error{"'" + next + "' is no name: 1 to 100 bytes, no leading dot, none of /\\:*?\"<>|", ""};
    for (std::size_t i = 0; i < cameras.size(); ++i)
        if (i != index && cameras[i].name == next)
            return Error{"another camera is called '" + next + "'", ""};
    if (next == before) return {};
    TRY(std::string text, scene::rename_camera(document_.text(), cameras, index, next));
    return document_.edit(translated("Undo", "Camera '%1' renamed '%2'")
                              .arg(QString::fromStdString(before), QString::fromStdString(next)),
                          {std::move(text), app_.look(), app_.selection()});
}

Result<void> PatchEdit::remove_camera(const QString& which) {
    TRY_VOID(document_.check_editable());
    TRY(const std::size_t index, camera_of(which));
    const scene::Show& show = *app_.show();
    const std::string name = show.cameras[index].name;
    TRY(std::string text, scene::remove_camera(document_.text(), show.cameras, index));
    if (show.cameras.size() == 1)
        return Error{"camera '" + name + "' is the last one of the show; keep another one first (Ctrl+K)",
                     ""};
    for (const scene::Cue& cue : show.cues)
        if (cue.camera == name)
            return Error{"camera '" + name + "' cannot be removed: cue '" + cue.name +
                             "' goes to it; give that cue another camera first",
                         ""};
    for (const scene::TrackerUse& use : show.tracking.uses)
        if (use.camera == name)
            return Error{"camera '" + name + "' cannot be removed: a tracker moves it", ""};
    for (const scene::Mover& mover : show.movers)
        if (std::find(mover.cameras.begin(), mover.cameras.end(), name) != mover.cameras.end())
            return Error{"camera '" + name + "' cannot be removed: mover '" + mover.name + "' carries it",
                         ""};
    return document_.edit(translated("Undo", "Camera '%1' removed").arg(QString::fromStdString(name)),
                          {std::move(text), app_.look(), app_.selection()});
}

bool is_model(const fs::path& file) {
    const std::string ending = lower(file.extension().string());
    const auto known = {".glb", ".gltf", ".obj", ".3ds"};
    return std::find(known.begin(), known.end(), ending) != known.end();
}

namespace {

QString name_of(const fs::path& file) {
    return QString::fromStdString(file.filename().string());
}

Result<void> check_model(const fs::path& file) {
    if (is_model(file)) return {};
    return Error{"is no model, expected .glb, .gltf, .obj or .3ds", file.string()};
}

} // namespace

Result<void> PatchEdit::set_stage(const fs::path& file) {
    TRY_VOID(check_model(file));
    return set_file(translated("Undo", "'%1' is the stage").arg(name_of(file)), "stage", file);
}

Result<void> PatchEdit::add_model(const fs::path& file, const glm::vec3& position_m) {
    TRY_VOID(document_.check_editable());
    TRY_VOID(check_model(file));
    TRY(const std::string inside, beside_show(file, kMostModelBytes));
    TRY(std::string text, scene::add_model(document_.text(), inside, position_m));
    return document_.edit(translated("Undo", "Model '%1' added").arg(name_of(file)),
                          {std::move(text), app_.look(), app_.selection()});
}

Result<void> PatchEdit::set_plot(const fs::path& file) {
    TRY_VOID(document_.check_editable());
    if (!app_.show()->plot_file.empty())
        return Error{"the show has a plot; 'ghostlight import' into its folder merges a newer one",
                     file.string()};
    if (lower(file.extension().string()) != ".mvr") return Error{"is no plot, expected .mvr", file.string()};
    return set_file(translated("Undo", "'%1' is the plot").arg(name_of(file)), "plot", file);
}

// Of what a desk sends its channels are zeros, and it would hang turned to its stops, dark, until the desk
// knows it. Where nothing is sent it is at its defaults.
std::optional<fixture::Address> PatchEdit::address_for_new(int footprint) const {
    const std::vector<fixture::Patch> patched = patches();
    const auto first = fixture::find_free_address(patched, footprint, {1, 1});
    auto free = first;
    while (free && app_.rig().universes.find(static_cast<std::uint16_t>(free->universe)))
        free = fixture::find_free_address(patched, footprint, {free->universe + 1, 1});
    return free ? free : first;
}

Result<void> PatchEdit::add(const fs::path& file, const Place& place_of) {
    TRY_VOID(document_.check_editable());
    const fs::path folder = app_.show()->folder;
    TRY(const FixtureFile read, aside_of_show([=] { return read_fixture(file, folder); }));
    const fixture::Type& type = *read.type;
    document_.know(folder / read.inside, read.type);
    scene::PatchedFixture hung; // how wide it is
    hung.type = read.type;
    const glm::vec3 position_m = place_of(hung);
    std::set<std::string> taken;
    for (const scene::PatchedFixture& fixture : fixtures()) taken.insert(fixture.name);
    scene::NewFixture made{read.inside, {}};
    std::string name = type.name;
    std::erase_if(name,
                  [](char letter) { return std::string("/\\:*?\"<>|").find(letter) != std::string::npos; });
    made.keys.name = next_name((name.empty() ? "Fixture" : name.substr(0, 80)) + " 0", taken);
    made.keys.address = address_for_new(fixture::footprint_of(type, 0)).value_or(fixture::Address{1, 0});
    made.keys.position_m = position_m;
    // One that is not said is a guess, which is told of every time.
    if (type.modes.size() > 1 && !type.modes.front().name.empty()) made.keys.mode = type.modes.front().name;
    TRY(std::string text, scene::add_fixture(document_.text(), made));
    if (const std::string mover = carrier_at(app_, position_m); !mover.empty()) {
        TRY(text, scene::hang_on_mover(text, mover, {*made.keys.name}));
    }
    const auto of_file = static_cast<std::size_t>(
        std::count_if(fixtures().begin(), fixtures().end(),
                      [](const scene::PatchedFixture& fixture) { return fixture.uuid.empty(); }));
    const auto place = [&](std::size_t index) -> std::optional<std::size_t> {
        return index < of_file ? index : index + 1;
    };
    return document_.edit(translated("Undo", "'%1' added").arg(QString::fromStdString(*made.keys.name)),
                          {std::move(text), counted_anew(app_.look(), place), {of_file}});
}

} // namespace ghost::ui
