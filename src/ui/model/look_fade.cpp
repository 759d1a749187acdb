// SPDX-License-Identifier: Apache-2.0
#include "ui/model/look_fade.h"
#include "show/show.h"

#include <cmath>

namespace ghost::ui {
namespace {

using fixture::Programmer;

// otherwise: what is there where the one or the other side does not set it.
template <class T>
std::optional<T> between(const std::optional<T>& from, const std::optional<T>& to,
                         const std::optional<T>& otherwise_from, const std::optional<T>& otherwise_to,
                         float share) {
    if (!from && !to) return std::nullopt;
    const std::optional<T> a = from ? from : otherwise_from, b = to ? to : otherwise_to;
    if (!a || !b) return share < 0.5f ? from : to;
    return *a + (*b - *a) * share;
}

template <class T>
std::optional<T> between(const std::optional<T>& from, const std::optional<T>& to,
                         const std::optional<T>& otherwise, float share) {
    return between(from, to, otherwise, otherwise, share);
}

template <class T>
std::optional<T> either(const std::optional<T>& from, const std::optional<T>& to, float share) {
    return share < 0.5f ? from : to;
}

// A fixture that a look is about, and what the desk does with it.
struct Faded {
    const scene::PatchedFixture* fixture = nullptr; // null: the show does not have it
    const fixture::Levels& desk;
    const FixtureNow& now;
};

// What a side asks for where its hands do not: what its levels say, else the desk.
Programmer asked_by(const Programmer& side, const Faded& faded) {
    if (!side.sets_levels() || !faded.fixture || !faded.fixture->type) return faded.now.asked;
    const fixture::Patch patch = faded.fixture->patch();
    return fixture::asked_for(fixture::decode_levels(patch, fixture::levels_by_hand(side, patch, faded.desk)),
                              patch);
}

std::vector<std::uint8_t> mixed_levels(const Programmer& from, const Programmer& to, const Faded& faded,
                                       float share) {
    if ((!from.sets_levels() && !to.sets_levels()) || !faded.fixture || !faded.fixture->type) return {};
    const fixture::Patch patch = faded.fixture->patch();
    return fixture::mixed_levels(patch, fixture::levels_by_hand(from, patch, faded.desk),
                                 fixture::levels_by_hand(to, patch, faded.desk), share);
}

Programmer mixed(const Programmer& from, const Programmer& to, const Faded& faded, float share) {
    const auto colour = [&](const Programmer& side, const Programmer& other) -> std::optional<glm::vec3> {
        if (side.sets_levels()) return std::nullopt;
        return faded.now.colour == glm::vec3(0) ? other.colour : faded.now.colour; // what is dark has none
    };
    const Programmer a = asked_by(from, faded), b = asked_by(to, faded);
    Programmer result;
    result.intensity = between(from.intensity, to.intensity, a.intensity, b.intensity, share);
    result.colour = between(from.colour, to.colour, colour(from, to), colour(to, from), share);
    result.zoom_deg = between(from.zoom_deg, to.zoom_deg, a.zoom_deg, b.zoom_deg, share);
    result.pan_deg = between(from.pan_deg, to.pan_deg, a.pan_deg, b.pan_deg, share);
    result.tilt_deg = between(from.tilt_deg, to.tilt_deg, a.tilt_deg, b.tilt_deg, share);
    result.gobo = either(from.gobo, to.gobo, share);
    result.gel = between(from.gel, to.gel, std::optional(glm::vec3(1)), share);
    result.lamp = between(from.lamp, to.lamp, std::optional(1.0f), share);
    result.lamp_k = between(from.lamp_k, to.lamp_k, {}, share);
    result.levels = mixed_levels(from, to, faded, share);
    return result;
}

// A side that does not hold it asks for what drives it else.
std::map<std::size_t, std::vector<float>> mixed_movers(const Look& from, const Look& to, const RigNow& now,
                                                       float share) {
    std::map<std::size_t, std::vector<float>> movers = from.movers;
    movers.insert(to.movers.begin(), to.movers.end());
    for (auto& [index, values] : movers) {
        const auto asked_by = [&, index = index](const Look& side) -> std::vector<float> {
            if (const auto held = side.movers.find(index); held != side.movers.end()) return held->second;
            return index < now.movers.size() ? now.movers[index].asked : std::vector<float>{};
        };
        const std::vector<float> a = asked_by(from), b = asked_by(to);
        if (a.size() != values.size() || b.size() != values.size()) continue;
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::lerp(a[k], b[k], share);
    }
    return movers;
}

template <class T>
void keep(std::optional<T>& from, const std::optional<T>& before, const std::optional<T>& after) {
    if (before != after) from = after;
}

} // namespace

Look faded(const Look& from, const Look& to, const scene::Show& show, const RigNow& now, float share) {
    if (share >= 1) return to;
    Look look = to;
    std::set<std::size_t> fixtures;
    for (const auto& [index, programmer] : from.fixtures) fixtures.insert(index);
    for (const auto& [index, programmer] : to.fixtures) fixtures.insert(index);
    fixture::Levels desk;
    for (const dmx::Universe& universe : now.universes.list) desk.set(universe.number, *universe.levels);
    const FixtureNow unknown;
    const auto of = [](const Look& one, std::size_t index, const Faded& faded) {
        const auto found = one.fixtures.find(index);
        Programmer side = found == one.fixtures.end() ? Programmer{} : found->second;
        const fixture::Patch patch = faded.fixture ? faded.fixture->patch() : fixture::Patch{};
        if (faded.now.is_dark_without_hands && !fixture::asks_for_light(side, patch)) side.intensity = 0.0f;
        return side;
    };
    for (const std::size_t index : fixtures) {
        const Faded faded{index < show.fixtures.size() ? &show.fixtures[index] : nullptr, desk,
                          index < now.fixtures.size() ? now.fixtures[index] : unknown};
        look.fixtures[index] = mixed(of(from, index, faded), of(to, index, faded), faded, share);
    }
    look.movers = mixed_movers(from, to, now, share);
    const SceneLook &a = from.scene, &b = to.scene;
    look.scene.smoke = between(a.smoke, b.smoke, std::optional(1.0f), share);
    look.scene.ambient_lux = between(a.ambient_lux, b.ambient_lux, std::optional(show.ambient_lux), share);
    look.scene.ambient_colour =
        between(a.ambient_colour, b.ambient_colour, std::optional(show.ambient_colour), share);
    look.scene.attenuation = either(a.attenuation, b.attenuation, share);
    look.scene.shadows = either(a.shadows, b.shadows, share);
    return look;
}

void keep_changes(Look& from, const Look& before, const Look& after) {
    const auto of = [](const Look& look, std::size_t index) {
        const auto found = look.fixtures.find(index);
        return found == look.fixtures.end() ? Programmer{} : found->second;
    };
    std::set<std::size_t> fixtures;
    for (const auto& [index, programmer] : before.fixtures) fixtures.insert(index);
    for (const auto& [index, programmer] : after.fixtures) fixtures.insert(index);
    for (const std::size_t index : fixtures) {
        const Programmer was = of(before, index), is = of(after, index);
        if (was == is) continue;
        Programmer& programmer = from.fixtures[index];
        keep(programmer.intensity, was.intensity, is.intensity);
        keep(programmer.colour, was.colour, is.colour);
        keep(programmer.zoom_deg, was.zoom_deg, is.zoom_deg);
        keep(programmer.pan_deg, was.pan_deg, is.pan_deg);
        keep(programmer.tilt_deg, was.tilt_deg, is.tilt_deg);
        keep(programmer.gobo, was.gobo, is.gobo);
        keep(programmer.gel, was.gel, is.gel);
        keep(programmer.lamp, was.lamp, is.lamp);
        keep(programmer.lamp_k, was.lamp_k, is.lamp_k);
        if (was.levels != is.levels) programmer.levels = is.levels;
        if (was.channels != is.channels) programmer.channels = is.channels;
    }
    for (const auto& [index, values] : after.movers)
        if (const auto was = before.movers.find(index); was == before.movers.end() || was->second != values)
            from.movers[index] = values;
    for (const auto& [index, values] : before.movers)
        if (!after.movers.contains(index)) from.movers.erase(index);
    const SceneLook &was = before.scene, &is = after.scene;
    keep(from.scene.smoke, was.smoke, is.smoke);
    keep(from.scene.ambient_lux, was.ambient_lux, is.ambient_lux);
    keep(from.scene.ambient_colour, was.ambient_colour, is.ambient_colour);
    keep(from.scene.attenuation, was.attenuation, is.attenuation);
    keep(from.scene.shadows, was.shadows, is.shadows);
}

void leave_solo(Look& look, std::size_t fixture_count) {
    if (look.solo.empty()) return;
    for (std::size_t i = 0; i < fixture_count; ++i)
        if (!look.solo.contains(i)) look.fixtures[i].intensity = 0.0f;
}

} // namespace ghost::ui
