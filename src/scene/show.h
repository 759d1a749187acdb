#pragma once
// SPDX-License-Identifier: Apache-2.0
// Show: what show.toml says, with its fixture types and stage loaded. Metres and degrees as in the file; Z
// up, X right from the house, Y up-stage. A fixture hangs head down in its identity pose. Plain values,
// loaded once.

#include "base/result.h"
#include "fixture/type.h"
#include "scene/report.h"
#include "scene/stage.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct Camera {
    std::string name;
    glm::vec3 position_m{0, -10, 2};
    glm::vec3 target_m{0, 0, 2};
    float fov_y_deg = 40; // vertical
    int width = 1280;
    int height = 720;
    float ev100 = 6; // exposure
    bool auto_exposure = false;
    std::filesystem::path
        foreign_passes; // a passes.toml rendered elsewhere (docs/foreign-passes.md), or empty
};

// mean: see docs; extinction covers the way lamp -> surface -> camera.
struct HazeSettings {
    float extinction_per_m = 0.015f;
    float albedo = 1.0f; // scattering / extinction
    float forward_g = 0.77f;
    float back_g = -0.6f;
    float back_weight = 0.035f;
};

// A fixture that travels: the bake has one pass per stop, and a DMX value moves it from the first to the last
// stop.
struct Track {
    std::vector<glm::vec3> stops_m; // at least 2
    int universe = 0;               // 1-based
    int address = 0;                // 1-based, 16 bit coarse first
};

struct PatchedFixture {
    std::string name;
    std::filesystem::path gdtf; // as written
    std::shared_ptr<const fixture::Type>
        type;         // null where the file could not be read: the fixture stays dark
    int mode = 0;     // index into type->modes
    int universe = 1; // 1-based
    int address = 1;  // 1-based; 0: not patched
    glm::vec3 position_m{0};
    glm::vec3 rotation_deg{0}; // about X, then Y, then Z; zero hangs, (180, 0, 0) stands on the floor
    float home_pan_deg = 0;    // pose of the body in baked passes
    float home_tilt_deg = 0;
    std::optional<Track> track;

    // Hanging positions to bake: the stops of the track, or the one position.
    std::vector<glm::vec3> stops_m() const {
        return track ? track->stops_m : std::vector<glm::vec3>{position_m};
    }
};

struct Show {
    std::filesystem::path file;   // show.toml
    std::filesystem::path folder; // where relative names start
    std::string name;
    std::filesystem::path stage_file;
    std::filesystem::path recording; // the show's own DMX recording, or empty
    float ambient_lux = 0.0f;        // even light from everywhere, so that the house is not pitch black
    HazeSettings haze;
    std::vector<Camera> cameras;
    std::vector<PatchedFixture> fixtures;
    Stage stage; // the model, without fixture bodies

    // Index of the camera of this name (the first one where name is empty); the error suggests a near name.
    Result<std::size_t> find_camera(const std::string& camera_name) const;
    std::filesystem::path cache_folder() const { return folder / ".ghost"; }
};

// path: show.toml or the folder that holds it. An error only where nothing can go on (no such file, not TOML,
// no camera at all); everything else goes to the report with file and line, and the rest is kept. load_stage
// = false leaves the stage empty (a renderer with baked passes needs no geometry).
Result<Show> load_show(const std::filesystem::path& path, bool load_stage, Report& report);

// A glTF binary (or any format Assimp reads), instanced, turned to Z up. Error: unreadable, cut short, over
// the limits.
Result<Stage> load_stage_file(const std::filesystem::path& path, Report& report);

// The stage with all fixture bodies hung at their home pose (first stop), marked with their fixture's index.
Stage stage_with_bodies(const Show& show, Report& report);

// Camera space to world (columns: right, up, backward, eye); the camera looks down its -Z.
glm::mat4 camera_to_world(const Camera& camera);

// World matrix of a fixture hung at a stop (index into stops_m()).
glm::mat4 fixture_to_world(const PatchedFixture& fixture, std::size_t stop);

// Where the light comes from for the baker and the renderer: the pivot of the head (tilt axis), which does
// not move when the head turns, in world metres.
glm::vec3 light_position_m(const PatchedFixture& fixture, std::size_t stop);

} // namespace ghost::scene
