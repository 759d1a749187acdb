// SPDX-License-Identifier: Apache-2.0
// Values with units and the words that stand for percentages (Open Fixture Library, capability-types.md).
#include "base/text.h"
#include "fixture/values.h"
#include "fixture_files/ofl/private/ofl_reader.h"

#include <algorithm>
#include <cmath>

namespace ghost::fixture {
namespace {

constexpr std::size_t kMaxText = 512;

struct Word {
    std::string_view word;
    float percent;
};

// "slow" is 1 %, "fast" 100 %, and so on; one table serves all entities, no word means two things.
constexpr Word kWords[] = {
    {"fast reverse", -100},
    {"slow reverse", -1},
    {"stop", 0},
    {"slow", 1},
    {"fast", 100},
    {"fast ccw", -100},
    {"slow ccw", -1},
    {"slow cw", 1},
    {"fast cw", 100},
    {"instant", 0},
    {"short", 1},
    {"long", 100},
    {"near", 1},
    {"far", 100},
    {"off", 0},
    {"dark", 1},
    {"bright", 100},
    {"warm", -100},
    {"cto", -100},
    {"default", 0},
    {"cold", 100},
    {"ctb", 100},
    {"weak", 1},
    {"strong", 100},
    {"closed", 0},
    {"narrow", 1},
    {"wide", 100},
    {"low", 1},
    {"high", 100},
    {"out", 0},
    {"in", 100},
    {"open", 100},
    {"small", 1},
    {"big", 100},
    {"left", -100},
    {"right", 100},
    {"top", -100},
    {"bottom", 100},
    {"center", 0},
};

float from_percent(float percent, Quantity quantity, const EntityScale& scale) {
    const float sign = percent < 0.0f ? -1.0f : 1.0f;
    const float size = std::min(std::abs(percent), 100.0f);
    switch (quantity) {
    case Quantity::strobe:
    case Quantity::rotation:
        if (size == 0.0f) return 0.0f;
        return sign *
               (scale.slow + (scale.fast - scale.slow) * std::clamp((size - 1.0f) / 99.0f, 0.0f, 1.0f));
    case Quantity::beam_angle:
        if (size == 0.0f) return 0.5f * scale.slow;
        return scale.slow + (scale.fast - scale.slow) * std::clamp((size - 1.0f) / 99.0f, 0.0f, 1.0f);
    case Quantity::angle:
        return sign * size / 100.0f * scale.fast;
    case Quantity::temperature:
        return percent < 0.0f ? scale.middle + (scale.slow - scale.middle) * size / 100.0f
                              : scale.middle + (scale.fast - scale.middle) * size / 100.0f;
    case Quantity::time:
        return size / 100.0f * scale.fast;
    case Quantity::distance:
        return std::clamp((size - 1.0f) / 99.0f, 0.0f, 1.0f);
    case Quantity::share:
        return sign * size / 100.0f;
    case Quantity::plain:
        return percent;
    }
    return percent;
}

} // namespace

const Json& member(const Json& object, std::string_view key) {
    static const Json none;
    if (!object.is_object()) return none;
    const auto found = object.find(std::string(key));
    return found == object.end() ? none : *found;
}

std::string text_at(const Json& object, std::string_view key) {
    const Json& value = member(object, key);
    return value.is_string() ? value.get_ref<const std::string&>().substr(0, kMaxText) : std::string();
}

std::optional<float> number_in(const Json& value) {
    if (!value.is_number()) return std::nullopt;
    const double number = value.get<double>();
    if (!(std::abs(number) <= 1e9)) return std::nullopt;
    return static_cast<float>(number);
}

std::string escaped(std::string_view key) {
    std::string text;
    for (const char c : key.substr(0, 80)) {
        if (c == '~')
            text += "~0";
        else if (c == '/')
            text += "~1";
        else
            text += c;
    }
    return text;
}

std::optional<float> entity(const Json& value, Quantity quantity, const EntityScale& scale) {
    if (const std::optional<float> number = number_in(value)) return number;
    if (!value.is_string()) return std::nullopt;
    const std::string text = lower(trimmed(value.get_ref<const std::string&>()));
    if (text.size() > 64) return std::nullopt;
    for (const Word& word : kWords)
        if (word.word == text) return from_percent(word.percent, quantity, scale);
    std::size_t end = 0;
    while (end < text.size() && (text[end] == '-' || text[end] == '+' || text[end] == '.' ||
                                 (text[end] >= '0' && text[end] <= '9')))
        ++end;
    const std::optional<float> number = parse_float(std::string_view(text).substr(0, end));
    if (!number || std::abs(*number) > 1e9f) return std::nullopt;
    const std::string_view unit = trimmed(std::string_view(text).substr(end));
    if (unit == "%") return from_percent(*number, quantity, scale);
    if (unit == "hz") return quantity == Quantity::rotation ? *number * 360.0f : *number;
    if (unit == "bpm") return quantity == Quantity::rotation ? *number * 6.0f : *number / 60.0f;
    if (unit == "rpm") return quantity == Quantity::rotation ? *number * 6.0f : *number / 60.0f;
    if (unit == "ms") return *number / 1000.0f;
    if (unit == "m" && quantity == Quantity::distance) // the inverse of focus_distance_m
        return std::clamp(std::log(std::max(*number, 0.1f) / 2.0f) / std::log(25.0f), 0.0f, 1.0f);
    constexpr std::string_view kPlain[] = {"", "s", "deg", "°", "k", "lm", "m", "m^3/min"};
    if (std::find(std::begin(kPlain), std::end(kPlain), unit) != std::end(kPlain)) return *number;
    return std::nullopt;
}

std::optional<OflRange> entity_range(OflReader& reader, const Json& capability, const std::string& pointer,
                                     const std::string& key, Quantity quantity, const EntityScale& scale) {
    const auto read = [&](const std::string& name) -> std::optional<float> {
        const Json& value = member(capability, name);
        if (value.is_null()) return std::nullopt;
        const std::optional<float> number = entity(value, quantity, scale);
        if (!number)
            reader.say(
                Severity::warning, pointer + "/" + name,
                "expected a number with a unit, or a word of its table (slow, fast, near, far, ...), not " +
                    value.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, 60));
        return number;
    };
    if (const std::optional<float> steady = read(key)) return OflRange{*steady, *steady};
    const std::optional<float> start = read(key + "Start");
    const std::optional<float> end = read(key + "End");
    if (!start && !end) return std::nullopt;
    return OflRange{start ? *start : *end, end ? *end : *start};
}

} // namespace ghost::fixture
