// SPDX-License-Identifier: Apache-2.0
#include "web/private/cue_label.h"

#include <algorithm>

namespace ghost::web {
namespace {

constexpr double kJumpTakes_s = 1; // at most, until the recording is where a cue sent it

} // namespace

void CueLabel::call(const std::string& name, double now_s) {
    called_ = name;
    called_s_ = now_s;
    recording_s_.reset();
}

std::string CueLabel::name(const scene::Show& show, std::optional<double> recording_s, double now_s) {
    const scene::Cue* passed = nullptr;
    for (const scene::Cue& cue : show.cues)
        if (recording_s && cue.look.empty() && cue.at_s && *cue.at_s <= *recording_s &&
            (!passed || *cue.at_s >= *passed->at_s))
            passed = &cue;
    const auto called = std::ranges::find(show.cues, called_, &scene::Cue::name);
    if (called != show.cues.end()) {
        if (now_s - called_s_ < kJumpTakes_s || !recording_s) return called_;
        if (!recording_s_) recording_s_ = called->at_s.value_or(*recording_s);
        if (!passed || *passed->at_s <= *recording_s_) return called_;
        called_.clear();
    }
    return passed ? passed->name : "";
}

} // namespace ghost::web
