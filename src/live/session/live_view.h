#pragma once
// SPDX-License-Identifier: Apache-2.0
// LiveView: the stage of a show on the device, seen from a camera that may go anywhere: its meshes, the
// G-buffer of the camera, the distance maps of all lights. Yokes and heads follow the rig. Main thread; show
// and device must outlive it.

#include "bake/moving_maps.h"
#include "base/name_index.h"
#include "gpu/device.h"
#include "light/bodies.h"
#include "light/rig.h"
#include "live/session/atmosphere.h"
#include "live/session/map_maker.h"
#include "passes/distance_maps.h"
#include "render/geometry/g_buffer.h"
#include "render/geometry/stage_model.h"
#include "render/haze/distance_images.h"
#include "show/show.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace ghost::app {

inline constexpr float kStill_m = 0.002f; // what moved less is where it was: the G-buffer is not drawn again

// Who makes the distance maps of a show with movers. choice: the device, unless it is a processor itself or
// lacks what it takes.
enum class MovingMapsBy { choice, processor, device };

struct LiveOptions {
    bool shadows = true;
    bool maps_in_background = false; // start at once; a light throws no shadows until its map is made
    bool quiet = false;
    bool keep_hidden = false;           // hidden objects stay, so that they can be shown
    std::optional<Atmosphere> air = {}; // nothing: the show's
    std::function<bool()> stop = {};    // ends the opening with an error; nothing: never
    MovingMapsBy moving_maps = MovingMapsBy::choice;
};

class LiveView {
public:
    // Loads the stage if that was not done, makes the distance maps that are missing (with a progress bar
    // unless quiet) or begins to, and draws the G-buffer. A show without a stage that can be read has its
    // beams all the same. Error: interrupted.
    static Result<std::unique_ptr<LiveView>> open(const gpu::Device& device, scene::Show& show,
                                                  const scene::Camera& camera, const LiveOptions& options,
                                                  Report& report);

    // What look_from did to the G-buffer.
    enum class Seen { anew, where_it_changed };
    // A picture of another size has another G-buffer. parks: the one before is kept, for the next picture of
    // its size; else it goes first, for memory may not hold both.
    // flies: the next one will be from elsewhere, so the stage may be drawn in less detail. splits: then it
    // has a G-buffer of its own, as one of another size has.
    Seen look_from(const scene::Camera& camera, bool parks = false, bool flies = false, bool splits = false);
    // Draws the G-buffer of a picture of another size, or after a flight that has its own, which takes the
    // place of the parked one, so that look_from need not; what is shown stays. False: stop ended it
    // (GBuffer::draw), and the next one goes on.
    bool prepare(const scene::Camera& camera, const std::function<bool()>& stop);
    // Another G-buffer from there, with less detail; what is shown stays. False: stop ended it.
    bool draw_beside(const scene::Camera& camera, render::GBuffer& into,
                     const std::function<bool()>& stop) const {
        render::Pose pose = pose_of(camera, true);
        pose.single = false;
        return into.draw(model_, pose, surroundings(), stop);
    }
    // There is none of another size.
    void drop_parked() { parked_.reset(); }
    const scene::Camera& camera() const { return camera_; }
    // From the next look_from on.
    void set_atmosphere(Atmosphere air) { air_ = std::move(air); }
    shared::Haze haze() const { return air_.medium(); }
    // Light that haze bends so little that it counts as not weakened (bounce/bounce_air.h), from the next
    // look_from on. False: it was that before.
    bool set_forward_per_m(float per_m) { return std::exchange(forward_per_m_, per_m) != per_m; }
    // Likewise, render::Surroundings::work_lux.
    void set_work_light(float lux) { work_lux_ = lux; }
    float work_light() const { return work_lux_; } // lux
    // For the next look_from. The distance maps of the lights that see it are made again in the background.
    void show(std::size_t instance, bool shown);
    // The bodies of these fixtures, by index of the show, send out so much light beside what they reflect,
    // and all others none. The picture shows it after follow().
    void light_bodies(const std::set<std::size_t>& fixtures, float cd_m2);
    void set_material(std::size_t material, const scene::Material& values) {
        model_.set_material(material, values);
    }
    // Turns yokes and heads as the rig does, and puts tracked and carried objects where they are. False:
    // nothing moved in the picture.
    bool follow(const scene::Rig& rig);
    // Those that no mover carries, by name pattern ([[object]]); steps: base/name_index.h.
    std::vector<std::size_t> objects_named(const std::vector<std::string>& patterns, std::uint64_t& steps);
    // Objects that will move all the time. Their middle, at the height of their feet; none: there are none.
    std::optional<glm::vec3> track(const std::vector<std::size_t>& objects);
    // So far from where the show has them; the picture shows it after follow(). The distance maps of the
    // lights that see them are made again in the background, as often as they get finished.
    void move_tracked(const std::vector<std::size_t>& objects, const glm::vec3& by_m);
    // Uploads distance maps that were finished in the background, for a part of a picture's time. True: one
    // of them replaced another, so that images of lights which did not change are wrong. What went wrong goes
    // to the report.
    bool take_maps(Report& report);
    // Of a show with movers, whose maps are made as they are needed: what these lights, of follow's rig, see
    // now. True: a light that did not change itself has another image.
    bool update_maps(const std::vector<shared::Light>& lights);
    // What the last of these took.
    struct MapWork {
        std::uint64_t rays = 0;
        double trace_ms = 0;
        double upload_ms = 0;
        double draw_ms = 0; // instead of both, by the device
    };
    const MapWork& map_work() const { return map_work_; }
    bool draws_maps() const { return moving_maps_ && distances_->can_draw(); } // MovingMapsBy
    // That are being made; none where they cannot be.
    std::size_t missing_maps() const { return maker_ ? missing_maps_ : 0; }
    bool is_making_maps() const { return maker_ != nullptr; }

