// SPDX-License-Identifier: Apache-2.0
// What names of channels and capabilities mean. Half of all definitions say it in words only.
#include "base/text.h"
#include "fixture_files/qxf/private/qxf_reader.h"

#include <algorithm>
#include <charconv>

namespace ghost::fixture {
namespace {

constexpr float kOff = 0.0f;

// QLCChannel::Preset of QLC+ 4.12 to 4.14. Physical values that depend on the fixture (pan, zoom, rates) are
// filled in by sketch_channel.
constexpr ChannelPreset kPresets[] = {
    {"IntensityMasterDimmer", Subject::dimmer, "Dimmer", 0, 1},
    {"IntensityDimmer", Subject::dimmer, "Dimmer", 0, 1},
    {"IntensityRed", Subject::fixed, "ColorAdd_R", 0, 1},
    {"IntensityGreen", Subject::fixed, "ColorAdd_G", 0, 1},
    {"IntensityBlue", Subject::fixed, "ColorAdd_B", 0, 1},
    {"IntensityCyan", Subject::fixed, "ColorSub_C", 0, 1},
    {"IntensityMagenta", Subject::fixed, "ColorSub_M", 0, 1},
    {"IntensityYellow", Subject::fixed, "ColorSub_Y", 0, 1},
    {"IntensityAmber", Subject::fixed, "ColorAdd_RY", 0, 1},
    {"IntensityWhite", Subject::fixed, "ColorAdd_W", 0, 1},
    {"IntensityUV", Subject::fixed, "ColorAdd_UV", 0, 1},
    {"IntensityIndigo", Subject::fixed, "ColorAdd_BM", 0, 1},
    {"IntensityLime", Subject::fixed, "ColorAdd_GY", 0, 1},
    {"IntensityHue", Subject::fixed, "HSB_Hue", 0, 360},
    {"IntensitySaturation", Subject::fixed, "HSB_Saturation", 0, 1},
    {"IntensityLightness", Subject::fixed, "HSB_Brightness", 0, 1},
    {"IntensityValue", Subject::fixed, "HSB_Brightness", 0, 1},
    {"PositionPan", Subject::fixed, "Pan", 0, 1},
    {"PositionTilt", Subject::fixed, "Tilt", 0, 1},
    {"PositionXAxis", Subject::fixed, "Pan", 0, 1},
    {"PositionYAxis", Subject::fixed, "Tilt", 0, 1},
    {"SpeedPanSlowFast", Subject::time, "PositionTime", kSlowMove_s, kOff},
    {"SpeedPanFastSlow", Subject::time, "PositionTime", kOff, kSlowMove_s},
    {"SpeedTiltSlowFast", Subject::time, "PositionTime", kSlowMove_s, kOff},
    {"SpeedTiltFastSlow", Subject::time, "PositionTime", kOff, kSlowMove_s},
    {"SpeedPanTiltSlowFast", Subject::time, "PositionTime", kSlowMove_s, kOff},
    {"SpeedPanTiltFastSlow", Subject::time, "PositionTime", kOff, kSlowMove_s},
    {"ColorMacro", Subject::colour, "Color#", 0, 1},
    {"ColorWheel", Subject::colour, "Color#", 0, 1},
    {"ColorRGBMixer", Subject::fixed, "HSB_Hue", 0, 360},
    {"ColorCTOMixer", Subject::temperature, "CTO", 0, 1},
    {"ColorCTCMixer", Subject::temperature, "CTC", 0, 1},
    {"ColorCTBMixer", Subject::temperature, "CTB", 0, 1},
    {"GoboWheel", Subject::gobo, "Gobo#", 0, 1},
    {"GoboIndex", Subject::gobo_turn, "Gobo#Pos", 0, 360},
    {"ShutterStrobeSlowFast", Subject::shutter, "Shutter1Strobe", kSlowStrobe_Hz, kFastStrobe_Hz},
    {"ShutterStrobeFastSlow", Subject::shutter, "Shutter1Strobe", kFastStrobe_Hz, kSlowStrobe_Hz},
    {"ShutterIrisMinToMax", Subject::iris, "Iris", kSmallestIris, 1},
    {"ShutterIrisMaxToMin", Subject::iris, "Iris", 1, kSmallestIris},
    {"ShutterIris", Subject::iris, "Iris", kSmallestIris, 1}, // of ShutterIrisFine
    {"BeamIris", Subject::iris, "Iris", kSmallestIris, 1},
    {"BeamFocusNearFar", Subject::focus, "Focus1", 0, 1},
    {"BeamFocusFarNear", Subject::focus, "Focus1", 1, 0},
    {"BeamFocus", Subject::focus, "Focus1", 0, 1}, // of BeamFocusFine
    {"BeamZoomSmallBig", Subject::zoom, "Zoom", 0, 1},
    {"BeamZoomBigSmall", Subject::zoom, "Zoom", 1, 0},
    {"BeamZoom", Subject::zoom, "Zoom", 0, 1}, // of BeamZoomFine
    {"PrismRotationSlowFast", Subject::prism_turn, "Prism#PosRotate", -kSlowTurn_deg_s, -kFastTurn_deg_s},
    {"PrismRotationFastSlow", Subject::prism_turn, "Prism#PosRotate", -kFastTurn_deg_s, -kSlowTurn_deg_s},
    {"NoFunction", Subject::nothing, "NoFeature", 0, 1},
};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

struct Number {
    float value = 0.0f;
    std::size_t begin = 0;
    std::size_t end = 0;
};

std::vector<Number> numbers_in(const std::string& text) {
    std::vector<Number> numbers;
    for (std::size_t i = 0; i < text.size();) {
        if (!is_digit(text[i])) {
            ++i;
            continue;
        }
        Number number;
        number.begin = i;
        while (i < text.size() &&
               (is_digit(text[i]) || (text[i] == '.' && i + 1 < text.size() && is_digit(text[i + 1]))))
            ++i;
        number.end = i;
        const auto [end, error] = std::from_chars(text.data() + number.begin, text.data() + i, number.value);
        if (error == std::errc{} && number.value < 1e7f) numbers.push_back(number);
    }
    return numbers;
}

} // namespace

bool has_word(std::string_view text, std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return text.find(word) != std::string_view::npos; });
}

