// SPDX-License-Identifier: Apache-2.0
#include "plots/plot_changes.h"

#include "dmx/wire/universes.h"
#include "json_xml_toml/toml_reader.h"
#include "show/show.h"
#include "show_file/scene_toml.h"

#include <cmath>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

namespace ghost::scene {
namespace {

// As fixture_to_world turns, with the size of the axes it had.
glm::dmat3 turned(const glm::dmat3& axes, const glm::vec3& rotation_deg) {
    const glm::dvec3 turn_rad = glm::radians(glm::dvec3(rotation_deg));
    glm::dmat4 matrix = glm::rotate(glm::dmat4(1.0), turn_rad.z, glm::dvec3(0, 0, 1));
    matrix = glm::rotate(matrix, turn_rad.y, glm::dvec3(0, 1, 0));
    matrix = glm::rotate(matrix, turn_rad.x, glm::dvec3(1, 0, 0));
    glm::dmat3 result(matrix);
    for (int k = 0; k < 3; ++k)
        if (const double length = glm::length(axes[k]); length > 0.0) result[k] *= length; // none: flattened
    if (glm::determinant(axes) < 0.0) result[0] = -result[0];
    return result;
}

// As the plot counts breaks: from 0, or from 1 where its program does.
int written_break(const PlotObject& object, int dmx_break) {
    for (const PlotAddress& address : object.device.addresses)
        if (gdtf_break(object.device, address) == dmx_break) return address.dmx_break;
    const bool counts_from_1 =
        !object.device.addresses.empty() && gdtf_break(object.device, object.device.addresses.front()) ==
                                                object.device.addresses.front().dmx_break;
    return counts_from_1 ? dmx_break : dmx_break - 1;
}

glm::dmat4 parent_world(const Plot& plot, const PlotObject& object) {
    if (object.parent >= 0) return plot.objects[static_cast<std::size_t>(object.parent)].world;
    if (object.layer >= 0) return plot.layers[static_cast<std::size_t>(object.layer)].local;
    return glm::dmat4(1.0);
}

// entry: of this object of the plot.
void add_changes(const Plot& plot, const PlotObject& object, const ChangeEntry& entry,
                 const glm::dvec3& origin_m, std::vector<PlotChange>& changes) {
    const auto add = [&](PlotChange::What what) -> PlotChange& {
        PlotChange& change = changes.emplace_back();
        change.uuid = entry.uuid;
        change.what = what;
        return change;
    };
    if (entry.address) {
        PlotChange& change = add(PlotChange::What::address);
        change.dmx_break = written_break(object, entry.dmx_break);
        change.address = *entry.address;
    }
    if (entry.mode) add(PlotChange::What::mode).text = *entry.mode;
    if (entry.name) add(PlotChange::What::name).text = *entry.name;
    if (entry.hidden) add(PlotChange::What::hidden).hidden = *entry.hidden;
    if (!entry.position_m && !entry.rotation_deg) return;
    glm::dmat4 world = object.world;
    if (entry.rotation_deg) {
        const glm::dmat3 axes = turned(glm::dmat3(world), *entry.rotation_deg);
        for (int k = 0; k < 3; ++k) world[k] = glm::dvec4(axes[k], 0.0);
    }
    if (entry.position_m) world[3] = glm::dvec4(glm::dvec3(*entry.position_m) + origin_m, 1.0);
    const glm::dmat4 parent = parent_world(plot, object);
    PlotChange& change = add(PlotChange::What::position);
    change.local = std::abs(glm::determinant(parent)) > 1e-12 ? glm::inverse(parent) * world : world;
}

} // namespace

std::vector<PlotChange> plot_changes(const Plot& plot, const std::vector<ChangeEntry>& entries,
                                     const glm::dvec3& origin_m) {
    const ObjectIndex index(plot);
    const PlotObject absent;
    std::vector<PlotChange> changes;
    for (const ChangeEntry& entry : entries) {
        const int found = index.find(entry.uuid);
        add_changes(plot, found < 0 ? absent : plot.objects[static_cast<std::size_t>(found)], entry, origin_m,
                    changes);
    }
    return changes;
}

std::vector<PlotChange> apply_changes(Plot& plot, const std::vector<ChangeEntry>& entries,
                                      const glm::dvec3& origin_m, Report& report) {
    const ObjectIndex index(plot);
    const PlotObject absent;
    std::vector<PlotChange> changes;
    bool is_moved = false;
    for (const ChangeEntry& entry : entries) {
        const int found = index.find(entry.uuid);
        if (found < 0) {
            add_changes(plot, absent, entry, origin_m, changes);
            if (!entry.uuid.empty())
                report.add(Severity::warning, entry.where,
                           "[[change]] uuid '" + entry.uuid.substr(0, 60) + "'" +
                               (entry.name ? " (" + entry.name->substr(0, 60) + ")" : "") +
                               " is not in the plot (any more); the change waits for it");
            continue;
        }
        update_world(plot, found); // what is above it may have been moved
        PlotObject& object = plot.objects[static_cast<std::size_t>(found)];
        const std::size_t first = changes.size();
        const PlacedBy placed_by = object.placed_by;
        add_changes(plot, object, entry, origin_m, changes);
        for (std::size_t k = first; k < changes.size(); ++k) {
            apply_change(object, changes[k]);
            is_moved = is_moved || changes[k].what == PlotChange::What::position;
        }
        if (!entry.position_m) object.placed_by = placed_by; // a turn places nothing
        if (entry.rotation_deg) object.turned_by = PlacedBy::change;
    }
    if (is_moved) update_world(plot);
    return changes;
}

void apply_circuits(Show& show, const std::vector<ChangeEntry>& entries) {
    std::map<std::string, std::string> circuits;
    for (const ChangeEntry& entry : entries)
        if (entry.circuit) circuits[uuid_key(entry.uuid)] = *entry.circuit;
    for (PatchedFixture& fixture : show.fixtures) {
        if (fixture.uuid.empty()) continue;
        if (const auto found = circuits.find(uuid_key(fixture.uuid)); found != circuits.end())
            fixture.circuit = found->second;
    }
}

} // namespace ghost::scene
