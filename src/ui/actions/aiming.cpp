// SPDX-License-Identifier: Apache-2.0
#include "ui/actions/aiming.h"

#include "light/aim.h"
#include "show/camera_moves.h"
#include "show/show.h"
#include "ui/actions/programmer_actions.h"
#include "ui/language/language.h"
#include "ui/model/fan.h"

#include <algorithm>
#include <vector>

namespace ghost::ui {
namespace {

constexpr double kFarthestAim_m = 10000;
constexpr float kNear_deg = 0.01f; // a reach is held to that

bool turns_both_ways(const AppModel& app, std::size_t index) {
    const scene::PatchedFixture& fixture = app.show()->fixtures[index];
    if (!fixture.type || index >= app.rig().fixtures.size()) return false;
    const fixture::Patch patch = fixture.patch();
    return fixture::reach_of(patch, fixture::Role::pan) && fixture::reach_of(patch, fixture::Role::tilt);
}

// Those that do, from left to right.
std::vector<std::size_t> heads_of(const AppModel& app) {
    std::vector<std::size_t> heads = heads_in(HeadOrder::left_to_right, app);
    std::erase_if(heads, [&](std::size_t index) { return !turns_both_ways(app, index); });
    return heads;
}

// How many do not reach.
int aim_heads(AppModel& app, const std::vector<std::size_t>& heads, const glm::vec3& at_m, float spread_m) {
    Look look = app.look();
    int beyond = 0;
    for (std::size_t k = 0; k < heads.size(); ++k) {
        const scene::PatchedFixture& fixture = app.show()->fixtures[heads[k]];
        const FixtureNow& now = app.rig().fixtures[heads[k]];
        fixture::Programmer& programmer = look.fixtures[heads[k]];
        const float share =
            heads.size() > 1 ? static_cast<float>(k) / static_cast<float>(heads.size() - 1) - 0.5f : 0.0f;
        const glm::vec3 way = at_m + glm::vec3(share * spread_m, 0, 0) - now.light_m;
        const glm::mat3 to_fixture =
            glm::inverse(now.turned * glm::mat3(scene::fixture_to_world(fixture, 0)));
        const scene::PanTilt wanted =
            scene::aim(to_fixture * way, {programmer.pan_deg.value_or(now.pan_deg),
                                          programmer.tilt_deg.value_or(now.tilt_deg)});
        const fixture::Patch patch = fixture.patch();
        const auto held = [&](float deg, fixture::Role role) {
            const fixture::AxisRange reach = *fixture::reach_of(patch, role);
            return std::clamp(deg, std::min(reach.low, reach.high), std::max(reach.low, reach.high));
        };
        programmer.pan_deg = held(wanted.pan_deg, fixture::Role::pan);
        programmer.tilt_deg = held(wanted.tilt_deg, fixture::Role::tilt);
        if (std::abs(*programmer.pan_deg - wanted.pan_deg) > kNear_deg ||
            std::abs(*programmer.tilt_deg - wanted.tilt_deg) > kNear_deg)
            ++beyond;
    }
    app.set_look(std::move(look), translated("Undo", "aim"));
    return beyond;
}

} // namespace

Result<int> aim_selected(AppModel& app, const glm::vec3& at_m, float spread_m) {
    if (app.selection().empty()) return Error{"no fixture is selected", ""};
    const std::vector<std::size_t> heads = heads_of(app);
    if (heads.empty()) return Error{"nothing that is selected turns both ways", ""};
    return aim_heads(app, heads, at_m, spread_m);
}

Aiming::Aiming(AppModel& app, Actions& actions, QObject* parent)
    : QObject(parent), app_(app), actions_(actions) {
    connect(&app_, &AppModel::picked_came, this, &Aiming::take_picked);
}

Result<void> Aiming::aim_through(const glm::vec2& place, float spread_m) {
    if (app_.selection().empty()) return Error{"no fixture is selected", ""};
    const std::vector<std::size_t> heads = heads_of(app_);
    if (heads.empty()) return Error{"nothing that is selected turns both ways", ""};
    if (!app_.picture().image) return Error{"there is no picture yet", ""};
    heads_.clear();
    for (const std::size_t index : heads) heads_.push_back(app_.show()->fixtures[index].name);
    const scene::Camera& camera = app_.picture().camera;
    spread_m_ = spread_m;
    number_ = app_.pick(camera.position_m, scene::way_through(camera, place));
    return {};
}

void Aiming::take_picked() {
    const Picked& picked = app_.picked();
    if (picked.number != number_) return;
    number_ = 0;
    // The answer may be late: another selection, or another show by then.
    std::vector<std::size_t> heads;
    for (const std::string& name : heads_)
        for (std::size_t i = 0; i < app_.show()->fixtures.size(); ++i)
            if (app_.show()->fixtures[i].name == name && turns_both_ways(app_, i)) heads.push_back(i);
    if (picked.hit)
        say(aim_heads(app_, heads, picked.at_m, spread_m_));
    else if (actions_.complain)
        actions_.complain(Error{"there is nothing but air to aim at", ""});
}

void Aiming::say(const Result<int>& beyond) {
    if (!actions_.complain) return;
    if (!beyond.ok())
        actions_.complain(beyond.error());
    else if (*beyond > 0)
        actions_.complain(Error{std::to_string(*beyond) + (*beyond == 1 ? " head does" : " heads do") +
                                    " not reach that far, and turned as far as possible",
                                ""});
}

void add_aim_actions(Actions& actions, AppModel& app, Aiming& aiming) {
    actions.add(
        {"aim",
         "",
         "aim",
         "",
         "X Y Z [SPREAD_M]",
         [&app](const QStringList& words) -> Result<void> {
             glm::vec3 at_m(0);
             for (int axis = 0; axis < 3; ++axis) {
                 TRY(const double place,
                     number_of(words, axis, "place in metres", -kFarthestAim_m, kFarthestAim_m));
                 at_m[axis] = static_cast<float>(place);
             }
             double spread_m = 0;
             if (words.size() > 3) {
                 TRY(spread_m, number_of(words, 3, "spread in metres", -kFarthestAim_m, kFarthestAim_m));
             }
             TRY(const int beyond, aim_selected(app, at_m, static_cast<float>(spread_m)));
             if (beyond > 0)
                 return Error{std::to_string(beyond) + " of them do not reach that far, and turned as "
                                                       "far as possible",
                              ""};
             return {};
         },
         {}});
    actions.add({"aim-through",
                 "Edit",
                 translated("Action", "Aim at the middle of the picture"),
                 "Ctrl+Shift+T",
                 "[X Y [SPREAD_M]]",
                 [&aiming](const QStringList& words) -> Result<void> {
                     glm::vec2 place(0.5f);
                     for (int axis = 0; axis < 2 && !words.isEmpty(); ++axis) {
                         TRY(const double share, number_of(words, axis, "share of the picture", 0, 1));
                         place[axis] = static_cast<float>(share);
                     }
                     double spread_m = 0;
                     if (words.size() > 2) {
                         TRY(spread_m,
                             number_of(words, 2, "spread in metres", -kFarthestAim_m, kFarthestAim_m));
                     }
                     return aiming.aim_through(place, static_cast<float>(spread_m));
                 },
                 {}});
}

} // namespace ghost::ui
