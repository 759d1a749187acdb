// SPDX-License-Identifier: Apache-2.0
// PhysicalDescriptions: emitters and filters with what was measured, colour spaces, gamuts, DMX profiles,
// colour rendering, connectors, properties.
#include "fixture_files/gdtf/private/gdtf_reader.h"

#include "base/text.h"
#include "fixture/colour_spectrum.h"
#include "fixture/curves.h"
#include "fixture/power.h"
#include "fixture/values.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxNamed = 4096;         // of each kind
constexpr std::size_t kMaxMeasurements = 256;   // per emitter or filter
constexpr std::size_t kMaxSpectrum = 4096;      // points of one measurement
constexpr std::size_t kMaxProfilePoints = 4096; // per profile
constexpr std::size_t kMostPowerInputs = 256;

Measurement read_measurement(GdtfReader& reader, pugi::xml_node node) {
    Measurement measurement;
    measurement.physical_percent = reader.number(node, "Physical", 100.0f, 0.0f, 100.0f);
    measurement.luminous_intensity_cd = reader.number(node, "LuminousIntensity", 0.0f, 0.0f, 1e12f);
    measurement.transmission = reader.number(node, "Transmission", 0.0f, 0.0f, 1e6f);
    const std::string interpolation = reader.choice(node, "InterpolationTo", {"Linear", "Step", "Log"});
    if (interpolation == "Step") measurement.from_previous = Interpolation::step;
    if (interpolation == "Log") measurement.from_previous = Interpolation::log;
    bool sorted = true;
    for (const pugi::xml_node child : node.children("MeasurementPoint")) {
        if (reader.is_full(child, measurement.spectrum.size(), kMaxSpectrum, "points of a spectrum")) break;
        const glm::vec2 point(reader.number(child, "WaveLength", 0.0f, 0.0f, 1e5f),
                              reader.number(child, "Energy", 0.0f, 0.0f, 1e12f));
        sorted = sorted && (measurement.spectrum.empty() || measurement.spectrum.back().x < point.x);
        measurement.spectrum.push_back(point);
    }
    if (!sorted) {
        reader.say(Severity::warning, node, "the wavelengths of a spectrum do not rise, sorted");
        std::stable_sort(measurement.spectrum.begin(), measurement.spectrum.end(),
                         [](const glm::vec2& a, const glm::vec2& b) { return a.x < b.x; });
        const auto end = std::unique(measurement.spectrum.begin(), measurement.spectrum.end(),
                                     [](const glm::vec2& a, const glm::vec2& b) { return a.x == b.x; });
        measurement.spectrum.erase(end, measurement.spectrum.end());
    }
    return measurement;
}

std::vector<Measurement> read_measurements(GdtfReader& reader, pugi::xml_node node) {
    std::vector<Measurement> all;
    for (const pugi::xml_node child : node.children("Measurement")) {
        if (reader.is_full(child, all.size(), kMaxMeasurements, "measurements")) break;
        all.push_back(read_measurement(reader, child));
    }
    std::stable_sort(all.begin(), all.end(), [](const Measurement& a, const Measurement& b) {
        return a.physical_percent < b.physical_percent;
    });
    return all;
}

Emitter read_emitter(GdtfReader& reader, pugi::xml_node node) {
    Emitter emitter;
    emitter.name = reader.text(node, "Name");
    emitter.dominant_wavelength_nm = reader.number(node, "DominantWaveLength", 0.0f, 0.0f, 2000.0f);
    emitter.diode_part = reader.text(node, "DiodePart");
    emitter.measurements = read_measurements(reader, node);
    if (reader.attribute(node, "Color") || emitter.dominant_wavelength_nm == 0.0f)
        emitter.color = reader.color(node, "Color");
    else // what the standard allows for ultraviolet and other pure colours
        emitter.color = color_of_wavelength(emitter.dominant_wavelength_nm);
    if (!emitter.measurements.empty())
        emitter.spectral_color = color_of_spectrum(emitter.measurements.back().spectrum);
    return emitter;
}

