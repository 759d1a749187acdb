// SPDX-License-Identifier: Apache-2.0
#include "mvr/mvr_load.h"

#include "base/text.h"
#include "fixture/values.h"
#include "json_xml_toml/xml_encoding.h"
#include "json_xml_toml/xml_entities.h"
#include "mvr/private/mvr_reader.h"

#include <algorithm>
#include <set>
#include <utility>

namespace ghost::scene {
namespace {

constexpr const char* kDescription = "GeneralSceneDescription.xml";
// A node takes sixteen times the four letters that make one: without this, 64 MiB of text become a gigabyte.
constexpr std::ptrdiff_t kMaxXmlTags = 2'000'000;
constexpr std::size_t kMaxUserData = 64u << 10;
constexpr std::size_t kMaxUserDataEntries = 1000;

std::string forward(std::string_view name) {
    std::string result = lower(name);
    std::replace(result.begin(), result.end(), '\\', '/');
    return result;
}

void say_names(Report& report, const std::string& archive, const std::vector<std::string>& which,
               const std::string& what) {
    if (which.empty()) return;
    std::string text = what + ": '" + which.front().substr(0, 80) + "'";
    if (which.size() > 1) text += " and " + std::to_string(which.size() - 1) + " more";
    report.add(Severity::warning, archive, text);
}

struct LimitedWriter : pugi::xml_writer {
    std::string text;
    void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), std::min(size, kMaxUserData - text.size()));
    }
};

void read_user_data(MvrReader& reader, pugi::xml_node root) {
    for (const pugi::xml_node list : root.children("UserData"))
        for (const pugi::xml_node node : list.children("Data")) {
            if (reader.plot().user_data.size() >= kMaxUserDataEntries) return;
            LimitedWriter writer;
            node.print(writer, "", pugi::format_raw);
            reader.plot().user_data.push_back(
                {reader.attribute(node, "provider"), reader.attribute(node, "ver"), std::move(writer.text)});
        }
}

Result<void> check_description(Bytes xml, const std::string& where) {
    if (std::count(xml.begin(), xml.end(), '<') > kMaxXmlTags ||
        std::count(xml.begin(), xml.end(), '=') > kMaxXmlTags)
        return Error{"the description has more than " + std::to_string(kMaxXmlTags) + " tags or attributes",
                     where};
    return {};
}

// The way to the element that was read last, by names: what can be looked for in the file.
std::string last_element(const pugi::xml_document& document) {
    std::string way;
    pugi::xml_node node = document.document_element();
    while (node) {
        way += (way.empty() ? "" : "/") + std::string(node.name());
        if (const std::string_view name = node.attribute("name").value(); !name.empty())
            way += " '" + std::string(name) + "'";
        node = node.last_child();
        while (node && node.type() != pugi::node_element) node = node.previous_sibling();
    }
    return way;
}

Result<void> read_description(LoadedPlot& loaded, const MvrMembers& members, const MvrLoading& loading) {
    const std::string where = loaded.name + ": " + loaded.description;
    TRY(std::vector<std::uint8_t> xml, loaded.archive.read(loaded.description, kMaxMvrXmlBytes));
    const bool repaired = fixture::repair_utf8(xml);
    TRY_VOID(check_description(xml, where));
    if (loading.progress) loading.progress(0.2, "description");
    MvrReader reader(loaded, loading, members, xml);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer_inplace(xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype,
                                     repaired ? pugi::encoding_utf8 : pugi::encoding_auto);
    if (!parsed) {
        const std::string way = last_element(document);
        return Error{std::string("the XML is not well formed: ") + parsed.description() +
                         (way.empty() ? ", in" : ", in or behind " + way + " of") +
                         " that file inside of the plot, which is a zip",
                     where + ":" + std::to_string(reader.line_at(parsed.offset))};
    }
    pugi::xml_node root = document.child("GeneralSceneDescription");
    if (!root) return Error{"expected the element GeneralSceneDescription", where};
    if (repaired) reader.say(Severity::warning, root, fixture::kNotUtf8);
    if (fixture::declares_entities(document)) reader.say(Severity::warning, root, fixture::kEntitiesLeft);
    Plot& plot = loaded.plot;
    const auto version = [&](const char* name) {
        const auto number = fixture::parse_int(reader.attribute(root, name));
        if (!number) reader.say(Severity::warning, root, std::string("no whole number in ") + name);
        return number.value_or(0);
    };
    plot.version_major = version("verMajor");
    plot.version_minor = version("verMinor");
    if (plot.version_major > 1)
        reader.say(Severity::warning, root,
                   "MVR " + std::to_string(plot.version_major) + " is newer than 1.6");
    plot.provider = reader.attribute(root, "provider");
    plot.provider_version = reader.attribute(root, "providerVersion");
    read_user_data(reader, root);
    for (const pugi::xml_node node : root.children())
        if (const std::string_view tag = node.name(); tag != "UserData" && tag != "Scene")
            reader.unknown(node);
    const pugi::xml_node scene = root.child("Scene");
    if (!scene) reader.say(Severity::error, root, "there is no Scene element: the plot is empty");
    if (loading.progress) loading.progress(0.4, "objects");
    if (scene) {
        read_auxiliary(reader, scene);
        read_layers(reader, scene);
        for (const pugi::xml_node node : scene.children())
            if (const std::string_view tag = node.name(); tag != "AUXData" && tag != "Layers")
                reader.unknown(node);
    }
    if (reader.cancelled()) return Error{"cancelled", loaded.name};
    if (loading.progress) loading.progress(0.9, "links");
    resolve_links(reader);
    cut_symbols(reader);
    reader.finish_messages();
    if (loading.progress) loading.progress(1.0, "done");
    return {};
}

