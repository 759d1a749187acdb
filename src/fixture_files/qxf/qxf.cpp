// SPDX-License-Identifier: Apache-2.0
#include "fixture_files/qxf/qxf.h"

#include "base/text.h"
#include "disk/files.h"
#include "fixture/values.h"
#include "fixture_files/qxf/private/qxf_reader.h"
#include "json_xml_toml/xml_encoding.h"
#include "json_xml_toml/xml_entities.h"

#include <pugixml.hpp>

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 8u << 20; // the largest of QLC+'s own has 0.2 MB
constexpr std::size_t kMaxChannels = 4096;
constexpr std::size_t kMaxCapabilities = 256; // of a channel: it has no more values
constexpr std::size_t kMaxAliases = 64;       // of a capability
constexpr std::size_t kMaxModes = 512;
constexpr int kMaxModeChannels = 2048;
constexpr std::size_t kMaxAllChannels = 65536; // of all modes
constexpr std::size_t kMaxHeads = 1024;
constexpr std::size_t kMaxText = 512;

class Parser {
public:
    Parser(QxfReader& reader, Bytes xml) : reader_(reader), line_starts_{0} {
        for (std::size_t i = 0; i < xml.size(); ++i)
            if (xml[i] == '\n') line_starts_.push_back(i + 1);
    }

    std::size_t line(std::ptrdiff_t offset) const {
        const auto place = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        return static_cast<std::size_t>(std::upper_bound(line_starts_.begin(), line_starts_.end(), place) -
                                        line_starts_.begin());
    }

    void read(pugi::xml_node definition) {
        Type& type = reader_.loaded.type;
        type.manufacturer = text_of(definition.child("Manufacturer"));
        type.name = text_of(definition.child("Model"));
        type.short_name = type.name;
        reader_.fixture_kind = text_of(definition.child("Type"));
        type.description = reader_.fixture_kind;
        const pugi::xml_node creator = definition.child("Creator");
        type.data_version = text_of(creator.child("Version"));
        if (type.name.empty())
            reader_.say(Severity::warning, line_of(definition), "no Model: the fixture has no name");
        for (const pugi::xml_node node : definition.children("Channel")) {
            if (reader_.channels.size() == kMaxChannels) {
                reader_.say(Severity::error, line_of(node), "more than 4096 channels");
                break;
            }
            read_channel(node);
        }
        if (const pugi::xml_node node = definition.child("Physical")) reader_.physical = read_physical(node);
        type.properties.weight_kg = reader_.physical.weight_kg;
        type.properties.power_w = reader_.physical.lamp.power_w;
        for (const pugi::xml_node node : definition.children("Mode")) {
            if (reader_.modes.size() == kMaxModes) {
                reader_.say(Severity::error, line_of(node), "more than 512 modes");
                break;
            }
            read_mode(node);
        }
        if (reader_.modes.empty())
            reader_.say(Severity::error, line_of(definition), "the fixture has no Mode");
    }

private:
    std::size_t line_of(pugi::xml_node node) const { return line(node.offset_debug()); }

    static std::string shortened(std::string_view text) {
        return std::string(trimmed(text).substr(0, kMaxText));
    }
    static std::string text_of(pugi::xml_node node) { return shortened(node.text().as_string()); }
    static std::string text_of(pugi::xml_attribute attribute) { return shortened(attribute.as_string()); }

    // low where the attribute is missing or wrong; wrong is said.
    float number(pugi::xml_node node, const char* attribute, float low, float high) {
        const pugi::xml_attribute found = node.attribute(attribute);
        if (!found || *found.value() == '\0') return low;
        const std::optional<float> value = parse_float(found.value());
        if (value && *value >= low && *value <= high) return *value;
        reader_.say(Severity::warning, line_of(node),
                    std::string(attribute) + " is '" + text_of(found) + "', expected a number from " +
                        std::to_string(static_cast<int>(low)) + " to " +
                        std::to_string(static_cast<long>(high)) + ", taking it as not stated");
        return low;
    }

    void read_capability(pugi::xml_node node, QxfChannel& channel) {
        QxfCapability capability;
        capability.line = line_of(node);
        const std::optional<int> low = parse_int(node.attribute("Min").as_string());
        const std::optional<int> high = parse_int(node.attribute("Max").as_string());
        if (!low || !high || *low < 0 || *high > 255 || *low > *high) {
            reader_.say(Severity::error, capability.line,
                        "Min and Max of the capability are '" + text_of(node.attribute("Min")) + "' and '" +
                            text_of(node.attribute("Max")) +
                            "', expected 0 to 255 in ascending order; left out");
            return;
        }
        capability.low = static_cast<std::uint32_t>(*low);
        capability.high = static_cast<std::uint32_t>(*high);
        capability.name = text_of(node);
        capability.words = lower(capability.name);
        capability.preset = text_of(node.attribute("Preset"));
        // QLC+ before 4.12 wrote Res for pictures, Color and Color2 for colours.
        for (const char* name : {"Res1", "Res", "Color"})
            if (capability.resource.empty()) capability.resource = text_of(node.attribute(name));
        for (const char* name : {"Res2", "Color2"})
            if (capability.resource2.empty()) capability.resource2 = text_of(node.attribute(name));
        for (const pugi::xml_node alias : node.children("Alias")) {
            if (capability.aliases.size() == kMaxAliases) {
                reader_.say(Severity::error, capability.line, "more than 64 aliases in a capability");
                break;
            }
            capability.aliases.push_back({text_of(alias.attribute("Mode")),
                                          text_of(alias.attribute("Channel")),
                                          text_of(alias.attribute("With"))});
        }
        channel.capabilities.push_back(std::move(capability));
    }

