#pragma once
// SPDX-License-Identifier: Apache-2.0
// Movers: machines that carry lamps, objects of the stage, cameras and other movers: [[mover]] of show.toml.
// A mover has axes; the value of an axis is metres or degrees from where the model has it, so that all is
// where it is drawn while every value is 0. Plain values; where things are is show/mover_pose.h, how they get
// there show/mover_motion.h. Errors: to the report, with file and line.

#include "base/report.h"
#include "fixture/patch.h"

#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace ghost::scene {

class TableReader; // json_xml_toml/toml_reader.h
struct Show;       // show/show.h
struct Stage;      // stage/stage.h

inline constexpr int kNoMover = -1;
inline constexpr std::size_t kMostMovers = 256;
inline constexpr std::size_t kMostMoverAxes = 32;
inline constexpr double kFarthestMove_m = 1000;

enum class MoverKind {
    hoists,  // a truss on one or more chains; each axis lifts one of its points
    linear,  // a lift, a winch: along a direction
    revolve, // round an axis through centre_m
    path,    // a wagon: along path_m
    flown,   // axes x, y, z, turn_x, turn_y, turn_z of its own
};

// What an axis of a flown mover does; its index is the place in pose's list.
enum class Degree { x, y, z, turn_x, turn_y, turn_z };

struct MoverAxis {
    std::string name;      // "hoist 2", "height": for messages and hands
    glm::vec3 point_m{0};  // hoists: what it lifts, where the model has it
    Degree degree{};       // flown
    bool is_angle = false; // degrees, else metres
    float from = 0;        // at the channel's 0
    float to = 0;          // at its highest value; may be below from
    float low = 0;         // end stops, between which it is whatever is asked
    float high = 0;
    float speed = 0;                      // per second; 0: no limit
    float acceleration = 0;               // per second squared; 0: no limit
    std::vector<fixture::Address> levels; // of the channel, coarse first; empty: none drives it
    std::string fixture, attribute;       // whose channel that is, until check_movers has found it
    std::string where;                    // file:line
};

struct MoverKey {
    double at_s = 0;           // of the recording, or time code
    std::vector<float> values; // of all axes
};

struct Mover {
    std::string name;
    MoverKind kind = MoverKind::linear;
    std::string parent_name;                             // which carries it; empty: none
    int parent = kNoMover;                               // index, set by check_movers
    std::vector<std::string> fixtures, objects, cameras; // names; patterns as in [[object]]
    glm::vec3 centre_m{0};                               // revolve, flown
    glm::vec3 direction{0, 0, 1};                        // linear: way; revolve: axis; unit
    std::vector<glm::vec3> path_m;                       // it stands at the first point
    float wheelbase_m = 0; // path: between its axles, which both stay on it; 0: it does not turn
    std::vector<MoverAxis> axes;
    std::vector<MoverKey> keys; // by time
    int tracker_id = -1;        // PosiStageNet that it follows; -1: known by its name
    std::string tracker;        // empty: known by its id
    glm::vec3 home_m{0};        // where the tracker is, in the show, while all values are 0
    std::string where;          // file:line

    bool has_tracker() const { return tracker_id >= 0 || !tracker.empty(); }
    bool carries_nothing() const { return fixtures.empty() && objects.empty() && cameras.empty(); }
};

// Tables of the show file; those that say nothing of use are left out.
std::vector<Mover> read_movers(TableReader& top, const std::string& file, Report& report);

// Finds parents, channels of fixtures and what is carried (PatchedFixture::mover, Camera::mover); names that
// the show does not have, loops and movers without a load go to the report. Once, when all fixtures are
// there.
void check_movers(Show& show, Report& report);

// Names of objects that no instance of the stage has.
void check_moved_objects(const Show& show, const Stage& stage, Report& report);

// Indices, parents before what they carry. No loops: check_movers has cut them.
std::vector<std::size_t> parents_first(const std::vector<Mover>& movers);

// For each instance of a stage the mover that carries it, or kNoMover. Bodies go with their fixtures.
std::vector<int> movers_of_instances(const Show& show, const Stage& stage);

} // namespace ghost::scene
