// SPDX-License-Identifier: Apache-2.0
#include "live/inputs/remote.h"

#include "show/looks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace ghost::app {

namespace {

constexpr std::string_view kOurs = "/ghostlight/";
constexpr float kLatest_s = 366.0f * 86400.0f;

// A number between low and high; a truth value counts as 0 or 1.
Result<float> number_in(const std::vector<dmx::OscArgument>& arguments, std::size_t index, float low,
                        float high, const std::string& where) {
    double value = std::nan("");
    if (index < arguments.size()) {
        if (const double* number = std::get_if<double>(&arguments[index])) value = *number;
        if (const bool* truth = std::get_if<bool>(&arguments[index])) value = *truth ? 1.0 : 0.0;
    }
    if (value >= static_cast<double>(low) && value <= static_cast<double>(high))
        return static_cast<float>(value);
    char expected[64];
    std::snprintf(expected, sizeof expected, "expected a number from %g to %g", static_cast<double>(low),
                  static_cast<double>(high));
    return Error{expected, where};
}

} // namespace

struct Remote::Asked {
    const std::vector<dmx::OscArgument>& arguments;
    const std::string& where;

    Result<float> number(std::size_t index, float low, float high) const {
        return number_in(arguments, index, low, high, where);
    }
    const std::string* text(std::size_t index) const {
        return index < arguments.size() ? std::get_if<std::string>(&arguments[index]) : nullptr;
    }
};

// By name, or by number from 1; then seconds of the flight there.
Result<void> Remote::recall_camera(const Asked& asked) {
    std::size_t index = cameras_.size();
    if (!asked.arguments.empty()) {
        if (const std::string* name = asked.text(0)) {
            const auto found = std::find(cameras_.begin(), cameras_.end(), *name);
            index = static_cast<std::size_t>(found - cameras_.begin());
        } else if (const auto number = asked.number(0, 1.0f, static_cast<float>(cameras_.size()));
                   number.ok() && *number == std::floor(*number)) {
            index = static_cast<std::size_t>(*number) - 1;
        }
    }
    if (index >= cameras_.size())
        return Error{"expected the name of a camera, or its number from 1 to " +
                         std::to_string(cameras_.size()),
                     asked.where};
    float flight_s = 0;
    if (asked.arguments.size() > 1) {
        TRY(flight_s, asked.number(1, 0.0f, kLongestFlight_s));
    }
    request_.camera = RemoteCamera{index, flight_s};
    ++request_.calls;
    return {};
}

// By name or number from 1; or, steps other than 0, so many after the last one.
Result<void> Remote::call_cue(const Asked& asked, int steps) {
    if (cues_.empty()) return Error{"the show has no [[cue]]", asked.where};
    std::size_t index = cues_.size();
    if (steps != 0) {
        // Before the first call, "go" is the first one.
        const auto last = static_cast<int>(cues_.size()) - 1;
        const int next = cue_ ? static_cast<int>(*cue_) + steps : 0;
        if (next < 0 || next > last)
            return Error{next < 0 ? "this is the first cue" : "this was the last cue", asked.where};
        index = static_cast<std::size_t>(next);
    } else if (!asked.arguments.empty()) {
        if (const std::string* name = asked.text(0)) {
            const auto found = std::find_if(cues_.begin(), cues_.end(),
                                            [&](const scene::Cue& cue) { return cue.name == *name; });
            index = static_cast<std::size_t>(found - cues_.begin());
        } else if (const auto number = asked.number(0, 1.0f, static_cast<float>(cues_.size())); number.ok()) {
            index = static_cast<std::size_t>(*number) - 1;
        }
    }
    if (index >= cues_.size())
        return Error{"expected the name of a cue, or its number from 1 to " + std::to_string(cues_.size()),
                     asked.where};
    cue_ = index;
    const scene::Cue& cue = cues_[index];
    in_ = cue.name;
    request_.cue = cue.name;
    ++request_.cues;
    if (!cue.look.empty()) {
        request_.look = {cue.look, cue.fade_s ? static_cast<double>(*cue.fade_s) : -1};
        ++request_.recalls;
    }
    if (cue.at_s) {
        request_.at_s = *cue.at_s;
        ++request_.jumps;
    }
    const auto camera = std::find(cameras_.begin(), cameras_.end(), cue.camera);
    if (camera == cameras_.end()) return {}; // none, or one that the show does not have, which was said
    request_.camera = RemoteCamera{static_cast<std::size_t>(camera - cameras_.begin()), cue.flight_s};
    ++request_.calls;
    return {};
}

