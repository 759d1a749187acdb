// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/hang_edit.h"

#include "base/text.h"
#include "show/free_address.h"
#include "show/show.h"
#include "show_file/mover_edit.h"
#include "show_folder/hang.h"
#include "ui/actions/object_edit.h"
#include "ui/actions/patch_edit.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ghost::ui {
namespace {

constexpr float kLowestTruss_m = 2; // what lies lower is a rail or a pipe on the floor

// Who reads the file reads "5.75", not "5.7499995".
glm::vec3 in_millimetres(const glm::vec3& place_m) {
    return glm::round(place_m * 1000.0f) / 1000.0f;
}

Result<std::vector<glm::vec3>> places_of_selection(const AppModel& app, ShowDocument& document) {
    TRY_VOID(document.check_editable());
    std::vector<glm::vec3> places;
    for (const std::size_t index : app.selection()) places.push_back(app.show()->fixtures[index].position_m);
    if (places.empty()) return Error{"no fixture is selected", ""};
    return places;
}

// How much of a bar's length a fixture takes there: its body at rest, between its ends along the bar.
float width_of(const scene::PatchedFixture& fixture, const glm::vec3& way) {
    constexpr float kUnknown_m = 0.3f;
    if (!fixture.type) return kUnknown_m;
    const fixture::Mode& mode = fixture.patch().mode_of();
    const glm::mat4 turn = scene::placed({}, fixture.rotation_deg);
    std::vector<glm::mat4> to_fixture;
    float low_m = 0, high_m = 0;
    for (const fixture::Node& node : mode.nodes) {
        const auto parent = static_cast<std::size_t>(node.parent);
        to_fixture.push_back(node.parent < 0 ? turn * node.local : to_fixture[parent] * node.local);
        if (node.model < 0) continue;
        const glm::vec3 size_m = fixture.type->models[static_cast<std::size_t>(node.model)].size_m;
        float half_m = 0;
        for (int axis = 0; axis < 3; ++axis)
            half_m += 0.5f * size_m[axis] * std::abs(glm::dot(glm::vec3(to_fixture.back()[axis]), way));
        const float at_m = glm::dot(glm::vec3(to_fixture.back()[3]), way);
        low_m = std::min(low_m, at_m - half_m);
        high_m = std::max(high_m, at_m + half_m);
    }
    // As wide to both sides of its clamp, for that is its place.
    const float width_m = 2 * std::max(-low_m, high_m);
    return width_m > 0 ? width_m : kUnknown_m;
}

// All that hangs under a bar, but those.
std::vector<scene::BarLoad> what_hangs(const scene::Bar& bar,
                                       const std::vector<scene::PatchedFixture>& fixtures,
                                       const std::set<std::size_t>& but) {
    const glm::vec3 way = glm::normalize(bar.to_m - bar.from_m);
    std::vector<scene::BarLoad> there;
    for (std::size_t i = 0; i < fixtures.size(); ++i)
        if (!but.contains(i) && !fixtures[i].track && scene::hangs_away_m(bar, fixtures[i].position_m))
            there.push_back({fixtures[i].position_m, width_of(fixtures[i], way)});
    return there;
}

// The whole truss that a piece is of; the names of all its pieces, each once.
scene::Bar take_pieces(const std::vector<Object>& objects, std::size_t piece,
                       std::vector<std::string>& names) {
    std::vector<scene::Bar> bars;
    std::vector<std::size_t> of_bar;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i].bar && scene::is_slender(*objects[i].bar)) {
            bars.push_back(*objects[i].bar);
            of_bar.push_back(i);
        }
    std::vector<bool> taken;
    const scene::Bar whole = scene::joined(*objects[piece].bar, bars, taken);
    names.push_back(objects[piece].name);
    for (std::size_t k = 0; k < bars.size(); ++k)
        if (taken[k] && std::find(names.begin(), names.end(), objects[of_bar[k]].name) == names.end())
            names.push_back(objects[of_bar[k]].name);
    return whole;
}

// Neither a fixture nor another mover reads it.
std::optional<fixture::Address> free_channels(const scene::Show& show, int count) {
    std::vector<fixture::Patch> patches;
    for (const scene::PatchedFixture& fixture : show.fixtures)
        if (fixture.type) patches.push_back(fixture.patch());
    fixture::Address from{1, 1};
    for (;;) {
        const auto free = fixture::find_free_address(patches, count, from);
        if (!free) return std::nullopt;
        int behind = 0; // what a mover reads of it
        for (const scene::Mover& mover : show.movers)
            for (const scene::MoverAxis& axis : mover.axes)
                for (const fixture::Address& byte : axis.levels)
                    if (byte.universe == free->universe && byte.channel >= free->channel &&
                        byte.channel < free->channel + count)
                        behind = std::max(behind, byte.channel + 1);
        if (behind == 0) return free;
        from = {free->universe, behind};
    }
}