bool falls(const std::string& words) {
    constexpr std::pair<const char*, const char*> kPairs[] = {
        {"fast", "slow"}, {"max", "min"},     {"wide", "narrow"}, {"big", "small"},
        {"far", "near"},  {"open", "clos"},   {"large", "small"}, {"high", "low"},
        {"full", "off"},  {"bright", "dark"}, {"hard", "soft"},   {"100", " 0%"}};
    for (const auto& [high, low] : kPairs) {
        const std::size_t first = words.find(high);
        const std::size_t second = words.find(low);
        if (first != std::string::npos && second != std::string::npos) return first < second;
    }
    if (has_word(words, {"decreas", "100%-0", "100-0", "100% - 0", "100% to 0", "100 - 0"})) return true;
    return false;
}

Range graded(const std::string& words, float slow, float fast) {
    if (falls(words)) return {fast, slow};
    const bool is_slow = has_word(words, {"slow"});
    const bool is_fast = has_word(words, {"fast"});
    if (is_slow && !is_fast) return {slow, slow};
    if (is_fast && !is_slow) return {fast, fast};
    return {slow, fast};
}

std::vector<float> numbers_before(const std::string& words, std::initializer_list<const char*> units) {
    constexpr std::size_t kGap = 8; // bytes between the numbers of a range: " - ", " to ", an arrow
    const std::vector<Number> numbers = numbers_in(words);
    std::vector<float> found;
    for (std::size_t i = 0; i < numbers.size() && found.size() < 2; ++i) {
        std::size_t after = numbers[i].end;
        while (after < words.size() && words[after] == ' ') ++after;
        const bool fits = std::any_of(units.begin(), units.end(), [&](const char* unit) {
            return std::string_view(words).substr(after).starts_with(unit);
        });
        if (!fits) continue;
        if (found.empty() && i > 0 && numbers[i].begin - numbers[i - 1].end <= kGap)
            found.push_back(numbers[i - 1].value);
        if (found.size() < 2) found.push_back(numbers[i].value);
    }
    return found;
}

