// SPDX-License-Identifier: Apache-2.0
#include "book/hangings.h"

#include "base/natural_order.h"
#include "book/fixture_values.h"
#include "mvr/mvr_load.h"
#include "print/quantities.h"
#include "show/show.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace ghost::scene {
namespace {

Hanging hanging_of(const Plot& plot, const PlotObject& object) {
    Hanging hanging;
    const PlotDevice& device = object.device;
    if (device.position >= 0)
        hanging.position = plot.positions[static_cast<std::size_t>(device.position)].name;
    if (object.layer >= 0) hanging.layer = plot.layers[static_cast<std::size_t>(object.layer)].name;
    if (device.unit_number && *device.unit_number > 0) hanging.unit = std::to_string(*device.unit_number);
    hanging.function = device.function;
    if (device.color) hanging.filter = colour_text(*device.color);
    if (hanging.filter == "#ffffff") hanging.filter.clear(); // MVR's default: no filter
    if (device.gobo) hanging.gobo = device.gobo->file;
    hanging.type = device.gdtf_spec;
    hanging.mode = device.gdtf_mode;
    if (device.focus >= 0) hanging.focus = plot.objects[static_cast<std::size_t>(device.focus)].name;
    return hanging;
}

} // namespace

std::vector<Hanging> hangings_of(const Show& show) {
    std::vector<Hanging> all(show.fixtures.size());
    const auto name = [&](std::size_t i) {
        all[i].number = show.fixtures[i].fixture_id;
        all[i].name = show.fixtures[i].name;
    };
    for (std::size_t i = 0; i < all.size(); ++i) name(i);
    if (!show.plot) return all;
    const Plot& plot = show.plot->plot;
    std::map<std::string, std::size_t> objects;
    for (std::size_t i = 0; i < plot.objects.size(); ++i)
        objects.try_emplace(uuid_key(plot.objects[i].uuid), i);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (show.fixtures[i].uuid.empty()) continue;
        const auto found = objects.find(uuid_key(show.fixtures[i].uuid));
        if (found == objects.end()) continue;
        all[i] = hanging_of(plot, plot.objects[found->second]);
        name(i);
    }
    return all;
}

std::vector<std::size_t> in_hanging_order(const std::vector<Hanging>& hangings) {
    std::vector<std::size_t> order(hangings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const Hanging &one = hangings[a], &other = hangings[b];
        if (one.position.empty() != other.position.empty()) return other.position.empty();
        if (one.position != other.position) return natural_less(one.position, other.position);
        if (one.position.empty() && one.layer != other.layer) return natural_less(one.layer, other.layer);
        if (one.unit != other.unit) return natural_less(one.unit, other.unit);
        if (one.number.empty() != other.number.empty()) return other.number.empty();
        if (one.number != other.number) return natural_less(one.number, other.number);
        return natural_less(one.name, other.name);
    });
    return order;
}

} // namespace ghost::scene
