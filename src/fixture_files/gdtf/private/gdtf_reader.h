#pragma once
// SPDX-License-Identifier: Apache-2.0
// Private to load_gdtf: the state of one reading and the readers of the parts of description.xml. Every
// getter says what it could not understand, with the line, and goes on with the standard's default.

#include "archives/archive.h"
#include "base/message_list.h"
#include "fixture_files/gdtf/gdtf.h"

#include <pugixml.hpp>

#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ghost::fixture {

using Names = std::map<std::string, int>; // of linked things; the first of a name wins

struct GdtfReader {
    Archive& archive;
    std::string name; // of the file, for messages
    std::vector<std::uint32_t> line_starts;
    LoadedType loaded{};
    MessageCap messages{};
    std::size_t functions_made = 0; // over all modes
    std::size_t nodes_made = 0;
    std::size_t expanded_bytes = 0; // what references multiply: channels, relations, lists of beams
    std::size_t pixels_decoded = 0;
    Names wheels{}, emitters{}, filters{}, models{}, geometries{}, top_level{};
    Names definitions{}, color_spaces{}, gamuts{}, dmx_profiles{}, modes{};
    std::map<std::string, int> media{};              // by MediaFileName
    std::map<int, std::string> reference_targets{};  // geometry index -> name of the target
    std::map<int, pugi::xml_node> reference_nodes{}; // for messages

    std::set<std::string> said_once{};

    Type& type() { return loaded.type; }

    std::string place(pugi::xml_node node) const; // "VL.gdtf: description.xml:120"
    void say(Severity severity, pugi::xml_node node, const std::string& what);
    void say_once(Severity severity, pugi::xml_node node, const std::string& what); // the same words: once
    void say_at(Severity severity, const std::string& where, const std::string& what);

    // As the standard spells it, else in any case.
    pugi::xml_attribute attribute(pugi::xml_node node, const char* name) const;
    std::string text(pugi::xml_node node, const char* attribute, const char* fallback = "");
    float number(pugi::xml_node node, const char* attribute, float fallback, float low, float high);
    ColorCie color(pugi::xml_node node, const char* attribute, ColorCie fallback = {});
    // One of the words, without case; the first of them is the fallback.
    std::string choice(pugi::xml_node node, const char* attribute, std::initializer_list<const char*> words);
    // The index of a linked name; -1 and a message where there is a name but nothing of that name.
    int link(pugi::xml_node node, const char* attribute, const Names& index);
    void add_name(Names& index, pugi::xml_node node, const char* kind, const std::string& name, int number);
    // True, and said once per caller, where a list is full.
    bool is_full(pugi::xml_node node, std::size_t count, std::size_t limit, const char* what);
    // False where what references multiply would need more memory than is allowed.
    bool take_bytes(std::size_t bytes);
};

int find_name(const Names& index, const std::string& name); // exactly, else without case; -1

void read_attributes(GdtfReader& reader, pugi::xml_node fixture_type); // AttributeDefinitions
void read_physical(GdtfReader& reader, pugi::xml_node fixture_type);   // PhysicalDescriptions
void read_wheels(GdtfReader& reader, pugi::xml_node fixture_type);
void read_models(GdtfReader& reader, pugi::xml_node fixture_type);
void read_symbols(GdtfReader& reader, pugi::xml_node fixture_type); // of the models
void read_geometries(GdtfReader& reader, pugi::xml_node fixture_type);
void read_modes(GdtfReader& reader, pugi::xml_node fixture_type);
void say_unused(GdtfReader& reader, pugi::xml_node root); // what none of the others reads

// Where a reference puts its channels.
struct ReferenceInstance {
    std::vector<glm::ivec2> offsets; // x: break, y: bytes to add
    glm::ivec2 overwrite{1, 0};
    bool root = false; // the mode's own tree: adds nothing, in every break
};

struct ExpandedNodes {
    std::vector<int> instance;  // per Mode::nodes: index into instances
    std::vector<int> reference; // per Mode::nodes: the reference geometry it came from, else -1
    std::vector<ReferenceInstance> instances;
};

// Fills mode.nodes, beams, parts from the tree under a top-level geometry.
ExpandedNodes expand_geometries(GdtfReader& reader, pugi::xml_node mode_node, int root, Mode& mode);

} // namespace ghost::fixture