int turning(const std::string& words) {
    if (has_word(words,
                 {"ccw", "counter", "anti", "reverse", "backward", "c.c.w", "left rot", "rotate left"}))
        return -1;
    if (has_word(words, {"cw", "clockwise", "forward", "right rot", "rotate right", "c.w"})) return 1;
    return 0;
}

bool stops(const std::string& words) {
    return has_word(words, {"stop", "no rotation", "no rotate", "no spin", "no scroll", "rotation off"});
}

std::optional<int> gobo_number(const std::string& words) {
    constexpr float kMost = 64.0f;
    const std::vector<Number> numbers = numbers_in(words);
    for (const Number& number : numbers) {
        if (number.value > kMost) continue;
        std::string_view before = std::string_view(words).substr(0, number.begin);
        const auto drop = [&](std::string_view end) {
            while (before.ends_with(' ')) before.remove_suffix(1);
            if (before.ends_with(end)) before.remove_suffix(end.size());
        };
        drop("shake");
        drop("shaking");
        drop("gobo");
        const bool is_named = words.compare(before.size(), 4, "gobo") == 0;
        if (is_named || (numbers.size() == 1 && trimmed(words).size() == number.end - number.begin))
            return static_cast<int>(number.value);
    }
    return std::nullopt;
}

std::optional<Range> bare_range(const std::string& words) {
    const std::vector<Number> numbers = numbers_in(words);
    if (numbers.size() != 2) return std::nullopt;
    const std::string_view between =
        trimmed(std::string_view(words).substr(numbers[0].end, numbers[1].begin - numbers[0].end));
    if (between != "-" && between != "to" && between != "..." && between != "->") return std::nullopt;
    return Range{numbers[0].value, numbers[1].value};
}

const ChannelPreset* find_preset(std::string_view name) {
    if (name.ends_with("Fine")) name.remove_suffix(4);
    for (const ChannelPreset& preset : kPresets)
        if (preset.name == name) return &preset;
    return nullptr;
}

bool is_fine_preset(std::string_view name) {
    return name.ends_with("Fine");
}

std::optional<Subject> subject_of_words(const QxfChannel& channel) {
    const std::string& words = channel.words;
    const bool turns = has_word(words, {"rotat", "index", "spin", "indexing"});
    const bool is_speed = has_word(words, {"speed", "time", "duration", "delay"});
    if (has_word(words, {"macro", "program", "auto", "sound", "chase", "sensitiv", "show mode"}) &&
        !has_word(words, {"color", "colour", "strobe", "gobo"}))
        return Subject::unknown;
    if (has_word(words, {"frost", "diffus"}) && channel.group != "Colour") return Subject::frost;
    if (has_word(words, {"prism"})) return turns ? Subject::prism_turn : Subject::prism;
    if (has_word(words, {"gobo"})) return turns ? Subject::gobo_turn : Subject::gobo;
    if (has_word(words, {"iris"})) return Subject::iris;
    if (has_word(words, {"zoom"}) && !is_speed && !has_word(words, {"reset"})) return Subject::zoom;
    if (has_word(words, {"focus"}) && !is_speed && !has_word(words, {"auto", "reset"})) return Subject::focus;
    if (has_word(words, {"strob", "shutter"}) && !has_word(words, {"duration", "blade", "framing"}))
        return Subject::shutter;
    if (has_word(words,
                 {"cto", "ctc", "ctb", "color temp", "colour temp", "color correct", "colour correct"}))
        return Subject::temperature;
    if (is_speed && has_word(words, {"pan", "tilt", "move", "p/t", "position", "motor", "mirror"}))
        return Subject::time;
    if (is_speed) return Subject::nothing;
    if (has_word(words, {"color", "colour"})) return Subject::colour;
    return std::nullopt;
}

} // namespace ghost::fixture
