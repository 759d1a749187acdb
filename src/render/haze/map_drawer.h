#pragma once
// SPDX-License-Identifier: Apache-2.0
// MapDrawer: distance maps that the device draws itself, of the stage that it has, with what is made of them
// for soft shadows: the way for what moves where there is a graphics card, for nothing crosses to it but the
// places of things (shaders/shared/map_draw.h; bake/moving_maps.h traces the same on the processor). Blocks
// of kMapBlock texels a side, numbered row by row; metres. Main thread, uses all cores; the device must
// outlive it. Memory that is not there is thrown (gpu/device_failures.h).

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/raster.h"
#include "gpu/texture.h"
#include "render/geometry/beam_reach.h"
#include "render/geometry/stage_model.h"
#include "shared/map_draw.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ghost::render {

class MapDrawer {
public:
    // What a device lacks for it, or "".
    static std::string lack_of(const gpu::Device& device);
    // Maps of that size can be drawn.
    static bool takes(std::uint32_t side);

    // As many maps at once as are wanted, but no more than is good for memory.
    MapDrawer(const gpu::Device& device, std::uint32_t side, std::uint32_t maps);

    struct Job {
        std::uint32_t map = 0; // layer of the textures; each once
        glm::vec3 position_m{0};
        const std::vector<int>& blocks;
    };
    // texels: r16f; cells: rgba16f, render/haze/private/blockers.h. Both are stored to. far: of each map,
    // what is true of the other blocks before. Waits.
    void draw(const StageModel& model, const std::vector<Job>& jobs, const gpu::Texture& texels,
              const gpu::Texture& cells, std::vector<FarParts>& far);

    const std::vector<gpu::Span>& spans() const { return spans_; } // of the last time
    std::uint64_t bytes() const { return depth_.bytes(); }

private:
    // All directions of some blocks that lie in one octant.
    struct Sight {
        std::uint32_t octant = 0;
        glm::vec3 axis{0};
        float sine = 0, cosine = 1; // of the angle between the axis and the farthest of them
        bool meets(const glm::vec3& middle_m, float radius_m) const;
    };
    struct Draw {
        std::uint32_t solid = 0;
        std::uint32_t octant = 0;
    };
    // Those of a mesh, one after the other.
    struct Group {
        std::size_t mesh = 0;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    // What is drawn at once.
    struct Part {
        std::uint32_t layers = 0;
        VkRect2D seen{}; // round all blocks
        std::vector<Group> groups;
        std::uint32_t first_block = 0, blocks = 0;
        std::uint32_t first_square = 0, squares = 0;
    };
    struct Plan {
        std::vector<Part> parts;
        std::vector<shared::MapDraw> draws;
        std::vector<shared::MapBlock> blocks;
        std::vector<shared::MapSquare> squares;
        std::uint32_t farthest = 0; // numbers that the squares have
    };
    std::vector<Sight> sights_of(const std::vector<int>& blocks) const;
    std::vector<Draw> draws_of(const std::vector<StageModel::Solid>& solids, const Job& job) const;
    Plan plan(const StageModel& model, const std::vector<Job>& jobs) const;
    void draw_meshes(const StageModel& model, std::span<const Group> groups);
    const gpu::Raster& raster_for(const StageModel::Surface& surface);
    void take_farthest(const std::vector<shared::MapSquare>& squares, std::vector<FarParts>& far);
    // Of farthest_level_, a side.
    std::uint32_t cells_of_square() const { return shared::kMapSquare / 4 >> farthest_level_; }

    const gpu::Device& device_;
    std::uint32_t side_, across_;    // texels; blocks
    std::uint32_t farthest_level_;   // of the cells of which the farthest distances are known
    std::vector<glm::vec3> corners_; // directions of the corners of all blocks
    gpu::Texture depth_;             // as many maps as are drawn at once
    gpu::Program blocks_to_maps_, squares_to_cells_;
    std::map<std::uint32_t, std::unique_ptr<gpu::Raster>> rasters_;
    gpu::Commands commands_;
    std::vector<gpu::Span> spans_;
    gpu::Buffer draws_, blocks_, squares_, farthest_;
    std::vector<std::vector<std::uint16_t>> farthest_cells_; // half floats, of each map; empty: never drawn
};

} // namespace ghost::render
