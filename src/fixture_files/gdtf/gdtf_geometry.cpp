// SPDX-License-Identifier: Apache-2.0
// The geometry tree, and its expansion for one mode.
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include "base/text.h"
#include "fixture/decode.h"
#include "fixture/values.h"
#include "fixture_files/common/laser_type.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace ghost::fixture {
namespace {

constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxGeometries = 8192;
constexpr std::size_t kMaxNodes = 8192;     // per mode
constexpr std::size_t kMaxAllNodes = 65536; // per file
constexpr std::size_t kMaxName = 512;       // of an expanded node
constexpr std::size_t kMaxBreaks = 64;      // of a reference; real ones have one to four
constexpr float kMaxMatrix = 1e5f;          // metres, or a scale

constexpr std::pair<const char*, GeometryKind> kKinds[] = {
    {"Geometry", GeometryKind::geometry},
    {"Axis", GeometryKind::axis},
    {"FilterBeam", GeometryKind::filter_beam},
    {"FilterColor", GeometryKind::filter_color},
    {"FilterGobo", GeometryKind::filter_gobo},
    {"FilterShaper", GeometryKind::filter_shaper},
    {"Beam", GeometryKind::beam},
    {"MediaServerLayer", GeometryKind::media_server_layer},
    {"MediaServerCamera", GeometryKind::media_server_camera},
    {"MediaServerMaster", GeometryKind::media_server_master},
    {"Display", GeometryKind::display},
    {"Laser", GeometryKind::laser},
    {"GeometryReference", GeometryKind::reference},
    {"WiringObject", GeometryKind::wiring},
    {"Inventory", GeometryKind::inventory},
    {"Structure", GeometryKind::structure},
    {"Support", GeometryKind::support},
    {"Magnet", GeometryKind::magnet},
};

std::optional<GeometryKind> kind_from(const std::string& tag) {
    for (const auto& [name, kind] : kKinds)
        if (tag == name) return kind;
    return std::nullopt;
}

BeamType read_beam_type(GdtfReader& reader, pugi::xml_node node) {
    const std::string type =
        reader.choice(node, "BeamType", {"Wash", "Spot", "None", "Rectangle", "PC", "Fresnel", "Glow"});
    if (type == "Spot") return BeamType::spot;
    if (type == "None") return BeamType::none;
    if (type == "Rectangle") return BeamType::rectangle;
    if (type == "PC") return BeamType::pc;
    if (type == "Fresnel") return BeamType::fresnel;
    if (type == "Glow") return BeamType::glow;
    return BeamType::wash;
}

Beam read_beam(GdtfReader& reader, pugi::xml_node node) {
    Beam beam;
    beam.lamp_type = reader.text(node, "LampType", "Discharge");
    beam.power_w = reader.number(node, "PowerConsumption", 1000.0f, 0.0f, 1e6f);
    beam.luminous_flux_lm = reader.number(node, "LuminousFlux", 10000.0f, 0.0f, 1e8f);
    beam.color_temperature_k = reader.number(node, "ColorTemperature", 6000.0f, 0.0f, 1e5f);
    beam.beam_angle_deg = reader.number(node, "BeamAngle", 25.0f, 0.0f, 360.0f);
    beam.field_angle_deg = reader.number(node, "FieldAngle", 25.0f, 0.0f, 360.0f);
    beam.throw_ratio = reader.number(node, "ThrowRatio", 1.0f, 0.0f, 1000.0f);
    beam.rectangle_ratio = reader.number(node, "RectangleRatio", 1.7777f, 0.0f, 1000.0f);
    beam.beam_radius_m = reader.number(node, "BeamRadius", 0.05f, 0.0f, 100.0f);
    beam.color_rendering_index = reader.number(node, "ColorRenderingIndex", 100.0f, 0.0f, 100.0f);
    beam.beam_type = read_beam_type(reader, node);
    beam.emitter = reader.link(node, "EmitterSpectrum", reader.emitters);
    const bool throws = beam.beam_type != BeamType::none && beam.beam_type != BeamType::glow;
    if (throws && beam.beam_radius_m <= 0.0f)
        reader.say(Severity::note, node,
                   "BeamRadius is 0: its lens has no size, so it is not seen and its shadows are sharp");
    if (throws && beam.luminous_flux_lm <= 0.0f)
        reader.say(Severity::warning, node, "LuminousFlux is 0: this beam gives no light");
    if (std::max(beam.beam_angle_deg, beam.field_angle_deg) > kMaxZoom_deg)
        reader.say(Severity::note, node,
                   "a beam of more than " + std::to_string(static_cast<int>(kMaxZoom_deg)) +
                       " degrees is drawn with so many");
    if (beam.color_temperature_k < 500.0f) {
        reader.say(Severity::warning, node, "ColorTemperature below 500 K, taking 6000 K");
        beam.color_temperature_k = 6000.0f;
    }
    if (beam.field_angle_deg <= 0.0f && beam.beam_angle_deg <= 0.0f) {
        reader.say(Severity::warning, node, "BeamAngle and FieldAngle are 0, taking 25 degrees");
        beam.beam_angle_deg = beam.field_angle_deg = 25.0f;
    }
    if (beam.beam_angle_deg <= 0.0f) {
        reader.say(Severity::warning, node, "BeamAngle is 0, taking 0.6 of FieldAngle");
        beam.beam_angle_deg = 0.6f * beam.field_angle_deg;
    }
    if (beam.field_angle_deg < beam.beam_angle_deg) {
        reader.say(Severity::warning, node,
                   "FieldAngle is smaller than BeamAngle, taking BeamAngle for both");
        beam.field_angle_deg = beam.beam_angle_deg;
    }
    return beam;
}

Laser read_laser(GdtfReader& reader, pugi::xml_node node) {
    Laser laser;
    laser.single_wavelength = reader.choice(node, "ColorType", {"RGB", "SingleWaveLength"}) != "RGB";
    laser.wavelength_nm = reader.number(node, "Color", 0.0f, 0.0f, 2000.0f);
    laser.output_w = reader.number(node, "OutputStrength", 1.0f, 0.0f, 1e4f);
    laser.emitter = reader.link(node, "Emitter", reader.emitters);
    laser.diameter_m = reader.number(node, "BeamDiameter", 0.005f, 0.0f, 1.0f);
    laser.divergence_min_mrad = reader.number(node, "BeamDivergenceMin", 0.0f, 0.0f, 1000.0f);
    laser.divergence_max_mrad = reader.number(node, "BeamDivergenceMax", 0.0f, 0.0f, 1000.0f);
    laser.scan_pan_deg = reader.number(node, "ScanAnglePan", 0.0f, 0.0f, 360.0f);
    laser.scan_tilt_deg = reader.number(node, "ScanAngleTilt", 0.0f, 0.0f, 360.0f);
    laser.scan_speed_kpps = reader.number(node, "ScanSpeed", 0.0f, 0.0f, 1e6f);
    for (const pugi::xml_node protocol : node.children("Protocol")) {
        if (reader.is_full(protocol, laser.protocols.size(), kMaxBreaks, "protocols of a laser")) break;
        laser.protocols.push_back(reader.text(protocol, "Name"));
    }
    if (laser.output_w <= 0.0f) {
        reader.say(Severity::warning, node, "OutputStrength is 0 W, taking 1 W");
        laser.output_w = 1.0f;
    }
    return laser;
}

// Plugs that hand power on, and those for data, take none.
std::optional<PowerInput> read_power_input(GdtfReader& reader, pugi::xml_node node) {
    PowerInput input{.plug = reader.text(node, "Name"),
                     .connector = reader.text(node, "ConnectorType"),
                     .power_w = reader.number(node, "ElectricalPayLoad", 0.0f, 0.0f, 1e6f),
                     .power_factor = reader.number(node, "CosPhi", 0.0f, 0.0f, 1.0f),
                     .voltage_low_v = reader.number(node, "VoltageRangeMin", 0.0f, 0.0f, 1e5f),
                     .voltage_high_v = reader.number(node, "VoltageRangeMax", 0.0f, 0.0f, 1e5f)};
    const bool takes = lower(reader.text(node, "ComponentType")) == "consumer" &&
                       lower(reader.text(node, "SignalType")) == "power" && input.power_w > 0;
    return takes ? std::optional(std::move(input)) : std::nullopt;
}

// A matrix that turns the fixture into a plane, or throws it out of the world, would spoil everything under
// it.
bool is_usable(const glm::mat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= kMaxMatrix)) return false;
    return std::abs(glm::determinant(glm::mat3(matrix))) > 1e-9f;
}

