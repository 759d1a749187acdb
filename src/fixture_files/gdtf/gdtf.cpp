// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/gdtf/gdtf.h"

#include "base/text.h"
#include "disk/files.h"
#include "fixture/slot_meanings.h"
#include "fixture/values.h"
#include "fixture_files/common/named_ranges.h"
#include "fixture_files/gdtf/private/gdtf_reader.h"
#include "json_xml_toml/xml_encoding.h"
#include "json_xml_toml/xml_entities.h"

#include <algorithm>
#include <cstdio>

namespace ghost::fixture {
namespace {

// What a hostile file can make us hold is the sum of these, the pictures (gdtf_parts.cpp) and the nodes
// (gdtf_geometry.cpp): docs/reference/gdtf.md states it. The largest real files are 3 MB with 1 MB of XML.
constexpr std::uintmax_t kMaxFileBytes = 128u << 20;
constexpr ArchiveLimits kLimits{.entries = 4096, .entry_bytes = 64u << 20, .total_bytes = 256u << 20};
constexpr std::size_t kMaxXmlBytes = 32u << 20;
constexpr std::size_t kMaxXmlItems = 4u << 20;        // elements, attributes and lines
constexpr std::size_t kMaxExpandedBytes = 128u << 20; // what references multiply
constexpr std::size_t kMaxText = 4096;                // bytes of one attribute that are kept

// The document in memory takes about 64 bytes per element and per attribute, so they are counted first.
bool has_too_many_items(Bytes xml) {
    std::size_t items = 0;
    for (const std::uint8_t byte : xml) items += byte == '<' || byte == '=' || byte == '\n';
    return items > kMaxXmlItems;
}

std::vector<std::uint32_t> find_line_starts(Bytes xml) {
    std::vector<std::uint32_t> starts{0};
    for (std::size_t i = 0; i < xml.size(); ++i)
        if (xml[i] == '\n') starts.push_back(static_cast<std::uint32_t>(i + 1));
    return starts;
}

std::size_t line_of(const std::vector<std::uint32_t>& starts, std::size_t offset) {
    return static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), offset) - starts.begin());
}

std::string short_text(const std::string& value) {
    return "'" + (value.size() > 60 ? value.substr(0, 57) + "..." : value) + "'";
}

// DataVersion: read alike, but a file of another time may hold what we do not know.
void check_version(GdtfReader& reader, pugi::xml_node root) {
    const std::string version = reader.text(root, "DataVersion");
    reader.type().data_version = version;
    if (version == "1.0" || version == "1.1" || version == "1.2") return;
    reader.say(Severity::note, root,
               version.empty()
                   ? std::string("no DataVersion, read as GDTF 1.2")
                   : "DataVersion is " + short_text(version) + ", expected 1.0, 1.1 or 1.2; read as 1.2");
}

void check_archive(GdtfReader& reader) {
    for (const std::string& entry : reader.archive.climbing())
        reader.say_at(Severity::error, reader.name,
                      "the entry " + short_text(entry) + " has a path that leaves the archive, left out");
    for (const std::string& entry : reader.archive.repeated())
        reader.say_at(Severity::warning, reader.name,
                      "a second entry " + short_text(entry) + " in the archive, the first counts");
}

} // namespace

std::string GdtfReader::place(pugi::xml_node node) const {
    const std::ptrdiff_t offset = node.offset_debug();
    std::string where = name + ": description.xml";
    if (offset >= 0) where += ":" + std::to_string(line_of(line_starts, static_cast<std::size_t>(offset)));
    return where;
}

void GdtfReader::say_at(Severity severity, const std::string& where, const std::string& what) {
    if (messages.takes(static_cast<int>(severity), what, loaded.messages.size()))
        loaded.messages.push_back({severity, where, what});
}

void GdtfReader::say(Severity severity, pugi::xml_node node, const std::string& what) {
    say_at(severity, place(node), what);
}

void GdtfReader::say_once(Severity severity, pugi::xml_node node, const std::string& what) {
    if (said_once.contains(what)) return;
    if (said_once.size() < kMaxMessages) said_once.insert(what);
    say(severity, node, what);
}

pugi::xml_attribute GdtfReader::attribute(pugi::xml_node node, const char* wanted) const {
    if (const pugi::xml_attribute found = node.attribute(wanted)) return found;
    const std::string_view name_wanted = wanted;
    for (const pugi::xml_attribute other : node.attributes())
        if (std::string_view(other.name()).size() == name_wanted.size() &&
            lower(other.name()) == lower(name_wanted))
            return other;
    return {};
}

std::string GdtfReader::text(pugi::xml_node node, const char* wanted, const char* fallback) {
    return std::string(trimmed(attribute(node, wanted).as_string(fallback)).substr(0, kMaxText));
}

float GdtfReader::number(pugi::xml_node node, const char* wanted, float fallback, float low, float high) {
    const pugi::xml_attribute found = attribute(node, wanted);
    if (!found) return fallback;
    const std::optional<float> value = parse_float(found.value());
    if (value && *value >= low && *value <= high) return *value;
    char range[80];
    std::snprintf(range, sizeof range, "expected a number from %g to %g, taking %g", static_cast<double>(low),
                  static_cast<double>(high), static_cast<double>(fallback));
    say(Severity::warning, node, std::string(wanted) + " is " + short_text(found.value()) + ", " + range);
    return fallback;
}

