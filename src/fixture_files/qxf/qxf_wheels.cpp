// SPDX-License-Identifier: Apache-2.0
// Channels that choose: colours, gobos, prisms.
#include "base/text.h"
#include "fixture/values.h"
#include "fixture_files/qxf/private/qxf_sketcher.h"

#include <cmath>
#include <string_view>

namespace ghost::fixture {
namespace {

constexpr float kShakeSlow_Hz = 1.0f;
constexpr float kShakeFast_Hz = 5.0f;
constexpr std::size_t kMaxSlots = 512; // of a wheel

} // namespace

int QxfSketcher::slot_of(Wheel& wheel, const std::string& slot_name, const ColorCie& color,
                         const std::string& media) {
    for (std::size_t i = 0; i < wheel.slots.size(); ++i) {
        const Slot& slot = wheel.slots[i];
        const bool same_color = slot.color.x == color.x && slot.color.y == color.y && slot.color.Y == color.Y;
        if (sketch_.subject == Subject::colour
                ? same_color
                : (media.empty() ? slot.media_file.empty() && slot.name == slot_name
                                 : slot.media_file == media))
            return static_cast<int>(i);
    }
    if (wheel.slots.size() == kMaxSlots) return 0;
    Slot slot;
    slot.name = slot_name;
    slot.color = color;
    slot.media_file = media;
    if (!media.empty()) {
        const GoboFiles::Found found = reader_.gobos.find(reader_.loaded.type, media);
        slot.media = found.media;
        if (!found.problem.empty()) reader_.say(Severity::error, channel_.line, found.problem);
    }
    wheel.slots.push_back(std::move(slot));
    return static_cast<int>(wheel.slots.size()) - 1;
}

std::string QxfSketcher::slot_name(const QxfCapability& capability) {
    std::string text = capability.words;
    for (const char* word : {" shaking", " shake", " slow to fast", " fast to slow", " speed"})
        if (const std::size_t at = text.find(word); at != std::string::npos)
            return capability.name.substr(0, at);
    return capability.name;
}

SlotRequest QxfSketcher::request_colour(Wheel& wheel, const QxfCapability& capability) {
    const std::optional<ColorCie> first = color_from_hex(capability.resource);
    const std::optional<ColorCie> second = color_from_hex(capability.resource2);
    if (first) {
        SlotRequest request{slot_of(wheel, capability.name, *first, "")};
        if (second) request.second = slot_of(wheel, capability.name, *second, "");
        return request;
    }
    if (has_word(capability.words, {"auto", "sound", "program", "macro", "random", "chang", "fade", "jump",
                                    "chase", "effect", "speed", "strob", "index"}))
        return {};
    for (const char* separator : {"/", "+", " & ", " - ", " and "}) {
        const std::size_t at = capability.words.find(separator);
        if (at == std::string::npos) continue;
        const std::optional<ColorCie> left = color_from_name(capability.words.substr(0, at));
        const std::optional<ColorCie> right = color_from_name(capability.words.substr(at));
        if (left && right) {
            guessed_colour_ = true;
            return {slot_of(wheel, capability.name, *left, ""), slot_of(wheel, capability.name, *right, "")};
        }
    }
    if (const std::optional<ColorCie> named = color_from_name(capability.words)) {
        if (!has_word(capability.words, {"open", "white"})) guessed_colour_ = true;
        return {slot_of(wheel, capability.name, *named, "")};
    }
    return {};
}

SlotRequest QxfSketcher::request_gobo(Wheel& wheel, const QxfCapability& capability) {
    const bool shows = capability.preset == "GoboMacro" || capability.preset == "GoboShakeMacro";
    const std::string& words = capability.words;
    if (!shows &&
        has_word(words,
                 {"auto", "sound", "program", "macro", "random", "blackout", "effect", "no function"}) &&
        !has_word(words, {"open"}))
        return {};
    // Some definitions have a white colour where the picture belongs.
    const std::string picture = capability.resource.starts_with('#') ? "" : capability.resource;
    const bool open = picture.find("open.") != std::string::npos ||
                      (picture.empty() && (has_word(words, {"open", "no gobo", "white"}) || words == "hole" ||
                                           words == "clear"));
    if (open) return {slot_of(wheel, "Open", {}, "")};
    // "Rot. Gobo 3" and "Gobo 3 shake" are the third gobo, too.
    if (const std::optional<int> number = gobo_number(words); picture.empty() && number)
        for (std::size_t i = 0; i < wheel.slots.size(); ++i)
            if (wheel.slots[i].media_file.empty() && gobo_number(lower(wheel.slots[i].name)) == number)
                return {static_cast<int>(i)};
    return {slot_of(wheel, slot_name(capability), {}, picture)};
}

SlotRequest QxfSketcher::request_prism(Wheel& wheel, const QxfCapability& capability) {
    const std::string& words = capability.words;
    const bool on = capability.preset == "PrismEffectOn";
    if (wheel.slots.empty()) slot_of(wheel, "Open", {}, "");
    if (!on && (capability.preset == "PrismEffectOff" ||
                has_word(words, {"no prism", "open", "off", "out", "no function", "no effect", "without"})))
        return {0};
    if (!on && (has_word(words, {"macro", "auto", "frost", "sound"}) ||
                !(has_word(words, {"prism", "facet", "insert", "swing in", "effect on"}) || words == "on" ||
                  has_word(words, {"position", "index", "angle"}) || turning(words) != 0 ||
                  has_word(words, {"rotat"}))))
        return {};
    int facets = 3;
    if (const std::optional<int> stated = parse_int(capability.resource)) facets = *stated;
    if (const std::vector<float> counted = numbers_before(words, {"facet", "-facet", "x ", "-fold"});
        !counted.empty())
        facets = static_cast<int>(std::min(counted.back(), 64.0f));
    facets = std::clamp(facets, 2, 64);
    const std::string name = std::to_string(facets) + " facets";
    const int slot = slot_of(wheel, name, {}, "");
    if (slot > 0 && wheel.slots[static_cast<std::size_t>(slot)].facets.empty())
        wheel.slots[static_cast<std::size_t>(slot)].facets = prism_facets(facets);
    return {slot};
}

bool QxfSketcher::wheel_turns(const QxfCapability& capability) const {
    if (capability.preset.starts_with("Rotation")) return true;
    // The picture of a rainbow stands for a wheel that turns.
    if (sketch_.subject == Subject::colour && has_word(capability.resource, {"rainbow"})) return true;
    if (sketch_.subject == Subject::gobo) {
        if (capability.preset == "FastToSlow" || capability.preset == "SlowToFast") return true;
        if (gobo_number(capability.words) && !has_word(capability.words, {"scroll", "rainbow"})) return false;
    }
    if (!capability.preset.empty()) return false;
    if (capability.resource.starts_with('#')) return false;
    return stops(capability.words) || turning(capability.words) != 0 ||
           has_word(capability.words,
                    {"scroll", "spin", "rainbow", "wheel rot", "rotation", "wheel slow", "wheel fast"});
}

// Two colours side by side: slots that are neighbours, else two more at the end.
float QxfSketcher::between(Wheel& wheel, SlotRequest request) {
    const int count = static_cast<int>(wheel.slots.size());
    const int low = std::min(request.first, request.second);
    const int high = std::max(request.first, request.second);
    if (high - low == 1) return static_cast<float>(low) + 0.5f;
    for (int i = 0; i + 1 < count; ++i) { // a pair that was added for another channel value
        const auto same = [&](int a, int b) {
            const ColorCie& x = wheel.slots[static_cast<std::size_t>(a)].color;
            const ColorCie& y = wheel.slots[static_cast<std::size_t>(b)].color;
            return x.x == y.x && x.y == y.y && x.Y == y.Y;
        };
        if ((same(i, request.first) && same(i + 1, request.second)) ||
            (same(i, request.second) && same(i + 1, request.first)))
            return static_cast<float>(i) + 0.5f;
    }
    if (wheel.slots.size() + 2 > kMaxSlots) return static_cast<float>(low);
    wheel.slots.push_back(wheel.slots[static_cast<std::size_t>(request.first)]);
    wheel.slots.push_back(wheel.slots[static_cast<std::size_t>(request.second)]);
    return static_cast<float>(count) + 0.5f;
}

// A wheel that stops the light. "Blackout while moving" and the like say more words.
bool QxfSketcher::shuts(const QxfCapability& capability) {
    const std::string_view words = trimmed(capability.words);
    return words == "blackout" || words == "black out" || words == "closed" || words == "close";
}

void QxfSketcher::make_wheel() {
    const std::string attribute = sketch_.subject == Subject::colour
                                      ? "Color#"
                                      : (sketch_.subject == Subject::gobo ? "Gobo#" : "Prism#");
    Type& type = reader_.loaded.type;
    int index = -1;
    Wheel wheel;
    const auto known = reader_.wheels.find(index_);
    if (known != reader_.wheels.end()) {
        index = known->second;
        if (index >= 0) wheel = type.wheels[static_cast<std::size_t>(index)];
    }
    wheel.name = channel_.name;
    std::vector<SlotRequest> requests;
    std::vector<float> halves;
    const std::vector<QxfCapability> ranges = capabilities();
    for (const QxfCapability& capability : ranges) {
        SlotRequest request;
        const bool turns = sketch_.subject != Subject::prism && wheel_turns(capability);
        if (!turns && (capability.preset.empty() || capability.preset.find("Macro") != std::string::npos ||
                       capability.preset.starts_with("Prism") || sketch_.subject == Subject::prism)) {
            if (sketch_.subject == Subject::colour) request = request_colour(wheel, capability);
            if (sketch_.subject == Subject::gobo) request = request_gobo(wheel, capability);
            if (sketch_.subject == Subject::prism) request = request_prism(wheel, capability);
        }
        requests.push_back(request);
    }
    for (const SlotRequest& request : requests)
        halves.push_back(request.second >= 0 && request.second != request.first ? between(wheel, request)
                                                                                : -1.0f);
    sketch_.slots =
        std::any_of(requests.begin(), requests.end(), [](SlotRequest request) { return request.first >= 0; });
    if (known == reader_.wheels.end()) {
        if (!wheel.slots.empty()) {
            index = static_cast<int>(type.wheels.size());
            type.wheels.push_back(wheel);
        }
        reader_.wheels[index_] = index;
    }
    const float count = static_cast<float>(std::max<std::size_t>(wheel.slots.size(), 1));
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const QxfCapability& capability = ranges[i];
        const bool turns = wheel_turns(capability);
        if (!turns && is_service(capability)) continue;
        if (halves[i] >= 0.0f) {
            const float degrees = 360.0f * halves[i] / count;
            add(capability, "Color#WheelIndex", {degrees, degrees});
        } else if (requests[i].first >= 0) {
            add_slot(capability, attribute, requests[i].first);
        } else if (sketch_.subject != Subject::prism && wheel_turns(capability)) {
            convert_turn(capability, "", attribute + "WheelSpin", 1.0f, kSlowWheel_deg_s, kFastWheel_deg_s);
        } else {
            sketch_.plain.emplace_back(capability.low, capability.high);
            if (has_word(capability.preset, {"Strobe", "Shutter", "Pulse"}))
                convert_shutter(capability);
            else if (shuts(capability))
                add(capability, "Shutter1", {0, 0});
            else if (has_word(capability.words,
                              {"no function", "off", "open", "no effect", "no color", "no colour"}))
                ignore(capability);
            else
                miss(capability);
        }
    }
    for (ChannelFunction& function : sketch_.functions)
        if (function.attribute.starts_with("Color#") || function.attribute.starts_with("Gobo#") ||
            function.attribute.starts_with("Prism#"))
            function.wheel = index;
}