glm::mat4 read_position(GdtfReader& reader, pugi::xml_node node) {
    const std::string position = reader.text(node, "Position");
    if (position.empty()) return glm::mat4(1.0f);
    const std::optional<glm::mat4> matrix = parse_matrix(position);
    if (matrix && is_usable(*matrix)) return *matrix;
    reader.say(Severity::warning, node,
               matrix ? "Position is a matrix that flattens or throws away its geometry, taking identity"
                      : "Position is not a 4 x 4 matrix, taking identity");
    return glm::mat4(1.0f);
}

GeometryReference read_reference(GdtfReader& reader, pugi::xml_node node) {
    GeometryReference reference;
    for (const pugi::xml_node child : node.children("Break")) {
        if (reader.is_full(child, reference.offsets.size(), kMaxBreaks, "breaks of a reference")) break;
        const std::optional<int> number = parse_int(reader.text(child, "DMXBreak", "1"));
        const std::optional<int> offset = parse_dmx_address(reader.text(child, "DMXOffset", "1"));
        if (!number || *number < 1 || *number > 255 || !offset || *offset < 0 || *offset > 65536) {
            reader.say(Severity::error, child, "expected DMXBreak 1 to 255 and a DMXOffset from 1");
            continue;
        }
        reference.offsets.push_back({*number, *offset});
        reference.overwrite = {*number, *offset};
    }
    return reference;
}

