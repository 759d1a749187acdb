#pragma once
// SPDX-License-Identifier: Apache-2.0
// What trackers of the stage (PosiStageNet) move in a show: [tracking] and [[tracker]] of show.toml. Plain
// values; the network is dmx's.

#include "base/report.h"
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

class TableReader; // json_xml_toml/toml_reader.h
struct Show;       // show/show.h

// One tracker and what follows it, by name.
struct TrackerUse {
    int id = -1;           // -1: known by its name
    std::string name;      // as the tracking system calls it; empty: known by its id
    glm::vec3 offset_m{0}; // from the tracker to what is looked at: a beacon on the back, the head above it
    std::string camera;    // looks at it; empty: none
    std::vector<std::string> fixtures; // aim at it
    std::vector<std::string> objects;  // of the stage, go with it; patterns as in [[object]]
    std::optional<glm::vec3> home_m;   // where it is, in the show, while they stand as the model has them;
                                       // none: below the middle of them all
    std::string where;                 // file:line
};

struct Tracking {
    // Our X, Y, Z are these axes of the tracking system: 0 x, 1 y, 2 z; and their signs. PosiStageNet leaves
    // the axes to the sender; most have y up and z towards the audience.
    glm::ivec3 axes{0, 2, 1};
    glm::vec3 signs{1, -1, 1};
    glm::vec3 origin_m{0}; // of the tracking system, in the show
    std::vector<TrackerUse> uses;

    glm::vec3 to_world(const glm::vec3& tracked_m) const {
        return origin_m + signs * glm::vec3(tracked_m[axes.x], tracked_m[axes.y], tracked_m[axes.z]);
    }
};

// Tables of the show file.
Tracking read_tracking(TableReader& top, const std::string& file, Report& report);

// Names of cameras and fixtures that the show does not have.
void check_tracking(const Show& show, Report& report);

} // namespace ghost::scene
