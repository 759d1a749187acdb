#pragma once
// SPDX-License-Identifier: Apache-2.0
// Followers: what moves with the trackers of a stage, as the show's [[tracker]] entries say: heads that aim,
// objects that go along, cameras that look; and of the [[mover]] entries that follow a tracker. What was not
// heard of yet leaves all as it is. One session; its thread.

#include "base/name_index.h"
#include "live/session/session.h"
#include "psn_osc/psn.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ghost::app {

class Followers {
public:
    // Heads and objects, before the rig's step.
    void apply(Session& session, const dmx::Trackers& trackers);

private:
    // What an entry names is looked for once, for it may be thousands of names.
    struct Home {
        bool known = false;
        bool said_far = false;
        std::optional<glm::vec3> at_m; // none: no such object
        std::vector<std::size_t> objects;
        std::optional<std::vector<std::size_t>> fixtures;
    };
    void move_objects(Session& session, const scene::TrackerUse& use, const glm::vec3& point_m, Home& home);

    std::vector<Home> homes_; // of each entry
    std::uint64_t steps_ = kMostMatchSteps;
    std::vector<std::uint64_t> heard_; // packets with the tracker of each mover
    bool said_passes_ = false;
};

// Where the tracker of an entry is, in the show, with its offset; nothing before it was heard, and where it
// tells a place that is farther than anything of a show.
std::optional<glm::vec3> tracked_point_m(const scene::Show& show, const scene::TrackerUse& use,
                                         const dmx::Trackers& trackers);

// The camera turned to what it follows; the same one where it follows nothing, or all but stands there.
scene::Camera follow(const scene::Camera& camera, const scene::Show& show, const dmx::Trackers& trackers);

} // namespace ghost::app