    const render::GBuffer& g_buffer() const { return *g_buffer_; }
    const render::DistanceImages* distances() const { return distances_.get(); }
    // Without the distances, which are on the device; those that are missing have no fixture.
    const scene::DistanceMaps& maps() const { return maps_; }
    const scene::Stage& stage() const { return stage_; }
    // What light meets: without the objects that were hidden from the beginning.
    const scene::Stage& solid() const { return solid_ ? *solid_ : stage_; }
    // The same as hands and trackers have it now; a copy.
    scene::Stage solid_now() const;
    // Grows whenever that is another one because something was hidden or shown.
    std::uint64_t shown_changes() const { return shown_changes_; }

private:
    LiveView(const gpu::Device& device, const scene::Show& show, scene::Stage stage,
             const scene::Camera& camera, Atmosphere air, Report& report);
    void begin_maps(Report& report);
    void begin_changed_maps();
    void begin_moving_maps(MovingMapsBy by, Report& report);
    void move(std::size_t instance, const glm::mat4& by);
    void hang_lamps(const scene::Rig& rig);

    const gpu::Device& device_;
    const scene::Show& show_;
    scene::Stage stage_;                // with fixture bodies, at home
    std::optional<scene::Stage> solid_; // without hidden objects, where there are any
    std::vector<std::size_t> moving_;
    std::vector<scene::CarriedObject> carried_;
    struct ObjectNames {
        NameIndex by_name, by_mesh;
    };
    std::optional<ObjectNames> names_; // once somebody looks for one
    render::StageModel model_;
    MapWork map_work_;
    render::Pose pose_of(const scene::Camera& camera, bool flies) const;
    render::Surroundings surroundings() const;
    std::unique_ptr<render::GBuffer> g_buffer_, parked_;
    bool parked_is_anew_ = false; // since it was looked from last
    scene::Camera camera_;
    Atmosphere air_;
    float forward_per_m_ = 0;
    float work_lux_ = 0;
    scene::DistanceMaps maps_;
    std::size_t missing_maps_ = 0;
    std::unique_ptr<render::DistanceImages> distances_;
    std::unique_ptr<bake::MovingMaps> moving_maps_; // or null: the show has no movers
    struct CarriedFixture {
        std::size_t fixture = 0;
        std::size_t first_map = 0;
        std::vector<glm::vec3> places_m; // of its maps, where the show has them
    };
    std::vector<CarriedFixture> carried_fixtures_; // by movers
    // Tracked and carried objects and those that hands hid or showed: what the maker makes the maps of. These
    // go to a folder of their own, so that those of the show as it is stay.
    std::map<std::size_t, glm::mat4> moved_, mapped_;          // instance: how; with which maps were begun
    std::map<std::size_t, bool> shown_by_hand_, mapped_shown_; // instance; likewise
    std::uint64_t shown_changes_ = 0;
    scene::Show changed_show_;
    std::optional<scene::Stage> changed_stage_;
    std::unique_ptr<MapMaker> maker_; // reads show and stage: goes first
};

} // namespace ghost::app
