// SPDX-License-Identifier: Apache-2.0
#include "mvr/private/mvr_reader.h"

#include "base/text.h"
#include "fixture/values.h"
#include "mvr/private/mvr_values.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace ghost::scene {
namespace {

constexpr std::size_t kTickElements = 512;
constexpr std::size_t kShortText = 60;

std::string cut(std::string_view text, std::size_t limit) {
    if (text.size() <= limit) return std::string(text);
    std::size_t end = limit;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end; // not inside a letter
    return std::string(text.substr(0, end));
}

std::string short_text(const std::string& text) {
    return "'" + (text.size() > kShortText ? cut(text, kShortText - 3) + "..." : text) + "'";
}

} // namespace

MvrReader::MvrReader(LoadedPlot& loaded, const MvrLoading& loading, const MvrMembers& members, Bytes xml)
    : loaded_(loaded), loading_(loading), members_(members), xml_bytes_(xml.size()) {
    // UTF-16 is converted before it is parsed: its lines cannot be told from the file's bytes.
    if (std::count(xml.begin(), xml.begin() + std::min<std::ptrdiff_t>(8, std::ssize(xml)), 0) > 0) return;
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < xml.size(); ++i)
        if (xml[i] == '\n') line_starts_.push_back(i + 1);
}

int MvrReader::line_at(std::ptrdiff_t offset) const {
    if (offset < 0 || line_starts_.empty()) return 0;
    const auto after =
        std::upper_bound(line_starts_.begin(), line_starts_.end(), static_cast<std::size_t>(offset));
    return static_cast<int>(after - line_starts_.begin());
}

std::string MvrReader::where(pugi::xml_node node) const {
    std::string place = loaded_.name + ": " + loaded_.description;
    if (const int line = line_of(node); line > 0) place += ":" + std::to_string(line);
    std::string path;
    for (; node && node.parent(); node = node.parent()) {
        const std::string_view tag = node.name();
        if (tag.empty() || tag == "ChildList" || tag == "GeneralSceneDescription") continue;
        std::string part(cut(tag, kShortText));
        if (const auto name = node.attribute("name"); name && *name.value())
            part += " " + short_text(name.value());
        path = path.empty() ? part : part + "/" + path;
    }
    return path.empty() ? place : place + ": " + path;
}

void MvrReader::say(Severity severity, pugi::xml_node node, const std::string& what) {
    if (const auto known = said_index_.find(what); known != said_index_.end()) {
        ++said_[known->second].times;
        return;
    }
    if (!cap_.takes(static_cast<int>(severity), what, said_.size())) return;
    said_index_.emplace(what, said_.size());
    said_.push_back({severity, where(node), what});
}

void MvrReader::finish_messages() {
    for (std::size_t i = 0; i < said_.size(); ++i) {
        Said& said = said_[i];
        if (said.times > 1) said.what += " (" + std::to_string(said.times) + " times, first here)";
        if (const std::size_t more = cap_.more_like(i); more > 0)
            said.what += " (and " + std::to_string(more) + " more of this kind)";
        loaded_.report.add(said.severity, std::move(said.where), std::move(said.what));
    }
    if (cap_.is_over()) loaded_.report.add(static_cast<Severity>(cap_.worst()), loaded_.name, cap_.text());
    said_.clear();
    said_index_.clear();
}

void MvrReader::tick(pugi::xml_node node) {
    if (ticks_++ % kTickElements != 0) return;
    if (loading_.cancel && loading_.cancel->load()) cancelled_ = true;
    if (loading_.progress && xml_bytes_ > 0) {
        const double read = static_cast<double>(std::max<std::ptrdiff_t>(0, node.offset_debug())) /
                            static_cast<double>(xml_bytes_);
        loading_.progress(0.4 + 0.5 * std::min(1.0, read), "objects");
    }
}

