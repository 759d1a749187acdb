// SPDX-License-Identifier: Apache-2.0
// What description.xml holds and nobody here reads: known things that neither a picture nor a motor needs, in
// one note; unknown elements and attributes, one note each.
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include "base/text.h"
#include "fixture/values.h"

#include <algorithm>
#include <unordered_map>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxUnknown = 20; // notes about things that the standard does not know
constexpr int kMaxElementDepth = 96;    // deeper elements are geometries, which say so themselves

struct Known {
    const char* element;
    const char* read;    // attributes, separated by spaces
    const char* ignored; // attributes that are not read, and said when they hold something
};

#define POSITION "Name Model Position"

// GDTF 1.2 and what 1.0 and 1.1 had. A '-' before an element: it and all under it are ignored.
constexpr Known kKnown[] = {
    {"GDTF", "DataVersion", ""},
    {"FixtureType",
     "Name ShortName LongName Manufacturer Description FixtureTypeID Thumbnail RefFT CanHaveChildren",
     "ThumbnailOffsetX ThumbnailOffsetY"},
    {"AttributeDefinitions", "", ""},
    {"ActivationGroups", "", ""},
    {"ActivationGroup", "Name", ""},
    {"FeatureGroups", "", ""},
    {"FeatureGroup", "Name Pretty",
     ""}, // Pretty and Revision: every file has them, and they say nothing of the fixture
    {"Feature", "Name", ""},
    {"Attributes", "", ""},
    {"Attribute", "Name Pretty ActivationGroup Feature MainAttribute PhysicalUnit Color", ""},
    {"SubPhysicalUnit", "Type PhysicalUnit PhysicalFrom PhysicalTo", ""},
    {"Wheels", "", ""},
    {"Wheel", "Name", ""},
    {"Slot", "Name Color Filter MediaFileName", ""},
    {"Facet", "Color Rotation", ""},
    {"AnimationSystem", "P1 P2 P3 Radius", ""},
    {"PhysicalDescriptions", "", ""},
    {"Emitters", "", ""},
    {"Emitter", "Name Color DominantWaveLength DiodePart", ""},
    {"Filters", "", ""},
    {"Filter", "Name Color", ""},
    {"Measurement", "Physical LuminousIntensity Transmission InterpolationTo", ""},
    {"MeasurementPoint", "WaveLength Energy", ""},
    {"ColorSpace", "Name Mode Red Green Blue WhitePoint", ""},
    {"AdditionalColorSpaces", "", ""},
    {"Gamuts", "", ""},
    {"Gamut", "Name Points", ""},
    {"DMXProfiles", "", ""},
    {"DMXProfile", "Name", ""},
    {"Point", "DMXPercentage CFC0 CFC1 CFC2 CFC3", ""},
    {"CRIs", "", ""},
    {"CRIGroup", "ColorTemperature", ""},
    {"CRI", "CES ColorRenderingIndex", ""},
    {"Connectors", "", ""},
    {"Connector", "Name Type DMXBreak Gender Length", ""},
    {"Properties", "", ""},
    {"OperatingTemperature", "Low High", ""},
    {"Weight", "Value", ""},
    {"LegHeight", "Value", ""},
    {"PowerConsumption", "Value PowerFactor Connector VoltageLow VoltageHigh", "FrequencyLow FrequencyHigh"},
    {"Models", "", ""},
    {"Model",
     "Name Length Width Height PrimitiveType File SVGOffsetX SVGOffsetY SVGSideOffsetX SVGSideOffsetY "
     "SVGFrontOffsetX SVGFrontOffsetY",
     ""},
    {"Geometries", "", ""},
    {"Geometry", POSITION, ""},
    {"Axis", POSITION, ""},
    {"FilterBeam", POSITION, ""},
    {"FilterColor", POSITION, ""},
    {"FilterGobo", POSITION, ""},
    {"FilterShaper", POSITION, ""},
    {"Beam",
     POSITION " LampType PowerConsumption LuminousFlux ColorTemperature BeamAngle FieldAngle ThrowRatio "
              "RectangleRatio BeamRadius BeamType ColorRenderingIndex EmitterSpectrum",
     ""},
    {"MediaServerLayer", POSITION, ""},
    {"MediaServerCamera", POSITION, ""},
    {"MediaServerMaster", POSITION, ""},
    {"Display", POSITION " Texture", ""},
    {"Laser",
     POSITION " ColorType Color OutputStrength Emitter BeamDiameter BeamDivergenceMin BeamDivergenceMax "
              "ScanAnglePan ScanAngleTilt ScanSpeed",
     ""},
    {"Protocol", "Name", ""},
    {"GeometryReference", POSITION " Geometry", ""},
    {"Break", "DMXOffset DMXBreak", ""},
    {"WiringObject",
     POSITION " ConnectorType ComponentType SignalType ElectricalPayLoad VoltageRangeMax VoltageRangeMin "
              "CosPhi",
     "PinCount FrequencyRangeMax FrequencyRangeMin MaxPayLoad Voltage SignalLayer FuseCurrent FuseRating "
     "Orientation WireGroup"},
    {"PinPatch", "", "ToWiringObject FromPin ToPin"},
    {"Inventory", POSITION, "Count Geometry"},
    {"Structure", POSITION,
     "LinkedGeometry StructureType CrossSectionType CrossSectionHeight CrossSectionWallThickness "
     "TrussCrossSection Geometry"},
    {"Support", POSITION,
     "SupportType RopeCrossSection RopeOffset CapacityX CapacityY CapacityZ CapacityXX CapacityYY CapacityZZ "
     "ResistanceX ResistanceY ResistanceZ ResistanceXX ResistanceYY ResistanceZZ Geometry"},
    {"Magnet", POSITION, ""},
    {"DMXModes", "", ""},
    {"DMXMode", "Name Geometry Description", ""},
    {"DMXChannels", "", ""},
    {"DMXChannel", "DMXBreak Offset InitialFunction Highlight Geometry Default", ""},
    {"LogicalChannel", "Attribute Snap Master MibFade DMXChangeTimeLimit", ""},
    {"ChannelFunction",
     "Name Attribute OriginalAttribute DMXFrom Default PhysicalFrom PhysicalTo RealFade RealAcceleration "
     "Wheel "
     "Emitter Filter ColorSpace Gamut Gammut ModeMaster ModeFrom ModeTo DMXProfile Min Max CustomName",
     ""},
    {"ChannelSet", "Name DMXFrom PhysicalFrom PhysicalTo WheelSlotIndex", ""},
    {"SubChannelSet", "Name PhysicalFrom PhysicalTo SubPhysicalUnit DMXProfile", ""},
    {"Relations", "", ""},
    {"Relation", "Name Master Follower Type", ""},
    {"FTMacros", "", ""},
    {"FTMacro", "Name", "ChannelFunction"},
    {"MacroDMX", "", ""},
    {"MacroDMXStep", "Duration", ""},
    {"MacroDMXValue", "Value DMXChannel", ""},
    {"-MacroVisual", "", ""},
    {"Revisions", "", ""},
    {"Revision", "Text Date UserID ModifiedBy", ""},
    {"FTPresets", "", ""},
    {"-FTPreset", "", ""},
    {"Protocols", "", ""},
    {"-FTRDM", "", ""},
    {"-Art-Net", "", ""},
    {"-sACN", "", ""},
    {"-PosiStageNet", "", ""},
    {"-OpenSoundControl", "", ""},
    {"-CITP", "", ""},
};

