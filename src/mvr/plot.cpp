// SPDX-License-Identifier: Apache-2.0
#include "mvr/plot.h"

#include "base/text.h"

#include <algorithm>

namespace ghost::scene {
namespace {

struct KindName {
    ObjectKind kind;
    const char* name;
    const char* tag;
};
constexpr KindName kKindNames[] = {
    {ObjectKind::scene_object, "scene object", "SceneObject"},
    {ObjectKind::group, "group", "GroupObject"},
    {ObjectKind::focus_point, "focus point", "FocusPoint"},
    {ObjectKind::fixture, "fixture", "Fixture"},
    {ObjectKind::support, "support", "Support"},
    {ObjectKind::truss, "truss", "Truss"},
    {ObjectKind::video_screen, "video screen", "VideoScreen"},
    {ObjectKind::projector, "projector", "Projector"},
};

bool is_hex(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
}

void add_instances(const Plot& plot, const std::vector<PlotGeometry>& geometries, int object,
                   const glm::dmat4& to_world, std::vector<MeshInstance>& instances) {
    for (const PlotGeometry& geometry : geometries) {
        const glm::dmat4 world = to_world * geometry.local;
        if (geometry.mesh >= 0) instances.push_back({geometry.mesh, object, world});
        if (geometry.symbol >= 0)
            add_instances(plot, plot.symbols[static_cast<std::size_t>(geometry.symbol)].geometries, object,
                          world, instances);
    }
}

void place_in_world(const Plot& plot, PlotObject& object) {
    glm::dmat4 to_world(1.0);
    if (object.parent >= 0)
        to_world = plot.objects[static_cast<std::size_t>(object.parent)].world;
    else if (object.layer >= 0)
        to_world = plot.layers[static_cast<std::size_t>(object.layer)].local;
    object.world = to_world * object.local;
}

// Whose addresses are meant: its own, or of what it has its channels from.
const PlotDevice& addressed_device(const Plot& plot, const PlotObject& object) {
    const PlotDevice& device = object.device;
    const bool is_patched =
        std::any_of(device.addresses.begin(), device.addresses.end(),
                    [](const PlotAddress& address) { return address.address.channel > 0; });
    if (device.multipatch < 0 || is_patched) return device;
    return plot.objects[static_cast<std::size_t>(device.multipatch)].device;
}

} // namespace

const char* name_of(ObjectKind kind) {
    for (const KindName& entry : kKindNames)
        if (entry.kind == kind) return entry.name;
    return "object";
}

const char* tag_of(ObjectKind kind) {
    for (const KindName& entry : kKindNames)
        if (entry.kind == kind) return entry.tag;
    return "";
}

int absolute_address(const fixture::Address& address) {
    return address.channel > 0 ? (address.universe - 1) * 512 + address.channel : 0;
}

std::string uuid_key(std::string_view uuid) {
    const std::string small = lower(trimmed(uuid));
    std::string digits;
    for (const char c : small)
        if (is_hex(c)) digits += c;
    if (digits.size() != 32) return small;
    for (const std::size_t dash : {20u, 16u, 12u, 8u}) digits.insert(dash, 1, '-');
    return digits;
}

ObjectIndex::ObjectIndex(const Plot& plot) {
    for (std::size_t i = 0; i < plot.objects.size(); ++i)
        if (std::string key = uuid_key(plot.objects[i].uuid); !key.empty())
            by_key_.emplace(std::move(key), static_cast<int>(i));
}

int ObjectIndex::find(std::string_view uuid) const {
    const auto found = by_key_.find(uuid_key(uuid));
    return found == by_key_.end() ? -1 : found->second;
}

int gdtf_break(const PlotDevice& device, const PlotAddress& address) {
    int lowest = address.dmx_break;
    for (const PlotAddress& other : device.addresses) lowest = std::min(lowest, other.dmx_break);
    return lowest == 0 ? address.dmx_break + 1 : address.dmx_break;
}

std::vector<fixture::Address> patch_addresses(const Plot& plot, const PlotObject& object) {
    const PlotDevice& device = addressed_device(plot, object);
    std::vector<fixture::Address> result;
    for (const PlotAddress& address : device.addresses) {
        const auto at = static_cast<std::size_t>(gdtf_break(device, address) - 1);
        if (at >= result.size()) result.resize(at + 1);
        result[at] = address.address;
    }
    return result;
}

bool are_addresses_known(const Plot& plot, const PlotObject& object) {
    const auto are_known = [](const PlotDevice& of) {
        return !of.has_stray_address &&
               std::all_of(of.addresses.begin(), of.addresses.end(),
                           [](const PlotAddress& address) { return address.is_known; });
    };
    return are_known(object.device) && are_known(addressed_device(plot, object));
}

std::vector<MeshInstance> mesh_instances(const Plot& plot, int object) {
    std::vector<MeshInstance> instances;
    const PlotObject& from = plot.objects[static_cast<std::size_t>(object)];
    add_instances(plot, from.geometries, object, from.world, instances);
    return instances;
}

std::vector<MeshInstance> mesh_instances(const Plot& plot) {
    std::vector<MeshInstance> instances;
    for (std::size_t i = 0; i < plot.objects.size(); ++i)
        add_instances(plot, plot.objects[i].geometries, static_cast<int>(i), plot.objects[i].world,
                      instances);
    return instances;
}

void update_world(Plot& plot) {
    for (PlotObject& object : plot.objects) place_in_world(plot, object);
}

void update_world(Plot& plot, int object) {
    std::vector<int> above;
    for (int i = object; i >= 0; i = plot.objects[static_cast<std::size_t>(i)].parent) above.push_back(i);
    for (auto i = above.rbegin(); i != above.rend(); ++i)
        place_in_world(plot, plot.objects[static_cast<std::size_t>(*i)]);
}

void apply_change(PlotObject& object, const PlotChange& change) {
    switch (change.what) {
    case PlotChange::What::address: {
        auto& addresses = object.device.addresses;
        auto same = std::find_if(addresses.begin(), addresses.end(), [&](const PlotAddress& address) {
            return address.dmx_break == change.dmx_break;
        });
        if (same == addresses.end()) {
            addresses.push_back({.dmx_break = change.dmx_break});
            same = addresses.end() - 1;
        }
        same->address = change.address;
        same->is_known = true;
        same->written = std::to_string(absolute_address(change.address));
        break;
    }
    case PlotChange::What::mode:
        object.device.gdtf_mode = change.text;
        break;
    case PlotChange::What::position:
        object.local = change.local;
        object.placed_by = PlacedBy::change;
        break;
    case PlotChange::What::name:
        object.name = change.text;
        break;
    case PlotChange::What::hidden:
        object.hidden = change.hidden;
        break;
    }
}

} // namespace ghost::scene
