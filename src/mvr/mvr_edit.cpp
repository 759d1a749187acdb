// SPDX-License-Identifier: Apache-2.0
#include "mvr/mvr_edit.h"

#include "base/text.h"
#include "mvr/private/mvr_values.h"

#include <pugixml.hpp>

#include <cstring>
#include <unordered_map>
#include <utility>

namespace ghost::scene {
namespace {

// Entities and line ends are neither read nor written: what is not edited comes out as it went in.
constexpr unsigned kParse = pugi::parse_pi | pugi::parse_comments | pugi::parse_cdata | pugi::parse_doctype |
                            pugi::parse_declaration | pugi::parse_ws_pcdata | pugi::parse_fragment;
constexpr unsigned kPrint = pugi::format_raw | pugi::format_no_escapes | pugi::format_no_declaration;

struct StringWriter : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
    }
};

std::string replaced(std::string_view text, char letter, std::string_view by) {
    std::string result;
    for (const char c : text) {
        if (c == letter)
            result += by;
        else
            result += c;
    }
    return result;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r')
            result += ' '; // no XML has these
        else
            result += c;
    }
    return result;
}

// Finds the elements of the plot's objects, and makes every value fit into double quotes.
struct Walker : pugi::xml_tree_walker {
    std::unordered_map<std::ptrdiff_t, pugi::xml_node> by_offset;
    bool for_each(pugi::xml_node& node) override {
        if (node.type() == pugi::node_element) by_offset.emplace(node.offset_debug(), node);
        for (pugi::xml_attribute attribute : node.attributes())
            if (std::strchr(attribute.value(), '"'))
                attribute.set_value(replaced(attribute.value(), '"', "&quot;").c_str());
        return true;
    }
};

bool is_blank(pugi::xml_node node) {
    return node.type() == pugi::node_pcdata && trimmed(node.value()).empty();
}

void set_text(pugi::xml_node element, const std::string& text) {
    for (pugi::xml_node child = element.first_child(); child;) {
        const pugi::xml_node next = child.next_sibling();
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
            element.remove_child(child);
        child = next;
    }
    element.append_child(pugi::node_pcdata).set_value(text.c_str());
}

// A new element behind another one (or at the front), indented as its neighbours are.
pugi::xml_node insert(pugi::xml_node parent, const char* tag, pugi::xml_node after) {
    pugi::xml_node element;
    if (!after) {
        element = parent.prepend_child(tag);
        const pugi::xml_node indent = element.next_sibling();
        if (is_blank(indent)) parent.prepend_copy(indent);
        return element;
    }
    element = parent.insert_child_after(tag, after);
    const pugi::xml_node indent = after.previous_sibling();
    if (is_blank(indent)) parent.insert_copy_before(indent, element);
    return element;
}

pugi::xml_node first_of(pugi::xml_node parent, std::initializer_list<const char*> tags) {
    for (const char* tag : tags)
        if (const pugi::xml_node found = parent.child(tag)) return found;
    return {};
}

bool edit_address(pugi::xml_node node, const PlotChange& change) {
    const auto written = [](pugi::xml_node address) { return parse_mvr_address(address.text().get()); };
    const int wanted = absolute_address(change.address);
    pugi::xml_node list = node.child("Addresses");
    pugi::xml_node found;
    pugi::xml_node last;
    for (const pugi::xml_node address : list.children("Address")) {
        if (!found && address.attribute("break").as_int(0) == change.dmx_break) found = address;
        last = address;
    }
    if (found ? written(found) && absolute_address(*written(found)) == wanted : wanted == 0) return false;
    if (!list)
        list = insert(node, "Addresses", first_of(node, {"GDTFMode", "GDTFSpec", "Classing", "Matrix"}));
    if (!found) {
        found = insert(list, "Address", last);
        found.append_attribute("break").set_value(change.dmx_break);
    }
    const bool dotted = wanted > 0 && std::strchr(found.text().get(), '.');
    set_text(found,
             dotted ? std::to_string(change.address.universe) + "." + std::to_string(change.address.channel)
                    : std::to_string(wanted));
    return true;
}

bool edit_name(pugi::xml_node node, const std::string& name) {
    pugi::xml_attribute found = node.attribute("name");
    for (const pugi::xml_attribute other : node.attributes())
        if (!found && lower(other.name()) == "name") found = other;
    if (found.value() == escaped(name)) return false;
    if (!found) found = node.append_attribute("name");
    found.set_value(escaped(name).c_str());
    return true;
}

bool edit_mode(pugi::xml_node node, const std::string& mode) {
    pugi::xml_node child = node.child("GDTFMode");
    if (trimmed(child.text().get()) == escaped(mode)) return false;
    if (!child) child = insert(node, "GDTFMode", first_of(node, {"GDTFSpec", "Classing", "Matrix"}));
    set_text(child, escaped(mode));
    return true;
}

bool edit_position(pugi::xml_node node, const glm::dmat4& local) {
    pugi::xml_node child = node.child("Matrix");
    const std::string_view written = trimmed(child.text().get());
    const auto before = written.empty() ? glm::dmat4(1.0) : parse_mvr_matrix(written);
    if (before && *before == local) return false;
    if (!child) child = insert(node, "Matrix", {});
    set_text(child, mvr_matrix_text(local));
    return true;
}

bool apply(pugi::xml_node node, const PlotChange& change) {
    switch (change.what) {
    case PlotChange::What::address:
        return edit_address(node, change);
    case PlotChange::What::mode:
        return edit_mode(node, change.text);
    case PlotChange::What::position:
        return edit_position(node, change.local);
    case PlotChange::What::name:
        return edit_name(node, change.text);
    case PlotChange::What::hidden:
        return false; // no element of MVR says so
    }
    return false;
}

} // namespace

Result<std::optional<std::string>>
edit_description(Bytes xml, const Plot& plot, std::span<const PlotEdit> edits, const std::string& where) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(xml.data(), xml.size(), kParse, pugi::encoding_auto);
    if (!parsed) return Error{std::string("the XML is not well formed: ") + parsed.description(), where};
    Walker walker;
    document.traverse(walker);
    bool edited = false;
    for (const PlotEdit& edit : edits) {
        const PlotObject& object = plot.objects[static_cast<std::size_t>(edit.object)];
        const auto node = walker.by_offset.find(object.element);
        if (node == walker.by_offset.end() || std::string_view(node->second.name()) != tag_of(object.kind))
            return Error{"the description is not the one that was opened", where};
        edited |= apply(node->second, edit.change);
    }
    if (!edited) return std::optional<std::string>();
    if (parsed.encoding != pugi::encoding_utf8)
        for (pugi::xml_node node : document.children())
            if (node.type() == pugi::node_declaration && node.attribute("encoding"))
                node.attribute("encoding").set_value("UTF-8");
    const bool has_mark = xml.size() >= 3 && xml[0] == 0xef && xml[1] == 0xbb && xml[2] == 0xbf;
    StringWriter writer;
    document.save(writer, "", kPrint | (has_mark ? pugi::format_write_bom : 0u), pugi::encoding_utf8);
    return std::optional<std::string>(std::move(writer.text));
}

} // namespace ghost::scene