Result<LoadedPlot> load(fixture::Archive archive, const std::string& name,
                        std::shared_ptr<const std::vector<std::uint8_t>> bytes, const MvrLoading& loading) {
    LoadedPlot loaded{.plot = {},
                      .report = {},
                      .archive = std::move(archive),
                      .description = "",
                      .name = name,
                      .bytes = std::move(bytes)};
    if (loading.cancel && loading.cancel->load()) return Error{"cancelled", name};
    if (loading.progress) loading.progress(0.05, "archive");
    say_names(loaded.report, name, loaded.archive.climbing(),
              "names that lead out of the archive are left out");
    const MvrMembers members(loaded.archive.names(), name, loaded.report);
    const MvrMembers::Found found = members.find(kDescription);
    if (found.member.empty())
        return Error{std::string("expected ") + kDescription + " in the archive; is this an MVR file?", name};
    if (!found.exact)
        loaded.report.add(Severity::warning, name,
                          "the description is '" + found.member + "', expected " + kDescription +
                              " at the root of the archive");
    loaded.description = found.member;
    TRY_VOID(read_description(loaded, members, loading));
    return loaded;
}

} // namespace

bool leads_out(const std::string& member) {
    const std::string path = forward(member);
    if (path.empty() || path.front() == '/' || (path.size() > 1 && path[1] == ':')) return true;
    for (const std::string_view part : split(path, '/'))
        if (part == "..") return true;
    return false;
}

MvrMembers::MvrMembers(const std::vector<std::string>& names, const std::string& archive, Report& report) {
    std::vector<std::string> repeated;
    std::vector<std::string> alike;
    for (const std::string& name : names) {
        if (name.ends_with('/')) continue;
        const int index = static_cast<int>(names_.size());
        if (!by_name_.emplace(name, index).second) {
            repeated.push_back(name);
            continue;
        }
        const std::string small = forward(name);
        if (!by_small_.emplace(small, index).second) alike.push_back(name);
        by_last_.emplace(small.substr(small.rfind('/') + 1), index);
        names_.push_back(name);
        if (small.ends_with(".gdtf")) gdtf_files_.push_back(name);
    }
    say_names(report, archive, repeated, "the archive holds two files of one name, the first counts");
    say_names(report, archive, alike, "the archive holds names that differ only by case");
}

MvrMembers::Found MvrMembers::find(std::string_view name) const {
    Found found;
    if (const auto exact = by_name_.find(std::string(name)); exact != by_name_.end()) {
        found.member = exact->first;
        return found;
    }
    found.exact = false;
    const std::string small = forward(name);
    if (small.empty()) return found;
    if (const auto alike = by_small_.find(small); alike != by_small_.end())
        found.member = names_[static_cast<std::size_t>(alike->second)];
    else if (const auto last = by_last_.find(small.substr(small.rfind('/') + 1)); last != by_last_.end())
        found.member = names_[static_cast<std::size_t>(last->second)];
    return found;
}

Result<LoadedPlot> load_mvr(const std::filesystem::path& path, const MvrLoading& loading) {
    std::error_code code;
    const std::uintmax_t bytes = std::filesystem::file_size(path, code);
    if (!code && bytes > kMaxMvrBytes)
        return Error{"has " + std::to_string(bytes) + " bytes, at most " + std::to_string(kMaxMvrBytes) +
                         " are allowed",
                     path.string()};
    TRY(fixture::Archive archive, fixture::Archive::open_file(path, loading.limits));
    return load(std::move(archive), path.filename().string(), nullptr, loading);
}

Result<LoadedPlot> load_mvr(std::vector<std::uint8_t> bytes, const std::string& name,
                            const MvrLoading& loading) {
    const auto kept = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
    TRY(fixture::Archive archive, fixture::Archive::open(*kept, name, loading.limits));
    return load(std::move(archive), name, kept, loading);
}

} // namespace ghost::scene
