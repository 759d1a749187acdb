#pragma once
// SPDX-License-Identifier: Apache-2.0
// What goes by index, carried over to a show that counts otherwise: another text of it, its next version, or
// one that was made of a plot. Fixtures are the same by their object of the plot, else by name; movers,
// objects and materials by name. Pure.

#include "link/link.h"
#include "show/show.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ghost::ui {

// Of old names to new ones.
using Renamed = std::map<std::string, std::string>;

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

inline bool is_same_fixture(const scene::PatchedFixture& a, const scene::PatchedFixture& b) {
    return a.uuid == b.uuid && (!a.uuid.empty() || a.name == b.name);
}

inline constexpr auto kIsCalledSo = [](const auto& a, const auto& b) { return a.name == b.name; };

inline std::optional<std::size_t> fixture_of(std::size_t index, const scene::Show& before,
                                             const scene::Show& now, const Renamed& renamed = {}) {
    return place_of(index, before.fixtures, now.fixtures,
                    [&](const scene::PatchedFixture& a, const scene::PatchedFixture& b) {
                        const auto other = renamed.find(a.name);
                        return other != renamed.end() && a.uuid == b.uuid ? other->second == b.name
                                                                          : is_same_fixture(a, b);
                    });
}

// Fixtures and movers of it; all else stays.
inline Look carried(const Look& look, const scene::Show& before, const scene::Show& now,
                    const Renamed& renamed = {}) {
    Look carried = look;
    carried.fixtures.clear();
    carried.solo.clear();
    carried.movers.clear();
    for (const auto& [index, programmer] : look.fixtures)
        if (const auto place = fixture_of(index, before, now, renamed)) carried.fixtures[*place] = programmer;
    for (const std::size_t index : look.solo)
        if (const auto place = fixture_of(index, before, now, renamed)) carried.solo.insert(*place);
    for (const auto& [index, values] : look.movers)
        if (const auto place = place_of(index, before.movers, now.movers, kIsCalledSo);
            place && now.movers[*place].axes.size() == values.size())
            carried.movers[*place] = values;
    return carried;
}

// Likewise objects and materials, too.
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
