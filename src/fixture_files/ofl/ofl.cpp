// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/ofl/ofl.h"

#include "disk/files.h"
#include "fixture_files/ofl/private/ofl_reader.h"
#include "json_xml_toml/json.h"

#include <algorithm>
#include <system_error>

namespace ghost::fixture {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 4u << 20; // the library's largest has 0.3 MB
constexpr JsonLimits kJsonLimits{.members = 1024}; // the list of manufacturers has 300
constexpr std::size_t kMaxListed = 8;

// "american-dj" -> "American Dj"
std::string maker_from(const std::string& key) {
    std::string maker = key;
    bool start = true;
    for (char& c : maker) {
        if (c == '-' || c == '_') c = ' ';
        if (start && c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
        start = c == ' ';
    }
    return maker;
}

// Files of before schema 8 (2018) have channels with a type, and capabilities with a range and a name.
bool is_old(const Json& document) {
    for (const char* list : {"availableChannels", "templateChannels"})
        for (const Json& channel : member(document, list)) {
            if (!text_at(channel, "type").empty()) return true;
            const Json& capabilities = member(channel, "capabilities");
            if (capabilities.is_array() && !capabilities.empty() &&
                !member(capabilities[0], "range").is_null())
                return true;
        }
    return false;
}

// A scanner has a mirror, unless its head is stated.
std::string usual_focus(const Json& document) {
    const Json& categories = member(document, "categories");
    if (!categories.is_array()) return "";
    for (const Json& category : categories) {
        if (category == Json("Moving Head")) return "Head";
        if (category == Json("Scanner") || category == Json("Barrel Scanner")) return "Mirror";
    }
    return "";
}

// The name that the library's list of makers has for it.
std::string stated_maker(const std::filesystem::path& folder, const std::string& key) {
    const std::filesystem::path list = folder / ".." / "manufacturers.json";
    std::error_code code;
    if (!std::filesystem::is_regular_file(list, code)) return "";
    const Result<std::vector<std::uint8_t>> bytes = read_file(list, kMaxFileBytes);
    const Result<Json> makers = bytes ? parse_ofl_json(*bytes, list.string()) : Result<Json>(bytes.error());
    return makers ? text_at(member(*makers, key), "name") : "";
}

std::string listed(const std::string& list, const std::string& name) {
    return list + (list.empty() ? "" : ", ") + name;
}

} // namespace

Result<Json> parse_ofl_json(Bytes bytes, const std::string& name) {
    return read_ordered_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name, kJsonLimits);
}

Result<LoadedType> load_ofl(Bytes bytes, const std::string& name, const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> folders;
    if (!folder.empty()) folders = {folder, folder / "gobos", folder / ".." / ".." / "resources"};
    OflReader reader{.name = name, .gobos = GoboFiles(folders)};
    if (!folder.empty()) reader.resources = folders.back();
    TRY(reader.document, parse_ofl_json(bytes, name));
    const Json& document = reader.document;
    if (const std::string other = text_at(document, "redirectTo"); !other.empty())
        return Error{"is only a redirect: take the fixture '" + other + "'", name};
    if (!document.is_object() || !member(document, "modes").is_array() ||
        (!member(document, "availableChannels").is_object() &&
         !member(document, "templateChannels").is_object()))
        return Error{
            "no modes with availableChannels or templateChannels: this is no fixture of the Open Fixture "
            "Library",
            name};
    Type& type = reader.loaded.type;
    type.name = text_at(document, "name");
    type.short_name = text_at(document, "shortName");
    if (type.short_name.empty()) type.short_name = type.name;
    type.manufacturer = maker_from(text_at(document, "manufacturerKey"));
    type.description = text_at(document, "comment");
    if (type.name.empty()) reader.say(Severity::warning, "/name", "the fixture has no name");
    if (is_old(document)) {
        reader.say(Severity::error, "/",
                   "a file of the library from before 2018 (schema 7 or older), whose channels are not read: "
                   "take it "
                   "anew from open-fixture-library.org");
        reader.quiet = true;
    }
    reader.physical = read_ofl_physical(reader, member(document, "physical"), "/physical");
    if (reader.physical.focus.empty()) reader.physical.focus = usual_focus(document);
    type.properties.weight_kg = reader.physical.weight_kg;
    type.properties.power_w = reader.physical.lamp.power_w;
    read_ofl_wheels(reader);
    read_ofl_matrix(reader);
    convert_ofl_modes(reader);
    std::string list;
    for (const std::string& kind : reader.ignored) list = listed(list, kind);
    if (!list.empty())
        reader.say(Severity::note, "/", "capabilities that no picture shows are ignored: " + list);
    list.clear();
    for (std::size_t i = 0; i < reader.generic.size() && i < kMaxListed; ++i)
        list = listed(list, "'" + reader.generic[i].substr(0, 60) + "'");
    if (reader.generic.size() > kMaxListed) list += ", ...";
    if (!list.empty())
        reader.say(Severity::error, "/",
                   "channels of type Generic, which says nothing, are not shown: " + list);
    if (type.modes.empty()) reader.say(Severity::error, "/modes", "the fixture has no mode");
    reader.loaded.messages = std::move(reader.messages).take();
    return std::move(reader.loaded);
}

Result<LoadedType> load_ofl(const std::filesystem::path& path) {
    TRY(const std::vector<std::uint8_t> bytes, read_file(path, kMaxFileBytes));
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    TRY(LoadedType loaded, load_ofl(bytes, path.filename().string(), folder));
    const std::string key = folder.filename().string();
    if (!loaded.type.manufacturer.empty()) return loaded;
    const std::string maker = stated_maker(folder, key);
    loaded.type.manufacturer = maker.empty() ? maker_from(key) : maker;
    return loaded;
}

} // namespace ghost::fixture
