// SPDX-License-Identifier: Apache-2.0
#include "render/haze/map_drawer.h"

#include "base/check.h"
#include "passes/distance_maps.h"
#include "render/haze/private/blockers.h"
#include "shaders/map_blocks.h"
#include "shaders/map_draw_cut_frag.h"
#include "shaders/map_draw_frag.h"
#include "shaders/map_draw_vert.h"
#include "shaders/map_squares.h"
#include "shared/octahedral.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <tbb/parallel_for.h>

namespace ghost::render {
namespace {

constexpr std::uint32_t kBlockTexels = shared::kMapBlock, kSquareTexels = shared::kMapSquare;
constexpr std::uint32_t kLeastDrawnSide = kSquareTexels; // texels
constexpr std::uint32_t kMostDrawnSide = 4096;
constexpr std::uint32_t kMostDrawnLayers = 16;
constexpr std::uint64_t kDepthBytes = std::uint64_t{32} << 20; // of the layers that are drawn at once
constexpr std::uint32_t kClipDistances = 3;
// Rounding: what the boxes of things grow by, of the largest coordinate.
constexpr float kGrowth = 1e-5f;

static_assert(kBlockTexels == scene::kDistanceBlock);
static_assert(kSquareTexels == kLeastBlockerCell << (kBlockerLevels - 1));

std::uint32_t layers_at_once(const gpu::Device& device, std::uint32_t side, std::uint32_t maps) {
    const std::uint64_t bytes = std::uint64_t{side} * side * sizeof(float);
    const auto good =
        static_cast<std::uint32_t>(std::clamp<std::uint64_t>(kDepthBytes / bytes, 1, kMostDrawnLayers));
    return std::max(std::min({good, maps, device.limits().drawn_layers}), 1u);
}

gpu::Texture depth_layers(const gpu::Device& device, std::uint32_t side, std::uint32_t layers) {
    gpu::TextureShape shape{side, side, layers, 1, VK_FORMAT_D32_SFLOAT};
    shape.attachment = true;
    return {device, shape};
}

gpu::RasterShape raster_shape_of(const StageModel::Surface& surface) {
    gpu::RasterShape shape;
    shape.inputs = {{VK_FORMAT_R32G32B32_SFLOAT, offsetof(StageVertex, position_m)},
                    {VK_FORMAT_R32G32_SFLOAT, offsetof(StageVertex, uv)}};
    shape.vertex_stride = sizeof(StageVertex);
    constexpr auto kAxis = static_cast<std::uint32_t>(offsetof(shared::MapDraw, axis));
    constexpr auto kVector = static_cast<std::uint32_t>(sizeof(glm::vec3));
    shape.of_instance = {{VK_FORMAT_R32G32B32_SFLOAT, kAxis},
                         {VK_FORMAT_R32G32B32_SFLOAT, kAxis + kVector},
                         {VK_FORMAT_R32G32B32_SFLOAT, kAxis + 2 * kVector},
                         {VK_FORMAT_R32G32B32_SFLOAT, offsetof(shared::MapDraw, place_m)},
                         {VK_FORMAT_R32G32B32_SFLOAT, offsetof(shared::MapDraw, signs)},
                         {VK_FORMAT_R32_UINT, offsetof(shared::MapDraw, layer)}};
    shape.instance_stride = sizeof(shared::MapDraw);
    if (surface.alpha != shared::kOpaque)
        shape.constants = {surface.alpha, surface.textures & shared::kBaseTexture};
    return shape;
}

// Where the squares that hold these blocks begin, texels.
std::vector<glm::uvec2> squares_round(const std::vector<int>& blocks, std::uint32_t side) {
    const std::uint32_t across = side / kBlockTexels, squares = side / kSquareTexels;
    std::vector<bool> has(std::size_t{squares} * squares);
    std::vector<glm::uvec2> found;
    for (const int block : blocks) {
        const auto k = static_cast<std::uint32_t>(block);
        const std::uint32_t x = k % across * kBlockTexels / kSquareTexels,
                            y = k / across * kBlockTexels / kSquareTexels;
        if (!has[y * squares + x]) found.push_back(glm::uvec2(x, y) * kSquareTexels);
        has[y * squares + x] = true;
    }
    return found;
}

template <class Value>
void put(const gpu::Device& device, gpu::Buffer& buffer, const std::vector<Value>& values) {
    const std::uint64_t bytes = values.size() * sizeof(Value);
    if (buffer.bytes() < bytes || !buffer.valid()) {
        buffer = gpu::Buffer();
        buffer = gpu::Buffer(device, 2 * bytes, gpu::Access::upload);
    }
    if (bytes > 0) std::memcpy(buffer.mapped(), values.data(), bytes);
}

} // namespace

std::string MapDrawer::lack_of(const gpu::Device& device) {
    if (device.limits().clip_distances < kClipDistances)
        return "maxClipDistances " + std::to_string(kClipDistances);
    return device.limits().drawn_layers < 2 ? "shaderOutputLayer" : "";
}

bool MapDrawer::takes(std::uint32_t side) {
    return side >= kLeastDrawnSide && side <= kMostDrawnSide && std::has_single_bit(side);
}

MapDrawer::MapDrawer(const gpu::Device& device, std::uint32_t side, std::uint32_t maps)
    : device_(device), side_(side), across_(side / kBlockTexels),
      farthest_level_(
          std::min(static_cast<std::uint32_t>(std::bit_width(side / kFarSide / kLeastBlockerCell)) - 1,
                   kBlockerLevels - 1)),
      depth_(depth_layers(device, side, layers_at_once(device, side, maps))),
      blocks_to_maps_(device, shaders::kShader_map_blocks),
      squares_to_cells_(device, shaders::kShader_map_squares), commands_(device) {
    CHECK(takes(side) && lack_of(device).empty());
    for (std::uint32_t y = 0; y <= across_; ++y)
        for (std::uint32_t x = 0; x <= across_; ++x)
            corners_.push_back(
                shared::direction_from_octahedral(glm::vec2(x, y) / static_cast<float>(across_)));
}

bool MapDrawer::Sight::meets(const glm::vec3& middle_m, float radius_m) const {
    const float ahead_m = glm::dot(middle_m, axis);
    if (ahead_m < -radius_m) return false;
    const float beside_m = std::sqrt(std::max(glm::dot(middle_m, middle_m) - ahead_m * ahead_m, 0.0f));
    return !(cosine * beside_m - sine * ahead_m > radius_m);
}

std::vector<MapDrawer::Sight> MapDrawer::sights_of(const std::vector<int>& blocks) const {
    std::array<std::vector<glm::vec3>, shared::kOctants> ways;
    const std::uint32_t middle = across_ / 2;
    for (const int block : blocks) {
        const std::uint32_t x = static_cast<std::uint32_t>(block) % across_,
                            y = static_cast<std::uint32_t>(block) / across_;
        const std::uint32_t quadrant = (x >= middle ? 1u : 0u) | (y >= middle ? 2u : 0u);
        // How far from the map's middle, in blocks: the diagonal between the halves is at `middle`.
        const std::uint32_t out =
            (x >= middle ? x - middle : middle - 1 - x) + (y >= middle ? y - middle : middle - 1 - y);
        for (const std::uint32_t half : {0u, 4u}) {
            if (half == 0 ? out > middle : out + 2 < middle) continue;
            std::vector<glm::vec3>& of_octant = ways[quadrant | half];
            for (const std::uint32_t corner : {0u, 1u, across_ + 1, across_ + 2})
                of_octant.push_back(corners_[y * (across_ + 1) + x + corner]);
        }
    }
    std::vector<Sight> sights;
    for (std::uint32_t octant = 0; octant < ways.size(); ++octant) {
        if (ways[octant].empty()) continue;
        glm::vec3 sum(0.0f);
        for (const glm::vec3& way : ways[octant]) sum += way;
        const glm::vec3 axis = glm::normalize(sum);
        float least = 1;
        for (const glm::vec3& way : ways[octant]) least = std::min(least, glm::dot(way, axis));
        // Blocks on a diagonal bend round it.
        const float angle_rad = std::acos(std::clamp(least, -1.0f, 1.0f)) + 4.0f / static_cast<float>(side_);
        const float kept_rad = std::min(angle_rad, 0.5f * shared::kPi);
        sights.push_back({octant, axis, std::sin(kept_rad), std::cos(kept_rad)});
    }
    return sights;
}

std::vector<MapDrawer::Draw> MapDrawer::draws_of(const std::vector<StageModel::Solid>& solids,
                                                 const Job& job) const {
    std::vector<Draw> draws;
    const glm::vec3& from_m = job.position_m;
    if (!std::isfinite(from_m.x + from_m.y + from_m.z)) return draws;
    const std::vector<Sight> sights = sights_of(job.blocks);
    for (std::uint32_t s = 0; s < solids.size(); ++s) {
        const StageModel::Solid& solid = solids[s];
        const glm::vec3 size = glm::max(glm::abs(solid.low_m), glm::abs(solid.high_m)) + glm::abs(from_m);
        const float growth_m = kGrowth * (1 + std::max({size.x, size.y, size.z}));
        const glm::vec3 low_m = solid.low_m - from_m - growth_m, high_m = solid.high_m - from_m + growth_m;
        std::uint32_t octants = 0; // that it is in
        for (std::uint32_t octant = 0; octant < shared::kOctants; ++octant) {
            const glm::vec3 signs = shared::octant_signs(octant);
            const bool is_in = (signs.x < 0 ? low_m.x < 0 : high_m.x > 0) &&
                               (signs.y < 0 ? low_m.y < 0 : high_m.y > 0) &&
                               (signs.z < 0 ? low_m.z < 0 : high_m.z > 0);
            octants |= is_in ? 1u << octant : 0u;
        }
        const glm::vec3 middle_m = 0.5f * (low_m + high_m);
        const float radius_m = 0.5f * glm::length(high_m - low_m);
        for (const Sight& sight : sights)
            if ((octants >> sight.octant & 1u) != 0 && sight.meets(middle_m, radius_m))
                draws.push_back({s, sight.octant});
    }
    return draws;
}

const gpu::Raster& MapDrawer::raster_for(const StageModel::Surface& surface) {
    const bool is_opaque = surface.alpha == shared::kOpaque;
    const std::uint32_t key =
        is_opaque ? 0 : surface.alpha << 1 | ((surface.textures & shared::kBaseTexture) != 0 ? 1u : 0u);
    std::unique_ptr<gpu::Raster>& raster = rasters_[key];
    if (!raster)
        raster = std::make_unique<gpu::Raster>(device_, shaders::kShader_map_draw_vert,
                                               is_opaque ? shaders::kShader_map_draw_frag
                                                         : shaders::kShader_map_draw_cut_frag,
                                               raster_shape_of(surface));
    return *raster;
}

void MapDrawer::draw_meshes(const StageModel& model, std::span<const Group> groups) {
    const gpu::Raster* used = nullptr;
    const shared::MapDrawPush push{static_cast<float>(side_)};
    for (const Group& group : groups) {
        const StageModel::Surface& surface = model.surface_of(group.mesh);
        const gpu::Raster& raster = raster_for(surface);
        if (used != &raster) {
            used = &raster;
            gpu::use_raster(commands_, raster);
            gpu::push_constants(commands_, raster, &push, sizeof push);
        }
        if (surface.alpha != shared::kOpaque)
            gpu::use_bindings(commands_, device_, raster,
                              shaders::MapDrawCutFragBindings{
                                  .base_texture = gpu::sampled(model.texture(surface.texture[0])),
                                  .material = gpu::uniform(model.materials(), surface.offset)});
        gpu::draw_instances(commands_, model.whole(group.mesh), group.first, group.count);
    }
}

MapDrawer::Plan MapDrawer::plan(const StageModel& model, const std::vector<Job>& jobs) const {
    const std::vector<StageModel::Solid> solids = model.solids();
    std::vector<std::vector<Draw>> draws(jobs.size());
    tbb::parallel_for(std::size_t{0}, jobs.size(),
                      [&](std::size_t j) { draws[j] = draws_of(solids, jobs[j]); });

    Plan plan;
    const std::size_t at_once = depth_.shape().layers;
    for (std::size_t first = 0; first < jobs.size(); first += at_once) {
        Part& part = plan.parts.emplace_back();
        part.layers = static_cast<std::uint32_t>(std::min(at_once, jobs.size() - first));
        part.first_block = static_cast<std::uint32_t>(plan.blocks.size());
        part.first_square = static_cast<std::uint32_t>(plan.squares.size());
        glm::ivec2 low(static_cast<int>(across_)), high(0);
        std::map<std::size_t, std::uint32_t> of_mesh;
        for (std::uint32_t layer = 0; layer < part.layers; ++layer) {
            const Job& job = jobs[first + layer];
            for (const int block : job.blocks) {
                const glm::ivec2 at(block % static_cast<int>(across_), block / static_cast<int>(across_));
                low = glm::min(low, at);
                high = glm::max(high, at + 1);
                plan.blocks.push_back({layer, job.map, static_cast<std::uint32_t>(at.x) * kBlockTexels,
                                       static_cast<std::uint32_t>(at.y) * kBlockTexels});
            }
            for (const glm::uvec2& square : squares_round(job.blocks, side_)) {
                plan.squares.push_back({job.map, square.x, square.y, plan.farthest});
                plan.farthest += cells_of_square() * cells_of_square();
            }
            for (const Draw& draw : draws[first + layer]) ++of_mesh[solids[draw.solid].mesh];
        }
        part.blocks = static_cast<std::uint32_t>(plan.blocks.size()) - part.first_block;
        part.squares = static_cast<std::uint32_t>(plan.squares.size()) - part.first_square;
        constexpr int kWidth = static_cast<int>(kBlockTexels);
        part.seen = {{low.x * kWidth, low.y * kWidth},
                     {static_cast<std::uint32_t>(std::max(high.x - low.x, 0) * kWidth),
                      static_cast<std::uint32_t>(std::max(high.y - low.y, 0) * kWidth)}};

        std::map<std::size_t, std::uint32_t> next;
        for (const auto& [mesh, count] : of_mesh) {
            next[mesh] = static_cast<std::uint32_t>(plan.draws.size());
            part.groups.push_back({mesh, next[mesh], count});
            plan.draws.resize(plan.draws.size() + count);
        }
        std::stable_sort(part.groups.begin(), part.groups.end(), [&](const Group& a, const Group& b) {
            return model.surface_of(a.mesh).alpha < model.surface_of(b.mesh).alpha;
        });
        for (std::uint32_t layer = 0; layer < part.layers; ++layer)
            for (const Draw& draw : draws[first + layer]) {
                const StageModel::Solid& solid = solids[draw.solid];
                shared::MapDraw& made = plan.draws[next[solid.mesh]++];
                for (int k = 0; k < 3; ++k) made.axis[k] = glm::vec3(solid.world[k]);
                made.place_m = glm::vec3(solid.world[3]) - jobs[first + layer].position_m;
                made.signs = shared::octant_signs(draw.octant);
                made.layer = layer;
            }
    }
    return plan;
}

void MapDrawer::draw(const StageModel& model, const std::vector<Job>& jobs, const gpu::Texture& texels,
                     const gpu::Texture& cells, std::vector<FarParts>& far) {
    CHECK_EQ(texels.shape().width, side_);
    const Plan plan = this->plan(model, jobs);
    spans_.clear();
    if (plan.blocks.empty()) return;
    put(device_, draws_, plan.draws);
    put(device_, blocks_, plan.blocks);
    put(device_, squares_, plan.squares);
    if (farthest_.bytes() < plan.farthest * sizeof(std::uint32_t)) {
        farthest_ = gpu::Buffer();
        farthest_ = gpu::Buffer(device_, 2 * plan.farthest * sizeof(std::uint32_t), gpu::Access::readback);
    }
    const std::uint32_t levels = cells.shape().levels;
    const auto level_of = [&](std::uint32_t level) {
        return gpu::stored_level(cells, std::min(level, levels - 1));
    };

    commands_.begin();
    for (const Part& part : plan.parts) {
        if (part.blocks == 0) continue;
        commands_.begin_span("maps drawn");
        gpu::begin_drawing_layers(commands_, depth_, part.layers, part.seen);
        gpu::use_vertices(commands_, model.vertices(), model.indices());
        gpu::use_instances(commands_, draws_);
        draw_meshes(model, part.groups);
        gpu::end_drawing(commands_);
        commands_.begin_span("maps from depth");
        commands_.dispatch(blocks_to_maps_, shared::MapBlocksPush{part.first_block, side_},
                           shaders::MapBlocksBindings{.depths = gpu::sampled(depth_),
                                                      .blocks = gpu::storage(blocks_),
                                                      .texels = gpu::stored(texels)},
                           part.blocks);
        commands_.barrier();
        commands_.begin_span("cells of maps");
        commands_.dispatch(squares_to_cells_,
                           shared::MapSquaresPush{part.first_square, levels, farthest_level_},
                           shaders::MapSquaresBindings{.texels = gpu::sampled(texels),
                                                       .squares = gpu::storage(squares_),
                                                       .farthest = gpu::storage(farthest_),
                                                       .cells_4 = level_of(0),
                                                       .cells_8 = level_of(1),
                                                       .cells_16 = level_of(2),
                                                       .cells_32 = level_of(3),
                                                       .cells_64 = level_of(4)},
                           part.squares);
    }
    commands_.submit_and_wait();
    spans_ = commands_.spans();
    take_farthest(plan.squares, far);
}

void MapDrawer::take_farthest(const std::vector<shared::MapSquare>& squares, std::vector<FarParts>& far) {
    farthest_cells_.resize(far.size());
    const std::uint32_t of_square = cells_of_square();
    const std::uint32_t cells = side_ / kSquareTexels * of_square; // a side
    const std::size_t of_part = cells / kFarSide;
    const auto* const read = static_cast<const std::uint32_t*>(farthest_.mapped());
    for (const shared::MapSquare& square : squares) {
        std::vector<std::uint16_t>& known = farthest_cells_[square.map];
        if (known.empty()) known.assign(std::size_t{cells} * cells, scene::kNoSurface);
        const std::size_t x0 = square.x / kSquareTexels * of_square,
                          y0 = square.y / kSquareTexels * of_square;
        for (std::uint32_t k = 0; k < of_square * of_square; ++k)
            known[(y0 + k / of_square) * cells + x0 + k % of_square] =
                static_cast<std::uint16_t>(read[square.farthest + k]);
        for (std::size_t y = y0 / of_part; y * of_part < y0 + of_square; ++y)
            for (std::size_t x = x0 / of_part; x * of_part < x0 + of_square; ++x) {
                std::uint16_t most = 0;
                for (std::size_t k = 0; k < of_part * of_part; ++k)
                    most = std::max(most,
                                    known[(y * of_part + k / of_part) * cells + x * of_part + k % of_part]);
                far[square.map][y * kFarSide + x] = glm::unpackHalf1x16(most);
            }
    }
}

} // namespace ghost::render