    void read_channel(pugi::xml_node node) {
        QxfChannel channel;
        channel.line = line_of(node);
        channel.name = text_of(node.attribute("Name"));
        channel.words = lower(channel.name);
        channel.preset = text_of(node.attribute("Preset"));
        const pugi::xml_node group = node.child("Group");
        channel.group = text_of(group);
        channel.colour = text_of(node.child("Colour"));
        channel.fine = text_of(group.attribute("Byte")) == "1" || is_fine_preset(channel.preset);
        if (node.attribute("Default")) channel.initial = static_cast<int>(number(node, "Default", 0, 255));
        if (channel.name.empty()) reader_.say(Severity::warning, channel.line, "a channel has no Name");
        if (!channel.preset.empty() && channel.preset != "Custom" && !find_preset(channel.preset))
            reader_.say(Severity::warning, channel.line,
                        "Preset '" + channel.preset +
                            "' is none of QLC+ 4.12 to 4.14; its Group and names count");
        for (const pugi::xml_node child : node.children("Capability")) {
            if (channel.capabilities.size() == kMaxCapabilities) {
                reader_.say(Severity::error, channel.line, "more than 256 capabilities in a channel");
                break;
            }
            read_capability(child, channel);
        }
        std::stable_sort(channel.capabilities.begin(), channel.capabilities.end(),
                         [](const QxfCapability& a, const QxfCapability& b) { return a.low < b.low; });
        drop_overlaps(channel);
        if (!reader_.channel_names.emplace(channel.name, static_cast<int>(reader_.channels.size())).second)
            reader_.say(Severity::warning, channel.line,
                        "a second channel '" + channel.name + "', the first counts");
        reader_.channels.push_back(std::move(channel));
    }

    void drop_overlaps(QxfChannel& channel) {
        std::vector<QxfCapability> kept;
        for (QxfCapability& capability : channel.capabilities) {
            if (!kept.empty() && capability.low <= kept.back().high) {
                reader_.say(Severity::error, capability.line,
                            "the capability starts at " + std::to_string(capability.low) +
                                ", where the one before it goes on to " + std::to_string(kept.back().high) +
                                "; only what lies above is kept");
                if (capability.high <= kept.back().high) continue;
                capability.low = kept.back().high + 1;
            }
            kept.push_back(std::move(capability));
        }
        channel.capabilities = std::move(kept);
    }

    QxfPhysical read_physical(pugi::xml_node node) {
        QxfPhysical physical;
        const pugi::xml_node bulb = node.child("Bulb");
        physical.lamp.bulb = text_of(bulb.attribute("Type"));
        physical.lamp.lumens = number(bulb, "Lumens", 0, 1e7f);
        physical.lamp.color_temperature_k = number(bulb, "ColourTemperature", 0, 1e5f);
        const pugi::xml_node size = node.child("Dimensions");
        physical.size_m = glm::vec3(number(size, "Width", 0, 1e5f), number(size, "Depth", 0, 1e5f),
                                    number(size, "Height", 0, 1e5f)) /
                          1000.0f;
        physical.weight_kg = number(size, "Weight", 0, 1e5f);
        const pugi::xml_node lens = node.child("Lens");
        physical.lamp.lens = text_of(lens.attribute("Name"));
        physical.lamp.degrees_min = number(lens, "DegreesMin", 0, 360);
        physical.lamp.degrees_max = number(lens, "DegreesMax", 0, 360);
        const pugi::xml_node focus = node.child("Focus");
        physical.focus = text_of(focus.attribute("Type"));
        physical.pan_max_deg = number(focus, "PanMax", 0, 36000);
        physical.tilt_max_deg = number(focus, "TiltMax", 0, 36000);
        physical.lamp.power_w = number(node.child("Technical"), "PowerConsumption", 0, 1e6f);
        if (const pugi::xml_node layout = node.child("Layout")) {
            physical.layout = {static_cast<int>(number(layout, "Width", 0, 1024)),
                               static_cast<int>(number(layout, "Height", 0, 1024))};
            physical.layout = glm::max(physical.layout, glm::ivec2(1));
        }
        return physical;
    }

