// SPDX-License-Identifier: Apache-2.0
// What a range of values does, wheels apart.
#include "base/text.h"
#include "fixture_files/ofl/private/ofl_sketcher.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ghost::fixture {

std::string OflSketcher::fog_attribute() const {
    return text_at(*capability_, "fogType") == "Haze" ? "Haze1" : "Fog1";
}

std::string OflSketcher::blade() const {
    const Json& value = member(*capability_, "blade");
    constexpr std::string_view kSides[] = {"Top", "Right", "Bottom", "Left"};
    for (int i = 0; i < 4; ++i)
        if (value == Json(std::string(kSides[i]))) return std::to_string(i + 1);
    const std::optional<float> number = number_in(value);
    return std::to_string(number ? static_cast<int>(std::clamp(*number, 1.0f, 4.0f)) : 1);
}

// Lumens are a share of the lamp's.
void OflSketcher::convert_brightness(const std::string& attribute, const char* key) {
    OflRange value = range(key, Quantity::share, kOne).value_or(OflRange{0, 1});
    const float most = std::max(std::abs(value.from), std::abs(value.to));
    if (most > 1.0f) {
        const float full = std::max(physical_.lamp.lumens, most);
        value = {value.from / full, value.to / full};
    }
    add(attribute, {std::clamp(value.from, 0.0f, 1.0f), std::clamp(value.to, 0.0f, 1.0f)});
}

void OflSketcher::convert_colour() {
    struct Name {
        std::string_view color;
        const char* attribute;
    };
    constexpr Name kNames[] = {
        {"Red", "ColorAdd_R"},         {"Green", "ColorAdd_G"},   {"Blue", "ColorAdd_B"},
        {"Cyan", "ColorSub_C"},        {"Magenta", "ColorSub_M"}, {"Yellow", "ColorSub_Y"},
        {"Amber", "ColorAdd_RY"},      {"White", "ColorAdd_W"},   {"Warm White", "ColorAdd_WW"},
        {"Cold White", "ColorAdd_CW"}, {"UV", "ColorAdd_UV"},     {"Lime", "ColorAdd_GY"},
        {"Indigo", "ColorAdd_BM"}};
    const std::string color = text_at(*capability_, "color");
    for (const Name& known : kNames)
        if (known.color == color) return convert_brightness(known.attribute);
    reader_.say(Severity::error, here_ + "/color",
                "'" + color.substr(0, 60) + "' is no colour of the schema");
    ignore();
}

void OflSketcher::convert_shutter() {
    const std::string effect = text_at(*capability_, "shutterEffect");
    // What a stagehand calls it: "Closed", not "Shutter1".
    const std::string name = comment().empty() ? effect : comment();
    if (effect == "Open" || effect == "Closed") {
        const float open = effect == "Open" ? 1.0f : 0.0f;
        add("Shutter1", {open, open}).name = name;
        return;
    }
    if (member(*capability_, "soundControlled") == Json(true)) return miss("sound controlled " + effect);
    std::string kind = member(*capability_, "randomTiming") == Json(true) ? "Random" : "";
    if (effect == "Pulse" || effect == "RampUpDown") kind += "Pulse";
    if (effect == "RampUp") kind += "PulseOpen";
    if (effect == "RampDown") kind += "PulseClose";
    const bool is_special = effect == "Lightning" || effect == "Spikes" || effect == "Burst";
    if (is_special) kind = "Effect";
    std::optional<OflRange> hertz = range("speed", Quantity::strobe, kStrobe);
    if (!hertz)
        if (const std::optional<OflRange> seconds = range("duration", Quantity::time, {0, 1}))
            hertz = OflRange{1.0f / std::max(seconds->from, 0.05f), 1.0f / std::max(seconds->to, 0.05f)};
    ChannelFunction* function = nullptr;
    if (!hertz && strobes_.rate) {
        function = &add("StrobeMode" + (kind.empty() ? "Strobe" : kind), {0, 1});
    } else {
        if (!hertz) hertz = OflRange{5, 5};
        function = &add("Shutter1Strobe" + kind,
                        {std::clamp(hertz->from, 0.0f, 100.0f), std::clamp(hertz->to, 0.0f, 100.0f)});
    }
    function->name = is_special && !comment().empty() ? effect + ", " + comment() : name;
}

// The rate of what another channel chooses, or else a strobe that this channel's shutter makes.
void OflSketcher::convert_strobe_speed() {
    const Json& list = member(channel_, "capabilities");
    const bool has_shutter =
        list.is_array() && std::any_of(list.begin(), list.end(), [](const Json& capability) {
            return text_at(capability, "type") == "ShutterStrobe";
        });
    add_graded("speed", has_shutter && !strobes_.kind ? "Shutter1Strobe" : "StrobeFrequency",
               Quantity::strobe, kStrobe, {kSlowStrobe_Hz, kFastStrobe_Hz});
}

// Angles count from any end; centre_axes moves them to the middle of the whole way.
void OflSketcher::convert_axis(const std::string& type) {
    const bool is_scanner = lower(physical_.focus) == "mirror";
    float max = type == "Pan" ? physical_.pan_max_deg : physical_.tilt_max_deg;
    if (max <= 0.0f && is_scanner) max = type == "Pan" ? 180.0f : 90.0f;
    if (max <= 0.0f) max = type == "Pan" ? 540.0f : 270.0f;
    add_graded("angle", type, Quantity::angle, {0, max}, {0, max});
}

void OflSketcher::centre_axes() {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    const auto is_axis = [](const ChannelFunction& function) {
        return function.meaning.role == Role::pan || function.meaning.role == Role::tilt;
    };
    for (const ChannelFunction& function : sketch_.functions) {
        if (!is_axis(function)) continue;
        low = std::min({low, function.physical_from, function.physical_to});
        high = std::max({high, function.physical_from, function.physical_to});
    }
    for (ChannelFunction& function : sketch_.functions) {
        if (!is_axis(function)) continue;
        function.physical_from -= 0.5f * (low + high);
        function.physical_to -= 0.5f * (low + high);
    }
}

void OflSketcher::convert_move() {
    if (const std::optional<OflRange> seconds = range("duration", Quantity::time, kSeconds)) {
        add("PositionTime", *seconds);
        return;
    }
    // 1 % of the speed takes longest.
    const OflRange speed = range("speed", Quantity::share, kOne).value_or(OflRange{1, 1});
    const auto seconds = [](float share) {
        return kSlowMove_s * (1.0f - std::clamp(std::abs(share), 0.0f, 1.0f));
    };
    add("PositionTime", {seconds(speed.from), seconds(speed.to)});
}

void OflSketcher::convert_turn(const std::string& index, const std::string& rotate, const EntityScale& scale,
                               float sign) {
    if (const std::optional<OflRange> speed = range("speed", Quantity::rotation, scale)) {
        add(rotate, {sign * speed->from, sign * speed->to});
        return;
    }
    add_graded("angle", index, Quantity::angle, kCircle, {0, 360});
}

} // namespace ghost::fixture
