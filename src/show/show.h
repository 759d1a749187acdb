#pragma once
// SPDX-License-Identifier: Apache-2.0
// Show: what show.toml says, with its fixture types and stage loaded. Metres and degrees as in the file; Z
// up, X right from the house, Y up-stage. A fixture hangs head down in its identity pose. Plain values,
// loaded once.

#include "base/report.h"
#include "base/result.h"
#include "fixture/motion.h"
#include "fixture/patch.h"
#include "fixture/type.h"
#include "show/bounce_detail.h"
#include "show/camera.h"
#include "show/circuits.h"
#include "show/cues.h"
#include "show/laser.h"
#include "show/led_wall.h"
#include "show/movers.h"
#include "show/palettes.h"
#include "show/projector.h"
#include "show/tracking.h"
#include "stage/overrides.h"
#include "stage/stage.h"

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ghost::scene {

struct BeamShape;  // light/beam_shape.h
struct LoadedPlot; // mvr/mvr_load.h

// mean: see docs; extinction covers the way lamp -> surface -> camera.
struct HazeMedium {
    float extinction_per_m = 0.015f;
    float albedo = 1.0f; // scattering / extinction
    float forward_g = 0.77f;
    float back_g = -0.6f;
    float back_weight = 0.035f;
    float unevenness = 0;  // 0: the same everywhere; 1: from nothing to twice as thick
    float patch_m = 2.5f;  // size of a cloud
    glm::vec3 wind_m_s{0}; // the clouds drift with it
};

// A machine that makes haze: a plume on top of what fills the room.
struct Hazer {
    glm::vec3 position_m{0};
    glm::vec3 direction{0, 0, 1}; // unit
    float rate = 3;               // density 1 m before the nozzle, as a multiple of the room's
    float spread_deg = 30;        // full angle of the plume
    float reach_m = 6;            // from here on it is as thin as the room
};

// A model beside the stage.
struct Model {
    std::filesystem::path file;
    glm::vec3 position_m{0};
    glm::vec3 rotation_deg{0}; // about X, then Y, then Z
    float scale = 1;
    std::string where; // file:line
};

// What is heard while the recording plays.
struct Sound {
    std::filesystem::path file; // or empty
    double offset_s = 0;        // second of the recording at which it begins; below 0: before it
    std::string where;          // file:line
};

// The thesis's factors: light falls with 1 / (constant + linear d + quadratic d^2); (0, 0, 1) is physics.
struct Attenuation {
    float constant = 0;
    float linear = 0;
    float quadratic = 1;
};

// A fixture that travels: the bake has one pass per stop, and a DMX value moves it from the first to the last
// stop.
struct Track {
    std::vector<glm::vec3> stops_m; // at least 2
    int universe = 0;               // 1-based
    int address = 0;                // 1-based, 16 bit coarse first
};

inline constexpr double kMaxCoordinate_m = 10'000; // of anything that show.toml places

// Texels a side of a distance map (passes/distance_maps.h).
inline constexpr int kDistanceMapSize = 512;
inline constexpr int kMinDistanceMapSize = 64;
inline constexpr int kMaxDistanceMapSize = 4096;

inline constexpr std::size_t kMaxShowBytes = std::size_t{16} << 20; // of show.toml

struct PatchedFixture {
    std::string name;
    std::string written_name;   // in show.toml, where that cannot name a file; else empty
    std::filesystem::path gdtf; // as written
    std::shared_ptr<const fixture::Type>
        type;     // null where the file could not be read: the fixture stays dark
    int mode = 0; // index into type->modes
    // False: none is written that can be read, or that the type has, and it has been given one.
    bool is_mode_known = true;
    bool is_place_known = true;
    bool is_rotation_known = true;
    bool is_address_known = true; // false: of some break; where none is given, 0 stands for what it may be
    int universe = 1;             // 1-based
    int address = 1;              // 1-based, of break 1; 0: not patched
    std::vector<fixture::Address> more_addresses; // of breaks 2, 3, ...
    bool invert_pan = false;                      // the desk's values count the other way round
    bool invert_tilt = false;
    glm::vec3 position_m{0};
    glm::vec3 rotation_deg{0}; // about X, then Y, then Z; zero hangs, (180, 0, 0) stands on the floor
    float home_pan_deg = 0;    // pose of the body in baked passes
    float home_tilt_deg = 0;
    std::optional<Track> track;
    std::optional<Projector> projector;     // a moving picture in its gate
    std::optional<Laser> laser;             // a scanner before it
    std::optional<LedWall> wall;            // a moving picture on its front
    std::shared_ptr<const BeamShape> shape; // measured light in place of the profile, or null
    int mover = kNoMover;                   // that carries it (show/movers.h)
    std::string fixture_id; // of the plot, as the desk calls it; "" where the show file has the fixture
    std::string uuid;       // of the plot's object, or ""
    std::string circuit;    // that feeds it, by name (show/circuits.h), or ""

    // Where its channels are; for readers of channels, type must be there.
    fixture::Patch patch() const;

    // Hanging positions to bake: the stops of the track, or the one position.
    std::vector<glm::vec3> stops_m() const {
        return track ? track->stops_m : std::vector<glm::vec3>{position_m};
    }
};

struct Show {
    std::filesystem::path file;       // show.toml, or the .mvr that was opened as it is
    std::filesystem::path folder;     // where relative names start
    std::string cache_name;           // its folder in .ghost; "": .ghost itself
    std::filesystem::path user_cache; // stands for .ghost where that cannot be made (disk/user_cache.h)
    std::string name;
    std::filesystem::path stage_file;
    std::vector<Model> models;
    std::filesystem::path plot_file;        // .mvr, or empty
    std::shared_ptr<LoadedPlot> plot;       // of it, as the show changes it; null where it could not be read
    glm::dvec3 plot_origin_m{0.0};          // taken off all places of a plot in survey coordinates
    std::vector<std::string> hidden_layers; // of the plot, by name
    std::vector<std::string> hidden_classes;
    std::filesystem::path recording; // the show's own DMX recording, or empty
    double begin_s = 0;              // second of it at which the window begins to play
    Sound sound;
    float ambient_lux = 0.0f;       // even light from everywhere, so that the house is not pitch black
    glm::vec3 ambient_colour{1.0f}; // of it: linear Rec.2020, luminance 1
    HazeMedium haze;
    std::vector<Hazer> hazers;
    Attenuation attenuation;
    BounceDetail bounce = BounceDetail::off; // of pictures that are drawn live
    bool shadows = true;
    fixture::Motion motion = fixture::Motion::as_the_machine;
    float shutter_deg = 360;   // of the camera: share of a frame, in degrees, for which strobes are seen
    int distance_map_size = 0; // texels a side; 0: by the number of lights
    std::vector<ObjectSettings> objects; // applied by stage_with_bodies
    std::vector<Camera> cameras;
    std::vector<PatchedFixture> fixtures;
    std::vector<Circuit> circuits;
    std::vector<Cue> cues;
    std::vector<Palette> palettes;
    std::vector<Media> media;
    int media_side = kMediaSide;
    Tracking tracking;
    std::vector<Mover> movers;
    Stage stage; // the model as its file has it and all that the plot draws, without fixture bodies

    // Index of the camera of this name (the first one where name is empty); the error suggests a near name.
    Result<std::size_t> find_camera(const std::string& camera_name) const;
    // What is kept for all shows of the folder, for this one, and the folder from which both are reached
    // without following a link (disk/own_folder.h).
    std::filesystem::path cache_root() const { return user_cache.empty() ? folder / ".ghost" : user_cache; }
    std::filesystem::path cache_folder() const {
        return cache_name.empty() ? cache_root() : cache_root() / cache_name;
    }
    std::filesystem::path cache_home() const {
        return user_cache.empty() ? folder : user_cache.parent_path().parent_path();
    }
};

// World matrix of a fixture hung at a stop (index into stops_m()).
glm::mat4 fixture_to_world(const PatchedFixture& fixture, std::size_t stop);
// What rotation_deg of show.toml means: turned about X, then Y, then Z, and put there.
glm::mat4 placed(const glm::vec3& position_m, const glm::vec3& rotation_deg);

// Turn of a fixture that shines downwards (rotation_deg of a show) so that it shines there with its picture
// upright.
glm::vec3 rotation_towards(const glm::vec3& from_m, const glm::vec3& target_m);

} // namespace ghost::scene
