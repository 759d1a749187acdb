// SPDX-License-Identifier: Apache-2.0
// Wheels and what their slots hold.
#include "base/text.h"
#include "fixture_files/ofl/private/ofl_reader.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxWheels = 64;
constexpr std::size_t kMaxSlots = 512;

// A slot of a wheel, as what a picture makes of it.
Slot read_slot(OflReader& reader, const Json& json, const std::string& pointer, const std::string& kind) {
    Slot slot;
    slot.name = text_at(json, "name");
    if (slot.name.empty()) slot.name = kind;
    if (kind == "Closed") slot.color.Y = 0.0f;
    if (kind == "Color") {
        const Json& colors = member(json, "colors");
        std::optional<ColorCie> color;
        if (colors.is_array() && !colors.empty() && colors[0].is_string())
            color = color_from_hex(colors[0].get_ref<const std::string&>());
        const float lamp_k = reader.physical.lamp.color_temperature_k >= 1000.0f
                                 ? reader.physical.lamp.color_temperature_k
                                 : 6000.0f;
        if (!color)
            if (const std::optional<float> kelvin = entity(member(json, "colorTemperature"),
                                                           Quantity::temperature, {3200.0f, 9000.0f, lamp_k}))
                color = color_from_temperature(*kelvin, lamp_k);
        if (!color) {
            color = color_from_name(slot.name);
            reader.say(Severity::warning, pointer,
                       std::string("the slot states no colour, ") +
                           (color ? "its name decides" : "it is taken as open"));
        }
        if (color) slot.color = *color;
        if (colors.is_array() && colors.size() > 1)
            reader.say(Severity::note, pointer, "a slot of several colours shows the first");
    }
    if (kind == "Gobo" || kind.starts_with("AnimationGobo")) {
        const Json& resource = member(json, "resource");
        if (resource.is_string() || resource.is_object()) {
            read_ofl_gobo(reader, resource, pointer, slot);
        } else if (kind == "Gobo" && lower(slot.name) != "open") {
            reader.say(Severity::error, pointer, "a gobo without a picture: the slot stays open");
        }
    }
    if (kind == "Prism") {
        const std::optional<float> facets = number_in(member(json, "facets"));
        slot.facets = prism_facets(facets ? static_cast<int>(std::clamp(*facets, 2.0f, 64.0f)) : 3);
    }
    return slot;
}

// On a wheel of apertures or frosts the open slot is one, too.
OflStop stop_of(const Json& slot, const std::string& kind, const std::string& prefix) {
    const auto share = [&](const char* key, float otherwise) {
        return entity(member(slot, key), Quantity::share, {}).value_or(otherwise);
    };
    if (kind == "Closed" && prefix != "Color#") return {"Shutter1", 0.0f};
    if (kind == "Iris" || prefix == "Iris") return {"Iris", share("openPercent", 1.0f)};
    if (kind == "Frost" || prefix == "Frost1")
        return {"Frost1", share("frostIntensity", kind == "Frost" ? 1.0f : 0.0f)};
    return {};
}

} // namespace

void read_ofl_wheels(OflReader& reader) {
    const Json& wheels = member(reader.document, "wheels");
    if (!wheels.is_object()) return;
    for (const auto& [key, json] : wheels.items()) {
        const std::string pointer = "/wheels/" + escaped(key);
        if (reader.wheels.size() == kMaxWheels) {
            reader.say(Severity::error, pointer, "more than 64 wheels");
            return;
        }
        const Json& slots = member(json, "slots");
        if (!slots.is_array() || slots.empty()) {
            reader.say(Severity::error, pointer, "the wheel has no slots");
            continue;
        }
        OflWheel made;
        std::map<std::string, int> kinds;
        Wheel wheel;
        wheel.name = key.substr(0, 256);
        for (const Json& slot : slots) {
            if (wheel.slots.size() == kMaxSlots) {
                reader.say(Severity::error, pointer, "more than 512 slots on a wheel");
                break;
            }
            const std::string kind = text_at(slot, "type");
            ++kinds[kind];
            wheel.slots.push_back(
                read_slot(reader, slot, pointer + "/slots/" + std::to_string(wheel.slots.size()), kind));
        }
        made.prefix = kinds.count("Gobo")                 ? "Gobo#"
                      : kinds.count("Color")              ? "Color#"
                      : kinds.count("Prism")              ? "Prism#"
                      : kinds.count("AnimationGoboStart") ? "AnimationWheel#"
                      : kinds.count("Iris")               ? "Iris"
                      : kinds.count("Frost")              ? "Frost1"
                                                          : "Gobo#";
        for (std::size_t i = 0; i < wheel.slots.size(); ++i)
            made.stops.push_back(stop_of(slots[i], text_at(slots[i], "type"), made.prefix));
        made.index = static_cast<int>(reader.loaded.type.wheels.size());
        reader.loaded.type.wheels.push_back(std::move(wheel));
        reader.wheels.emplace(key, made);
    }
}

} // namespace ghost::fixture
