// SPDX-License-Identifier: Apache-2.0
// One channel of the library -> functions in the channel's own resolution.
#include "base/text.h"
#include "fixture/values.h"
#include "fixture_files/ofl/private/ofl_sketcher.h"
#include "fixture_files/ofl/private/ofl_words.h"

#include <algorithm>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxCapabilities = 1024;

// Types that no picture shows, and those whose effect the file does not describe.
constexpr std::string_view kInvisible[] = {"NoFunction",     "Maintenance",     "SoundSensitivity",
                                           "Time",           "Speed",           "EffectSpeed",
                                           "EffectDuration", "EffectParameter", "FogType"};
constexpr std::string_view kUndescribed[] = {"Effect", "IrisEffect", "FrostEffect", "Rotation",
                                             "BeamPosition"};

} // namespace

OflSketcher::OflSketcher(OflReader& reader, const OflChannel& channel, const OflPhysical& physical,
                         const OflStrobes& strobes)
    : reader_(reader), channel_(channel.json), key_(channel.key), pointer_(channel.pointer),
      physical_(physical), strobes_(strobes) {
    lamp_k_ = physical.lamp.color_temperature_k >= 1000.0f ? physical.lamp.color_temperature_k : 6000.0f;
    narrow_ = std::min(physical.lamp.degrees_min, physical.lamp.degrees_max);
    wide_ = std::max(physical.lamp.degrees_min, physical.lamp.degrees_max);
    if (!(wide_ > narrow_ && narrow_ > 0.0f)) {
        wide_ = wide_ > 0.0f ? wide_ : 40.0f;
        narrow_ = 0.2f * wide_;
    }
}

OflChannelSketch OflSketcher::run() {
    read_resolution();
    const Json& list = member(channel_, "capabilities");
    if (list.is_array()) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (i == kMaxCapabilities) {
                reader_.say(Severity::error, pointer_, "more than 1024 capabilities in a channel");
                break;
            }
            read(list[i], pointer_ + "/capabilities/" + std::to_string(i), false);
        }
    } else if (member(channel_, "capability").is_object()) {
        read(member(channel_, "capability"), pointer_ + "/capability", true);
    } else {
        reader_.say(Severity::error, pointer_, "the channel has neither capability nor capabilities");
    }
    centre_axes();
    fill_gaps();
    read_default();
    list_losses();
    return std::move(sketch_);
}

// The values of a channel count in the finest of its bytes unless it says otherwise.
void OflSketcher::read_resolution() {
    const Json& fine = member(channel_, "fineChannelAliases");
    const std::size_t aliases = fine.is_array() ? fine.size() : 0;
    sketch_.bytes = static_cast<int>(std::min<std::size_t>(aliases, 3)) + 1;
    const std::string stated = text_at(channel_, "dmxValueResolution");
    if (stated == "8bit") sketch_.bytes = 1;
    if (stated == "16bit") sketch_.bytes = 2;
    if (stated == "24bit") sketch_.bytes = 3;
    max_ = dmx_max(sketch_.bytes);
}

void OflSketcher::read(const Json& capability, const std::string& pointer, bool whole) {
    low_ = 0;
    high_ = max_;
    if (!whole) {
        const Json& range = member(capability, "dmxRange");
        const bool pair = range.is_array() && range.size() == 2;
        const float low = pair ? number_in(range[0]).value_or(-1.0f) : -1.0f;
        const float high = pair ? number_in(range[1]).value_or(-1.0f) : -1.0f;
        if (low < 0.0f || high < low || high > static_cast<float>(max_)) {
            reader_.say(Severity::error, pointer + "/dmxRange",
                        "expected two ascending values from 0 to " + std::to_string(max_) + "; left out");
            return;
        }
        low_ = static_cast<std::uint32_t>(range[0].get<double>());
        high_ = static_cast<std::uint32_t>(range[1].get<double>());
        if (!sketch_.functions.empty() && low_ <= last_high_) {
            reader_.say(Severity::error, pointer + "/dmxRange",
                        "starts inside of the capability before it; only what lies above is kept");
            if (high_ <= last_high_) return;
            low_ = last_high_ + 1;
        }
    }
    last_high_ = high_;
    capability_ = &capability;
    here_ = pointer;
    convert(text_at(capability, "type"));
}

ChannelFunction& OflSketcher::add(const std::string& attribute, OflRange physical) {
    ChannelFunction function = make_function(attribute, low_, high_, physical.from, physical.to);
    if (const std::string stated = comment(); !stated.empty()) function.name = stated;
    sketch_.functions.push_back(std::move(function));
    return sketch_.functions.back();
}

void OflSketcher::miss(const std::string& type) {
    ignore();
    for (const char* key : {"effectName", "effectPreset", "comment"})
        if (const std::string stated = text_at(*capability_, key); !stated.empty()) {
            missed_.push_back(stated);
            return;
        }
    missed_.push_back(type);
}