ColorSpace read_color_space(GdtfReader& reader, pugi::xml_node node) {
    ColorSpace space;
    space.name = reader.text(node, "Name", "Default");
    if (space.name.empty()) space.name = "Default";
    space.mode = reader.choice(node, "Mode", {"sRGB", "ProPhoto", "ANSI", "Custom"});
    if (space.mode == "ProPhoto") {
        space.red = {0.7347f, 0.2653f};
        space.green = {0.1596f, 0.8404f};
        space.blue = {0.0366f, 0.0001f};
        space.white = {0.3457f, 0.3585f};
    } else if (space.mode == "ANSI") {
        space.red = {0.7347f, 0.2653f};
        space.green = {0.1596f, 0.8404f};
        space.blue = {0.0366f, 0.001f};
        space.white = {0.4254f, 0.4044f};
    } else if (space.mode == "Custom") {
        space.red = reader.color(node, "Red", space.red);
        space.green = reader.color(node, "Green", space.green);
        space.blue = reader.color(node, "Blue", space.blue);
        space.white = reader.color(node, "WhitePoint", space.white);
    }
    return space;
}

// "{x,y,Y}{x,y,Y}..." or "x,y,Y,x,y,Y,..."
Gamut read_gamut(GdtfReader& reader, pugi::xml_node node) {
    Gamut gamut;
    gamut.name = reader.text(node, "Name");
    std::string points = reader.text(node, "Points");
    std::replace(points.begin(), points.end(), '{', ',');
    std::replace(points.begin(), points.end(), '}', ',');
    std::vector<float> numbers;
    bool good = true;
    for (const std::string_view part : split(points, ',')) {
        if (trimmed(part).empty()) continue;
        const std::optional<float> number = parse_float(part);
        good = good && number;
        numbers.push_back(number.value_or(0.0f));
    }
    if (!good || numbers.size() % 3 != 0 || numbers.size() < 9) {
        reader.say(Severity::error, node,
                   "Points of the gamut '" + gamut.name + "' are not three or more 'x,y,Y'");
        return gamut;
    }
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        gamut.points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return gamut;
}

DmxProfile read_dmx_profile(GdtfReader& reader, pugi::xml_node node) {
    DmxProfile profile;
    profile.name = reader.text(node, "Name");
    for (const pugi::xml_node child : node.children("Point")) {
        if (reader.is_full(child, profile.points.size(), kMaxProfilePoints, "points of a DMX profile")) break;
        DmxProfile::Point point;
        point.dmx_percent = reader.number(child, "DMXPercentage", 0.0f, 0.0f, 100.0f);
        constexpr const char* kNames[] = {"CFC0", "CFC1", "CFC2", "CFC3"};
        for (std::size_t i = 0; i < 4; ++i)
            point.coefficients[i] = reader.number(child, kNames[i], 0.0f, -1e6f, 1e6f);
        profile.points.push_back(point);
    }
    if (profile.points.empty()) {
        reader.say(Severity::warning, node,
                   "the DMX profile '" + profile.name + "' has no Point, taken as linear");
        profile.points.push_back({0.0f, {0.0f, 100.0f, 0.0f, 0.0f}});
    }
    std::stable_sort(
        profile.points.begin(), profile.points.end(),
        [](const DmxProfile::Point& a, const DmxProfile::Point& b) { return a.dmx_percent < b.dmx_percent; });
    return profile;
}

CriGroup read_cri_group(GdtfReader& reader, pugi::xml_node node) {
    CriGroup group;
    group.color_temperature_k = reader.number(node, "ColorTemperature", 6000.0f, 0.0f, 1e5f);
    for (const pugi::xml_node child : node.children("CRI")) {
        if (reader.is_full(child, group.samples.size(), 99, "colour samples")) break;
        const std::string sample = reader.text(child, "CES", "CES01");
        const std::optional<int> number = sample.size() == 5 && lower(sample).starts_with("ces")
                                              ? parse_int(sample.substr(3))
                                              : std::nullopt;
        if (!number || *number < 1 || *number > 99) {
            reader.say(Severity::error, child, "CES is '" + sample + "', expected CES01 to CES99");
            continue;
        }
        group.samples.emplace_back(
            *number, static_cast<int>(reader.number(child, "ColorRenderingIndex", 100.0f, 0.0f, 255.0f)));
    }
    return group;
}

Connector read_connector(GdtfReader& reader, pugi::xml_node node) {
    return {.name = reader.text(node, "Name"),
            .type = reader.text(node, "Type"),
            .dmx_break = static_cast<int>(reader.number(node, "DMXBreak", 0.0f, 0.0f, 255.0f)),
            .gender = static_cast<int>(reader.number(node, "Gender", 0.0f, -1.0f, 1.0f)),
            .length_m = reader.number(node, "Length", 0.0f, 0.0f, 1000.0f)};
}