// Down to a metre above the floor; a truss that lies lower flies up.
void add_hoists(const scene::Bar& bar, const scene::Show& show, scene::Mover& truss) {
    constexpr float kOverhang = 0.207f; // of its length: where a beam on two points bends least
    constexpr float kLowest_m = 1, kHighest_m = 8;
    constexpr float kSpeed_m_s = 0.2f;
    constexpr std::size_t kBytes = 2;
    const float low_m = std::min(bar.from_m.z, bar.to_m.z);
    const float way_m = low_m > 2 * kLowest_m ? kLowest_m - low_m : kHighest_m - low_m;
    const glm::vec3 run = bar.to_m - bar.from_m;
    const bool is_across = std::abs(run.x) >= std::abs(run.y);
    const auto free = free_channels(show, static_cast<int>(2 * kBytes));
    for (std::size_t k = 0; k < 2; ++k) {
        scene::MoverAxis& hoist = truss.axes.emplace_back();
        hoist.name = is_across ? (k == 0 ? "left" : "right") : (k == 0 ? "down-stage" : "up-stage");
        hoist.point_m = in_millimetres(bar.from_m + (k == 0 ? kOverhang : 1 - kOverhang) * run +
                                       glm::vec3(0, 0, bar.height_m));
        hoist.to = std::round(way_m * 100) / 100;
        hoist.speed = hoist.acceleration = kSpeed_m_s;
        if (!free) continue;
        for (std::size_t byte = 0; byte < kBytes; ++byte)
            hoist.levels.push_back({free->universe, free->channel + static_cast<int>(k * kBytes + byte)});
    }
}

Result<void> set_address(AppModel& app, ShowDocument& document, const QStringList& words) {
    TRY_VOID(document.check_editable());
    TRY(const std::size_t index, mover_called(app, words.value(0)));
    const QStringList parts = words.value(1).split('.');
    TRY(const double universe, number_of(parts, 0, "universe", 1, dmx::kMaxUniverse));
    TRY(const double address, number_of(parts, 1, "address", 1, 512));
    const int bits = words.value(2, "16").toInt();
    if (bits != 8 && bits != 16 && bits != 24)
        return Error{"'" + words.value(2).toStdString() + "' is none of 8, 16 and 24 bits", ""};
    const scene::Mover& mover = app.show()->movers[index];
    TRY(std::string text,
        scene::set_mover_address(document.text(), mover,
                                 {static_cast<int>(universe), static_cast<int>(address)}, bits));
    return document.edit(translated("Undo", "Address of '%1' set").arg(QString::fromStdString(mover.name)),
                         {std::move(text), app.look(), app.selection()});
}

// Its name; "": none. By the show's names: the engine may not have read yet that it flies.
std::string carrier_of(const scene::Show& show, const Object& object) {
    for (const scene::Mover& mover : show.movers)
        for (const std::string& pattern : mover.objects)
            if (matches(pattern, object.name)) return mover.name;
    const auto index = static_cast<std::size_t>(object.mover);
    return object.mover == scene::kNoMover || index >= show.movers.size() ? "" : show.movers[index].name;
}

} // namespace

std::string carrier_at(const AppModel& app, const glm::vec3& place_m) {
    std::string nearest;
    float nearest_m = INFINITY;
    for (const Object& object : app.opened().objects) {
        if (!object.bar || !scene::is_slender(*object.bar)) continue;
        const std::optional<float> away_m = scene::hangs_away_m(*object.bar, place_m);
        if (!away_m || *away_m >= nearest_m) continue;
        nearest_m = *away_m;
        nearest = carrier_of(*app.show(), object);
    }
    return nearest;
}

