#pragma once
// SPDX-License-Identifier: Apache-2.0
// MvrReader: one reading of an MVR description into a Plot; private to the mvr_*.cpp files that fill it.
// Sentences that come up again and again are counted and said once, with the first place.

#include "base/message_cap.h"
#include "mvr/mvr_load.h"

#include <glm/mat4x4.hpp>
#include <pugixml.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace ghost::scene {

// "../x", "/x", "C:x": nothing that an archive should hold.
bool leads_out(const std::string& member);

// The archive's files by name. Names that lead out of the archive are not among them.
class MvrMembers {
public:
    MvrMembers(const std::vector<std::string>& names, const std::string& archive, Report& report);

    struct Found {
        std::string member; // empty: none
        bool exact = true;  // false: case, a folder or slashes differ
    };
    Found find(std::string_view name) const;
    const std::vector<std::string>& gdtf_files() const { return gdtf_files_; }

private:
    std::unordered_map<std::string, int> by_name_;
    std::unordered_map<std::string, int> by_small_; // small letters, slashes forward
    std::unordered_map<std::string, int> by_last_;  // the same without folders
    std::vector<std::string> names_;
    std::vector<std::string> gdtf_files_;
};

class MvrReader {
public:
    MvrReader(LoadedPlot& loaded, const MvrLoading& loading, const MvrMembers& members, Bytes xml);

    Plot& plot() { return loaded_.plot; }
    const MvrMembers& members() const { return members_; }

    void say(Severity severity, pugi::xml_node node, const std::string& what);
    void finish_messages();

    // Checks for cancelling and reports progress, now and then.
    void tick(pugi::xml_node node);
    bool cancelled() const { return cancelled_; }

    int line_of(pugi::xml_node node) const { return line_at(node.offset_debug()); }
    int line_at(std::ptrdiff_t offset) const; // 0: cannot be told
    std::string attribute(pugi::xml_node node, const char* name);
    std::string text(pugi::xml_node node); // of the element itself, without blanks around
    std::string text(pugi::xml_node node, const char* child) { return text(node.child(child)); }
    int integer(pugi::xml_node node, int fallback); // fallback and a message where it is none
    double number(pugi::xml_node node, const std::string& written, double fallback);
    bool yes(pugi::xml_node node, bool fallback);
    // Identity where there is none. Nothing, and a message: it cannot be used.
    std::optional<glm::dmat4> matrix(pugi::xml_node parent);
    void unknown(pugi::xml_node node);
    // One more geometry, address, command ..: false where there are too many of them.
    bool take_part(pugi::xml_node node);

    std::vector<PlotGeometry> geometries(pugi::xml_node list); // Geometry3D and Symbol
    std::optional<PlotSource> source(pugi::xml_node node);
    // Sources of a list: Source elements, or bare text.
    std::vector<PlotSource> sources(pugi::xml_node list);
    PictureScale scale(pugi::xml_node parent);

    // Parallel to plot().objects; symdef UUIDs of plot().symbols and of every Symbol, in reading order.
    std::vector<pugi::xml_node> object_nodes;
    std::unordered_map<std::string, int> object_index;
    std::unordered_map<std::string, int> symbol_index;
    std::vector<pugi::xml_node> symbol_nodes;

private:
    struct Said {
        Severity severity;
        std::string where;
        std::string what;
        std::size_t times = 1;
    };
    std::string where(pugi::xml_node node) const;
    int mesh(pugi::xml_node node);

    LoadedPlot& loaded_;
    const MvrLoading& loading_;
    const MvrMembers& members_;
    std::vector<std::size_t> line_starts_;
    std::size_t xml_bytes_ = 0;
    std::map<std::string, std::size_t> said_index_;
    std::vector<Said> said_;
    MessageCap cap_;
    std::size_t parts_ = 0;
    std::size_t ticks_ = 0;
    std::unordered_map<std::string, int> mesh_index_;
    bool cancelled_ = false;
};

void read_auxiliary(MvrReader& reader, pugi::xml_node scene);                  // mvr_auxiliary.cpp
void read_layers(MvrReader& reader, pugi::xml_node scene);                     // mvr_objects.cpp
bool read_device_part(MvrReader& reader, pugi::xml_node node, PlotDevice& to); // mvr_device.cpp
void cut_symbols(MvrReader& reader);                                           // mvr_auxiliary.cpp
void resolve_links(MvrReader& reader);                                         // mvr_links.cpp

} // namespace ghost::scene
