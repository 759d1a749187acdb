// SPDX-License-Identifier: Apache-2.0
// AttributeDefinitions: what the file says about its attributes, with their groups, features and units.
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include "base/text.h"
#include "fixture/values.h"

#include <set>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxAttributes = 4096;
constexpr std::size_t kMaxSubUnits = 64; // per attribute; the standard has 11

// What the links of an attribute may mean: without case, as real files differ in it.
std::set<std::string> names_of(pugi::xml_node list, const char* element) {
    std::set<std::string> names;
    for (const pugi::xml_node node : list.children(element))
        names.insert(lower(trimmed(node.attribute("Name").as_string())));
    return names;
}

std::set<std::string> features_of(pugi::xml_node groups) {
    std::set<std::string> names;
    for (const pugi::xml_node group : groups.children("FeatureGroup"))
        for (const std::string& feature : names_of(group, "Feature"))
            names.insert(lower(trimmed(group.attribute("Name").as_string())) + "." + feature);
    return names;
}

AttributeDefinition read_definition(GdtfReader& reader, pugi::xml_node node) {
    AttributeDefinition definition;
    definition.name = reader.text(node, "Name");
    definition.pretty = reader.text(node, "Pretty");
    definition.activation_group = reader.text(node, "ActivationGroup");
    definition.feature = reader.text(node, "Feature");
    definition.main_attribute = reader.text(node, "MainAttribute");
    definition.physical_unit = reader.text(node, "PhysicalUnit", "None");
    definition.meaning = attribute_from(definition.name);
    // Black (0,0,0) is what editors write for "no colour"; many write nonsense: it is a hint for a desk's
    // encoders only, so nothing is said about it.
    if (const auto color = parse_color(reader.text(node, "Color")); color && color->y > 0.0f) {
        definition.color = *color;
        definition.has_color = true;
    }
    for (const pugi::xml_node child : node.children("SubPhysicalUnit")) {
        if (reader.is_full(child, definition.sub_units.size(), kMaxSubUnits, "sub-physical units")) break;
        definition.sub_units.push_back({reader.text(child, "Type"),
                                        reader.text(child, "PhysicalUnit", "None"),
                                        reader.number(child, "PhysicalFrom", 0.0f, -1e9f, 1e9f),
                                        reader.number(child, "PhysicalTo", 1.0f, -1e9f, 1e9f)});
    }
    return definition;
}

} // namespace

void read_attributes(GdtfReader& reader, pugi::xml_node fixture_type) {
    const pugi::xml_node all = fixture_type.child("AttributeDefinitions");
    const std::set<std::string> groups = names_of(all.child("ActivationGroups"), "ActivationGroup");
    const std::set<std::string> features = features_of(all.child("FeatureGroups"));
    Type& type = reader.type();
    for (const pugi::xml_node node : all.child("Attributes").children("Attribute")) {
        if (reader.is_full(node, type.definitions.size(), kMaxAttributes, "attributes")) break;
        AttributeDefinition definition = read_definition(reader, node);
        if (!definition.activation_group.empty() && !groups.contains(lower(definition.activation_group)))
            reader.say(Severity::note, node,
                       "the activation group '" + definition.activation_group + "' is not defined");
        if (!definition.feature.empty() && !features.contains(lower(definition.feature)))
            reader.say(Severity::note, node, "the feature '" + definition.feature + "' is not defined");
        reader.add_name(reader.definitions, node, "attribute", definition.name,
                        static_cast<int>(type.definitions.size()));
        type.attributes.push_back(definition.name);
        type.definitions.push_back(std::move(definition));
    }
    for (std::size_t i = 0; i < type.definitions.size(); ++i) {
        const std::string& main = type.definitions[i].main_attribute;
        if (!main.empty() && find_name(reader.definitions, main) < 0)
            reader.say(Severity::note, all,
                       "the main attribute '" + main + "' of '" + type.definitions[i].name +
                           "' is not defined");
    }
}

} // namespace ghost::fixture