// Whoever keeps the list may know an edit of it earlier: a name that is not there yet moves nothing.
void Remote::be_in(const std::string& cue) {
    in_ = cue;
    const auto found =
        std::find_if(cues_.begin(), cues_.end(), [&](const scene::Cue& one) { return one.name == cue; });
    if (found != cues_.end())
        cue_ = static_cast<std::size_t>(found - cues_.begin());
    else if (cue.empty())
        cue_.reset();
}

void Remote::know(std::vector<std::string> cameras, std::vector<scene::Cue> cues) {
    const std::vector<scene::Cue> before = std::exchange(cues_, std::move(cues));
    cameras_ = std::move(cameras);
    const auto place_of = [&](const std::string& name) -> std::optional<std::size_t> {
        const auto found =
            std::find_if(cues_.begin(), cues_.end(), [&](const scene::Cue& one) { return one.name == name; });
        return found == cues_.end() ? std::nullopt
                                    : std::optional(static_cast<std::size_t>(found - cues_.begin()));
    };
    const std::optional<std::size_t> was = std::exchange(cue_, place_of(in_));
    for (std::size_t i = was ? *was + 1 : 0; !cue_ && i > 0; --i) cue_ = place_of(before[i - 1].name);
}

void Remote::begin(std::vector<std::string> cameras, std::vector<scene::Cue> cues) {
    cameras_ = std::move(cameras);
    cues_ = std::move(cues);
    in_.clear();
    cue_.reset();
    const RemoteRequest none;
    request_.master = none.master;
    request_.blackout = none.blackout;
    request_.haze = none.haze;
    request_.ev100 = none.ev100;
    request_.tone = none.tone;
}

// By name; then seconds of the fade there.
Result<void> Remote::recall_look(const Asked& asked) {
    const std::string* name = asked.text(0);
    if (!name || name->empty()) return Error{"expected the name of a look", asked.where};
    double seconds = -1;
    if (asked.arguments.size() > 1) {
        TRY(seconds, asked.number(1, 0.0f, static_cast<float>(scene::kLongestFade_s)));
    }
    request_.look = {*name, seconds};
    ++request_.recalls;
    return {};
}

Result<void> Remote::apply(const dmx::OscMessage& message) {
    const std::string_view address = message.address;
    return apply(address.starts_with(kOurs) ? address.substr(kOurs.size()) : std::string_view(),
                 message.arguments, message.address);
}

Result<void> Remote::apply(std::string_view what, const std::vector<dmx::OscArgument>& arguments,
                           const std::string& where) {
    const Asked asked{arguments, where};
    if (what == "camera") return recall_camera(asked);
    if (what == "look") return recall_look(asked);
    if (what == "cue") return call_cue(asked, 0);
    // A button sends 1 when it is pressed and 0 when it is let go.
    if (what == "cue/go" || what == "cue/back") {
        if (!asked.arguments.empty()) {
            TRY(const float value, asked.number(0, 0.0f, 1.0f));
            if (value < 0.5f) return {};
        }
        return call_cue(asked, what == "cue/go" ? 1 : -1);
    }
    if (what == "master") {
        TRY(request_.master, asked.number(0, 0.0f, 1.0f));
    } else if (what == "haze") {
        TRY(request_.haze, asked.number(0, 0.0f, kThickestHaze));
    } else if (what == "recording") {
        TRY(const float at_s, asked.number(0, 0.0f, kLatest_s));
        request_.at_s = static_cast<double>(at_s);
        ++request_.jumps;
    } else if (what == "exposure") {
        TRY(request_.ev100, asked.number(0, -10.0f, 20.0f));
    } else if (what == "exposure/auto") {
        request_.ev100.reset();
    } else if (what == "tone" && asked.arguments.empty()) {
        request_.tone.reset();
    } else if (what == "tone") {
        const std::string* name = asked.text(0);
        const Result<image::Tone> tone = image::tone_from(name ? *name : "");
        if (!tone.ok()) return Error{tone.error().what, asked.where};
        request_.tone = *tone;
    } else if (what == "blackout") {
        // A button without a value blacks out; faders and buttons send 0 or 1.
        if (asked.arguments.empty()) {
            request_.blackout = true;
        } else {
            TRY(const float value, asked.number(0, 0.0f, 1.0f));
            request_.blackout = value >= 0.5f;
        }
    } else {
        return Error{"is no address of ours; they are /ghostlight/camera, look, cue, cue/go, cue/back, "
                     "recording, master, "
                     "blackout, haze, exposure, exposure/auto and tone",
                     asked.where};
    }
    return {};
}

} // namespace ghost::app