void read_properties(GdtfReader& reader, pugi::xml_node physical) {
    // Old files have them directly in PhysicalDescriptions.
    const pugi::xml_node node = physical.child("Properties") ? physical.child("Properties") : physical;
    const auto child = [&](const char* name) {
        return node.child(name) ? node.child(name) : physical.child(name);
    };
    Properties& properties = reader.type().properties;
    properties.weight_kg = reader.number(child("Weight"), "Value", 0.0f, 0.0f, 1e6f);
    properties.leg_height_m = reader.number(child("LegHeight"), "Value", 0.0f, 0.0f, 100.0f);
    properties.temperature_low_c =
        reader.number(child("OperatingTemperature"), "Low", 0.0f, -273.0f, 1000.0f);
    properties.temperature_high_c =
        reader.number(child("OperatingTemperature"), "High", 40.0f, -273.0f, 1000.0f);
    for (const pugi::xml_node power : node.children("PowerConsumption")) {
        if (reader.is_full(power, properties.power_inputs.size(), kMostPowerInputs, "power consumptions"))
            break;
        const std::string plug = reader.text(power, "Connector");
        const auto& connectors = reader.type().connectors;
        const auto connector = std::find_if(connectors.begin(), connectors.end(),
                                            [&](const Connector& one) { return one.name == plug; });
        add_power_input(properties.power_inputs,
                        {.plug = plug,
                         .connector = connector == connectors.end() ? "" : connector->type,
                         .power_w = reader.number(power, "Value", 0.0f, 0.0f, 1e6f),
                         .power_factor = reader.number(power, "PowerFactor", 0.0f, 0.0f, 1.0f),
                         .voltage_low_v = reader.number(power, "VoltageLow", 0.0f, 0.0f, 1e5f),
                         .voltage_high_v = reader.number(power, "VoltageHigh", 0.0f, 0.0f, 1e5f)});
    }
    properties.power_w = power_w_of(properties.power_inputs);
}

// Every child of a list, into a list of the Type; names, where wanted, are for links.
template <class Item, class Read>
void read_list(GdtfReader& reader, pugi::xml_node list, const char* element, std::vector<Item>& items,
               Names* names, const char* kind, Read read) {
    for (const pugi::xml_node node : list.children(element)) {
        if (reader.is_full(node, items.size(), kMaxNamed, kind)) return;
        if (names)
            reader.add_name(*names, node, kind, reader.text(node, "Name"), static_cast<int>(items.size()));
        items.push_back(read(reader, node));
    }
}

} // namespace

void read_physical(GdtfReader& reader, pugi::xml_node fixture_type) {
    const pugi::xml_node physical = fixture_type.child("PhysicalDescriptions");
    Type& type = reader.type();
    read_list(reader, physical.child("Emitters"), "Emitter", type.emitters, &reader.emitters, "emitter",
              read_emitter);
    read_list(
        reader, physical.child("Filters"), "Filter", type.filters, &reader.filters, "filter",
        [](GdtfReader& from, pugi::xml_node node) {
            return Filter{from.text(node, "Name"), from.color(node, "Color"), read_measurements(from, node)};
        });
    if (physical.child("ColorSpace"))
        type.color_space = read_color_space(reader, physical.child("ColorSpace"));
    reader.color_spaces.emplace(type.color_space.name, -1);
    read_list(reader, physical.child("AdditionalColorSpaces"), "ColorSpace", type.color_spaces,
              &reader.color_spaces, "colour space", read_color_space);
    read_list(reader, physical.child("Gamuts"), "Gamut", type.gamuts, &reader.gamuts, "gamut", read_gamut);
    read_list(reader, physical.child("DMXProfiles"), "DMXProfile", type.dmx_profiles, &reader.dmx_profiles,
              "DMX profile", read_dmx_profile);
    read_list(reader, physical.child("CRIs"), "CRIGroup", type.cri_groups, nullptr,
              "groups of colour samples", read_cri_group);
    read_list(reader, physical.child("Connectors"), "Connector", type.connectors, nullptr, "connectors",
              read_connector);
    read_properties(reader, physical);
}

} // namespace ghost::fixture
