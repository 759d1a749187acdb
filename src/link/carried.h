#pragma once
// SPDX-License-Identifier: Apache-2.0
// What goes by index, carried over to a show that counts otherwise: another text of it, its next version, or
// one that was made of a plot. Which fixture is which says show/same_fixtures.h; movers, objects and
// materials go by name. Pure.

#include "link/link.h"
#include "show/same_fixtures.h"
#include "show/show.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace ghost::ui {

// Where its like stands: at the same index, else the first one. Nothing: nowhere.
template <class T, class F>
std::optional<std::size_t> place_of(std::size_t index, const std::vector<T>& before,
                                    const std::vector<T>& now, F&& is_same) {
    if (index >= before.size()) return std::nullopt;
    if (index < now.size() && is_same(before[index], now[index])) return index;
    const auto found =
        std::find_if(now.begin(), now.end(), [&](const T& one) { return is_same(before[index], one); });
    return found == now.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - now.begin()));
}

// Whether an index means something else now. What is new or gone behind all others changes none.
template <class T, class F>
bool counts_otherwise(const std::vector<T>& before, const std::vector<T>& now, F&& is_same) {
    const auto count = static_cast<std::ptrdiff_t>(std::min(before.size(), now.size()));
    return !std::equal(before.begin(), before.begin() + count, now.begin(), is_same);
}

inline constexpr auto kIsCalledSo = [](const auto& a, const auto& b) { return a.name == b.name; };

// Those that are there.
inline std::set<std::size_t> carried(const std::set<std::size_t>& fixtures, const scene::Show& before,
                                     const scene::Show& now) {
    std::set<std::size_t> carried;
    const std::vector<std::optional<std::size_t>> same = scene::same_fixtures(before, now);
    for (std::size_t i = 0; i < same.size(); ++i)
        if (same[i] && fixtures.contains(*same[i])) carried.insert(i);
    return carried;
}

inline std::optional<std::size_t> carried(const std::optional<std::size_t>& fixture,
                                          const scene::Show& before, const scene::Show& now) {
    if (!fixture) return std::nullopt;
    const std::set<std::size_t> there = carried(std::set{*fixture}, before, now);
    return there.empty() ? std::nullopt : std::optional(*there.begin());
}

// What is said of each of them; of one that is new, what `now_said` says.
template <class T>
std::vector<T> carried(const std::vector<T>& said, std::vector<T> now_said, const scene::Show& before,
                       const scene::Show& now) {
    const std::vector<std::optional<std::size_t>> same = scene::same_fixtures(before, now);
    for (std::size_t i = 0; i < same.size(); ++i)
        if (same[i] && *same[i] < said.size()) now_said.at(i) = said[*same[i]];
    return now_said;
}

// Fixtures and movers of it; all else stays.
inline Look carried(const Look& look, const scene::Show& before, const scene::Show& now) {
    Look carried = look;
    carried.fixtures.clear();
    carried.solo = ui::carried(look.solo, before, now);
    carried.movers.clear();
    const std::vector<std::optional<std::size_t>> same = scene::same_fixtures(before, now);
    for (std::size_t i = 0; i < same.size(); ++i)
        if (const auto held = same[i] ? look.fixtures.find(*same[i]) : look.fixtures.end();
            held != look.fixtures.end())
            carried.fixtures[i] = held->second;
    for (const auto& [index, values] : look.movers)
        if (const auto place = place_of(index, before.movers, now.movers, kIsCalledSo);
            place && now.movers[*place].axes.size() == values.size())
            carried.movers[*place] = values;
    return carried;
}

// Names of the fixtures and movers that hands hold and that are not there any more.
inline std::vector<std::string> lost_of(const Look& look, const scene::Show& before, const scene::Show& now) {
    std::vector<std::string> lost;
    std::set<std::size_t> left;
    for (const std::optional<std::size_t>& one : scene::same_fixtures(before, now))
        if (one) left.insert(*one);
    for (const auto& [index, programmer] : look.fixtures)
        if (index < before.fixtures.size() && !left.contains(index))
            lost.push_back(before.fixtures[index].name);
    for (const auto& [index, values] : look.movers)
        if (index < before.movers.size() && !place_of(index, before.movers, now.movers, kIsCalledSo))
            lost.push_back(before.movers[index].name);
    return lost;
}

// As `carried`, objects and materials, too.
inline Look carried(const Look& look, const Opened& before, const Opened& now) {
    Look carried = ui::carried(look, *before.show, *now.show);
    carried.shown.clear();
    carried.surfaces.clear();
    for (std::size_t index = 0; index < before.objects.size(); ++index) {
        const auto shown = look.shown.find(before.objects[index].instance);
        if (shown == look.shown.end()) continue;
        if (const auto place = place_of(index, before.objects, now.objects, kIsCalledSo))
            carried.shown[now.objects[*place].instance] = shown->second;
    }
    for (const auto& [index, surface] : look.surfaces)
        if (const auto place = place_of(index, before.materials, now.materials, kIsCalledSo))
            carried.surfaces[*place] = surface;
    return carried;
}

} // namespace ghost::ui
