// SPDX-License-Identifier: Apache-2.0
// What an object of an MVR description says of itself as a device: fixture file, patch, identity, commands.
#include "mvr/private/mvr_reader.h"

#include "fixture/values.h"
#include "mvr/private/mvr_values.h"

#include <utility>

namespace ghost::scene {
namespace {

constexpr int kMaxBreak = 255;

void read_address(MvrReader& reader, pugi::xml_node node, PlotDevice& device) {
    if (!reader.take_part(node)) return;
    PlotAddress address;
    const std::string written_break = reader.attribute(node, "break");
    if (!written_break.empty()) {
        const auto number = fixture::parse_int(written_break);
        if (!number || *number < 0 || *number > kMaxBreak) {
            reader.say(Severity::error, node,
                       "expected a break from 0 to " + std::to_string(kMaxBreak) + ", found '" +
                           written_break.substr(0, 40) + "'; the address is left out");
            device.has_stray_address = true;
            return;
        }
        address.dmx_break = *number;
    }
    for (const PlotAddress& other : device.addresses)
        if (other.dmx_break == address.dmx_break) {
            reader.say(Severity::warning, node, "a second address for the same break; the first one counts");
            return;
        }
    address.written = reader.text(node);
    const auto parsed = parse_mvr_address(address.written);
    address.is_known = parsed || address.written.empty();
    if (parsed)
        address.address = *parsed;
    else if (!address.is_known)
        reader.say(Severity::error, node,
                   "expected an address like 513 or 2.1 (up to universe " + std::to_string(kMaxUniverse) +
                       "), found '" + address.written.substr(0, 40) + "'; taken as not patched");
    device.addresses.push_back(std::move(address));
}

void read_addresses(MvrReader& reader, pugi::xml_node list, PlotDevice& device) {
    for (const pugi::xml_node node : list.children()) {
        const std::string_view tag = node.name();
        if (tag == "Address") {
            read_address(reader, node, device);
        } else if (tag == "Network") {
            if (reader.take_part(node))
                device.networks.push_back({reader.attribute(node, "geometry"), reader.attribute(node, "ipv4"),
                                           reader.attribute(node, "subnetmask"),
                                           reader.attribute(node, "ipv6"), reader.attribute(node, "dhcp"),
                                           reader.attribute(node, "hostname")});
        } else {
            reader.unknown(node);
        }
    }
}

void read_protocols(MvrReader& reader, pugi::xml_node list, PlotDevice& device) {
    for (const pugi::xml_node node : list.children("Protocol")) {
        if (!reader.take_part(node)) return;
        PlotProtocol protocol;
        if (node.attribute("geometry")) protocol.geometry = reader.attribute(node, "geometry");
        protocol.name = reader.attribute(node, "name");
        protocol.type = reader.attribute(node, "type");
        protocol.version = reader.attribute(node, "version");
        protocol.transmission = reader.attribute(node, "transmission");
        device.protocols.push_back(std::move(protocol));
    }
}

glm::dvec3 vector(MvrReader& reader, pugi::xml_node node, const char* name, const glm::dvec3& fallback) {
    const std::string written = reader.attribute(node, name);
    if (written.empty()) return fallback;
    const auto value = parse_mvr_vector(written);
    if (!value)
        reader.say(Severity::warning, node,
                   std::string("expected three numbers in ") + name + ", found '" + written.substr(0, 40) +
                       "'");
    return value.value_or(fallback);
}

void read_alignments(MvrReader& reader, pugi::xml_node list, PlotDevice& device) {
    for (const pugi::xml_node node : list.children("Alignment")) {
        if (!reader.take_part(node)) return;
        PlotAlignment alignment;
        alignment.geometry = reader.attribute(node, "geometry");
        alignment.up = vector(reader, node, "up", alignment.up);
        alignment.direction = vector(reader, node, "direction", alignment.direction);
        device.alignments.push_back(std::move(alignment));
    }
}

void read_mappings(MvrReader& reader, pugi::xml_node list, PlotDevice& device) {
    for (const pugi::xml_node node : list.children("Mapping")) {
        if (!reader.take_part(node)) return;
        PlotMapping mapping;
        mapping.definition_uuid = reader.attribute(node, "linkedDef");
        mapping.ux = reader.integer(node.child("ux"), 0);
        mapping.uy = reader.integer(node.child("uy"), 0);
        mapping.ox = reader.integer(node.child("ox"), 0);
        mapping.oy = reader.integer(node.child("oy"), 0);
        mapping.rz_deg = reader.number(node, reader.text(node, "rz"), 0);
        device.mappings.push_back(std::move(mapping));
    }
}

void read_lists(MvrReader& reader, pugi::xml_node list, PlotDevice& device) {
    for (const pugi::xml_node node : list.children()) {
        const std::string_view tag = node.name();
        if (tag == "CustomCommand") {
            if (!reader.take_part(node)) return;
            PlotCommand command = parse_mvr_command(reader.text(node));
            if (!command.text.empty()) device.commands.push_back(std::move(command));
        } else if (tag == "Overwrite") {
            if (!reader.take_part(node)) return;
            device.overwrites.push_back(
                {reader.attribute(node, "universal"), reader.attribute(node, "target")});
        } else if (tag == "Connection") {
            if (!reader.take_part(node)) return;
            device.connections.push_back({reader.attribute(node, "own"), reader.attribute(node, "other"),
                                          reader.attribute(node, "toObject")});
        } else {
            reader.unknown(node);
        }
    }
}

void read_gobo(MvrReader& reader, pugi::xml_node node, PlotDevice& device) {
    PlotGobo gobo;
    gobo.file = reader.text(node);
    if (gobo.file.empty()) return;
    gobo.rotation_deg = reader.number(node, reader.attribute(node, "rotation"), 0);
    for (const char* end : {"", ".png", ".jpg", ".svg"}) {
        gobo.member = reader.members().find(gobo.file + end).member;
        if (!gobo.member.empty()) break;
    }
    if (gobo.member.empty())
        reader.say(Severity::error, node, "gobo '" + gobo.file.substr(0, 60) + "' is not in the archive");
    device.gobo = std::move(gobo);
}

void read_colour(MvrReader& reader, pugi::xml_node node, PlotDevice& device) {
    const std::string written = reader.text(node);
    if (written.empty()) return;
    device.color = fixture::parse_color(written);
    if (!device.color)
        reader.say(Severity::warning, node,
                   "expected a colour x,y,Y, found '" + written.substr(0, 60) + "'; left out");
}

} // namespace

bool read_device_part(MvrReader& reader, pugi::xml_node node, PlotDevice& to) {
    const std::string_view tag = node.name();
    const auto optional_number = [&] {
        const std::string written = reader.text(node);
        return written.empty() ? std::optional<int>() : std::optional<int>(reader.integer(node, 0));
    };
    if (tag == "GDTFSpec")
        to.gdtf_spec = reader.text(node);
    else if (tag == "GDTFMode")
        to.gdtf_mode = reader.text(node);
    else if (tag == "Focus")
        to.focus_uuid = reader.text(node);
    else if (tag == "CastShadow")
        to.cast_shadow = reader.yes(node, true);
    else if (tag == "DMXInvertPan")
        to.invert_pan = reader.yes(node, false);
    else if (tag == "DMXInvertTilt")
        to.invert_tilt = reader.yes(node, false);
    else if (tag == "Position")
        to.position_uuid = reader.text(node);
    else if (tag == "Function")
        to.function = reader.text(node);
    else if (tag == "FixtureID")
        to.fixture_id = reader.text(node);
    else if (tag == "FixtureIDNumeric")
        to.fixture_id_numeric = optional_number();
    else if (tag == "FixtureTypeId")
        to.fixture_type_id = optional_number();
    else if (tag == "UnitNumber")
        to.unit_number = optional_number();
    else if (tag == "CustomId")
        to.custom_id = reader.integer(node, 0);
    else if (tag == "CustomIdType")
        to.custom_id_type = reader.integer(node, 0);
    else if (tag == "ChildPosition")
        to.child_position = reader.text(node);
    else if (tag == "Color" || tag == "CIEColor")
        read_colour(reader, node, to);
    else if (tag == "Addresses")
        read_addresses(reader, node, to);
    else if (tag == "Protocols")
        read_protocols(reader, node, to);
    else if (tag == "Alignments")
        read_alignments(reader, node, to);
    else if (tag == "CustomCommands" || tag == "Overwrites" || tag == "Connections")
        read_lists(reader, node, to);
    else if (tag == "Mappings")
        read_mappings(reader, node, to);
    else if (tag == "Gobo")
        read_gobo(reader, node, to);
    else
        return false;
    return true;
}

} // namespace ghost::scene
