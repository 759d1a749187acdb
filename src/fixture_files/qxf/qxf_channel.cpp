// SPDX-License-Identifier: Apache-2.0
// One channel of a definition -> functions of one byte.
#include "base/text.h"
#include "fixture_files/qxf/private/qxf_sketcher.h"

#include <cmath>

namespace ghost::fixture {

Sketch QxfSketcher::run() {
    find_subject();
    switch (sketch_.subject) {
    case Subject::nothing:
        add(make_function("NoFeature", 0, 255, 0, 1));
        return std::move(sketch_);
    case Subject::unknown:
        for (const QxfCapability& capability : capabilities()) miss(capability);
        break;
    case Subject::colour:
    case Subject::gobo:
    case Subject::prism:
        make_wheel();
        break;
    default:
        for (const QxfCapability& capability : capabilities()) convert(capability);
    }
    fill_gaps();
    list_losses();
    return std::move(sketch_);
}

void QxfSketcher::find_subject() {
    if (const ChannelPreset* preset = find_preset(channel_.preset)) {
        preset_ = preset;
        sketch_.subject = preset->subject;
        return;
    }
    const std::string& group = channel_.group;
    const std::string& words = channel_.words;
    if (group == "Intensity" && !channel_.colour.empty() && channel_.colour != "Generic") {
        preset_ = find_preset("Intensity" + channel_.colour);
        if (preset_) {
            sketch_.subject = Subject::fixed;
            return;
        }
    }
    if (group == "Maintenance" || group == "Nothing") {
        sketch_.subject = Subject::nothing;
        return;
    }
    if (group == "Pan" || group == "Tilt") {
        const bool pan = group == "Pan";
        const bool turns = has_word(words, {"continuous", "endless", "infinite", "rotat", "rolling"}) ||
                           any_capability({"clockwise", "cw ", "ccw"});
        if (has_word(words, {"macro", "offset", "speed"})) {
            sketch_.subject = Subject::unknown;
        } else if (turns) {
            sketch_.subject = pan ? Subject::pan_turn : Subject::tilt_turn;
        } else {
            preset_ = find_preset(pan ? "PositionPan" : "PositionTilt");
            sketch_.subject = Subject::fixed;
        }
        return;
    }
    if (group == "Intensity") {
        for (const char* colour :
             {"Red", "Green", "Blue", "White", "Amber", "Cyan", "Magenta", "Yellow", "Lime", "Indigo", "UV"})
            if (has_word(words, {lower(colour).c_str()}) && !has_word(words, {"strob", "macro", "program"})) {
                preset_ = find_preset("Intensity" + std::string(colour));
                sketch_.subject = Subject::fixed;
                return;
            }
        if (has_word(words, {"fog", "haze", "smoke", "fan", "output"}) &&
            has_word(lower(reader_.fixture_kind), {"smoke", "hazer"})) {
            sketch_.subject = Subject::fog;
            return;
        }
        if (has_word(words, {"dimmer", "intensity", "brightness", "master"}) &&
            !has_word(words, {"curve", "mode", "speed", "effect"})) {
            sketch_.subject = Subject::dimmer;
            return;
        }
    }
    if (group == "Colour" && any_preset({"ColorMacro", "ColorDoubleMacro"})) {
        sketch_.subject = Subject::colour;
        return;
    }
    if (const std::optional<Subject> subject = subject_of_words(channel_)) {
        sketch_.subject = *subject;
        // The diffuser of a wash light with a range of angles is what makes them.
        if (*subject == Subject::frost && has_word(words, {"diffus"}) &&
            physical_.lamp.degrees_max > physical_.lamp.degrees_min && physical_.lamp.degrees_min > 0.0f)
            sketch_.subject = Subject::zoom;
        // "Gobo rotation" of a channel that also chooses gobos is the wheel itself.
        if (*subject == Subject::gobo_turn && (any_preset({"GoboMacro", "GoboShakeMacro"}) || names_gobos()))
            sketch_.subject = Subject::gobo;
        if (*subject == Subject::prism_turn && any_preset({"PrismEffectOn"}))
            sketch_.subject = Subject::prism;
        return;
    }
    if (group == "Intensity") sketch_.subject = Subject::dimmer;
    if (group == "Shutter")
        sketch_.subject = has_word(words, {"blade", "framing"}) ? Subject::unknown : Subject::shutter;
    if (group == "Colour") sketch_.subject = Subject::colour;
    if (group == "Gobo") sketch_.subject = has_word(words, {"rotat"}) ? Subject::gobo_turn : Subject::gobo;
    if (group == "Prism") sketch_.subject = has_word(words, {"rotat"}) ? Subject::prism_turn : Subject::prism;
    if (group == "Beam" || group == "Effect") {
        sketch_.subject = Subject::unknown;
        if (any_preset({"GoboMacro", "GoboShakeMacro"})) sketch_.subject = Subject::gobo;
        if (any_preset({"ColorMacro", "ColorDoubleMacro"})) sketch_.subject = Subject::colour;
        if (any_preset({"PrismEffectOn"})) sketch_.subject = Subject::prism;
        if (any_preset({"ShutterOpen", "StrobeSlowToFast"})) sketch_.subject = Subject::shutter;
    }
    if (group.empty() && channel_.preset.empty()) sketch_.subject = Subject::unknown;
}

// Its ranges are called "Gobo 1", "Gobo 2", ...: "Rotating gobo wheel" chooses, whatever its name says of
// turning.
bool QxfSketcher::names_gobos() const {
    if (has_word(channel_.words, {"iris"})) return false;
    std::set<int> numbers;
    for (const QxfCapability& capability : channel_.capabilities)
        if (const std::optional<int> number = gobo_number(capability.words)) numbers.insert(*number);
    return numbers.size() >= 2;
}

// Housekeeping that stands in channels of every kind.
bool QxfSketcher::is_service(const QxfCapability& capability) {
    const std::string& preset = capability.preset;
    if (preset == "LampOn" || preset == "LampOff") {
        ChannelFunction function = make_function("LampControl", capability.low, capability.high, 0, 1);
        function.sets.push_back(
            {preset == "LampOn" ? "On" : "Off", capability.low, capability.high, 0, 0, -1});
        function.physical_from = function.physical_to = preset == "LampOn" ? 1.0f : 0.0f;
        add(std::move(function));
        return true;
    }
    if (preset.starts_with("Reset")) {
        add(capability, "FixtureGlobalReset", {0, 1});
        return true;
    }
    if (preset.starts_with("SilentMode") || preset == "NoFunction" || preset == "GenericPicture") {
        ignore(capability);
        return true;
    }
    return false;
}

void QxfSketcher::convert(const QxfCapability& capability) {
    if (is_service(capability)) return;
    switch (sketch_.subject) {
    case Subject::fixed:
        convert_fixed(capability);
        break;
    case Subject::dimmer:
        convert_dimmer(capability);
        break;
    case Subject::shutter:
        convert_shutter(capability);
        break;
    case Subject::temperature:
        convert_temperature(capability);
        break;
    case Subject::gobo_turn:
        convert_turn(capability, "Gobo#Pos", "Gobo#PosRotate", -1.0f, kSlowTurn_deg_s, kFastTurn_deg_s);
        break;
    case Subject::prism_turn:
        convert_turn(capability, "Prism#Pos", "Prism#PosRotate", -1.0f, kSlowTurn_deg_s, kFastTurn_deg_s);
        break;
    case Subject::pan_turn:
        convert_turn(capability, "", "PanRotate", -1.0f, kSlowAxis_deg_s, kFastAxis_deg_s);
        break;
    case Subject::tilt_turn:
        convert_turn(capability, "", "TiltRotate", -1.0f, kSlowAxis_deg_s, kFastAxis_deg_s);
        break;
    case Subject::iris:
        convert_graded(capability, "Iris", kSmallestIris, 1.0f);
        break;
    case Subject::focus:
        convert_graded(capability, "Focus1", 0.0f, 1.0f);
        break;
    case Subject::zoom:
        convert_zoom(capability);
        break;
    case Subject::frost:
        convert_frost(capability);
        break;
    case Subject::time:
        convert_time(capability);
        break;
    case Subject::fog:
        add(capability, has_word(channel_.words, {"fan"}) ? "Fan1" : "Fog1",
            {static_cast<float>(capability.low) / 255.0f, static_cast<float>(capability.high) / 255.0f});
        break;
    default:
        miss(capability);
    }
}

// Every value has a function: what the file leaves out does nothing.
void QxfSketcher::fill_gaps() {
    std::vector<ChannelFunction>& functions = sketch_.functions;
    std::stable_sort(
        functions.begin(), functions.end(),
        [](const ChannelFunction& a, const ChannelFunction& b) { return a.dmx_from < b.dmx_from; });
    std::vector<ChannelFunction> gaps;
    std::uint32_t next = 0;
    for (const ChannelFunction& function : functions) {
        if (function.dmx_from > next)
            gaps.push_back(make_function("NoFeature", next, function.dmx_from - 1, 0, 1));
        next = function.dmx_to + 1;
    }
    if (next <= 255) gaps.push_back(make_function("NoFeature", next, 255, 0, 1));
    functions.insert(functions.end(), gaps.begin(), gaps.end());
    std::stable_sort(
        functions.begin(), functions.end(),
        [](const ChannelFunction& a, const ChannelFunction& b) { return a.dmx_from < b.dmx_from; });
}

void QxfSketcher::list_losses() {
    if (guessed_rate_)
        reader_.say(Severity::note, channel_.line,
                    "strobe rates are not in the file: slow is 1 Hz, fast 20 Hz");
    if (guessed_colour_)
        reader_.say(Severity::note, channel_.line,
                    "channel '" + channel_.name + "' names colours without values: common ones are taken");
    if (missed_.empty()) return;
    std::string list;
    for (std::size_t i = 0; i < missed_.size() && i < 3; ++i) list += (i ? ", '" : "'") + missed_[i] + "'";
    if (missed_.size() > 3) list += ", ...";
    reader_.say(Severity::error, channel_.line,
                "channel '" + channel_.name + "': " + std::to_string(missed_.size()) + " of " +
                    std::to_string(capabilities().size()) + " ranges are not shown: " + list);
}

Sketch sketch_channel(QxfReader& reader, int channel, const QxfPhysical& physical) {
    const bool before = reader.quiet;
    reader.quiet = before || !reader.described.insert(channel).second;
    Sketch sketch = QxfSketcher(reader, channel, physical).run();
    reader.quiet = before;
    return sketch;
}

} // namespace ghost::fixture