void read_tree(GdtfReader& reader, pugi::xml_node parent_node, int parent, int depth) {
    Type& type = reader.type();
    for (const pugi::xml_node node : parent_node.children()) {
        const std::optional<GeometryKind> kind = kind_from(node.name());
        if (!kind) continue; // said by say_unused
        if (depth == kMaxDepth || type.geometries.size() == kMaxGeometries) {
            reader.say(Severity::error, node, "geometries nest deeper than 64 or are more than 8192");
            return;
        }
        Geometry geometry;
        geometry.kind = *kind;
        geometry.name = reader.text(node, "Name");
        geometry.model = reader.link(node, "Model", reader.models);
        geometry.parent = parent;
        geometry.local = read_position(reader, node);
        if (geometry.kind == GeometryKind::beam) geometry.beam = read_beam(reader, node);
        if (geometry.kind == GeometryKind::laser) {
            geometry.laser = read_laser(reader, node);
            geometry.beam = beam_of(*geometry.laser);
        }
        if (geometry.kind == GeometryKind::wiring) geometry.power_input = read_power_input(reader, node);
        if (geometry.kind == GeometryKind::display) {
            if (const std::string file = reader.text(node, "Texture"); !file.empty()) {
                geometry.texture = reader.archive.find(file);
                if (geometry.texture.empty())
                    reader.say(Severity::error, node, "the texture '" + file + "' is not in the archive");
            }
        }
        const int index = static_cast<int>(type.geometries.size());
        if (geometry.kind == GeometryKind::reference) {
            geometry.reference = read_reference(reader, node);
            reader.reference_targets[index] = reader.text(node, "Geometry");
            reader.reference_nodes[index] = node;
        }
        if (!reader.geometries.emplace(geometry.name, index).second)
            reader.say(Severity::note, node,
                       "a second geometry named '" + geometry.name +
                           "', channels mean the first one in the tree of their mode");
        if (parent < 0)
            reader.top_level.emplace(geometry.name, index);
        else
            type.geometries[static_cast<std::size_t>(parent)].children.push_back(index);
        type.geometries.push_back(std::move(geometry));
        read_tree(reader, node, index, depth + 1);
    }
}

struct Expansion {
    GdtfReader& reader;
    pugi::xml_node mode_node;
    Mode& mode;
    ExpandedNodes result{};
    bool full = false;
    std::map<std::string, int> names{}; // and how often each was asked for
    std::vector<int> chain{};           // top-level geometries that are being expanded
    std::set<int> said_cycles{};        // references

    // Node names are unique, as links and messages need; files repeat them ("Power IN" on each base).
    std::string unique(std::string name, int parent) {
        if (++names[name] == 1) return name;
        const std::string base =
            parent < 0 ? name : name + " (in " + mode.nodes[static_cast<std::size_t>(parent)].name + ")";
        name = base.substr(0, kMaxName);
        for (int times = ++names[name]; times > 1; times = ++names[name])
            name = base.substr(0, kMaxName) + " " + std::to_string(times);
        return name;
    }