Result<void> hang_under(AppModel& app, ShowDocument& document, std::size_t object) {
    TRY_VOID(places_of_selection(app, document));
    const std::vector<Object>& objects = app.opened().objects;
    if (object >= objects.size() || !objects[object].bar)
        return Error{"does not lie like a truss or a pipe, so nothing hangs under it",
                     object < objects.size() ? objects[object].name : ""};
    std::vector<scene::Bar> pieces;
    for (const Object& one : objects)
        if (one.bar && scene::is_slender(*one.bar)) pieces.push_back(*one.bar);
    const scene::Bar bar = scene::joined(*objects[object].bar, pieces);
    const glm::vec3 way = glm::normalize(bar.to_m - bar.from_m);
    std::vector<scene::BarLoad> shall;
    for (const std::size_t index : app.selection()) {
        const scene::PatchedFixture& fixture = app.show()->fixtures[index];
        shall.push_back({fixture.position_m, width_of(fixture, way)});
    }
    std::optional<std::vector<glm::vec3>> places =
        scene::places_beside(bar, shall, what_hangs(bar, app.show()->fixtures, app.selection()));
    if (!places)
        return Error{"has no room beside what hangs there for " + std::to_string(shall.size()) +
                         " more; take fewer, or hang them elsewhere",
                     objects[object].name};
    for (glm::vec3& place_m : *places) place_m = in_millimetres(place_m);
    return PatchEdit(app, document)
        .set_positions(
            translated("Undo", "Hung under '%1'").arg(QString::fromStdString(objects[object].name)), *places,
            carrier_of(*app.show(), objects[object]));
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

glm::vec3 place_above(const std::vector<Object>& objects, const std::vector<scene::PatchedFixture>& others,
                      const scene::PatchedFixture& made, const glm::vec3& floor_m, float lowest_m) {
    std::vector<scene::Bar> pieces, on_plan; // what is above what counts for nothing there
    for (const Object& object : objects) {
        if (!object.bar || !object.shown || !scene::is_slender(*object.bar) ||
            std::min(object.bar->from_m.z, object.bar->to_m.z) < kLowestTruss_m)
            continue;
        pieces.push_back(*object.bar);
        on_plan.push_back(*object.bar);
        on_plan.back().from_m.z = on_plan.back().to_m.z = 0;
    }
    const glm::vec3 at_m(floor_m.x, floor_m.y, 0);
    const std::optional<std::size_t> nearest = scene::nearest_bar(on_plan, at_m);
    if (!nearest) return in_millimetres({floor_m.x, floor_m.y, std::max(floor_m.z, lowest_m)});
    const scene::Bar bar = scene::joined(pieces[*nearest], pieces);
    const std::array shall{scene::BarLoad{at_m, width_of(made, glm::normalize(bar.to_m - bar.from_m))}};
    const auto beside = scene::places_beside(bar, shall, what_hangs(bar, others, {}));
    return in_millimetres(beside ? beside->front() : scene::places_under(bar, std::array{at_m}).front());
}

Result<void> fly_on_hoists(AppModel& app, ShowDocument& document, std::size_t object) {
    TRY_VOID(document.check_editable());
    const std::vector<Object>& objects = app.opened().objects;
    if (object >= objects.size() || !objects[object].bar || !scene::is_slender(*objects[object].bar))
        return Error{"does not lie like a truss or a pipe, so no hoists hold it",
                     object < objects.size() ? objects[object].name : ""};
    const scene::Show& show = *app.show();
    scene::Mover truss;
    truss.name = objects[object].name;
    truss.kind = scene::MoverKind::hoists;
    const scene::Bar bar = take_pieces(objects, object, truss.objects);
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i].mover != scene::kNoMover &&
            std::find(truss.objects.begin(), truss.objects.end(), objects[i].name) != truss.objects.end())
            return Error{"goes with mover '" + show.movers[static_cast<std::size_t>(objects[i].mover)].name +
                             "' already",
                         objects[i].name};
    for (const scene::Mover& mover : show.movers)
        if (mover.name == truss.name) return Error{"is the name of another mover", truss.name};
    for (const scene::PatchedFixture& fixture : show.fixtures)
        if (fixture.mover == scene::kNoMover && !fixture.track &&
            scene::hangs_away_m(bar, fixture.position_m))
            truss.fixtures.push_back(fixture.name);
    add_hoists(bar, show, truss);
    TRY(std::string text, scene::add_mover(document.text(), truss));
    return document.edit(translated("Undo", "'%1' flies on hoists").arg(QString::fromStdString(truss.name)),
                         {std::move(text), app.look(), app.selection()});
}

void add_hang_action(Actions& actions, AppModel& app, ShowDocument& document) {
    actions.add({"fly-on-hoists",
                 "Edit",
                 translated("Action", "Fly the chosen truss on two hoists"),
                 "Ctrl+Shift+H",
                 "[OBJECT]",
                 [&app, &document](const QStringList& words) -> Result<void> {
                     TRY(const std::size_t object, object_called(app, words.value(0)));
                     return fly_on_hoists(app, document, object);
                 },
                 {}});
    actions.add({"mover-address",
                 "",
                 "mover-address",
                 "",
                 "NAME UNIVERSE.ADDRESS [BITS]",
                 [&app, &document](const QStringList& words) { return set_address(app, document, words); },
                 {}});
    actions.add({"hang",
                 "Edit",
                 translated("Action", "Hang under the nearest truss"),
                 "Ctrl+H",
                 "[OBJECT]",
                 [&app, &document](const QStringList& words) { return hang(app, document, words.value(0)); },
                 {}});
}

} // namespace ghost::ui