std::string MvrReader::attribute(pugi::xml_node node, const char* name) {
    pugi::xml_attribute found = node.attribute(name);
    // The tables of the standard write UUID and Name, its examples and all files uuid and name.
    if (!found)
        for (const pugi::xml_attribute other : node.attributes())
            if (lower(other.name()) == lower(name)) found = other;
    const std::string_view value = found.value();
    if (value.size() > kMaxMvrText)
        say(Severity::warning, node,
            std::string("attribute ") + name + " is cut at " + std::to_string(kMaxMvrText) + " bytes");
    return cut(value, kMaxMvrText);
}

std::string MvrReader::text(pugi::xml_node node) {
    const std::string_view value = trimmed(node.text().get());
    if (value.size() > kMaxMvrText)
        say(Severity::warning, node, "text is cut at " + std::to_string(kMaxMvrText) + " bytes");
    return cut(value, kMaxMvrText);
}

int MvrReader::integer(pugi::xml_node node, int fallback) {
    const std::string written = text(node);
    if (written.empty()) return fallback;
    const auto value = fixture::parse_int(written);
    if (!value)
        say(Severity::warning, node,
            "expected a whole number, found " + short_text(written) + "; taken as " +
                std::to_string(fallback));
    return value.value_or(fallback);
}

double MvrReader::number(pugi::xml_node node, const std::string& written, double fallback) {
    if (trimmed(written).empty()) return fallback;
    const auto value = parse_mvr_number(written);
    if (!value)
        say(Severity::warning, node, "expected a number, found " + short_text(written) + "; left out");
    return value.value_or(fallback);
}

bool MvrReader::yes(pugi::xml_node node, bool fallback) {
    const std::string written = lower(text(node));
    if (written == "true" || written == "1") return true;
    if (written == "false" || written == "0") return false;
    if (!written.empty())
        say(Severity::warning, node, "expected true or false, found " + short_text(written));
    return fallback;
}

std::optional<glm::dmat4> MvrReader::matrix(pugi::xml_node parent) {
    const pugi::xml_node node = parent.child("Matrix");
    if (!node) return glm::dmat4(1.0);
    const std::string written = text(node);
    if (written.empty()) return glm::dmat4(1.0);
    const auto value = parse_mvr_matrix(written);
    if (!value) {
        say(Severity::error, node,
            "expected {u}{v}{w}{o}, four rows of three usable numbers (millimetres), found " +
                short_text(written) + "; it stays at the origin of what it hangs on");
        return std::nullopt;
    }
    if (glm::determinant(glm::dmat3(*value)) == 0.0)
        say(Severity::warning, node, "the matrix flattens what it places (its determinant is 0)");
    return value;
}

void MvrReader::unknown(pugi::xml_node node) {
    if (node.type() != pugi::node_element) return;
    say(Severity::note, node,
        "element " + cut(node.name(), kShortText) + " means nothing to MVR 1.6 in " +
            cut(node.parent().name(), kShortText) + "; kept for the export");
}

bool MvrReader::take_part(pugi::xml_node node) {
    if (parts_ >= kMaxMvrParts) {
        say(Severity::error, node,
            "more than " + std::to_string(kMaxMvrParts) +
                " geometries, addresses, commands and the like; the rest is left out");
        return false;
    }
    ++parts_;
    return true;
}