    // The channels of a referenced geometry sit this far behind those of the reference's own place.
    ReferenceInstance instance_of(const GeometryReference& reference, int outer) const {
        const ReferenceInstance& around = result.instances[static_cast<std::size_t>(outer)];
        const auto shift = [&](glm::ivec2 place) {
            int add = place.y - 1;
            for (const glm::ivec2 known : around.offsets)
                if (known.x == place.x) add += known.y;
            return glm::ivec2(place.x, add);
        };
        ReferenceInstance made;
        for (const glm::ivec2 place : reference.offsets) made.offsets.push_back(shift(place));
        made.overwrite = shift(reference.overwrite);
        return made;
    }

    void add(int geometry_index, int parent, int instance, const std::string& prefix, int depth) {
        const Type& type = reader.type();
        if (depth == kMaxDepth || mode.nodes.size() == kMaxNodes || reader.nodes_made == kMaxAllNodes) {
            if (!full)
                reader.say(Severity::error, mode_node,
                           "the mode's geometries nest deeper than 64 or are more than 8192 (65536 in all "
                           "modes), the "
                           "rest is left out");
            full = true;
            return;
        }
        const Geometry* geometry = &type.geometries[static_cast<std::size_t>(geometry_index)];
        Node node;
        node.name = unique((prefix + geometry->name).substr(0, kMaxName), parent);
        node.geometry = geometry_index;
        node.parent = parent;
        node.model = geometry->model;
        node.local = geometry->local;
        int reference = -1;
        std::string child_prefix = prefix;
        if (geometry->reference) {
            const int target = geometry->reference->geometry;
            if (target < 0) return; // said already
            if (std::find(chain.begin(), chain.end(), target) != chain.end()) {
                if (said_cycles.insert(geometry_index).second)
                    reader.say(Severity::error, reader.reference_nodes[geometry_index],
                               "the reference '" + geometry->name + "' leads back to '" +
                                   type.geometries[static_cast<std::size_t>(target)].name +
                                   "', which it is part of; left out");
                return;
            }
            chain.push_back(target);
            reference = geometry_index;
            result.instances.push_back(instance_of(*geometry->reference, instance));
            instance = static_cast<int>(result.instances.size()) - 1;
            child_prefix = node.name + ".";
            node.geometry = geometry->reference->geometry;
            geometry = &type.geometries[static_cast<std::size_t>(node.geometry)];
            if (node.model < 0) node.model = geometry->model;
        }
        const int index = static_cast<int>(mode.nodes.size());
        if (geometry->beam) mode.beams.push_back(index);
        if (node.model >= 0) mode.parts.push_back(index);
        mode.nodes.push_back(std::move(node));
        ++reader.nodes_made;
        result.instance.push_back(instance);
        result.reference.push_back(reference);
        for (const int child : geometry->children) {
            if (full) break;
            add(child, index, instance, child_prefix, depth + 1);
        }
        if (reference >= 0) chain.pop_back();
    }
};

} // namespace

void read_geometries(GdtfReader& reader, pugi::xml_node fixture_type) {
    read_tree(reader, fixture_type.child("Geometries"), -1, 0);
    for (const auto& [index, target] : reader.reference_targets) {
        const int found = find_name(reader.top_level, target);
        Geometry& geometry = reader.type().geometries[static_cast<std::size_t>(index)];
        if (found >= 0 && !reader.type().geometries[static_cast<std::size_t>(found)].reference)
            geometry.reference->geometry = found;
        else
            reader.say(Severity::error, reader.reference_nodes[index],
                       "the reference '" + geometry.name + "' asks for a top-level geometry '" + target +
                           "' that does not exist");
    }
}

ExpandedNodes expand_geometries(GdtfReader& reader, pugi::xml_node mode_node, int root, Mode& mode) {
    Expansion expansion{.reader = reader, .mode_node = mode_node, .mode = mode, .result = {}};
    ReferenceInstance own;
    own.root = true;
    expansion.result.instances.push_back(own);
    expansion.chain.push_back(root);
    expansion.add(root, -1, 0, "", 0);
    return std::move(expansion.result);
}

} // namespace ghost::fixture
