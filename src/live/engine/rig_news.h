#pragma once
// SPDX-License-Identifier: Apache-2.0
// RigNews: what the rig does, for the window: where each fixture points and what it sends as often as a
// person can read it, and on demand why one is dark, or which of all. Engine thread.

#include "link/link.h"
#include "live/inputs/live_input.h"
#include "live/inputs/remote.h"
#include "live/session/session.h"
#include "rays/tracer.h"

#include <functional>
#include <optional>

namespace ghost::app {

class RigNews {
public:
    explicit RigNews(ui::Link& link) : link_(link) {}

    // drawn: the lights of the picture. recorded_s: nothing is being recorded where it is nothing.
    void publish(const Session& session, const LiveInput& input, const RemoteRequest& remote,
                 const scene::FrameLights& drawn, std::optional<double> recorded_s, double now_s);

    struct Question {
        std::optional<std::size_t> fixture; // of the show
        std::optional<std::size_t> hovered; // likewise
        bool all = false;
    };
    // rays_of: asked only where something is due.
    void explain(const Question& question, const Session& session, const LiveInput& input,
                 const scene::PatchMap& patch, const std::function<const bake::Tracer&()>& rays_of,
                 double now_s);

private:
    ui::Link& link_;
    std::optional<std::size_t> asked_; // fixture of the last question
    double sent_s_ = 0, explained_s_ = 0, hovered_s_ = 0, verdicts_s_ = 0;
};

} // namespace ghost::app