void OflSketcher::convert(const std::string& type) {
    if (std::find(std::begin(kInvisible), std::end(kInvisible), type) != std::end(kInvisible)) {
        if (type != "NoFunction") reader_.ignored.insert(type);
        return ignore();
    }
    if (type == "Generic") return convert_generic();
    if (std::find(std::begin(kUndescribed), std::end(kUndescribed), type) != std::end(kUndescribed))
        return miss(type);
    if (type == "ShutterStrobe") return convert_shutter();
    if (type == "StrobeSpeed") return convert_strobe_speed();
    if (type == "StrobeDuration")
        return add_graded("duration", "StrobeDuration", Quantity::time, {0, 0.5f}, {0, 0.5f});
    if (type == "Intensity") return convert_brightness("Dimmer");
    if (type == "ColorIntensity") return convert_colour();
    if (type == "ColorPreset") return convert_preset();
    if (type == "ColorTemperature")
        return add_graded("colorTemperature", "CTC", Quantity::temperature, {3200, 9000, lamp_k_},
                          {lamp_k_, lamp_k_});
    if (type == "Pan" || type == "Tilt") return convert_axis(type);
    if (type == "PanContinuous" || type == "TiltContinuous") {
        const OflRange turn =
            range("speed", Quantity::rotation, kAxisTurn).value_or(OflRange{0, kFastAxis_deg_s});
        add(type == "PanContinuous" ? "PanRotate" : "TiltRotate", {-turn.from, -turn.to});
        return;
    }
    if (type == "PanTiltSpeed") return convert_move();
    if (type.starts_with("Wheel")) return convert_wheels(type);
    if (type == "Focus") return add_graded("distance", "Focus1", Quantity::distance, kOne, {0, 1});
    if (type == "Zoom" || type == "BeamAngle")
        return add_graded("angle", "Zoom", Quantity::beam_angle, {narrow_, wide_}, {narrow_, wide_});
    if (type == "Iris") return add_graded("openPercent", "Iris", Quantity::share, kOne, {kSmallestIris, 1});
    if (type == "Frost") return add_graded("frostIntensity", "Frost1", Quantity::share, kOne, {0, 1});
    if (type == "Prism") return convert_prism();
    if (type == "PrismRotation") return convert_turn("Prism1Pos", "Prism1PosRotate", kTurn, -1.0f);
    if (type == "BladeInsertion")
        return add_graded("insertion", "Blade" + blade() + "A", Quantity::share, kOne, {0, 1});
    if (type == "BladeRotation")
        return add_graded("angle", "Blade" + blade() + "Rot", Quantity::angle, {0, 45}, {-45, 45});
    if (type == "BladeSystemRotation")
        return add_graded("angle", "ShaperRot", Quantity::angle, {0, 90}, {-45, 45});
    if (type == "Fog" || type == "FogOutput") return convert_brightness(fog_attribute(), "fogOutput");
    reader_.say(Severity::warning, here_ + "/type",
                "'" + type.substr(0, 60) + "' is no capability type of schema 12");
    miss(type);
}

// The schema has no type for hue and saturation: only the channel's name tells.
void OflSketcher::convert_generic() {
    if (low_ == 0 && high_ == max_ && ofl_has_label(key_, "hue")) {
        add("HSB_Hue", {0, 360});
        return;
    }
    if (low_ == 0 && high_ == max_ && ofl_has_label(key_, "saturation")) {
        add("HSB_Saturation", {0, 1});
        return;
    }
    ignore();
    for (const char* idle : {"unused", "reserved", "not used", "no function", "no effect"})
        if (lower(key_ + " " + comment()).find(idle) != std::string::npos) return;
    if (!reader_.quiet && (reader_.generic.empty() || reader_.generic.back() != key_))
        reader_.generic.push_back(key_);
}

void OflSketcher::fill_gaps() {
    std::vector<ChannelFunction> filled;
    std::uint32_t next = 0;
    bool full = false;
    for (ChannelFunction& function : sketch_.functions) {
        if (function.dmx_from > next)
            filled.push_back(make_function("NoFeature", next, function.dmx_from - 1, 0, 1));
        full = function.dmx_to == max_;
        next = function.dmx_to + 1;
        filled.push_back(std::move(function));
    }
    if (!full) filled.push_back(make_function("NoFeature", next, max_, 0, 1));
    sketch_.functions = std::move(filled);
}

void OflSketcher::read_default() {
    const Json& value = member(channel_, "defaultValue");
    const bool centred =
        std::any_of(sketch_.functions.begin(), sketch_.functions.end(), [](const ChannelFunction& function) {
            const Role role = function.meaning.role;
            return role == Role::pan || role == Role::tilt || role == Role::focus;
        });
    double start = centred ? 0.5 * (static_cast<double>(max_) + 1.0) : 0.0;
    if (value.is_number())
        start = static_cast<double>(number_in(value).value_or(0.0f));
    else if (value.is_string())
        start = static_cast<double>(entity(value, Quantity::share, kOne).value_or(0.0f)) * max_;
    sketch_.initial = static_cast<std::uint32_t>(std::clamp(start, 0.0, static_cast<double>(max_)));
}

void OflSketcher::list_losses() {
    if (missed_.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < missed_.size() && i < 3; ++i)
        list += (i ? ", '" : "'") + missed_[i].substr(0, 60) + "'";
    if (missed_.size() > 3) list += ", ...";
    reader_.say(Severity::error, pointer_,
                std::to_string(missed_.size()) + " of the channel's capabilities are not shown: " + list);
}

OflChannelSketch sketch_ofl_channel(OflReader& reader, const OflChannel& channel, const OflPhysical& physical,
                                    const OflStrobes& strobes) {
    const bool before = reader.quiet;
    reader.quiet = before || !reader.described.insert(channel.pointer).second;
    OflChannelSketch sketch = OflSketcher(reader, channel, physical, strobes).run();
    reader.quiet = before;
    return sketch;
}

} // namespace ghost::fixture