void QxfSketcher::add_slot(const QxfCapability& capability, const std::string& attribute, int slot) {
    const ChannelSet set{capability.name, capability.low, capability.high, 0, 0, slot};
    const bool shakes = sketch_.subject == Subject::gobo &&
                        (capability.preset == "GoboShakeMacro" || has_word(capability.words, {"shak"}));
    const bool spins = sketch_.subject == Subject::prism && capability.preset != "PrismEffectOn" &&
                       slot > 0 && (turning(capability.words) != 0 || has_word(capability.words, {"rotat"}));
    if (shakes || spins) {
        Range range = graded(capability.words, kShakeSlow_Hz, kShakeFast_Hz);
        if (spins) {
            const Range turn = graded(capability.words, kSlowTurn_deg_s, kFastTurn_deg_s);
            const float sign = turning(capability.words) < 0 ? 1.0f : -1.0f;
            range = stops(capability.words) ? Range{0, 0} : Range{sign * turn.from, sign * turn.to};
        }
        ChannelFunction function = make_function(attribute + (shakes ? "SelectShake" : "SelectSpin"),
                                                 capability.low, capability.high, range.from, range.to);
        function.name = capability.name;
        function.sets.push_back(set);
        function.sets.back().physical_from = range.from;
        function.sets.back().physical_to = range.to;
        add(std::move(function));
        return;
    }
    // Ranges that follow one another are sets of one function.
    if (!sketch_.functions.empty()) {
        ChannelFunction& last = sketch_.functions.back();
        if (last.attribute == attribute && last.dmx_to + 1 == capability.low && !last.sets.empty()) {
            last.sets.push_back(set);
            last.dmx_to = capability.high;
            return;
        }
    }
    ChannelFunction function = make_function(attribute, capability.low, capability.high, 0, 1);
    function.name = channel_.name;
    function.sets.push_back(set);
    add(std::move(function));
}

} // namespace ghost::fixture