    void place_channel(pugi::xml_node node, QxfMode& mode) {
        const std::string wanted = text_of(node);
        const std::optional<int> number = node.attribute("Number")
                                              ? parse_int(node.attribute("Number").value())
                                              : std::optional<int>(static_cast<int>(mode.channels.size()));
        if (!number || *number < 0 || *number >= kMaxModeChannels) {
            reader_.say(Severity::error, line_of(node),
                        "Number is '" + text_of(node.attribute("Number")) +
                            "', expected 0 to 2047; left out");
            return;
        }
        QxfModeChannel placed;
        if (const auto found = reader_.channel_names.find(wanted); found != reader_.channel_names.end())
            placed.channel = found->second;
        else
            reader_.say(Severity::error, line_of(node),
                        "mode '" + mode.name + "' asks for a channel '" + wanted + "' that is not described");
        if (const pugi::xml_attribute acts_on = node.attribute("ActsOn"))
            placed.acts_on = parse_int(acts_on.value()).value_or(-1);
        if (mode.channels.size() <= static_cast<std::size_t>(*number))
            mode.channels.resize(static_cast<std::size_t>(*number) + 1);
        QxfModeChannel& place = mode.channels[static_cast<std::size_t>(*number)];
        if (place.channel >= 0) {
            reader_.say(Severity::error, line_of(node),
                        "mode '" + mode.name + "' has a second channel " + std::to_string(*number) +
                            ", the first counts");
            return;
        }
        place = placed;
    }

    void read_mode(pugi::xml_node node) {
        QxfMode mode;
        mode.line = line_of(node);
        mode.name = text_of(node.attribute("Name"));
        for (const pugi::xml_node child : node.children("Channel")) place_channel(child, mode);
        for (const pugi::xml_node child : node.children("Head")) {
            if (mode.heads.size() == kMaxHeads) {
                reader_.say(Severity::error, line_of(child), "more than 1024 heads in a mode");
                break;
            }
            QxfHead head;
            for (const pugi::xml_node channel : child.children("Channel")) {
                const std::optional<int> number = parse_int(channel.text().as_string());
                if (number && *number >= 0 && static_cast<std::size_t>(*number) < mode.channels.size()) {
                    if (head.numbers.size() < static_cast<std::size_t>(kMaxModeChannels))
                        head.numbers.push_back(*number);
                    continue;
                }
                reader_.say(Severity::warning, line_of(channel),
                            "a head has a channel '" + text_of(channel) + "' that the mode does not have");
            }
            mode.heads.push_back(std::move(head));
        }
        if (const pugi::xml_node physical = node.child("Physical")) mode.physical = read_physical(physical);
        all_channels_ += mode.channels.size();
        if (all_channels_ > kMaxAllChannels) {
            reader_.say(Severity::error, mode.line, "modes with more than 65536 channels in all");
            return;
        }
        reader_.modes.push_back(std::move(mode));
    }

    QxfReader& reader_;
    std::vector<std::size_t> line_starts_;
    std::size_t all_channels_ = 0;
};

// QLC+ keeps the pictures in a folder beside the one of the fixtures.
std::vector<std::filesystem::path> gobo_folders(const std::filesystem::path& folder) {
    if (folder.empty()) return {};
    return {folder, folder / "gobos", folder / ".." / "gobos", folder / ".." / ".." / "gobos"};
}

} // namespace

Result<LoadedType> load_qxf(Bytes bytes, const std::string& name, const std::filesystem::path& folder) {
    if (bytes.size() > kMaxFileBytes) return Error{"larger than 8 MB", name};
    std::vector<std::uint8_t> xml(bytes.begin(), bytes.end());
    const bool repaired = repair_utf8(xml);
    QxfReader reader{.name = name, .gobos = GoboFiles(gobo_folders(folder))};
    Parser parser(reader, xml);
    pugi::xml_document document;
    const pugi::xml_parse_result parsed =
        document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_doctype,
                             repaired ? pugi::encoding_utf8 : pugi::encoding_auto);
    if (!parsed)
        return Error{std::string("not well-formed XML: ") + parsed.description(),
                     name + ":" + std::to_string(parser.line(parsed.offset))};
    const pugi::xml_node definition = document.child("FixtureDefinition");
    if (!definition) return Error{"no element FixtureDefinition: this is no QLC+ fixture definition", name};
    if (repaired) reader.say(Severity::warning, 1, kNotUtf8);
    if (declares_entities(document)) reader.say(Severity::warning, 1, kEntitiesLeft);
    parser.read(definition);
    convert_modes(reader);
    reader.loaded.messages = std::move(reader.messages).take();
    return std::move(reader.loaded);
}

Result<LoadedType> load_qxf(const std::filesystem::path& path) {
    TRY(const std::vector<std::uint8_t> bytes, read_file(path, kMaxFileBytes));
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    return load_qxf(bytes, path.filename().string(), folder);
}

} // namespace ghost::fixture