ColorCie GdtfReader::color(pugi::xml_node node, const char* wanted, ColorCie fallback) {
    const pugi::xml_attribute found = attribute(node, wanted);
    if (!found) return fallback;
    if (const std::optional<ColorCie> value = parse_color(found.value())) return *value;
    say(Severity::warning, node,
        std::string(wanted) + " is " + short_text(found.value()) + ", expected 'x,y,Y', taking white");
    return fallback;
}

std::string GdtfReader::choice(pugi::xml_node node, const char* wanted,
                               std::initializer_list<const char*> words) {
    const std::string value = text(node, wanted);
    if (value.empty()) return *words.begin();
    std::string list;
    for (const char* word : words) {
        if (lower(word) == lower(value)) return word;
        list += (list.empty() ? "" : ", ") + std::string(word);
    }
    say(Severity::warning, node,
        std::string(wanted) + " is " + short_text(value) + ", expected one of " + list + "; taking " +
            *words.begin());
    return *words.begin();
}

int find_name(const Names& index, const std::string& name) {
    if (const auto found = index.find(name); found != index.end()) return found->second;
    int best = -1;
    for (const auto& [other, number] : index)
        if (other.size() == name.size() && lower(other) == lower(name) && (best < 0 || number < best))
            best = number;
    return best;
}

int GdtfReader::link(pugi::xml_node node, const char* wanted, const Names& index) {
    const std::string name_wanted = text(node, wanted);
    if (name_wanted.empty()) return -1;
    const int found = find_name(index, name_wanted);
    if (found < 0)
        say(Severity::error, node,
            std::string(wanted) + " " + short_text(name_wanted) + " does not exist in this file");
    return found;
}

void GdtfReader::add_name(Names& index, pugi::xml_node node, const char* kind, const std::string& added,
                          int number) {
    if (!index.emplace(added, number).second)
        say(Severity::note, node,
            std::string("a second ") + kind + " named " + short_text(added) + ", links mean the first");
}

bool GdtfReader::is_full(pugi::xml_node node, std::size_t count, std::size_t limit, const char* what) {
    if (count < limit) return false;
    say(Severity::error, node, "more than " + std::to_string(limit) + " " + what + ", the rest is left out");
    return true;
}

bool GdtfReader::take_bytes(std::size_t bytes) {
    if (bytes > kMaxExpandedBytes - expanded_bytes) return false;
    expanded_bytes += bytes;
    return true;
}

Result<LoadedType> load_gdtf(Bytes bytes, const std::string& name) {
    TRY(Archive archive, Archive::open(bytes, name, kLimits));
    const std::string entry = archive.find("description.xml");
    if (entry.empty()) return Error{"no description.xml in the archive: this is no GDTF file", name};
    TRY(std::vector<std::uint8_t> xml, archive.read(entry, kMaxXmlBytes));
    const std::string xml_name = name + ": description.xml";
    const bool repaired = repair_utf8(xml);
    if (has_too_many_items(xml))
        return Error{"more than " + std::to_string(kMaxXmlItems) + " elements, attributes and lines",
                     xml_name};

    GdtfReader reader{.archive = archive, .name = name, .line_starts = find_line_starts(xml)};
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer_inplace(xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype,
                                     repaired ? pugi::encoding_utf8 : pugi::encoding_auto);
    if (!parsed)
        return Error{std::string("not well-formed XML: ") + parsed.description(),
                     xml_name + ":" +
                         std::to_string(
                             line_of(reader.line_starts,
                                     static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset))))};
    const pugi::xml_node fixture_type = document.child("GDTF").child("FixtureType");
    if (!fixture_type) return Error{"no element GDTF > FixtureType", xml_name};
    check_archive(reader);
    if (repaired) reader.say_at(Severity::warning, xml_name, kNotUtf8);
    if (declares_entities(document)) reader.say_at(Severity::warning, xml_name, kEntitiesLeft);

    Type& type = reader.type();
    type.name = reader.text(fixture_type, "Name");
    type.short_name = reader.text(fixture_type, "ShortName");
    type.manufacturer = reader.text(fixture_type, "Manufacturer");
    type.description = reader.text(fixture_type, "Description");
    type.fixture_type_id = reader.text(fixture_type, "FixtureTypeID");
    type.long_name = reader.text(fixture_type, "LongName");
    type.reference_type = reader.text(fixture_type, "RefFT");
    type.can_have_children = lower(reader.text(fixture_type, "CanHaveChildren", "Yes")) != "no";
    if (const std::string thumbnail = reader.text(fixture_type, "Thumbnail"); !thumbnail.empty())
        type.thumbnail = archive.find(thumbnail + ".png");
    check_version(reader, document.child("GDTF"));
    if (type.name.empty()) reader.say(Severity::warning, fixture_type, "the fixture type has no Name");
    read_attributes(reader, fixture_type);
    read_physical(reader, fixture_type);
    read_wheels(reader, fixture_type);
    read_models(reader, fixture_type);
    read_symbols(reader, fixture_type);
    read_geometries(reader, fixture_type);
    read_modes(reader, fixture_type);
    give_meaning_by_slots(type);
    for (const std::string& sentence : believe_names(type))
        reader.say_at(Severity::warning, xml_name, sentence);
    say_unused(reader, document.child("GDTF"));
    finish_messages(reader.messages, name, reader.loaded.messages);
    return std::move(reader.loaded);
}

Result<LoadedType> load_gdtf(const std::filesystem::path& path) {
    TRY(const std::vector<std::uint8_t> bytes, read_file(path, kMaxFileBytes));
    return load_gdtf(bytes, path.filename().string());
}

} // namespace ghost::fixture