int MvrReader::mesh(pugi::xml_node node) {
    const std::string file = attribute(node, "fileName");
    if (file.empty()) {
        say(Severity::error, node, "Geometry3D without fileName");
        return -1;
    }
    if (const auto known = mesh_index_.find(file); known != mesh_index_.end()) return known->second;
    MvrMembers::Found found;
    for (const char* end : {"", ".3ds", ".glb", ".gltf"}) {
        found = members_.find(file + end);
        if (!found.member.empty()) break;
    }
    PlotMesh mesh;
    mesh.file = file;
    mesh.member = found.member;
    const std::string& name = found.member.empty() ? file : found.member;
    const std::size_t dot = name.rfind('.');
    mesh.extension = dot == name.npos ? "3ds" : lower(std::string_view(name).substr(dot + 1));
    if (mesh.extension == "glb" || mesh.extension == "gltf")
        mesh.to_metres = glm::dmat4({1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}); // Y up to Z up
    else
        mesh.to_metres = glm::dmat4({0.001, 0, 0, 0}, {0, 0.001, 0, 0}, {0, 0, 0.001, 0}, {0, 0, 0, 1});
    if (found.member.empty())
        say(Severity::error, node, "mesh " + short_text(file) + " is not in the archive");
    else if (!found.exact)
        say(Severity::warning, node, "mesh " + short_text(file) + ": taken is " + short_text(found.member));
    plot().meshes.push_back(std::move(mesh));
    const int index = static_cast<int>(plot().meshes.size()) - 1;
    mesh_index_.emplace(file, index);
    return index;
}

std::vector<PlotGeometry> MvrReader::geometries(pugi::xml_node list) {
    std::vector<PlotGeometry> result;
    for (const pugi::xml_node node : list.children()) {
        const std::string_view tag = node.name();
        if (tag == "Geometry3D" || tag == "Symbol") {
            if (!take_part(node)) break;
            PlotGeometry geometry;
            geometry.local = matrix(node).value_or(glm::dmat4(1.0));
            if (tag == "Geometry3D") {
                geometry.mesh = mesh(node);
            } else {
                geometry.uuid = attribute(node, "uuid");
                const auto symdef = symbol_index.find(uuid_key(attribute(node, "symdef")));
                if (symdef != symbol_index.end())
                    geometry.symbol = symdef->second;
                else
                    say(Severity::error, node,
                        "there is no Symdef " + short_text(attribute(node, "symdef")) + "; nothing is drawn");
            }
            result.push_back(std::move(geometry));
        } else {
            unknown(node);
        }
    }
    return result;
}

std::optional<PlotSource> MvrReader::source(pugi::xml_node node) {
    PlotSource source;
    source.value = text(node);
    source.linked_geometry = attribute(node, "linkedGeometry");
    source.type = attribute(node, "type");
    if (source.type.empty()) {
        source.type = "File";
        if (!source.value.empty()) say(Severity::warning, node, "source without a type; taken as File");
    }
    if (source.value.empty()) return std::nullopt;
    if (source.type == "File") {
        source.member = members_.find(source.value).member; // else it may lie beside the plot
    } else if (source.type != "NDI" && source.type != "CITP" && source.type != "CaptureDevice") {
        say(Severity::warning, node,
            "source of type " + short_text(source.type) + "; expected NDI, File, CITP or CaptureDevice");
    }
    return source;
}

std::vector<PlotSource> MvrReader::sources(pugi::xml_node list) {
    std::vector<PlotSource> result;
    for (const pugi::xml_node node : list.children()) {
        const bool bare = node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
        if (!bare && std::string_view(node.name()) != "Source") continue;
        if (!take_part(list)) break;
        if (bare) {
            // The example of the standard writes the file's name without a Source element.
            const std::string_view value = trimmed(node.value());
            if (value.empty()) continue;
            say(Severity::warning, list,
                "text " + short_text(std::string(value)) + " is taken as a Source of type File");
            const std::string name = cut(value, kMaxMvrText);
            result.push_back({"", "File", name, members_.find(name).member});
        } else if (auto found = source(node)) {
            result.push_back(std::move(*found));
        }
    }
    return result;
}

PictureScale MvrReader::scale(pugi::xml_node parent) {
    const pugi::xml_node node = parent.child("ScaleHandeling");
    std::string written = text(node);
    if (written.empty()) written = attribute(node, "Enum");
    const auto value = parse_picture_scale(written);
    if (!value)
        say(Severity::warning, node,
            "expected ScaleKeepRatio, ScaleIgnoreRatio or KeepSizeCenter, found " + short_text(written) +
                "; taken as ScaleKeepRatio");
    return value.value_or(PictureScale::keep_ratio);
}

} // namespace ghost::scene
