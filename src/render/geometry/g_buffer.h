#pragma once
// SPDX-License-Identifier: Apache-2.0
// GBuffer: what a free camera sees of a stage, as fragments for the light passes
// (render/geometry/fragments.h) and the material of each. The stage is drawn with kSamples samples a pixel
// into reversed depth and material attachments; a compute pass sorts the samples into fragments, as the baker
// sorts its rays. Positions are those of the samples, from their depth. Blended surfaces take a fraction of
// the samples of a pixel, by chance that is the same in every frame: a fraction of a quarter at least, noise
// beyond that. A picture of a moment may have one sample a pixel, a third of the work: its silhouettes are
// steps. Instances that move are drawn last, and what they hide is kept: when they move on, only the tiles
// where they were and are change. Main thread; the device must outlive it.

#include "gpu/commands.h"
#include "gpu/raster.h"
#include "render/geometry/fragments.h"
#include "render/geometry/screen_area.h"
#include "render/geometry/stage_model.h"
#include "shared/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace ghost::render {

// A pinhole camera that looks down its -Z, see scene::camera_to_world. All values finite.
struct Pose {
    glm::mat4 camera_to_world{1.0f};
    float fov_y_deg = 40;
    int width = 0; // of the picture: as the GBuffer was made
    int height = 0;
    float most_error_px = 0; // that surfaces of the stage may be off by, to be drawn faster
    bool single = false;     // likewise: one sample a pixel instead of kSamples
};

// What is between and around the surfaces.
struct Surroundings {
    glm::vec3 ambient{0}; // even light: colour times lux
    shared::Haze haze{};
    float work_lux = 0; // light to work by: from over the viewer's shoulder, no haze glows in it
};

// The rectangles of some tiles, as Vulkan wants them.
std::vector<VkRect2D> regions(const TileSet& tiles);

class GBuffer {
public:
    GBuffer(const gpu::Device& device, int width, int height);

    // Draws and waits: the numbers in fragments() are those of this camera then. stop: asked every few
    // milliseconds; true ends it, draw is false, and nothing but draw may be called until it was true. From
    // the same pose it goes on where it was stopped; and where only what surrounds it is other, the stage is
    // not drawn again.
    bool draw(const StageModel& model, const Pose& pose, const Surroundings& surroundings,
              const std::function<bool()>& stop = {});
    // What it was drawn with last.
    const Pose& pose() const { return pose_; }
    // Drawn from there, and surrounded like that.
    bool shows(const Pose& pose, const Surroundings& surroundings) const;
    // Draws what moved since then, seen and surrounded as before; the model must be the same. False: nothing
    // did, and nothing was drawn. Where another instance than the moving ones changed, draws everything.
    bool update(const StageModel& model);
    // Rectangles in which the last draw or update may have changed fragments.
    const std::vector<PixelRect>& changed() const { return changed_; }

    // In that one all extra fragments got other places.
    bool extras_moved() const { return extras_moved_; }

    const Fragments& fragments() const { return fragments_; }
    // One texel per fragment, laid out as Fragments::places; undefined where there is no fragment.
    const gpu::Texture& diffuse() const { return diffuse_; }   // rgba16f: Brdf::diffuse, Brdf::alpha
    const gpu::Texture& specular() const { return specular_; } // rgba16f: Brdf::f0, Brdf::f90
    // rgba16f: shading normal towards the viewer and normal of the facet, pack_normals in shared/g_buffer.h
    const gpu::Texture& normals() const { return normals_; }

    // Places of fragments beyond the main ones; after an update some of them may be empty.
    const gpu::Buffer& rooms() const { return rooms_; } // shared::TileRoom of each tile

    std::uint32_t extra_count() const { return extra_count_; }
    std::uint32_t dropped_pixels() const {
        return dropped_pixels_;
    } // showing their main surface only: no room
    const std::vector<gpu::Span>& spans() const { return spans_; }
    std::uint64_t memory_bytes() const; // on the device

private:
    // What is drawn to.
    struct Samples {
        gpu::Texture depth, base, normal, emission, metalness;
        std::array<const gpu::Texture*, 5> all() const {
            return {&depth, &base, &normal, &emission, &metalness};
        }
    };
    // An instance as it was drawn last.
    struct Shown {
        glm::mat4 to_eye{1.0f};
        float glow_cd_m2 = 0;
        PixelRect rect;
        bool looks_as(const Shown& other) const {
            return to_eye == other.to_eye && glow_cd_m2 == other.glow_cd_m2;
        }
    };
    // What a pose is drawn to, and what its moving instances hide, in the tiles of saved_.
    struct Target {
        Samples shown, hidden; // made when they are wanted
    };
    Samples make_samples() const; // for this pose
    Target& target() { return targets_[pose_.single ? 1 : 0]; }
    const gpu::Raster& raster_for(const StageModel::Surface& surface);
    bool draw_still(const StageModel& model, const std::function<bool()>& stop); // false: stopped
    void draw_meshes(const StageModel& model, std::span<const StageModel::Draw> draws, gpu::Before before);
    struct MovingPlan {
        TileSet tiles; // to be made anew
        std::vector<StageModel::Draw> draws;
    };
    // What has to be drawn for the moving instances, which then count as shown.
    MovingPlan plan_moving(const StageModel& model);
    void draw_moving(const StageModel& model, const MovingPlan& plan);
    bool stands_at(const Pose& pose) const;
    bool is_surrounded_by(const Surroundings& surroundings) const;
    void surround(const Surroundings& surroundings);
    void gather(const TileSet* tiles); // null: all of them
    void submit();
    void warn_of_dropped();

    const gpu::Device& device_;
    std::uint32_t capacity_; // extra fragments
    std::map<std::uint32_t, std::unique_ptr<gpu::Raster>> rasters_;
    std::array<gpu::LateProgram, 2> gather_; // likewise
    gpu::Program block_bounds_;
    gpu::Commands commands_;
    Fragments fragments_;
    gpu::Texture diffuse_, specular_, normals_;
    std::array<Target, 2> targets_; // kSamples of a pixel, and one
    TileSet saved_;
    std::map<std::size_t, Shown> shown_; // moving instances
    Pose pose_;
    Surroundings surroundings_;
    std::uint64_t still_revision_ = 0;
    std::vector<StageModel::Draw> to_draw_; // what does not move, of a draw that was stopped
    std::size_t drawn_count_ = 0;           // of these
    bool is_whole_ = false;
    std::vector<PixelRect> changed_;
    gpu::Buffer counts_, counts_read_, rooms_, tile_list_, block_list_;
    std::vector<gpu::Span> spans_;
    std::uint32_t extra_count_ = 0;
    std::uint32_t dropped_pixels_ = 0;
    bool extras_moved_ = false;
    bool warned_ = false; // that there is no room for all extra fragments
};

} // namespace ghost::render
