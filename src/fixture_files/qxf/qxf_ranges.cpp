// SPDX-License-Identifier: Apache-2.0
// What one range of values of a channel does.
#include "fixture/values.h"
#include "fixture_files/qxf/private/qxf_sketcher.h"

#include <cmath>

namespace ghost::fixture {
namespace {

constexpr float kWarm_k = 3200.0f; // of a CTO at full
constexpr float kCold_k = 9000.0f; // of a CTB at full
constexpr float kLightFrost = 1.0f / 3.0f;
constexpr float kMediumFrost = 2.0f / 3.0f;

} // namespace

void QxfSketcher::convert_fixed(const QxfCapability& capability) {
    Range whole{preset_->from, preset_->to};
    if (preset_->attribute == "Pan" || preset_->attribute == "Tilt") {
        const bool pan = preset_->attribute == "Pan";
        float max = pan ? physical_.pan_max_deg : physical_.tilt_max_deg;
        if (max <= 0.0f) {
            max = physical_.focus == "Mirror" ? (pan ? 180.0f : 90.0f) : (pan ? 540.0f : 270.0f);
            reader_.say(Severity::warning, channel_.line,
                        std::string(pan ? "PanMax" : "TiltMax") + " is not in the file, taking " +
                            std::to_string(static_cast<int>(max)) + " degrees");
        }
        whole = {-0.5f * max, 0.5f * max};
    }
    // A colour channel that also strobes or plays programs says so in its ranges.
    if (!single() && preset_->attribute.starts_with("Color") &&
        has_word(capability.words, {"strob", "program", "auto", "sound", "macro", "chang"})) {
        miss(capability);
        return;
    }
    add(capability, std::string(preset_->attribute), part(capability, whole));
}

void QxfSketcher::convert_dimmer(const QxfCapability& capability) {
    const std::string& words = capability.words;
    if (single()) {
        add(capability, "Dimmer", falls(words) ? Range{1, 0} : part(capability, {0, 1}));
        return;
    }
    if (is_strobe(capability) || capability.preset.starts_with("Shutter")) {
        convert_shutter(capability);
        return;
    }
    if (const std::vector<float> share = numbers_before(words, {"%"}); !share.empty()) {
        add(capability, "Dimmer",
            {std::min(share.front() / 100.0f, 1.0f), std::min(share.back() / 100.0f, 1.0f)});
    } else if (has_word(words, {"program", "macro", "auto", "sound", "effect", "speed", "curve"})) {
        miss(capability);
    } else if (has_word(words, {"dimm", "intens", "light 0", "increas", "fade", "linear", "bright"}) &&
               capability.high - capability.low >= 20) {
        add(capability, "Dimmer", falls(words) ? Range{1, 0} : Range{0, 1});
    } else if (has_word(words, {"off", "blackout", "black out", "closed", "black-out", "no light"})) {
        add(capability, "Dimmer", {0, 0});
    } else if (has_word(words, {"open", "full", "lamp on", "light on"}) || words == "on" ||
               words.ends_with(" on")) {
        add(capability, "Dimmer", {1, 1});
    } else {
        add(capability, "Dimmer", part(capability, {0, 1}));
    }
}

bool QxfSketcher::is_strobe(const QxfCapability& capability) {
    return has_word(capability.preset, {"Strobe", "Pulse", "RampUp", "RampDown"}) ||
           (has_word(capability.words, {"strob", "flash", "pulse", "lightning"}) &&
            !has_word(capability.words, {"no strob", "strobe off", "without", "strobe: off"}));
}

void QxfSketcher::add_strobe(const QxfCapability& capability, const std::string& attribute) {
    std::vector<float> hertz = numbers_before(capability.words, {"hz"});
    for (const std::string& resource : {capability.resource, capability.resource2})
        if (const std::optional<float> value = parse_float(resource);
            value && *value >= 0.0f && *value <= 100.0f) {
            if (hertz.size() == 2) hertz.clear();
            hertz.push_back(*value);
        }
    Range range = graded(capability.words, kSlowStrobe_Hz, kFastStrobe_Hz);
    if (preset_ && preset_->attribute == "Shutter1Strobe" && !has_word(capability.words, {"slow", "fast"}))
        range = {preset_->from, preset_->to};
    if (capability.preset.ends_with("SlowToFast")) range = {kSlowStrobe_Hz, kFastStrobe_Hz};
    if (capability.preset.ends_with("FastToSlow")) range = {kFastStrobe_Hz, kSlowStrobe_Hz};
    if (!hertz.empty()) {
        range = {std::min(hertz.front(), 100.0f), std::min(hertz.back(), 100.0f)};
    } else {
        guessed_rate_ = true;
        if (capability.high - capability.low < 3) range.from = range.to = 0.5f * (range.from + range.to);
    }
    // A strobe channel is at rest at 0, also where the file draws its one range from 0.
    if (capability.low == 0 && capability.high > 200) {
        add(make_function("Shutter1", 0, 0, 1, 1));
        QxfCapability rest = capability;
        rest.low = 1;
        add(rest, attribute, range);
        return;
    }
    add(capability, attribute, range);
}

void QxfSketcher::convert_shutter(const QxfCapability& capability) {
    const std::string& words = capability.words;
    const std::string& preset = capability.preset;
    const bool strobe_channel = has_word(channel_.words, {"strob", "flash"}) || preset_;
    if (preset == "ShutterOpen") return add(capability, "Shutter1", {1, 1});
    if (preset == "ShutterClose") return add(capability, "Shutter1", {0, 0});
    if (preset.starts_with("StrobeRandom")) return add_strobe(capability, "Shutter1StrobeRandom");
    if (preset.starts_with("Strobe")) return add_strobe(capability, "Shutter1Strobe");
    if (preset.starts_with("Pulse")) return add_strobe(capability, "Shutter1StrobePulse");
    if (preset.starts_with("RampUp")) return add_strobe(capability, "Shutter1StrobePulseOpen");
    if (preset.starts_with("RampDown")) return add_strobe(capability, "Shutter1StrobePulseClose");
    if (has_word(words,
                 {"sound", "audio", "music", "program", "macro", "while moving", "by movement", "reset"}))
        return miss(capability);
    if (has_word(words, {"slow open", "opening", "open pulse", "pulse open"}) &&
        has_word(words, {"fast", "pulse"}))
        return add_strobe(capability, "Shutter1StrobePulseOpen");
    if (has_word(words, {"slow close", "closing", "fast open", "pulse clos"}) &&
        has_word(words, {"slow", "pulse"}))
        return add_strobe(capability, "Shutter1StrobePulseClose");
    if (has_word(words, {"random", "rnd"})) return add_strobe(capability, "Shutter1StrobeRandom");
    if (has_word(words, {"pulse", "pulsat"})) return add_strobe(capability, "Shutter1StrobePulse");
    if (is_strobe(capability) || has_word(words, {" hz"})) return add_strobe(capability, "Shutter1Strobe");
    if (has_word(words, {"open", "no function", "no strobe", "no effect", "strobe off", "without", "lamp on",
                         "full", "light on", "led on", "turn on", "linear", "constant", "shutter on"}))
        return add(capability, "Shutter1", {1, 1});
    if (has_word(words, {"clos", "black", "dark", "shutter off", "light off", "led off"}))
        return add(capability, "Shutter1", {0, 0});
    if (has_word(words, {"dimm", "intens", "%"})) return convert_dimmer(capability);
    const std::uint32_t width = capability.high - capability.low;
    if (strobe_channel && width >= 20) return add_strobe(capability, "Shutter1Strobe");
    if (strobe_channel && has_word(words, {"off", "nothing"})) return add(capability, "Shutter1", {1, 1});
    if (has_word(words, {"off"})) return add(capability, "Shutter1", {0, 0});
    if (strobe_channel && (capability.low == 0 || words == "on")) return add(capability, "Shutter1", {1, 1});
    miss(capability);
}

void QxfSketcher::convert_temperature(const QxfCapability& capability) {
    const bool cold = has_word(channel_.words, {"ctb"}) || (preset_ && preset_->attribute == "CTB");
    const bool both = has_word(channel_.words, {"ctc"}) || (preset_ && preset_->attribute == "CTC");
    const float lamp_k =
        physical_.lamp.color_temperature_k >= 1000.0f ? physical_.lamp.color_temperature_k : 6000.0f;
    const std::string attribute = both ? "CTC" : (cold ? "CTB" : "CTO");
    const std::string& words = capability.words;
    if (const std::vector<float> kelvin = numbers_before(words, {"k"});
        !kelvin.empty() && kelvin.front() >= 1000.0f && kelvin.back() >= 1000.0f)
        return add(capability, attribute, {kelvin.front(), kelvin.back()});
    if (capability.resource.starts_with('#')) return miss(capability);
    if (!single() &&
        has_word(words, {"open", "off", "no function", "no effect", "no cto", "no ctc", "default"}))
        return add(capability, attribute, {lamp_k, lamp_k});
    const float end_k = cold ? std::max(kCold_k, lamp_k) : std::min(kWarm_k, lamp_k);
    const Range range = both ? Range{kCold_k, kWarm_k} : Range{lamp_k, end_k};
    if (has_word(words, {"auto", "sound", "macro"})) return miss(capability);
    add(capability, attribute,
        falls(words) || has_word(words, {"warm to cold", "warm - cold", "warm -> cold"})
            ? Range{range.to, range.from}
            : range);
}

// sign: of clockwise.
void QxfSketcher::convert_turn(const QxfCapability& capability, const std::string& index,
                               const std::string& rotate, float sign, float slow, float fast) {
    const std::string& words = capability.words;
    const std::string& preset = capability.preset;
    if (preset == "RotationStop" || (preset.empty() && stops(words))) return add(capability, rotate, {0, 0});
    if (preset.starts_with("Rotation") && preset != "RotationIndexed") {
        const float direction = preset.starts_with("RotationCounterClockwise") ? -sign : sign;
        Range range = graded(words, slow, fast);
        if (preset.ends_with("SlowToFast")) range = {slow, fast};
        if (preset.ends_with("FastToSlow")) range = {fast, slow};
        if (preset.ends_with("Clockwise") && range.from == slow && range.to == fast)
            range = {std::sqrt(slow * fast), std::sqrt(slow * fast)};
        return add(capability, rotate, {direction * range.from, direction * range.to});
    }
    if (preset_ && preset_->attribute.ends_with("PosRotate") && single())
        return add(capability, rotate, {preset_->from, preset_->to});
    const int direction = turning(words);
    if (preset != "RotationIndexed" && direction != 0) {
        const Range range = graded(words, slow, fast);
        const float signed_by = direction > 0 ? sign : -sign;
        return add(capability, rotate, {signed_by * range.from, signed_by * range.to});
    }
    const std::vector<float> degrees = numbers_before(words, {"°", "deg"});
    const bool is_index = preset == "RotationIndexed" ||
                          has_word(words, {"index", "posit", "angle", "degree", "°"}) ||
                          (single() && (preset_ || has_word(channel_.words, {"index", "pos", "angle"})));
    if (is_index && !index.empty()) {
        Range range{0, 360};
        if (degrees.size() == 2) range = {degrees[0], degrees[1]};
        if (degrees.size() == 1)
            range = {capability.high - capability.low < 20 ? degrees[0] : 0.0f, degrees[0]};
        return add(capability, index, range);
    }
    if (has_word(words, {"no function", "no effect"})) return ignore(capability);
    if (has_word(words, {"off"})) return add(capability, rotate, {0, 0});
    const bool whole_way = capability.high - capability.low >= 20;
    if (whole_way && (single() || has_word(words, {"rotat", "speed", "slow", "fast"}))) {
        const Range range = graded(words, slow, fast);
        return add(capability, rotate, {sign * range.from, sign * range.to});
    }
    miss(capability);
}

void QxfSketcher::convert_graded(const QxfCapability& capability, const std::string& attribute, float low,
                                 float high) {
    const std::string& words = capability.words;
    if (has_word(words, {"pulse", "macro", "auto", "effect", "sound", "strob", "random"}) ||
        has_word(capability.preset, {"Pulse"})) {
        if (attribute == "Iris" && has_word(words, {"pulse"}))
            return add(capability, "IrisPulse", graded(words, 0.5f, 5.0f));
        return miss(capability);
    }
    Range whole{low, high};
    if (preset_) whole = {preset_->from, preset_->to};
    if (capability.preset == "BigToSmall" || capability.preset == "FarToNear") whole = {high, low};
    if (capability.preset == "SmallToBig" || capability.preset == "NearToFar") whole = {low, high};
    if (capability.preset.empty() && falls(words)) whole = {high, low};
    if (single()) return add(capability, attribute, whole);
    if (capability.high - capability.low < 20) {
        if (has_word(words, {"open", "max", "big", "far"})) return add(capability, attribute, {high, high});
        if (has_word(words, {"clos", "min", "small", "near"})) return add(capability, attribute, {low, low});
        if (numbers_before(words, {"m"}).size() == 1 || !has_word(words, {"no function"}))
            return add(capability, attribute, part(capability, whole));
        return ignore(capability);
    }
    if (has_word(words, {"no function"})) return ignore(capability);
    if (words == "open") return add(capability, attribute, {high, high});
    add(capability, attribute, whole);
}

void QxfSketcher::convert_zoom(const QxfCapability& capability) {
    float low = std::min(physical_.lamp.degrees_min, physical_.lamp.degrees_max);
    float high = std::max(physical_.lamp.degrees_min, physical_.lamp.degrees_max);
    if (!(high > low && low > 0.0f)) {
        low = high > 0.0f ? 0.3f * high : 8.0f;
        high = high > 0.0f ? high : 40.0f;
        reader_.say(Severity::warning, channel_.line,
                    "a zoom, but Lens has no range of degrees: taking " +
                        std::to_string(static_cast<int>(std::lround(low))) + " to " +
                        std::to_string(static_cast<int>(std::lround(high))));
    }
    const std::vector<float> degrees = numbers_before(capability.words, {"°", "deg"});
    if (!degrees.empty() && degrees.back() >= 1.0f && degrees.back() <= 180.0f)
        return add(capability, "Zoom", {degrees.front(), degrees.back()});
    const std::size_t before = sketch_.functions.size();
    const ChannelPreset* preset = preset_;
    preset_ = nullptr;
    QxfCapability plain = capability;
    if (preset) plain.preset = preset->from < preset->to ? "SmallToBig" : "BigToSmall";
    convert_graded(plain, "Zoom", low, high);
    preset_ = preset;
    if (sketch_.functions.size() > before && sketch_.functions.back().attribute == "Zoom") return;
}

void QxfSketcher::convert_frost(const QxfCapability& capability) {
    const std::string& words = capability.words;
    const auto share = [&](float from, float to) {
        add(capability, "Frost1", {std::min(from, 1.0f), std::min(to, 1.0f)});
    };
    if (has_word(words, {"pulse", "pulsing", "macro", "prism", "auto", "sound", "reset", "strob", "ramp",
                         "raming", "random", "tracking"}))
        return miss(capability);
    if (const std::vector<float> stated = numbers_before(words, {"%"}); !stated.empty())
        return share(stated.front() / 100.0f, stated.back() / 100.0f);
    // Without a unit: per cent, else values of DMX.
    if (const std::optional<Range> bare = bare_range(words)) {
        const float full = std::max(bare->from, bare->to) > 100.0f ? 255.0f : 100.0f;
        return share(bare->from / full, bare->to / full);
    }
    const Range graded_way = falls(words) ? Range{1, 0} : Range{0, 1};
    if (single()) return share(graded_way.from, graded_way.to);
    if (has_word(words, {"no ", "open", "off", "out", "disable", "without", "exclu", "clear"}) &&
        !has_word(words, {"->", " to "}))
        return share(0, 0);
    if (has_word(words, {"->", "→", " to ", "linear", "progress", "increas", "slow", "variable", "adjust",
                         "<", ">>"}))
        return share(graded_way.from, graded_way.to);
    if (has_word(words, {"light"})) return share(kLightFrost, kLightFrost);
    if (has_word(words, {"medium"})) return share(kMediumFrost, kMediumFrost);
    if (has_word(words, {"frost", "diffus", "enabled", "insert", "full", "heavy", "wash"}) || words == "on")
        return share(1, 1);
    miss(capability);
}

void QxfSketcher::convert_time(const QxfCapability& capability) {
    const std::string& words = capability.words;
    if (const std::vector<float> seconds = numbers_before(words, {"s", "sec"}); !seconds.empty())
        return add(capability, "PositionTime", {seconds.front(), seconds.back()});
    if (preset_) return add(capability, "PositionTime", part(capability, {preset_->from, preset_->to}));
    if (!single() && (has_word(words, {"tracking", "max", "no function", "standard", "blackout", "normal"}) ||
                      capability.high - capability.low < 3))
        return add(capability, "PositionTime", {0, 0});
    const bool rises = words.find("slow") < words.find("fast");
    add(capability, "PositionTime", rises ? Range{kSlowMove_s, 0} : Range{0, kSlowMove_s});
}

} // namespace ghost::fixture
