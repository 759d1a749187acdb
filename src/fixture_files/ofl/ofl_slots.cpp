// SPDX-License-Identifier: Apache-2.0
// Capabilities that choose: slots of wheels, prisms, preset colours.
#include "fixture_files/ofl/private/ofl_sketcher.h"

#include <algorithm>
#include <cmath>

namespace ghost::fixture {
namespace {

std::size_t slot_at(float place, std::size_t count) {
    const long slot = std::lround(place) % static_cast<long>(count);
    return static_cast<std::size_t>(slot < 0 ? slot + static_cast<long>(count) : slot);
}

} // namespace

const OflWheel* OflSketcher::find_wheel() {
    const Json& value = member(*capability_, "wheel");
    std::string wanted = key_;
    if (value.is_string()) wanted = value.get_ref<const std::string&>();
    if (value.is_array() && !value.empty() && value[0].is_string()) {
        wanted = value[0].get_ref<const std::string&>();
        reader_.say(Severity::error, here_ + "/wheel", "a capability of several wheels turns the first");
    }
    const auto found = reader_.wheels.find(wanted);
    if (found != reader_.wheels.end()) return &found->second;
    // A colour wheel that only this channel's presets describe.
    if (const auto presets = reader_.preset_wheels.find(pointer_); presets != reader_.preset_wheels.end()) {
        virtual_wheel_ = {presets->second, "Color#", {}};
        return &virtual_wheel_;
    }
    reader_.say(Severity::error, here_, "the wheel '" + wanted.substr(0, 60) + "' is not described");
    return nullptr;
}

void OflSketcher::convert_wheels(const std::string& type) {
    const OflWheel* wheel = find_wheel();
    if (!wheel) return ignore();
    const std::string& prefix = wheel->prefix;
    if (prefix == "Gobo#") sketch_.gobo = true;
    const std::size_t before = sketch_.functions.size();
    if (type == "WheelSlot")
        convert_slot(*wheel);
    else if (!prefix.ends_with('#'))
        miss(type);
    else if (type == "WheelShake")
        convert_shake(*wheel);
    else if (type == "WheelSlotRotation")
        convert_slot_rotation(*wheel);
    else if (type == "WheelRotation" && prefix != "Prism#" && prefix != "AnimationWheel#")
        convert_turn(prefix + "WheelIndex", prefix + "WheelSpin", kWheelTurn, 1.0f);
    else if (type == "WheelRotation")
        convert_turn(prefix + "Pos", prefix + "PosRotate", kWheelTurn, -1.0f);
    else
        miss(type);
    for (std::size_t i = before; i < sketch_.functions.size(); ++i)
        if (prefix.ends_with('#') && sketch_.functions[i].attribute.starts_with(prefix))
            sketch_.functions[i].wheel = wheel->index;
}

// A slot's place from 0; halves lie between slots. Nothing where none is stated.
std::optional<OflRange> OflSketcher::slots_of(const OflWheel& wheel) {
    std::optional<OflRange> number = range("slotNumber", Quantity::plain, kOne);
    if (!number) return std::nullopt;
    const float count = static_cast<float>(wheel_at(wheel.index).slots.size());
    if (number->from < 0.0f || number->to < 0.0f || number->from > count + 1.0f || number->to > count + 1.0f)
        reader_.say(Severity::error, here_ + "/slotNumber",
                    "the wheel has slots 1 to " + std::to_string(static_cast<int>(count)));
    return OflRange{std::clamp(number->from - 1.0f, -0.5f, count),
                    std::clamp(number->to - 1.0f, -0.5f, count)};
}

ChannelFunction& OflSketcher::add_slot(const OflWheel& wheel, const std::string& attribute, float place,
                                       OflRange physical) {
    ChannelFunction& function = add(attribute, physical);
    const std::vector<Slot>& slots = wheel_at(wheel.index).slots;
    const std::size_t slot = slot_at(place, slots.size());
    function.sets.push_back({comment().empty() ? slots[slot].name : function.name, low_, high_, physical.from,
                             physical.to, static_cast<int>(slot)});
    return function;
}

// False where the slot is an ordinary one.
bool OflSketcher::add_stop(const OflWheel& wheel, float place) {
    if (wheel.stops.empty()) return false;
    const OflStop& stop = wheel.stops[slot_at(place, wheel.stops.size())];
    if (stop.attribute.empty()) return false;
    ChannelFunction& function = add(stop.attribute, {stop.value, stop.value});
    if (function.name == "Shutter1") function.name = "Closed";
    return true;
}

void OflSketcher::convert_slot(const OflWheel& wheel) {
    const std::optional<OflRange> slots = slots_of(wheel);
    if (!slots) return miss("WheelSlot without slotNumber");
    const bool whole = (slots->from == slots->to && slots->from == std::round(slots->from)) ||
                       !(wheel.prefix == "Color#" || wheel.prefix == "Gobo#");
    if (whole) {
        if (!add_stop(wheel, slots->from)) add_slot(wheel, wheel.prefix, slots->from, {0, 1});
        return;
    }
    const float step = 360.0f / static_cast<float>(wheel_at(wheel.index).slots.size());
    add(wheel.prefix + "WheelIndex", {step * slots->from, step * slots->to});
}

void OflSketcher::convert_shake(const OflWheel& wheel) {
    const OflRange hertz = range("shakeSpeed", Quantity::strobe, kShake).value_or(OflRange{2, 2});
    const std::optional<OflRange> slots = slots_of(wheel);
    const bool gobo = wheel.prefix == "Gobo#";
    if (slots && add_stop(wheel, slots->from))
        missed_.push_back("the shaking of " + wheel_at(wheel.index).name);
    else if (slots && gobo)
        add_slot(wheel, "Gobo#SelectShake", slots->from, hertz);
    else if (slots) {
        missed_.push_back("the shaking of " + wheel_at(wheel.index).name);
        add_slot(wheel, wheel.prefix, slots->from, {0, 1});
    } else if (gobo)
        add(text_at(*capability_, "isShaking") == "slot" ? "Gobo#PosShake" : "Gobo#WheelShake", hertz);
    else
        miss("WheelShake");
}

void OflSketcher::convert_slot_rotation(const OflWheel& wheel) {
    if (wheel.prefix == "Color#") return miss("WheelSlotRotation");
    const std::optional<OflRange> slots = slots_of(wheel);
    if (!slots) return convert_turn(wheel.prefix + "Pos", wheel.prefix + "PosRotate", kTurn, -1.0f);
    if (add_stop(wheel, slots->from))
        return missed_.push_back("the rotation of " + wheel_at(wheel.index).name);
    if (const std::optional<OflRange> speed = range("speed", Quantity::rotation, kTurn)) {
        add_slot(wheel, wheel.prefix + "SelectSpin", slots->from, {-speed->from, -speed->to});
        return;
    }
    missed_.push_back("the angle of a chosen slot");
    add_slot(wheel, wheel.prefix, slots->from, {0, 1});
}

void OflSketcher::convert_prism() {
    int& index = reader_.preset_wheels.try_emplace("prism", -1).first->second;
    if (index < 0) {
        Wheel wheel;
        wheel.name = "Prism";
        wheel.slots.resize(2);
        wheel.slots[0].name = "Open";
        wheel.slots[1].name = "3 facets";
        wheel.slots[1].facets = prism_facets(3);
        index = static_cast<int>(reader_.loaded.type.wheels.size());
        reader_.loaded.type.wheels.push_back(std::move(wheel));
        reader_.say(Severity::note, here_, "the prism's facets are not in the file: three are taken");
    }
    if (const std::optional<OflRange> speed = range("speed", Quantity::rotation, kTurn))
        add_slot({index, "Prism#", {}}, "Prism1SelectSpin", 1, {-speed->from, -speed->to}).wheel = index;
    else
        add_slot({index, "Prism#", {}}, "Prism1", 1, {0, 1}).wheel = index;
}

// Colours that a channel offers without a wheel: a virtual one.
void OflSketcher::convert_preset() {
    const Json* colors = &member(*capability_, "colors");
    if (!colors->is_array()) {
        colors = &member(*capability_, "colorsStart");
        if (colors->is_array())
            reader_.say(Severity::error, here_, "a blend from colour to colour shows its first colour only");
    }
    if (!colors->is_array() || colors->empty() || !(*colors)[0].is_string()) {
        if (const std::optional<OflRange> kelvin =
                range("colorTemperature", Quantity::temperature, {3200, 9000, lamp_k_})) {
            add("CTC", *kelvin);
            return;
        }
        if (const std::optional<ColorCie> named = color_from_name(comment()))
            return add_preset(comment(), *named);
        return miss("ColorPreset");
    }
    const std::string& hex = (*colors)[0].get_ref<const std::string&>();
    if (const std::optional<ColorCie> color = color_from_hex(hex)) {
        if (colors->size() > 1)
            reader_.say(Severity::note, here_, "a preset of several colours shows the first");
        return add_preset(comment().empty() ? hex : comment(), *color);
    }
    reader_.say(Severity::warning, here_ + "/colors",
                "'" + hex.substr(0, 40) + "' is no colour, expected #rrggbb");
    miss("ColorPreset");
}

void OflSketcher::add_preset(const std::string& name, const ColorCie& color) {
    sketch_.preset = true;
    int& index = reader_.preset_wheels.try_emplace(pointer_, -1).first->second;
    if (index < 0) {
        index = static_cast<int>(reader_.loaded.type.wheels.size());
        Wheel wheel;
        wheel.name = key_.substr(0, 256);
        wheel.slots.emplace_back(); // where no preset is chosen the light is the lamp's own
        wheel.slots[0].name = "Open";
        reader_.loaded.type.wheels.push_back(std::move(wheel));
    }
    std::vector<Slot>& slots = wheel_at(index).slots;
    std::size_t slot = 0;
    while (slot < slots.size() && !(slots[slot].color.x == color.x && slots[slot].color.y == color.y &&
                                    slots[slot].color.Y == color.Y))
        ++slot;
    if (slot == slots.size()) {
        slots.emplace_back();
        slots.back().name = name;
        slots.back().color = color;
    }
    ChannelFunction& function = add("Color#", {0, 1});
    function.wheel = index;
    function.sets.push_back({name, low_, high_, 0, 0, static_cast<int>(slot)});
}

} // namespace ghost::fixture
