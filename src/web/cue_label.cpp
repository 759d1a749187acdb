// SPDX-License-Identifier: Apache-2.0
#include "web/private/cue_label.h"

#include <algorithm>

namespace ghost::web {
namespace {

constexpr double kJumpTakes_s = 1; // at most, until the recording is where a cue sent it

// The look-less cue that a recording came by last.
std::string passed_by(const scene::Show& show, double recording_s) {
    const scene::Cue* passed = nullptr;
    for (const scene::Cue& cue : show.cues)
        if (cue.look.empty() && cue.at_s && *cue.at_s <= recording_s &&
            (!passed || *cue.at_s >= *passed->at_s))
            passed = &cue;
    return passed ? passed->name : "";
}

} // namespace

void CueLabel::call(const std::string& name, double now_s) {
    called_ = name;
    called_s_ = now_s;
    then_.reset();
}

std::string CueLabel::name(const scene::Show& show, std::optional<double> recording_s, double now_s) {
    const std::string passed = recording_s ? passed_by(show, *recording_s) : "";
    const auto called = std::ranges::find(show.cues, called_, &scene::Cue::name);
    if (called == show.cues.end()) return passed;
    if (!recording_s) return called_;
    if (!then_) then_ = called->at_s ? passed_by(show, *called->at_s) : passed;
    if (passed == *then_ || now_s - called_s_ < kJumpTakes_s) return called_;
    called_.clear();
    return passed;
}

} // namespace ghost::web