#undef POSITION

bool has_word(std::string_view words, std::string_view wanted) {
    for (const std::string_view word : split(words, ' '))
        if (word.size() == wanted.size() && lower(word) == lower(wanted)) return true;
    return false;
}

// Whether a value says more than an editor's default.
bool holds_something(std::string_view value) {
    if (trimmed(value).empty()) return false;
    const std::optional<float> number = parse_float(value);
    return !number || *number != 0.0f;
}

struct Finding {
    std::string what;
    std::size_t count = 0;
    pugi::xml_node first{};
};

class Census {
public:
    explicit Census(GdtfReader& reader) : reader_(reader) {
        for (const Known& known : kKnown) {
            const bool skip = known.element[0] == '-';
            known_.emplace(known.element + (skip ? 1 : 0), &known);
        }
    }

    // Depth first without recursion: the depth comes from the file.
    void walk(pugi::xml_node root) {
        pugi::xml_node node = root;
        int depth = 0;
        while (node) {
            const bool inside = node.type() == pugi::node_element && count(node) && depth < kMaxElementDepth;
            if (inside && node.first_child()) {
                node = node.first_child();
                ++depth;
                continue;
            }
            while (node != root && !node.next_sibling()) {
                node = node.parent();
                --depth;
            }
            if (node == root) return;
            node = node.next_sibling();
        }
    }

    void say() {
        std::string list;
        for (const Finding& finding : ignored_)
            list += (list.empty() ? "" : ", ") + std::to_string(finding.count) + " " + finding.what;
        if (!list.empty())
            reader_.say_at(Severity::note, reader_.name + ": description.xml",
                           "not used, as neither picture nor motion needs it: " + list);
        std::size_t said = 0;
        for (const Finding& finding : unknown_) {
            if (++said > kMaxUnknown) break;
            const std::string times =
                finding.count > 1 ? " (" + std::to_string(finding.count) + " times, here first)" : "";
            reader_.say(Severity::note, finding.first,
                        finding.what + " is not in the standard, left out" + times);
        }
        if (unknown_.size() > kMaxUnknown)
            reader_.say_at(Severity::note, reader_.name + ": description.xml",
                           std::to_string(unknown_.size() - kMaxUnknown) + " more unknown names");
    }

private:
    static void add(std::vector<Finding>& findings, const std::string& what, pugi::xml_node node) {
        for (Finding& finding : findings)
            if (finding.what == what) {
                ++finding.count;
                return;
            }
        if (findings.size() < 10 * kMaxUnknown) findings.push_back({what, 1, node});
    }

    // Whether to look at its children.
    bool count(pugi::xml_node node) {
        const auto found = known_.find(node.name());
        if (found == known_.end()) {
            add(unknown_, "the element <" + std::string(node.name()).substr(0, 60) + ">", node);
            return false;
        }
        const Known& known = *found->second;
        if (known.element[0] == '-') {
            add(ignored_, node.name(), node);
            return false;
        }
        for (const pugi::xml_attribute attribute : node.attributes()) {
            if (has_word(known.read, attribute.name())) continue;
            const std::string name =
                std::string(node.name()) + " " + std::string(attribute.name()).substr(0, 60);
            if (!has_word(known.ignored, attribute.name()))
                add(unknown_, "the attribute " + name, node);
            else if (holds_something(attribute.value()))
                add(ignored_, "values of " + std::string(node.name()), node);
        }
        return true;
    }

    GdtfReader& reader_;
    std::unordered_map<std::string_view, const Known*> known_;
    std::vector<Finding> ignored_;
    std::vector<Finding> unknown_;
};

} // namespace

void say_unused(GdtfReader& reader, pugi::xml_node root) {
    Census census(reader);
    census.walk(root);
    census.say();
}

} // namespace ghost::fixture
